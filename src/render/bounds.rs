//! The box that holds what is drawn.

use glam::Vec3;

use super::{Geometry, Scene};

/// An axis-parallel box in world coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least coordinates.
    pub low: Vec3,
    /// Greatest coordinates.
    pub high: Vec3,
}

impl Bounds {
    /// The smallest box around points; `None` if no point is finite.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        points
            .into_iter()
            .filter(|point| point.is_finite())
            .map(|point| Self {
                low: point,
                high: point,
            })
            .reduce(Self::joined)
    }

    /// The box around a surface at all its poses, so that it does not change while a beat plays.
    pub fn of_geometry(geometry: &Geometry) -> Option<Self> {
        Self::around(geometry.positions.iter().flatten().map(|&p| Vec3::from(p)))
    }

    /// The box around everything in a scene, surfaces at all their poses.
    pub fn of_scene(scene: &Scene) -> Option<Self> {
        let surfaces = scene
            .surfaces
            .iter()
            .filter_map(|surface| Self::of_geometry(&surface.geometry));
        let lines = scene.lines.iter().filter_map(|lines| {
            Self::around(lines.strips.iter().flatten().map(|&point| point.into()))
        });
        let points = scene
            .points
            .iter()
            .filter_map(|points| Self::around(points.positions.iter().map(|&point| point.into())));
        surfaces.chain(lines).chain(points).reduce(Self::joined)
    }

    /// The smallest box around two.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The middle.
    pub fn centre(&self) -> Vec3 {
        0.5 * (self.low + self.high)
    }

    /// Half the diagonal: the radius of a sphere about the middle that holds the box.
    pub fn radius(&self) -> f32 {
        0.5 * (self.high - self.low).length()
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            Vec3::new(
                if i & 1 == 0 { self.low.x } else { self.high.x },
                if i & 2 == 0 { self.low.y } else { self.high.y },
                if i & 4 == 0 { self.low.z } else { self.high.z },
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_holds_its_points_and_ignores_what_is_not_a_number() {
        let points = [
            Vec3::new(1.0, 2.0, 3.0),
            Vec3::new(-1.0, 4.0, 0.0),
            Vec3::NAN,
        ];
        let bounds = Bounds::around(points).unwrap();
        assert_eq!(bounds.low, Vec3::new(-1.0, 2.0, 0.0));
        assert_eq!(bounds.high, Vec3::new(1.0, 4.0, 3.0));
        assert_eq!(Bounds::around([Vec3::NAN]), None);
    }
}
