//! Puts designs, shapes, motions and grid together into a study and its truth.

use std::sync::Arc;

use rayon::prelude::*;

use super::design::{SubjectDesign, designs};
use super::grid::WallGrid;
use super::motion::{Material, Motion};
use super::params::{BuiltInError, BuiltInParams, FRAMES};
use super::patch::ChartPoint;
use super::segments::aha_segment;
use super::shape::Shape;
use super::timing::BeatState;
use super::truth::{GroundTruth, SurfaceTruth};
use crate::mesh::{Point3, TriMesh};
use crate::study::{
    Anatomy, CycleTiming, MeshSequence, Notice, Study, Subject, SurfaceKind, SurfaceSequence,
};
use crate::units::{LengthUnit, Seconds};

/// What the built-in study is called.
pub const BUILT_IN_NAME: &str = "Built-in cohort";

/// The built-in study and, apart from it, what is true of its subjects.
#[derive(Clone, Debug)]
pub struct BuiltInCohort {
    /// Nine normal subjects, N01 … N09, and fourteen patients, P01 … P14.
    pub study: Study,
    /// One for each subject, in the same order.
    pub truths: Vec<GroundTruth>,
}

/// Makes the cohort. Equal parameters give equal bits, whatever the number of threads.
///
/// # Errors
/// If the number of vertices is out of range.
pub fn cohort(params: &BuiltInParams) -> Result<BuiltInCohort, BuiltInError> {
    let grid = WallGrid::new(params.vertices_per_surface()?)?;
    let hearts = designs(params.seed)
        .into_par_iter()
        .map(|design| heart(&design, &grid))
        .collect::<Result<Vec<_>, _>>()?;
    let (subjects, truths): (Vec<_>, Vec<_>) = hearts.into_iter().unzip();
    Ok(BuiltInCohort {
        study: Study {
            name: BUILT_IN_NAME.to_owned(),
            subjects: subjects.into_iter().map(Arc::new).collect(),
            ..Study::default()
        },
        truths,
    })
}

/// One subject with its truth.
fn heart(design: &SubjectDesign, grid: &WallGrid) -> Result<(Subject, GroundTruth), BuiltInError> {
    let shape = Shape::new(design.form.clone(), design.edv_ml);
    let (squeeze, ejection_fraction) = squeeze_for(&shape, design.healthy_ejection_fraction);
    let motion = Motion::new(&shape, design.motion(squeeze));
    let states = design.timing.frames();
    let layers = [
        (
            SurfaceKind::Endocardium,
            particles(grid, |p| motion.endo(p)),
        ),
        (SurfaceKind::Epicardium, particles(grid, |p| motion.epi(p))),
    ];
    let place = |particle: &Material, state| design.placement * motion.at(particle, state);
    let mut surfaces = Vec::with_capacity(layers.len());
    for (kind, particles) in &layers {
        surfaces.push(surface(*kind, particles, grid, &states, place)?);
    }
    let anatomy = anatomy(&surfaces, grid, design);
    let mut subject = Subject::new(
        design.id.clone(),
        MeshSequence::new(surfaces)?,
        LengthUnit::Millimetre,
    );
    subject.label = Some(design.label().to_owned());
    subject.timing = CycleTiming {
        frame_times_s: Some(
            (0..FRAMES)
                .map(|frame| design.rr_s * frame as f64 / FRAMES as f64)
                .collect(),
        ),
        rr: Some(Seconds(design.rr_s)),
    };
    subject.anatomy = anatomy;
    subject.height_cm = Some(design.height_cm);
    subject.weight_kg = Some(design.weight_kg);
    subject
        .notices
        .push(Notice::info("made by the built-in model, not measured"));
    let truth = GroundTruth {
        abnormality: design.abnormality,
        patches: shape.patches().len(),
        segments: ill_segments(&shape, grid),
        surfaces: vec![
            surface_truth(SurfaceKind::Endocardium, &shape, grid),
            surface_truth(SurfaceKind::Epicardium, &shape, grid),
        ],
        end_diastolic_volume_ml: design.edv_ml,
        ejection_fraction,
    };
    Ok((subject, truth))
}

/// The squeeze κ with which a subject without patches would reach the ejection fraction, and the
/// ejection fraction that it reaches with them.
///
/// V(t) = ½ ∬ (1 − κ(Θ, Z)) Rₑ² dΘ dZ, because r² dz = (1 − κ) Rₑ² dZ on the inner surface.
fn squeeze_for(shape: &Shape, healthy_ejection_fraction: f64) -> (f64, f64) {
    let [whole, reached] = shape.cavity_integrals(|[height, _]| Shape::contraction_share(height));
    let squeeze = healthy_ejection_fraction * whole / reached;
    let [_, working] = shape.cavity_integrals(|[height, around]| {
        let z_mm = shape.cavity_tip_mm() * (1.0 - height);
        Shape::contraction_share(height) * (1.0 - shape.illness(z_mm, around).severity)
    });
    (squeeze, squeeze * working / whole)
}

fn particles(
    grid: &WallGrid,
    particle: impl Fn(super::grid::GridPoint) -> Material,
) -> Vec<Material> {
    grid.points.iter().map(|&point| particle(point)).collect()
}

fn surface(
    kind: SurfaceKind,
    particles: &[Material],
    grid: &WallGrid,
    states: &[BeatState],
    place: impl Fn(&Material, BeatState) -> Point3,
) -> Result<SurfaceSequence, BuiltInError> {
    let frames = states
        .iter()
        .map(|&state| {
            let points: Vec<Point3> = particles.iter().map(|p| place(p, state)).collect();
            TriMesh::new(points, Arc::clone(&grid.faces))
        })
        .collect::<Result<Vec<_>, _>>()?;
    Ok(SurfaceSequence::new(kind, frames)?)
}

/// Landmarks at end-diastole: the outer tip, the middle of the inner rim, and the directions of
/// septum and anterior wall.
fn anatomy(
    surfaces: &[SurfaceSequence],
    grid: &WallGrid,
    design: &SubjectDesign,
) -> Option<Anatomy> {
    let [endo, epi] = surfaces else { return None };
    let endo = endo.frames().first()?.vertices();
    let apex = *epi.frames().first()?.vertices().first()?;
    let rim = endo.get(endo.len() - grid.rim..)?;
    let sum: nalgebra::Vector3<f64> = rim.iter().map(|point| point.coords).sum();
    let base = Point3::from(sum / rim.len() as f64);
    let septum = base + design.placement.rotation * nalgebra::Vector3::x();
    let anterior = base + design.placement.rotation * nalgebra::Vector3::y();
    Anatomy::from_landmarks(apex, base, septum, anterior)
}

fn surface_truth(kind: SurfaceKind, shape: &Shape, grid: &WallGrid) -> SurfaceTruth {
    let heights = grid.points.iter().map(|point| match kind {
        SurfaceKind::Epicardium => shape.epi_height_mm(point.eccentric_share),
        _ => shape.endo_height_mm(point.eccentric_share),
    });
    let (patch, severity) = heights
        .zip(&grid.points)
        .map(|(z, point)| {
            (
                patch_of(shape, z, point.around_rad),
                shape.illness(z, point.around_rad).severity,
            )
        })
        .unzip();
    SurfaceTruth {
        kind,
        patch,
        severity,
    }
}

/// The patch of which a place is most a member, counted from 1, if it is at least half one.
fn patch_of(shape: &Shape, z_mm: f64, around_rad: f64) -> u8 {
    let point = ChartPoint::new(shape.height_share(z_mm), around_rad);
    let mut best = (0.5, 0);
    for (patch, number) in shape.patches().iter().zip(1_u8..) {
        let (member, _) = patch.membership(point);
        if member >= best.0 {
            best = (member, number);
        }
    }
    best.1
}

/// Segments of which at least a third of the inner surface's vertices lies in a patch.
fn ill_segments(shape: &Shape, grid: &WallGrid) -> Vec<u8> {
    let mut counts = [[0_usize; 2]; 18];
    for point in &grid.points {
        let z = shape.endo_height_mm(point.eccentric_share);
        let segment = aha_segment(shape.height_share(z), point.around_rad);
        counts[usize::from(segment)][0] += 1;
        if patch_of(shape, z, point.around_rad) > 0 {
            counts[usize::from(segment)][1] += 1;
        }
    }
    (1..=17)
        .filter(|&segment: &u8| {
            let [all, ill] = counts[usize::from(segment)];
            ill > 0 && 3 * ill >= all
        })
        .collect()
}
