//! The long axis and the rays about it: as marked, or else as found.

use crate::image::{MarkedPoints, Sampler, VolumeFrame};
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;
use crate::study::Notice;

use super::SpectError;
use super::axis::{Conic, LongAxis};
use super::find::{Surroundings, max_enclosed, surroundings, wall_towards};
use super::rays::{Rays, greatest};

/// How well a place must be enclosed. The twenty real studies of the tests score 0.3 to 0.65.
const ENCLOSED: f64 = 0.18;
/// Rounds of looking from the middle of the wall that was found.
const ROUNDS: usize = 5;
/// Height of the rays above the tip of the wall, in its greatest radii: longer than any ventricle, so that the valve is below.
const LENGTH: f64 = 4.0;

/// Where the ventricle is.
pub(super) struct Placed {
    pub rays: Rays,
    pub points: MarkedPoints,
}

/// Finds the axis and the wall of revolution about it.
///
/// # Errors
/// If no place is enclosed by a wall, marked points say no axis, or it was asked to stop.
pub(super) fn placed(
    frame: &VolumeFrame,
    sum: &[f32],
    marked: &MarkedPoints,
    notices: &mut Vec<Notice>,
    progress: &Progress,
) -> Result<Placed, SpectError> {
    let most = greatest(sum).ok_or(SpectError::NoCounts)?;
    let sampler = Sampler::new(frame, sum)?;
    let marked_axis = marked_axis(marked)?;
    let from = match (marked_axis, marked.blood) {
        (Some((axis, length)), _) => {
            let middle = axis.position(Vector3::new(0.0, 0.0, 0.5 * length));
            surroundings(&sampler, middle, most)
        }
        (None, Some(blood)) => surroundings(&sampler, blood, most),
        (None, None) => max_enclosed(&sampler, frame, most, progress)?,
    };
    let score = from.as_ref().map_or(0.0, |found| found.score);
    let found = from.filter(|found| found.score >= ENCLOSED || marked_axis.is_some());
    let none = || SpectError::NoVentricle {
        score,
        needed: ENCLOSED,
    };
    let found = found.ok_or_else(none)?;
    let conic = match marked_axis {
        Some((axis, _)) => Conic::about(&axis, &found.wall).ok_or_else(none)?,
        None => refined(&sampler, found, most, progress)?.ok_or_else(none)?,
    };
    let (tip, radius) = conic.tip_and_radius().ok_or_else(none)?;
    let rays = Rays::across(&conic, tip, radius, tip + LENGTH * radius);
    let points = MarkedPoints {
        apex: marked
            .apex
            .or(Some(conic.axis.position(Vector3::new(0.0, 0.0, tip)))),
        ..*marked
    };
    notices.push(Notice::info(match marked_axis {
        Some(_) => "the long axis is that of the marked apex and base".to_owned(),
        None => format!(
            "the long axis was found in the sum over all instants: the middle of the wall has a radius of {radius:.0} mm and its tip \
             at {} mm (LPS)",
            listed(conic.axis.position(Vector3::new(0.0, 0.0, tip)))
        ),
    }));
    Ok(Placed { rays, points })
}

fn listed(point: Point3) -> String {
    format!("({:.0}, {:.0}, {:.0})", point.x, point.y, point.z)
}

/// The axis of marked points and its length, from the apex.
fn marked_axis(points: &MarkedPoints) -> Result<Option<(LongAxis, f64)>, SpectError> {
    let marked = [points.apex, points.base, points.blood];
    let all = marked.iter().flatten().flat_map(|point| point.iter());
    if !all.into_iter().all(|x| x.is_finite()) {
        return Err(SpectError::NoAxis);
    }
    let (Some(apex), Some(base)) = (points.apex, points.base) else {
        return Ok(None);
    };
    let axis = LongAxis::towards(apex, base - apex).ok_or(SpectError::NoAxis)?;
    Ok(Some((axis, (base - apex).norm())))
}

/// The conic that fits what is seen from the middle of the conic before.
fn refined(
    sampler: &Sampler<'_>,
    found: Surroundings,
    most: f64,
    progress: &Progress,
) -> Result<Option<Conic>, SpectError> {
    let mut seen = found;
    let mut axis = LongAxis::towards(seen.centre, seen.opening);
    let mut conic = None;
    for _ in 0..ROUNDS {
        progress.check()?;
        let Some(start) = axis else {
            break;
        };
        conic = Conic::fitted(&start, &seen.wall);
        let Some(fitted) = conic else {
            break;
        };
        let Some((tip, radius)) = fitted.tip_and_radius() else {
            break;
        };
        // The middle of the sphere of rays, and a little towards the base.
        let centre = fitted
            .axis
            .position(Vector3::new(0.0, 0.0, tip + 1.3 * radius));
        let Some(next) = surroundings(sampler, centre, most) else {
            break;
        };
        let up = fitted.axis.up();
        // The apex is where there is more of a wall.
        let [base, apex] = [up, -up].map(|towards| wall_towards(sampler, centre, towards));
        axis = LongAxis::towards(centre, if base > apex { -up } else { up });
        seen = next;
    }
    Ok(conic)
}
