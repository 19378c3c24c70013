//! The grid on which contours stand that come without an image.

use super::ContourError;
use crate::image::{Contour, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// Voxels within slices, in millimetres; masks divide them further.
const PIXEL_MM: f64 = 1.0;
/// Millimetres around the contours.
const MARGIN_MM: f64 = 3.0;
/// Planes nearer than this are one: corners of files are rounded.
const SAME_PLANE_MM: f64 = 0.5;
/// A plane may stand off its place by this share of the distance of planes.
const UNEVEN: f64 = 0.1;
/// Cosine of the greatest angle between the planes of two contours: 5°.
const PARALLEL: f64 = 0.996;
/// Voxels along an axis; a heart has less than 200.
const MOST: f64 = 2048.0;

/// A grid for contours in parallel planes at even distances, of which some may be missing: slices are its last axis.
///
/// # Errors
/// If there is no contour, one encloses no area, or the planes are not parallel, not at even distances, or only one.
pub fn stack_of_contours(contours: &[Contour]) -> Result<VolumeFrame, ContourError> {
    let mut planes = contours.iter().map(Flat::of);
    let first = planes.next().ok_or(ContourError::Empty)??;
    let normal = first.normal;
    let mut heights = vec![first.middle.dot(&normal)];
    for plane in planes {
        let plane = plane?;
        if plane.normal.dot(&normal).abs() < PARALLEL {
            return Err(no_stack("the contours do not lie in parallel planes"));
        }
        heights.push(plane.middle.dot(&normal));
    }
    let (lowest, step, slices) = even(&mut heights)?;
    let [u, v] = axes_within(normal);
    let corners = || contours.iter().flat_map(|contour| &contour.points);
    let range = |axis: Vector3| {
        let along = corners().map(|point| point.coords.dot(&axis));
        let low = along.clone().fold(f64::INFINITY, f64::min) - MARGIN_MM;
        let high = along.fold(f64::NEG_INFINITY, f64::max) + MARGIN_MM;
        (low, ((high - low) / PIXEL_MM).ceil() + 1.0)
    };
    let [(low_u, size_u), (low_v, size_v)] = [range(u), range(v)];
    if [size_u, size_v, slices].iter().any(|size| *size > MOST) {
        return Err(no_stack(
            "the contours reach over more than two metres, or their planes lie too close",
        ));
    }
    let origin = Point3::from(u * low_u + v * low_v + normal * lowest);
    let size = [size_u, size_v, slices].map(|size| size as usize);
    let steps = [u * PIXEL_MM, v * PIXEL_MM, normal * step];
    Ok(VolumeFrame::new(size, origin, steps)?)
}

fn no_stack(reason: impl Into<String>) -> ContourError {
    ContourError::NoStack(reason.into())
}

/// The plane of a contour.
struct Flat {
    middle: Vector3,
    normal: Vector3,
}

impl Flat {
    /// The normal is that of the polygon's area vector (Newell).
    fn of(contour: &Contour) -> Result<Self, ContourError> {
        let points = &contour.points;
        let sum: Vector3 = points.iter().map(|point| point.coords).sum();
        let middle = sum / points.len().max(1) as f64;
        let edges = points.iter().zip(points.iter().cycle().skip(1));
        let area: Vector3 = edges
            .map(|(a, b)| (a.coords - middle).cross(&(b.coords - middle)))
            .sum();
        let normal = area.try_normalize(1e-6).filter(|n| n.norm().is_finite());
        let normal = normal.ok_or_else(|| no_stack("a contour encloses no area"))?;
        Ok(Self { middle, normal })
    }
}

/// The lowest plane, the distance of planes, and how many there are with those that are missing.
fn even(heights: &mut Vec<f64>) -> Result<(f64, f64, f64), ContourError> {
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|next, kept| *next - *kept < SAME_PLANE_MM);
    let gaps = heights.windows(2).map(|pair| pair[1] - pair[0]);
    let smallest = gaps.fold(f64::INFINITY, f64::min);
    let [Some(&low), Some(&high)] = [heights.first(), heights.last()] else {
        return Err(ContourError::Empty);
    };
    if !smallest.is_finite() {
        return Err(no_stack(
            "all contours lie in one plane: the distance of slices is not known without an image",
        ));
    }
    // The whole height says the distance best.
    let count = ((high - low) / smallest).round();
    let step = (high - low) / count;
    let off = |height: f64| {
        let place = (height - low) / step;
        (place - place.round()).abs()
    };
    if heights.iter().any(|&height| off(height) > UNEVEN) {
        return Err(no_stack(format!(
            "the planes of the contours do not stand at even distances ({smallest:.1} mm is the smallest)"
        )));
    }
    Ok((low, step, count + 1.0))
}

/// Two directions of length 1 across a normal and each other.
fn axes_within(normal: Vector3) -> [Vector3; 2] {
    let least = normal.iamin();
    let mut axis = Vector3::zeros();
    axis[least] = 1.0;
    let u = normal.cross(&axis).normalize();
    [u, normal.cross(&u)]
}
