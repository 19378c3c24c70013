//! The rigid-body part of a field, and what is left without it (2.3.7).

use nalgebra::{Matrix3, SymmetricEigen};

use crate::mesh::{Point3, Vector3};

/// The field p ↦ k₁ + k₂ × p of an infinitesimal rigid motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidField {
    /// Velocity of the origin.
    pub k1: Vector3,
    /// Angular velocity.
    pub k2: Vector3,
}

impl RigidField {
    /// The field at a point.
    pub fn at(&self, point: &Point3) -> Vector3 {
        self.k1 + self.k2.cross(&point.coords)
    }
}

/// The rigid field nearest to X: minimises Σ_p w_p ‖X_p − k₁ − k₂ × p‖².
///
/// With p' = p − p̄ and J = Σ w (|p'|² 1 − p' p'ᵀ): k₂ = J⁻¹ Σ w p' × X and k₁ = X̄ − k₂ × p̄.
/// Where J is singular (points on a line) the turn about that line is left out.
///
/// Source: V. Taimouri, section 2.3.7, solved by the inertia tensor.
pub fn rigid_part(points: &[Point3], weights: &[f64], field: &[Vector3]) -> RigidField {
    let weighted = points.iter().map(|p| p.coords).zip(weights.iter().copied());
    let moments = Moments::of(weighted);
    let (mut momentum, mut torque) = (Vector3::zeros(), Vector3::zeros());
    for ((point, &weight), x) in points.iter().zip(weights).zip(field) {
        momentum += x * weight;
        torque += (point.coords - moments.centre).cross(x) * weight;
    }
    moments.motion(momentum, torque)
}

/// What [`rigid_part`] needs of points and weights alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments {
    total: f64,
    pub centre: Vector3,
    /// J⁻¹, without axes about which nothing has a moment.
    inverse: Matrix3<f64>,
}

impl Moments {
    pub fn of(weighted: impl Iterator<Item = (Vector3, f64)> + Clone) -> Self {
        let (mut total, mut sum) = (0.0, Vector3::zeros());
        for (point, weight) in weighted.clone() {
            total += weight;
            sum += point * weight;
        }
        // Without weight there is nothing that a motion could explain.
        if total.is_nan() || total <= 0.0 {
            return Self {
                total: 0.0,
                centre: Vector3::zeros(),
                inverse: Matrix3::zeros(),
            };
        }
        // About the centroid the equations for translation and rotation separate.
        let centre = sum / total;
        let mut inertia = Matrix3::zeros();
        for (point, weight) in weighted {
            let arm = point - centre;
            inertia += (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * weight;
        }
        let eigen = SymmetricEigen::new(inertia);
        // Round-off of the sum is some 1e-15 of the largest moment.
        let least = 1e-13 * eigen.eigenvalues.amax();
        let inverse = (0..3)
            // Points on a line have no moment about it: that rotation moves none of them.
            .filter(|&k| eigen.eigenvalues[k] > least)
            .map(|k| {
                let axis: Vector3 = eigen.eigenvectors.column(k).into();
                axis * axis.transpose() / eigen.eigenvalues[k]
            })
            .sum();
        Self {
            total,
            centre,
            inverse,
        }
    }

    /// Σ w |rigid part of X|², from Σ w X and Σ w (p − p̄) × X: |Σ w X|² / Σ w + τᵀ J⁻¹ τ.
    pub fn energy(&self, momentum: Vector3, torque: Vector3) -> f64 {
        let drift = match self.total > 0.0 {
            true => momentum.norm_squared() / self.total,
            false => 0.0,
        };
        drift + torque.dot(&(self.inverse * torque))
    }

    /// The rigid field of Σ w X and Σ w (p − p̄) × X.
    pub fn motion(&self, momentum: Vector3, torque: Vector3) -> RigidField {
        let drift = match self.total > 0.0 {
            true => momentum / self.total,
            false => Vector3::zeros(),
        };
        let k2 = self.inverse * torque;
        RigidField {
            // Back from the centroid to the origin, about which a field is written.
            k1: drift - k2.cross(&self.centre),
            k2,
        }
    }
}

/// Σ_p w_p X'_p·Y'_p with X', Y' without their own rigid parts.
pub(super) fn rigid_product(
    points: &[Point3],
    weights: &[f64],
    x: &[Vector3],
    y: &[Vector3],
) -> f64 {
    let (rigid_x, rigid_y) = (
        rigid_part(points, weights, x),
        rigid_part(points, weights, y),
    );
    (points.iter().zip(weights).zip(x.iter().zip(y)))
        .map(|((p, w), (x, y))| w * (x - rigid_x.at(p)).dot(&(y - rigid_y.at(p))))
        .sum()
}
