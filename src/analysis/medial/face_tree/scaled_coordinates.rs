//! Coordinates that fit into 32 bits.

use crate::mesh::Point3;

/// Coordinates about the middle of all points, in units of their extent.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaledCoordinates {
    pub middle: Point3,
    /// One over the extent.
    pub scale: f64,
}

impl ScaledCoordinates {
    pub fn new(points: &[Point3]) -> Self {
        let first = points.first().copied().unwrap_or_default();
        let (low, high) = (points.iter()).fold((first, first), |(low, high), point| {
            (low.inf(point), high.sup(point))
        });
        let extent = (high - low).amax();
        Self {
            middle: low + 0.5 * (high - low),
            // A single point has no extent, and needs no scale.
            scale: if extent > 0.0 { extent.recip() } else { 1.0 },
        }
    }

    pub fn of(&self, point: Point3) -> Point3 {
        Point3::from(self.scale * (point - self.middle))
    }
}

/// The least number of 32 bits that is not below.
pub(super) fn above(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) < value {
        near.next_up()
    } else {
        near
    }
}
