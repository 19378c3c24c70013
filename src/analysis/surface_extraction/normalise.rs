//! Coordinates of a sequence in a box of side 1 around the origin.

use crate::mesh::{Point3, bounding_box, mean_point};

/// Which point becomes the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Centre {
    /// The mean of the points.
    Mean,
    /// The middle of their box.
    Box,
}

/// x ↦ (x − c) / s, the same for all frames of a sequence so that its motion stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normalisation {
    /// c.
    pub centre: Point3,
    /// s, the largest side of the box along the axes: one for all axes, so that shapes stay.
    pub largest_side: f64,
}

impl Normalisation {
    /// For the points of all frames of a sequence together.
    ///
    /// `None` without points, and where all coincide or their extent is not finite.
    pub fn of_sequence(frames: &[&[Point3]], centre: Centre) -> Option<Self> {
        let [low, high] = bounding_box(frames.iter().copied().flatten())?;
        let largest_side = (high - low).max();
        // A box takes no note of NaN.
        let all = frames.iter().copied().flatten().flat_map(|p| p.iter());
        let is_usable = all.copied().all(f64::is_finite) && largest_side > 0.0;
        let centre = match centre {
            Centre::Mean => mean_point(frames.concat().into_iter()),
            Centre::Box => nalgebra::center(&low, &high),
        };
        let is_usable = is_usable && largest_side.is_finite();
        (is_usable && centre.iter().all(|x| x.is_finite())).then_some(Self {
            centre,
            largest_side,
        })
    }

    /// The point in the box.
    pub fn apply(&self, point: &Point3) -> Point3 {
        Point3::from((point - self.centre) / self.largest_side)
    }

    /// The point back where it was.
    pub fn restored(&self, point: &Point3) -> Point3 {
        self.centre + point.coords * self.largest_side
    }
}
