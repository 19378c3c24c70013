//! The ways an object is deformed, none of which keeps angles.

use crate::mesh::Point3;

use super::objects::Solid;

/// A class of deformations; amplitude and object vary within it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Motion {
    /// The long axis becomes an arc.
    Bend,
    /// Sections across the long axis turn against each other.
    Twist,
    /// The long axis grows, the sections shrink, the volume stays.
    Stretch,
    /// A part of the upper side rises; the rest is still.
    Bump,
}

impl Motion {
    /// All classes, in the order of their numbers.
    pub const ALL: [Self; 4] = [Self::Bend, Self::Twist, Self::Stretch, Self::Bump];

    /// What tables and labels call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bend => "bend",
            Self::Twist => "twist",
            Self::Stretch => "stretch",
            Self::Bump => "bump",
        }
    }

    /// The amplitude at which a member of the class ends, before jitter: curvature of the arc,
    /// turn per length in radians, growth of the long axis, height of the bump.
    pub fn typical_amplitude(self, solid: Solid) -> f64 {
        match (self, solid) {
            (Self::Bend, Solid::Sphere) => 1.0,
            (Self::Bend, Solid::Torus) => 0.75,
            (Self::Twist, Solid::Sphere) => 1.2,
            (Self::Twist, Solid::Torus) => 0.7,
            (Self::Stretch, _) => 0.5,
            (Self::Bump, _) => 0.8,
        }
    }

    /// Where a point of the undeformed object lies at an amplitude; 0 leaves it in place.
    ///
    /// With x along the long axis and κ, τ, s, h the amplitude:
    /// bend x' = (1/κ − z) sin κx, z' = 1/κ − (1/κ − z) cos κx; twist turns (y, z) by τx;
    /// stretch (1 + s) x, (y, z) / √(1 + s); bump z' = z + h exp(−|p − c|² / 2b²) about a place c
    /// of the upper side, b = 0.6.
    pub fn moved(self, solid: Solid, point: &Point3, amplitude: f64) -> Point3 {
        let [x, y, z] = [point.x, point.y, point.z];
        match self {
            // Below this curvature the arc differs from the straight line by round-off only.
            Self::Bend if amplitude.abs() < 1e-12 => *point,
            Self::Bend => {
                let radius = 1.0 / amplitude;
                let (sin, cos) = (amplitude * x).sin_cos();
                // The line y = z = 0 keeps its length: bending is no stretch along the middle.
                Point3::new((radius - z) * sin, y, radius - (radius - z) * cos)
            }
            Self::Twist => {
                let (sin, cos) = (amplitude * x).sin_cos();
                Point3::new(x, cos * y - sin * z, sin * y + cos * z)
            }
            Self::Stretch => {
                // Narrower as it gets longer: the volume stays, so that volume alone tells no class.
                let across = 1.0 / (1.0 + amplitude).sqrt();
                Point3::new((1.0 + amplitude) * x, across * y, across * z)
            }
            Self::Bump => {
                let centre = match solid {
                    Solid::Sphere => Point3::new(0.0, 0.0, 1.0),
                    Solid::Torus => Point3::new(0.0, 1.0, 0.4),
                };
                let width = 0.6_f64;
                let height = (-(point - centre).norm_squared() / (2.0 * width * width)).exp();
                Point3::new(x, y, z + amplitude * height)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::experiments::objects::{Fineness, ObjectKind, object};
    use crate::mesh::signed_volume;

    #[test]
    fn no_amplitude_is_no_motion_and_a_stretch_keeps_the_volume() {
        let kind = ObjectKind::ALL[0];
        let mesh = object(kind, Fineness::Coarse);
        for motion in Motion::ALL {
            for point in mesh.vertices() {
                let same = motion.moved(kind.solid, point, 0.0);
                assert!((same - point).norm() < 1e-15, "{}", motion.name());
            }
        }
        let stretched: Vec<Point3> = (mesh.vertices().iter())
            .map(|p| Motion::Stretch.moved(kind.solid, p, 0.7))
            .collect();
        let volume = |points: &[Point3]| {
            let corners = mesh.triangles().iter();
            let triangles = corners.map(|face| face.map(|v| points[v as usize]));
            signed_volume(triangles, Point3::origin())
        };
        assert!((volume(&stretched) / volume(mesh.vertices()) - 1.0).abs() < 1e-12);
    }
}
