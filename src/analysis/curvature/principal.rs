//! The two principal curvatures at a vertex, and what follows from them.

use std::f64::consts::{FRAC_1_PI, SQRT_2};

use crate::mesh::Vector3;

/// How a surface bends at one vertex. Curvatures are in 1/mm where coordinates are millimetres, positive where the surface
/// bends away from its outward normal, as a sphere does everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Greatest normal curvature k₁.
    pub greatest: f64,
    /// Least normal curvature k₂.
    pub least: f64,
    /// Unit tangent along which the curvature is greatest; that of the least stands at a right angle to it. Where both are
    /// equal, as on a sphere, it is any tangent.
    pub direction: Vector3,
    /// Unit outward normal of the fitted surface.
    pub normal: Vector3,
}

impl Curvature {
    /// Mean curvature H = (k₁ + k₂) / 2.
    pub fn mean(&self) -> f64 {
        0.5 * (self.greatest + self.least)
    }

    /// Gaussian curvature K = k₁ k₂, in 1/mm².
    pub fn gaussian(&self) -> f64 {
        self.greatest * self.least
    }

    /// Shape index s = 2/π · atan((k₁ + k₂) / (k₁ − k₂)), from −1 (cup) over 0 (saddle) to 1 (cap); `None` where the surface is
    /// flat, which has no shape.
    ///
    /// Source: J. J. Koenderink and A. J. van Doorn (1992), Image and Vision Computing 10(8), 557–564.
    pub fn shape_index(&self) -> Option<f64> {
        let (sum, difference) = (self.greatest + self.least, self.greatest - self.least);
        if sum == 0.0 && difference == 0.0 {
            return None;
        }
        Some(2.0 * FRAC_1_PI * sum.atan2(difference))
    }

    /// Curvedness c = √((k₁² + k₂²) / 2): how much it bends, in whatever shape. The text prints it without the root, which
    /// is no curvature.
    pub fn curvedness(&self) -> f64 {
        self.greatest.hypot(self.least) / SQRT_2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(greatest: f64, least: f64) -> Curvature {
        Curvature {
            greatest,
            least,
            direction: Vector3::x(),
            normal: Vector3::z(),
        }
    }

    #[test]
    fn shapes_have_their_index() {
        let index = |a, b| of(a, b).shape_index();
        assert_eq!(index(1.0, 1.0), Some(1.0));
        assert_eq!(index(-1.0, -1.0), Some(-1.0));
        assert_eq!(index(1.0, -1.0), Some(0.0));
        assert_eq!(index(1.0, 0.0), Some(0.5));
        assert_eq!(index(0.0, -1.0), Some(-0.5));
        assert_eq!(index(0.0, 0.0), None);
    }

    #[test]
    fn curvedness_is_a_curvature() {
        assert!((of(3.0, 3.0).curvedness() - 3.0).abs() < 1e-15);
        assert!((of(2.0, 1.0).curvedness() - 2.5_f64.sqrt()).abs() < 1e-15);
        assert_eq!(of(2.0, 1.0).gaussian(), 2.0);
        assert_eq!(of(2.0, 1.0).mean(), 1.5);
    }
}
