//! Rigid motion between corresponding points of which some count more than others.

use nalgebra::{Matrix3, Vector3};

use crate::analysis::alignment::{RigidMotion, rotation_from_covariance};
use crate::mesh::Point3;

/// Why weighted points cannot be aligned.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum WeightsError {
    /// Points and weights must correspond one to one.
    #[error("{source_count} points, {target_count} points and {weights} weights do not correspond")]
    CountMismatch {
        /// Points to move.
        source_count: usize,
        /// Points to move them onto.
        target_count: usize,
        /// Weights.
        weights: usize,
    },
    /// A weight is negative or no finite number.
    #[error("weight {} is {value}, but weights are finite and not negative", .index + 1)]
    Weight {
        /// Which.
        index: usize,
        /// What it is.
        value: f64,
    },
    /// All weights are 0, or there are none.
    #[error("the weights sum to 0: there is nothing to align")]
    NoWeight,
}

/// Rigid motion minimising Σᵢ wᵢ ‖R sᵢ + t − tᵢ‖², for corresponding points.
///
/// As [`rigid_motion`](crate::analysis::alignment::rigid_motion), with weighted means and
/// Σ = Σᵢ wᵢ (tᵢ − t̄)(sᵢ − s̄)ᵀ. A point of weight 0 counts as if it were not there.
///
/// Source: Kabsch (1976), Acta Cryst. A32, 922–923, with the rotation of Umeyama (1991), IEEE TPAMI 13(4), eq. 40.
///
/// # Errors
/// If counts differ, a weight is negative or not finite, or all are 0.
pub fn weighted_rigid_motion(
    source: &[Point3],
    target: &[Point3],
    weights: &[f64],
) -> Result<RigidMotion, WeightsError> {
    if source.len() != target.len() || source.len() != weights.len() {
        return Err(WeightsError::CountMismatch {
            source_count: source.len(),
            target_count: target.len(),
            weights: weights.len(),
        });
    }
    let unusable = |weight: &f64| !(weight.is_finite() && *weight >= 0.0);
    if let Some(index) = weights.iter().position(unusable) {
        return Err(WeightsError::Weight {
            index,
            value: weights[index],
        });
    }
    // Relative to the greatest, so that their sum does not overflow.
    let greatest = weights.iter().fold(0.0_f64, |m, &w| m.max(w));
    if greatest == 0.0 {
        return Err(WeightsError::NoWeight);
    }
    let shares: Vec<f64> = weights.iter().map(|w| w / greatest).collect();
    let total: f64 = shares.iter().sum();
    let [source_mean, target_mean] = [source, target].map(|points| {
        let weighted = points.iter().zip(&shares).map(|(p, &w)| w * p.coords);
        weighted.sum::<Vector3<f64>>() / total
    });
    let covariance: Matrix3<f64> = (source.iter().zip(target).zip(&shares))
        .map(|((s, t), &w)| w * (t.coords - target_mean) * (s.coords - source_mean).transpose())
        .sum();
    let (rotation, _) = rotation_from_covariance(&covariance);
    Ok(RigidMotion {
        rotation,
        translation: target_mean - rotation * source_mean,
    })
}
