//! In which slice of a volume each contour lies, and where within it.

use super::{ContourError, ContourName};
use crate::image::{Contour, ContourPart, VolumeFrame};

/// A contour in its slice.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub instant: usize,
    pub part: ContourPart,
    pub slice: usize,
    /// Corners in voxels along the two axes within the slices; whole numbers are the centres of voxels.
    pub corners: Vec<[f64; 2]>,
}

/// Contours in their slices.
#[derive(Clone, Debug)]
pub(super) struct Placing {
    /// Axes of the volume: two within the slices, and the one across them.
    pub axes: [usize; 3],
    pub contours: Vec<Placed>,
}

/// A contour may stand off the plane of its slice by this share of the distance of slices.
const OFF_SLICE: f64 = 0.25;
/// And by no more than this, in millimetres: thick slices are known as well as thin ones.
const MAX_OFF_MM: f64 = 1.5;
/// Voxels by which a corner may lie outside of the image: an outline along its edge.
const OUTSIDE: f64 = 1.0;

impl Placing {
    /// Puts contours into the slices that they lie in.
    ///
    /// # Errors
    /// If there is none, or one that encloses no area, is oblique, lies between slices or outside of the image.
    pub(super) fn of(
        frame: &VolumeFrame,
        instants: usize,
        contours: &[Contour],
    ) -> Result<Self, ContourError> {
        if contours.is_empty() {
            return Err(ContourError::Empty);
        }
        let mut voxels = Vec::with_capacity(contours.len());
        for (place, contour) in contours.iter().enumerate() {
            let which = ContourName::of(place, contour);
            if contour.instant >= instants {
                return Err(ContourError::Instant { which, instants });
            }
            let corners: Vec<[f64; 3]> = (contour.points.iter())
                .map(|&point| frame.voxel(point).coords.into())
                .collect();
            if corners.len() < 3 || !corners.iter().flatten().all(|x| x.is_finite()) {
                return Err(ContourError::NoArea(which));
            }
            voxels.push((which, corners));
        }
        let across = axis_across(frame, &voxels);
        let axes = [(across + 1) % 3, (across + 2) % 3, across];
        let placed =
            (voxels.into_iter()).map(|(which, corners)| placed(frame, axes, which, &corners));
        Ok(Self {
            axes,
            contours: placed.collect::<Result<_, _>>()?,
        })
    }
}

/// Distance of neighbouring planes of voxels across each axis.
pub(super) fn plane_distances_mm(frame: &VolumeFrame) -> [f64; 3] {
    let steps = frame.steps();
    [0, 1, 2].map(|axis| {
        let side = steps[(axis + 1) % 3].cross(&steps[(axis + 2) % 3]).norm();
        frame.voxel_mm3() / side
    })
}

/// From the least to the greatest coordinate along an axis.
fn extent(corners: &[[f64; 3]], axis: usize) -> [f64; 2] {
    let places = corners.iter().map(|corner| corner[axis]);
    [
        places.clone().fold(f64::INFINITY, f64::min),
        places.fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// The axis along which the contours reach the least: nearly always k.
fn axis_across(frame: &VolumeFrame, contours: &[(ContourName, Vec<[f64; 3]>)]) -> usize {
    let distances = plane_distances_mm(frame);
    let reach = [0, 1, 2].map(|axis| {
        let extents = contours.iter().map(|(_, corners)| {
            let [low, high] = extent(corners, axis);
            (high - low) * distances[axis]
        });
        extents.sum::<f64>()
    });
    (0..3).rev().fold(2, |best, axis| {
        if reach[axis] < reach[best] {
            axis
        } else {
            best
        }
    })
}

fn placed(
    frame: &VolumeFrame,
    [u, v, across]: [usize; 3],
    which: ContourName,
    corners: &[[f64; 3]],
) -> Result<Placed, ContourError> {
    let step_mm = plane_distances_mm(frame)[across];
    let max_mm = MAX_OFF_MM.min(OFF_SLICE * step_mm);
    let [low, high] = extent(corners, across);
    let off_mm = (high - low) * step_mm;
    if off_mm > 2.0 * max_mm {
        return Err(ContourError::Oblique { which, off_mm });
    }
    let middle = 0.5 * (low + high);
    let slice = middle.round();
    let size = frame.size();
    if slice < 0.0 || slice >= size[across] as f64 {
        return Err(ContourError::Outside(which));
    }
    let off_mm = (middle - slice).abs() * step_mm;
    if off_mm > max_mm {
        return Err(ContourError::BetweenSlices {
            which,
            off_mm,
            step_mm,
        });
    }
    let outside = [u, v].into_iter().any(|axis| {
        let [low, high] = extent(corners, axis);
        low < -0.5 - OUTSIDE || high > size[axis] as f64 - 0.5 + OUTSIDE
    });
    if outside {
        return Err(ContourError::Outside(which));
    }
    let corners: Vec<[f64; 2]> = corners.iter().map(|c| [c[u], c[v]]).collect();
    if area(&corners).abs() < 1e-6 {
        return Err(ContourError::NoArea(which));
    }
    Ok(Placed {
        instant: which.instant,
        part: which.part,
        slice: slice as usize,
        corners,
    })
}

/// Signed area of a polygon, relative to its first corner so that its place loses no digits.
pub(super) fn area(corners: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = corners.first() else {
        return 0.0;
    };
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let twice: f64 = edges
        .map(|(a, b)| (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y))
        .sum();
    0.5 * twice
}
