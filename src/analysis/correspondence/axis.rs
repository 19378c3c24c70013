//! The long axis of a ventricle at one instant, from the form of its surfaces.

use crate::mesh::{Point3, Vector3, mean_point};

use super::TargetError;
use super::target_surface::TargetSurface;

/// Share of the depth, from the tip on, whose surface says where the apex is, each place by how deep it lies in it: a
/// single vertex would move with the triangles.
const TIP: f64 = 0.2;
/// Rounds in which the direction settles; it turns by a tenth of the turn before.
const ROUNDS: usize = 8;

/// Where the ventricle lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct VentricleAxis {
    /// The middle of the opening.
    pub base: Point3,
    /// Unit direction from the base to the apex.
    pub down: Vector3,
    /// Unit direction to the middle of the septum, perpendicular to the axis.
    pub septal: Vector3,
    /// Unit direction to the middle of the anterior wall, perpendicular to both.
    pub anterior: Vector3,
}

impl VentricleAxis {
    /// Of the surface with the opening and the one with the tip, which may be one; `towards` is a direction that
    /// becomes the septal one.
    pub fn found(
        opening: &TargetSurface,
        tip: &TargetSurface,
        towards: Option<Vector3>,
    ) -> Result<Self, TargetError> {
        let rim = opening.rim();
        let base = loop_centre(&rim).ok_or(TargetError::NoAxis)?;
        let parts = parts(tip);
        let whole: f64 = parts.iter().map(|(_, area)| area).sum();
        let centroid: Vector3 = (parts.iter())
            .map(|(place, area)| (place - base) * (area / whole))
            .sum();
        let mut down = centroid.try_normalize(0.0).ok_or(TargetError::NoAxis)?;
        for _ in 0..ROUNDS {
            let depths = parts.iter().map(|(place, _)| down.dot(&(place - base)));
            let deepest = depths.fold(0.0_f64, f64::max);
            let from = (1.0 - TIP) * deepest;
            let mut apex = Vector3::zeros();
            let mut weight = 0.0;
            for (place, area) in &parts {
                let share = area * (down.dot(&(place - base)) - from).max(0.0);
                apex += (place - base) * share;
                weight += share;
            }
            if weight <= 0.0 {
                return Err(TargetError::NoAxis);
            }
            down = (apex / weight)
                .try_normalize(0.0)
                .ok_or(TargetError::NoAxis)?;
        }
        let towards = towards.unwrap_or_else(|| rim[0] - base);
        Self::oriented(base, down, towards).ok_or(TargetError::NoAxis)
    }

    /// With the septum as far in a direction as it can be.
    pub fn oriented(base: Point3, down: Vector3, towards: Vector3) -> Option<Self> {
        let across = towards - down * down.dot(&towards);
        let septal = across.try_normalize(1e-9 * towards.norm())?;
        Some(Self {
            base,
            down,
            septal,
            // Seen from the base, the anterior wall is a quarter turn from the septum on, as in the body.
            anterior: septal.cross(&down),
        })
    }

    /// The same with the septum turned around the axis, towards the anterior wall.
    pub fn turned(&self, by_rad: f64) -> Self {
        let septal = self.direction(by_rad);
        Self {
            septal,
            anterior: septal.cross(&self.down),
            ..*self
        }
    }

    /// Unit direction at an angle from the septum towards the anterior wall.
    pub fn direction(&self, angle_rad: f64) -> Vector3 {
        let (sin, cos) = angle_rad.sin_cos();
        self.septal * cos + self.anterior * sin
    }

    /// How far a point lies from the base towards the apex.
    pub fn depth(&self, point: &Point3) -> f64 {
        self.down.dot(&(point - self.base))
    }

    /// Where the axis leaves a surface; where it lies beside it, the deepest point.
    pub fn apex_of(&self, surface: &TargetSurface) -> Point3 {
        let deepest = || {
            let by_depth = |a: &&Point3, b: &&Point3| self.depth(a).total_cmp(&self.depth(b));
            (surface.vertices().iter().max_by(by_depth)).map_or(self.base, |p| *p)
        };
        (surface.last_hit(self.base, self.down)).unwrap_or_else(deepest)
    }
}

/// Centroids of faces with their areas.
fn parts(surface: &TargetSurface) -> Vec<(Point3, f64)> {
    let corners = |t: &[u32; 3]| t.map(|v| surface.vertices()[v as usize]);
    let part = |t: &[u32; 3]| {
        let [a, b, c] = corners(t);
        let area = 0.5 * (b - a).cross(&(c - a)).norm();
        (mean_point([a, b, c].into_iter()), area)
    };
    surface.triangles().iter().map(part).collect()
}

/// The mean of a closed chain by length; `None` without any.
fn loop_centre(rim: &[Point3]) -> Option<Point3> {
    let mut sum = Vector3::zeros();
    let mut whole = 0.0;
    for (index, from) in rim.iter().enumerate() {
        let to = rim[(index + 1) % rim.len()];
        let length = (to - from).norm();
        // By length, so that a rim sampled more densely on one side keeps its centre.
        sum += 0.5 * length * (from.coords + to.coords);
        whole += length;
    }
    (whole > 0.0).then(|| Point3::from(sum / whole))
}
