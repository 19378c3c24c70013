//! Rigid motion and similarity between corresponding points, in closed form.

use nalgebra::{Matrix3, Vector3};

use crate::mesh::{Point3, mean_point};

use super::{cross_covariance, rotation_from_covariance};

/// The rigid motion x ↦ R x + t that maps source coordinates to target coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion {
    /// R, with determinant +1.
    pub rotation: Matrix3<f64>,
    /// t, in the length unit of the coordinates.
    pub translation: Vector3<f64>,
}

/// The similarity x ↦ c R x + t that maps source coordinates to target coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Similarity {
    /// c, positive or zero.
    pub scale: f64,
    /// R, with determinant +1.
    pub rotation: Matrix3<f64>,
    /// t, in the length unit of the coordinates.
    pub translation: Vector3<f64>,
}

/// Why points cannot be aligned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AlignmentError {
    /// Points must correspond one to one.
    #[error("{source_count} points cannot correspond with {target_count}")]
    CountMismatch {
        /// Points to move.
        source_count: usize,
        /// Points to move them onto.
        target_count: usize,
    },
    /// There is nothing to align.
    #[error("there are no points to align")]
    NoPoints,
    /// A scale needs source points that do not all coincide.
    #[error("{count} coinciding points have no size to scale")]
    NoSize {
        /// Points to move.
        count: usize,
    },
}

impl RigidMotion {
    /// The motion that leaves everything in place.
    pub fn identity() -> Self {
        Self {
            rotation: Matrix3::identity(),
            translation: Vector3::zeros(),
        }
    }

    /// The point after the motion.
    pub fn apply(&self, point: &Point3) -> Point3 {
        Point3::from(self.rotation * point.coords + self.translation)
    }

    /// The motion back.
    pub fn inverse(&self) -> Self {
        // The inverse of a rotation, without the round-off of inverting a matrix.
        let rotation = self.rotation.transpose();
        Self {
            rotation,
            translation: -(rotation * self.translation),
        }
    }

    /// First `self`, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        Self {
            rotation: next.rotation * self.rotation,
            translation: next.rotation * self.translation + next.translation,
        }
    }
}

impl Similarity {
    /// The point after the similarity.
    pub fn apply(&self, point: &Point3) -> Point3 {
        Point3::from(self.scale * (self.rotation * point.coords) + self.translation)
    }
}

/// Rigid motion minimising Σᵢ ‖R sᵢ + t − tᵢ‖², for corresponding points.
///
/// With Σ = Σᵢ (tᵢ − t̄)(sᵢ − s̄)ᵀ = U D Vᵀ,
/// R = U S Vᵀ, where S = diag(1, 1, det U · det V) excludes reflections, and t = t̄ − R s̄.
/// Where the points lie on a line or coincide, R is one of several best rotations.
///
/// Source: Umeyama (1991), IEEE TPAMI 13(4), eqs. 38–43, with scale c = 1.
///
/// # Errors
/// If there are no points, or not as many on both sides.
pub fn rigid_motion(source: &[Point3], target: &[Point3]) -> Result<RigidMotion, AlignmentError> {
    let fit = Fit::new(source, target)?;
    Ok(RigidMotion {
        rotation: fit.rotation,
        translation: fit.target_mean - fit.rotation * fit.source_mean,
    })
}

/// Similarity minimising Σᵢ ‖c R sᵢ + t − tᵢ‖², for corresponding points.
///
/// R as in [`rigid_motion`]; c = tr(D S) / Σᵢ ‖sᵢ − s̄‖², t = t̄ − c R s̄.
///
/// Source: Umeyama (1991), IEEE TPAMI 13(4), eqs. 40–42.
///
/// # Errors
/// If there are no points, not as many on both sides, or the source points coincide.
pub fn similarity(source: &[Point3], target: &[Point3]) -> Result<Similarity, AlignmentError> {
    let fit = Fit::new(source, target)?;
    let spread: f64 = source
        .iter()
        .map(|p| (p.coords - fit.source_mean).norm_squared())
        .sum();
    // Coinciding points differ from their mean by round-off of the mean only.
    let roundoff = f64::EPSILON * fit.source_mean.norm();
    if spread <= source.len() as f64 * roundoff * roundoff {
        return Err(AlignmentError::NoSize {
            count: source.len(),
        });
    }
    let scale = fit.trace / spread;
    Ok(Similarity {
        scale,
        rotation: fit.rotation,
        translation: fit.target_mean - scale * (fit.rotation * fit.source_mean),
    })
}

struct Fit {
    rotation: Matrix3<f64>,
    trace: f64,
    source_mean: Vector3<f64>,
    target_mean: Vector3<f64>,
}

impl Fit {
    fn new(source: &[Point3], target: &[Point3]) -> Result<Self, AlignmentError> {
        if source.len() != target.len() {
            return Err(AlignmentError::CountMismatch {
                source_count: source.len(),
                target_count: target.len(),
            });
        }
        if source.is_empty() {
            return Err(AlignmentError::NoPoints);
        }
        let [source_mean, target_mean] =
            [source, target].map(|points| mean_point(points.iter().copied()).coords);
        // Axis by axis, so that the sums run over neighbouring numbers in memory.
        let (s, t) = (axes(source), axes(target));
        let covariance = cross_covariance(
            [&s[0], &s[1], &s[2]],
            source_mean,
            [&t[0], &t[1], &t[2]],
            target_mean,
        );
        let (rotation, trace) = rotation_from_covariance(&covariance);
        Ok(Self {
            rotation,
            trace,
            source_mean,
            target_mean,
        })
    }
}

fn axes(points: &[Point3]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).collect())
}

#[cfg(test)]
mod tests;
