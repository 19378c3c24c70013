//! Masks of the left ventricle in gated SPECT.

use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::walls_from_masks::Masks;
use crate::image::{
    Border, Image, MarkedPoints, Sampler, VolumeEdit, VolumeFrame, blurred_image, edited,
};
use crate::mesh::Vector3;
use crate::progress::Progress;
use crate::study::Notice;

use super::base::{ValvePlane, valve_plane};
use super::borders::{borders, median};
use super::fill::{Surfaces, masks};
use super::middle::middles;
use super::place::{Placed, placed};
use super::rays::{ANGLES, Profiles, Rays, Sheet, greatest};
use super::unturned::unturned;
use super::{CheckedSpectParams, SpectError, SpectGrid, SpectParams};

/// What is found in an image.
#[derive(Clone, Debug)]
pub struct SpectSegmentation {
    /// Cavity and wall at each instant, in the world of the image.
    pub masks: Masks,
    /// Apex (the tip of the middle of the wall) and base (the valve at the first instant) as marked, or else as found; the others as
    /// marked.
    pub points: MarkedPoints,
    /// What was found and assumed.
    pub notices: Vec<Notice>,
}

/// Voxels of an image that are worked on: 128 × 128 × 128 at 32 instants.
const MAX_VOXELS: usize = 1 << 26;

/// How firmly the wall in the sum over instants is held to the surface of revolution, in counts of the wall per cm²: another
/// organ that touches the wall must not draw it away. From instant to instant it moves freely.
const HELD: f64 = 0.12;

/// Finds the left ventricle in gated SPECT and follows its wall.
///
/// 1. Planes through the long axis are laid out as a volume ([`SpectGrid`]); each volume is blurred and edited, with a threshold
///    that is a share of its greatest counts.
/// 2. In the sum over the instants the place is found from which counts rise to a wall in most directions; an axis is fitted
///    so that the wall is most nearly a surface of revolution. Marked points are taken instead, as far as they are given.
/// 3. PathState rays from the axis (spherical below, cylindrical above, as in Germano et al. 1995) the middle of the wall is where
///    counts are greatest, on a surface that is smooth in space and over the beat.
/// 4. Endocardium and epicardium lie where counts have fallen to a height, the valve where those of the middle of the wall fall.
///
/// Edits and marked points are in the world of the image; for turned planes that of its first plane.
///
/// # Errors
/// If no ventricle is found, the image has no counts or is too large, an edit says no place, or it was asked to stop.
pub fn segment_spect(
    image: &Image,
    points: &MarkedPoints,
    edits: &[VolumeEdit],
    params: &CheckedSpectParams,
    progress: &Progress,
) -> Result<SpectSegmentation, SpectError> {
    let params = params.get();
    let mut notices = Vec::new();
    let image = laid_out(image, params.grid, &mut notices, progress)?;
    let image = prepared(&image, edits, &params, progress)?;
    let sum = sum_over_instants(&image);
    let Placed { rays, mut points } = placed(image.frame(), &sum, points, &mut notices, progress)?;
    let ungated = rays.profiles(&Sampler::new(image.frame(), &sum)?, progress)?;
    let profiles: Vec<Profiles> = (image.volumes().iter())
        .map(|values| Ok(rays.profiles(&Sampler::new(image.frame(), values)?, progress)?))
        .collect::<Result<_, SpectError>>()?;
    let walls = followed(&rays, ungated, &profiles, progress)?;
    let planes = valve_planes(&rays, &profiles, &walls, params.base)?;
    notices.push(about_valve(&planes));
    let heights: Vec<f64> = planes.iter().map(|plane| plane.height).collect();
    let [inner, outer] = borders(
        &rays,
        &profiles,
        &walls.middles,
        [params.endocardium, params.epicardium],
        &heights,
    );
    let surfaces: Vec<Surfaces> = (0..profiles.len())
        .map(|instant| {
            let middle = &walls.middles[instant];
            let (inner, outer) = (&inner[instant], &outer[instant]);
            Surfaces {
                endo: middle.iter().zip(inner).map(|(r, by)| r - by).collect(),
                epi: middle.iter().zip(outer).map(|(r, by)| r + by).collect(),
                base: heights[instant],
            }
        })
        .collect();
    let valve = heights
        .first()
        .map(|&z| rays.conic.axis.position(Vector3::new(0.0, 0.0, z)));
    points.base = points.base.or(valve);
    notices.extend(about_narrow_cavities(&rays, &surfaces, &inner));
    Ok(SpectSegmentation {
        masks: masks(&rays, &surfaces, params.spacing_mm, progress)?,
        points,
        notices,
    })
}

/// The image as a volume.
fn laid_out(
    image: &Image,
    grid: SpectGrid,
    notices: &mut Vec<Notice>,
    progress: &Progress,
) -> Result<Image, SpectError> {
    let (voxels, instants) = (image.frame().voxel_count(), image.volumes().len());
    if voxels.saturating_mul(instants) > MAX_VOXELS {
        return Err(SpectError::TooLarge {
            voxels,
            instants,
            limit: MAX_VOXELS,
        });
    }
    let turned = match grid {
        SpectGrid::Volume => None,
        SpectGrid::Recognised => unturned(image, false, progress)?,
        SpectGrid::TurnedPlanes => unturned(image, true, progress)?,
    };
    let Some(volume) = turned else {
        return Ok(image.clone());
    };
    notices.push(Notice::info(
        "the image is planes through the long axis, turned by half a turn in all: they are laid out as a volume",
    ));
    Ok(volume)
}

/// Blurred and edited volumes. What is no count stays none.
fn prepared(
    image: &Image,
    edits: &[VolumeEdit],
    params: &SpectParams,
    progress: &Progress,
) -> Result<Image, SpectError> {
    let blurred = blurred_image(image, params.blur_mm, Border::Nearest, progress)?;
    let frame = blurred.frame();
    let volumes = blurred.volumes().par_iter().map(|values| {
        progress.check()?;
        let greatest = greatest(values).ok_or(SpectError::NoCounts)?;
        let mut edited = edited(values, frame, edits, params.threshold * greatest)?;
        forget_erased(&mut edited, frame, edits);
        Ok(Arc::from(edited))
    });
    let volumes = volumes.collect::<Result<Vec<Arc<[f32]>>, SpectError>>()?;
    Ok(Image::new(*frame, volumes, None)?)
}

/// Makes what is erased by position unknown (NaN): the hole in a liver must not look like a cavity.
fn forget_erased(values: &mut [f32], frame: &VolumeFrame, edits: &[VolumeEdit]) {
    let [nx, ny, _] = frame.size();
    for (voxel, value) in values.iter_mut().enumerate() {
        let place = [voxel % nx, voxel / nx % ny, voxel / nx / ny].map(|n| n as f64);
        let position = frame.position(place.into());
        if edits.iter().any(|edit| edit.erases(position)) {
            *value = f32::NAN;
        }
    }
}

fn sum_over_instants(image: &Image) -> Vec<f32> {
    let mut sum = vec![0.0_f32; image.frame().voxel_count()];
    for values in image.volumes() {
        for (sum, value) in sum.iter_mut().zip(values.iter()) {
            *sum += value;
        }
    }
    sum
}

/// The middle of the wall at each instant, and its usual counts there.
struct Followed {
    middles: Vec<Sheet>,
    counts: Vec<f64>,
}

/// Follows the wall first in the sum over instants, near the surface of revolution, then at each instant near that.
fn followed(
    rays: &Rays,
    ungated: Profiles,
    profiles: &[Profiles],
    progress: &Progress,
) -> Result<Followed, SpectError> {
    let expected = rays.conic_sheet();
    let usual = |profiles: &Profiles, sheet: &[f64]| {
        let counts = sheet.iter().enumerate();
        // Below the plane of the valve, whatever that is: the apical two thirds of the rays.
        let low = counts.take(rays.count() * 2 / 3);
        median(low.map(|(ray, &r)| profiles.at(ray, r)).collect()).filter(|counts| *counts > 0.0)
    };
    let wall = usual(&ungated, &expected).ok_or(SpectError::NoCounts)?;
    let ungated = [ungated];
    let first = middles(rays, &ungated, &expected, &[wall], HELD, progress)?;
    let expected = first.first().map_or(&[][..], |sheet| sheet);
    let counts: Vec<f64> = (profiles.iter().enumerate())
        .map(|(instant, profiles)| usual(profiles, expected).ok_or(SpectError::NoWall { instant }))
        .collect::<Result<_, _>>()?;
    let middles = middles(rays, profiles, expected, &counts, 0.0, progress)?;
    let counts = (profiles.iter().zip(&middles).enumerate())
        .map(|(instant, (profiles, sheet))| {
            usual(profiles, sheet).ok_or(SpectError::NoWall { instant })
        })
        .collect::<Result<_, _>>()?;
    Ok(Followed { middles, counts })
}

fn valve_planes(
    rays: &Rays,
    profiles: &[Profiles],
    walls: &Followed,
    share: f64,
) -> Result<Vec<ValvePlane>, SpectError> {
    let instants = profiles.iter().zip(&walls.middles).zip(&walls.counts);
    let planes = instants
        .enumerate()
        .map(|(instant, ((profiles, middle), &counts))| {
            valve_plane(rays, profiles, middle, counts, share).ok_or(SpectError::NoWall { instant })
        });
    planes.collect()
}

fn about_valve(planes: &[ValvePlane]) -> Notice {
    let ended = planes.iter().filter(|plane| plane.at_image_end).count();
    match ended {
        0 => Notice::info(
            "the plane of the valve was found where the counts of the wall fall towards the base, at each instant",
        ),
        _ => Notice::warning(format!(
            "at {ended} of {} instants the counts of the wall do not fall before the image or what an edit left of it ends: the ventricle is cut there",
            planes.len()
        )),
    }
}

/// A warning where the cavity is narrower than the half of the wall towards it: the images of opposite walls overlap there, so
/// that the middle of the wall moves inwards. In small hearts ejection fractions from SPECT are known to be too high.
fn about_narrow_cavities(rays: &Rays, surfaces: &[Surfaces], inner: &[Sheet]) -> Option<Notice> {
    let is_narrow = |(surfaces, inner): &(&Surfaces, &Sheet)| {
        let straight = |ray: usize| {
            let row = ray / ANGLES;
            rays.is_straight(row) && rays.height(row) <= surfaces.base
        };
        let rays = (0..rays.count()).filter(|&ray| straight(ray));
        let (endo, half): (Vec<f64>, Vec<f64>) =
            rays.map(|ray| (surfaces.endo[ray], inner[ray])).unzip();
        median(endo)
            .zip(median(half))
            .is_some_and(|(endo, half)| endo < half)
    };
    let narrow = surfaces.iter().zip(inner).filter(is_narrow).count();
    (narrow > 0).then(|| {
        Notice::warning(format!(
            "at {narrow} of {} instants the cavity is narrower than half of the wall as it appears: its volume is uncertain there, \
             and the ejection fraction likely too high",
            surfaces.len()
        ))
    })
}
