//! Where the left ventricle is: the place from which counts rise to a wall in most directions.

use std::f64::consts::{PI, TAU};

use rayon::prelude::*;

use crate::image::Sampler;
use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};

/// Directions that are looked into.
const DIRECTIONS: usize = 96;
/// Step between places that are looked from, and along a direction.
const PLACE_MM: f64 = 7.0;
const STEP_MM: f64 = 3.0;
/// Distances at which the middle of a wall may stand from the middle of its cavity.
pub(super) const WALL_MM: [f64; 2] = [9.0, 66.0];
/// To which share counts must fall behind the wall for it to end there.
const FALL: f64 = 0.8;
/// And where the image ends before.
const FALL_AT_END: f64 = 0.95;
/// Counts in the middle of the cavity as a share of those of the wall, at most.
const MAX_CAVITY: f64 = 0.9;
/// Counts of the wall as a share of the greatest of the image, at least: a liver may be several times as bright.
const MIN_WALL: f64 = 0.15;
/// Cosine of the angle to the axis within which the apex is, or the valve.
const NEAR_AXIS: f64 = 0.766;
/// Most places that are looked from.
const MAX_PLACES: f64 = 60_000.0;

/// A place with what surrounds it.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    pub centre: Point3,
    /// 0 for no wall, 1 for one all around without any counts within.
    pub score: f64,
    /// Where counts are greatest in each direction that ends in a wall.
    pub wall: Vec<Point3>,
    /// The direction in which there is no wall.
    pub opening: Vector3,
}

/// The place with the most of a wall around it.
///
/// # Errors
/// If it was asked to stop.
pub(super) fn max_enclosed(
    sampler: &Sampler<'_>,
    frame: &VolumeFrame,
    greatest: f64,
    progress: &Progress,
) -> Result<Option<Surroundings>, Stopped> {
    let places = places(frame);
    let directions = directions();
    let looked: Vec<Option<Surroundings>> = places
        .par_iter()
        .map(|&centre| {
            progress.check()?;
            Ok(around(sampler, centre, greatest, &directions))
        })
        .collect::<Result<_, Stopped>>()?;
    // The first of equal ones, whatever the number of threads.
    let best =
        looked.into_iter().flatten().reduce(
            |best, next| {
                if next.score > best.score { next } else { best }
            },
        );
    Ok(best)
}

/// What surrounds one place.
pub(super) fn surroundings(
    sampler: &Sampler<'_>,
    centre: Point3,
    greatest: f64,
) -> Option<Surroundings> {
    around(sampler, centre, greatest, &directions())
}

/// Places of a grid over the volume.
fn places(frame: &VolumeFrame) -> Vec<Point3> {
    let (size, spacing) = (frame.size(), frame.spacing());
    let extent = [0, 1, 2].map(|axis| spacing[axis] * (size[axis] - 1) as f64);
    let all: f64 = extent
        .iter()
        .map(|mm| (mm / PLACE_MM).floor() + 1.0)
        .product();
    let step = PLACE_MM * (all / MAX_PLACES).max(1.0).cbrt();
    let counts = extent.map(|mm| (mm / step).floor() as usize + 1);
    let mut places = Vec::new();
    for number in 0..counts.iter().product() {
        let on_grid = [
            number % counts[0],
            number / counts[0] % counts[1],
            number / counts[0] / counts[1],
        ];
        let voxel = [0, 1, 2].map(|axis| {
            let rest = extent[axis] - step * (counts[axis] - 1) as f64;
            (0.5 * rest + step * on_grid[axis] as f64) / spacing[axis]
        });
        places.push(frame.position(Point3::from(voxel)));
    }
    places
}

/// Directions spread over the sphere (a Fibonacci spiral).
fn directions() -> Vec<Vector3> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    (0..DIRECTIONS)
        .map(|n| {
            let z = 1.0 - (2.0 * n as f64 + 1.0) / DIRECTIONS as f64;
            let (sin, cos) = (golden * n as f64 % TAU).sin_cos();
            let across = (1.0 - z * z).sqrt();
            Vector3::new(across * cos, across * sin, z)
        })
        .collect()
}

fn around(
    sampler: &Sampler<'_>,
    centre: Point3,
    greatest: f64,
    directions: &[Vector3],
) -> Option<Surroundings> {
    let within = sampler.at(centre).filter(|counts| counts.is_finite())?;
    let (mut wall, mut distances, mut contrast, mut towards) =
        (Vec::new(), Vec::new(), 0.0, Vector3::zeros());
    for direction in directions {
        let Some((distance, counts)) = first_peak(sampler, centre, *direction) else {
            continue;
        };
        if counts < MIN_WALL * greatest || within > MAX_CAVITY * counts {
            continue;
        }
        contrast += 1.0 - (within / counts).max(0.0);
        wall.push(centre + direction * distance);
        distances.push(distance);
        // The valve has fewer counts than the apex.
        towards += direction * counts;
    }
    // The valve takes up less than half of what surrounds a cavity.
    if 2 * wall.len() < directions.len() {
        return None;
    }
    let count = distances.len() as f64;
    let mean = distances.iter().sum::<f64>() / count.max(1.0);
    let spread = distances.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / count.max(1.0);
    let even = 1.0 - (spread.sqrt() / mean.max(1.0)).min(1.0);
    Some(Surroundings {
        centre,
        score: contrast / directions.len() as f64 * even,
        wall,
        opening: -towards,
    })
}

/// Where counts are greatest before they fall again, and how great they are there.
fn first_peak(sampler: &Sampler<'_>, centre: Point3, direction: Vector3) -> Option<(f64, f64)> {
    let mut peak = (0.0, f64::MIN);
    let mut last = f64::MAX;
    let mut distance = STEP_MM;
    while distance <= WALL_MM[1] + 5.0 * STEP_MM {
        let counts = sampler.at(centre + direction * distance);
        let Some(counts) = counts.filter(|counts| counts.is_finite()) else {
            // At the end of the image a small fall must do.
            let fallen = last < FALL_AT_END * peak.1;
            return (peak.0 >= WALL_MM[0] && peak.0 <= WALL_MM[1] && fallen).then_some(peak);
        };
        if counts > peak.1 {
            peak = (distance, counts);
        } else if counts < FALL * peak.1 && peak.0 >= WALL_MM[0] {
            return (peak.0 <= WALL_MM[1]).then_some(peak);
        } else if counts < FALL * peak.1 {
            peak = (distance, counts);
        }
        last = counts;
        distance += STEP_MM;
    }
    None
}

/// Mean counts of the walls in the directions within 40° of one, with 0 for those without a wall.
pub(super) fn wall_towards(sampler: &Sampler<'_>, centre: Point3, direction: Vector3) -> f64 {
    let within = |other: &Vector3| other.dot(&direction) > NEAR_AXIS * direction.norm();
    let near: Vec<Vector3> = directions().into_iter().filter(within).collect();
    let peaks = near
        .iter()
        .filter_map(|direction| first_peak(sampler, centre, *direction));
    peaks.map(|(_, counts)| counts).sum::<f64>() / near.len().max(1) as f64
}
