//! Walls of all instants of a subject, in correspondence.

use rayon::prelude::*;

use crate::mesh::{Point3, TriMesh};
use crate::progress::{Progress, Stopped};
use crate::study::{Anatomy, MeshSequence, Notice, SurfaceKind, SurfaceSequence};

use super::fit::{distances, foldovers};
use super::from_slices::{SliceStack, anatomy_of};
use super::planes::{Place, Planes};
use super::preparation::{Preparation, Prepared, SliceShift};
use super::radial::SquaredRadius;
use super::rotated_planes::RotatedPlanes;
use super::shape::{RadialFrame, WallShape};
use super::sheets::{Sheets, Template};
use super::{CheckedWallParams, FrameWallError, Masks, SurfaceFit, Tissue, WallError};

/// The walls of a subject and how they came about.
#[derive(Clone, Debug)]
pub struct Walls {
    /// Endocardium and epicardium at each instant, open at the plane of the valve, in millimetres of the masks' world.
    pub sequence: MeshSequence,
    /// Two for each instant: endocardium, epicardium.
    pub fits: Vec<SurfaceFit>,
    /// Slices that were put back.
    pub shifts: Vec<SliceShift>,
    /// Apex, base and directions at the first instant, where the septum is known.
    pub anatomy: Option<Anatomy>,
    /// What was found, assumed and left out.
    pub notices: Vec<Notice>,
}

/// Walls from masks: at each instant a smooth endocardium and epicardium, with the volumes of the masks and one template
/// for all instants and subjects.
///
/// 1. Slices are put in order from the apex to the base, and cut at the plane of the valve: the upper side of the highest
///    slice in which the wall lies around most of the cavity. Slices that stand beside their neighbours are put back.
/// 2. In each slice an outline is the square of its radius, q(θ), around the middle of the cavity, so that ½ ∫ q dθ is its area.
/// 3. Over the height, q is a smoothing spline through the means over the slices that falls to 0 at a tip, as it does on an
///    ellipsoid. The volume, ½ ∬ q dθ dz, is linear in q: it is that of the mask.
/// 4. The vertices of the template lie at equal shares of the long axis, in equal directions from the septum on.
///
/// # Errors
/// At the first instant that gives no wall, with the reason; or if it was asked to stop.
pub fn walls_from_masks(
    masks: &Masks,
    params: &CheckedWallParams,
    progress: &Progress,
) -> Result<Walls, WallError> {
    let instants = masks.instants().len();
    progress.expect_steps(3 * instants);
    let at = |frame: usize| move |reason: FrameWallError| WallError::Frame { frame, reason };
    let preparation = match RotatedPlanes::of(masks) {
        Some(rotated) => prepared_turn(&rotated, instants, progress)?,
        None => SliceStack::of(masks, params, progress)?,
    };
    let template = Template::new(params.get().vertices).map_err(|error| at(0)(error.into()))?;
    let planes = &preparation.planes;
    let made: Vec<Made> = (preparation.frames.par_iter().enumerate())
        .map(|(frame, prepared)| {
            let shape = WallShape::of(&prepared.radial).map_err(at(frame))?;
            progress.step()?;
            let septal_rad = preparation.septal_rad.unwrap_or(std::f64::consts::PI);
            let sheets = template.on(planes, &shape, septal_rad).map_err(at(frame))?;
            progress.step()?;
            let fits = fits(
                masks, frame, prepared, planes, &shape, &sheets, &template, progress,
            )?;
            Ok(Made {
                shape,
                sheets,
                fits,
            })
        })
        .collect::<Result<_, WallError>>()?;
    assembled(masks, preparation, made)
}

struct Made {
    shape: WallShape,
    sheets: Sheets,
    fits: [SurfaceFit; 2],
}

fn prepared_turn(
    rotated: &RotatedPlanes,
    instants: usize,
    progress: &Progress,
) -> Result<Preparation, WallError> {
    let mut frames = Vec::with_capacity(instants);
    for frame in 0..instants {
        let found = rotated.radial(frame);
        let (radial, outlines) = found.map_err(|reason| WallError::Frame { frame, reason })?;
        frames.push(Prepared {
            radial,
            outlines,
            centres: Vec::new(),
            notes: Vec::new(),
        });
        progress.step()?;
    }
    Ok(Preparation {
        planes: rotated.planes(),
        frames,
        septal_rad: None,
        shifts: Vec::new(),
        notices: vec![Notice::info(
            "the masks are planes through the long axis, turned by half a turn in all: the middle line is the same in each, \
             and the last one is the first seen from behind",
        )],
    })
}

/// How both surfaces of an instant lie on their masks.
#[expect(clippy::too_many_arguments, reason = "all that made the surfaces")]
fn fits(
    masks: &Masks,
    frame: usize,
    prepared: &Prepared,
    planes: &Planes,
    shape: &WallShape,
    sheets: &Sheets,
    template: &Template,
    progress: &Progress,
) -> Result<[SurfaceFit; 2], Stopped> {
    let on_axis = |height: f64| planes.position(shape.centre(height), height);
    let outline = |places: &[(Place, f64)]| -> Vec<Point3> {
        let moved = places.iter().map(|&(place, height)| {
            let centre = prepared.centres.iter().find(|(z, _)| *z == height);
            let by = centre.map_or_else(Place::zeros, |(_, centre)| shape.centre(height) - centre);
            planes.position(place + by, height)
        });
        moved.collect()
    };
    let fit = |kind, mesh: &TriMesh, places, mask_volume_ml| {
        let [mean_mm, p95_mm] = distances(&outline(places), mesh, progress)?;
        Ok(SurfaceFit {
            frame,
            kind,
            mean_mm,
            p95_mm,
            foldovers: foldovers(mesh, |p| on_axis(planes.height_of(p)), progress)?,
            volume_ml: template.volume(mesh.vertices()) / 1000.0,
            mask_volume_ml,
        })
    };
    let [endo, epi] = mask_volumes_ml(masks, frame, prepared);
    Ok([
        fit(
            SurfaceKind::Endocardium,
            &sheets.endo,
            &prepared.outlines[0],
            endo,
        )?,
        fit(
            SurfaceKind::Epicardium,
            &sheets.epi,
            &prepared.outlines[1],
            epi,
        )?,
    ])
}

/// Volumes of cavity, and of cavity and wall: all voxels of them.
fn mask_volumes_ml(masks: &Masks, frame: usize, prepared: &Prepared) -> [f64; 2] {
    if prepared.centres.is_empty() {
        // Voxels of turned planes are not all of one volume.
        let RadialFrame {
            slices, thickness, ..
        } = &prepared.radial;
        let area = |q: &Option<SquaredRadius>| q.as_ref().map_or(0.0, |q| q.area());
        let sum = |areas: Vec<f64>| areas.iter().sum::<f64>() * thickness / 1000.0;
        return [
            sum(slices.iter().map(|slice| area(&slice.cavity)).collect()),
            sum(slices.iter().map(|slice| area(&slice.heart)).collect()),
        ];
    }
    let [cavity, wall] = [Tissue::Cavity, Tissue::Wall].map(|t| masks.count(frame, t) as f64);
    [cavity, cavity + wall].map(|voxels| voxels * masks.frame().voxel_mm3() / 1000.0)
}

fn assembled(masks: &Masks, preparation: Preparation, made: Vec<Made>) -> Result<Walls, WallError> {
    let mut notices = preparation.notices;
    for (frame, prepared) in preparation.frames.iter().enumerate() {
        let notes = prepared.notes.iter();
        notices.extend(notes.map(|note| Notice::info(format!("frame {frame}: {note}"))));
    }
    let planes = &preparation.planes;
    let anatomy = (made.first().zip(preparation.septal_rad)).and_then(|(first, septal_rad)| {
        anatomy_of(masks, planes, &first.shape, septal_rad, &mut notices)
    });
    let fits: Vec<SurfaceFit> = made.iter().flat_map(|made| made.fits).collect();
    for fit in fits.iter().filter(|fit| fit.foldovers > 0) {
        notices.push(Notice::warning(format!(
            "frame {}: {} faces of the {} are turned or cross another",
            fit.frame,
            fit.foldovers,
            fit.kind.name()
        )));
    }
    let (endo, epi) = made
        .into_iter()
        .map(|made| (made.sheets.endo, made.sheets.epi))
        .unzip();
    let surfaces = vec![
        SurfaceSequence::new(SurfaceKind::Endocardium, endo)?,
        SurfaceSequence::new(SurfaceKind::Epicardium, epi)?,
    ];
    Ok(Walls {
        sequence: MeshSequence::new(surfaces)?,
        fits,
        shifts: preparation.shifts,
        anatomy,
        notices,
    })
}
