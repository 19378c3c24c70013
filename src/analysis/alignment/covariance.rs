//! From the cross-covariance of two point sets to the rotation between them.

use nalgebra::{Matrix3, SVD, Vector3};

/// Σᵢ (tᵢ − t̄)(sᵢ − s̄)ᵀ of coordinates given axis by axis, one entry per point.
///
/// Lanes are summed in a fixed order, so the bits are always the same.
pub fn cross_covariance(
    source: [&[f64]; 3],
    source_mean: Vector3<f64>,
    target: [&[f64]; 3],
    target_mean: Vector3<f64>,
) -> Matrix3<f64> {
    // Four doubles fill a 256-bit register.
    const LANES: usize = 4;
    let mut sums = [[0.0; LANES]; 9];
    let count = source[0].len().min(target[0].len());
    // The remainder is added below, point by point.
    let whole = count - count % LANES;
    for at in (0..whole).step_by(LANES) {
        // Centred before multiplying: Σ t sᵀ − n t̄ s̄ᵀ would cancel far from the origin.
        let s = [0, 1, 2].map(|axis| centred::<LANES>(source[axis], at, source_mean[axis]));
        let t = [0, 1, 2].map(|axis| centred::<LANES>(target[axis], at, target_mean[axis]));
        for row in 0..3 {
            for column in 0..3 {
                for lane in 0..LANES {
                    sums[3 * row + column][lane] += t[row][lane] * s[column][lane];
                }
            }
        }
    }
    let mut covariance = Matrix3::from_fn(|row, column| sums[3 * row + column].iter().sum::<f64>());
    for at in whole..count {
        let pick = |axes: [&[f64]; 3]| Vector3::new(axes[0][at], axes[1][at], axes[2][at]);
        covariance += (pick(target) - target_mean) * (pick(source) - source_mean).transpose();
    }
    covariance
}

fn centred<const N: usize>(axis: &[f64], at: usize, mean: f64) -> [f64; N] {
    let mut lanes = [0.0; N];
    for (lane, value) in lanes.iter_mut().zip(&axis[at..at + N]) {
        *lane = value - mean;
    }
    lanes
}

/// The rotation R that maximises tr(Rᵀ Σ), and tr(S D): the sum of the singular values, the last
/// one negative if R would have been a reflection.
///
/// With Σ = U D Vᵀ, R = U S Vᵀ, S = diag(1, 1, det U · det V). Where points lie on a line or
/// coincide R is not unique, and one of the best is returned; the identity if Σ is zero or not
/// finite.
///
/// Source: Umeyama (1991), IEEE TPAMI 13(4), eqs. 39–43.
pub fn rotation_from_covariance(covariance: &Matrix3<f64>) -> (Matrix3<f64>, f64) {
    // The scale does not matter for R, and keeps very large or small inputs from over- and underflow.
    let scale = covariance.amax();
    if !(scale.is_finite() && scale > 0.0) {
        return (Matrix3::identity(), 0.0);
    }
    let svd = SVD::new(covariance / scale, true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else {
        return (Matrix3::identity(), 0.0);
    };
    let values = svd.singular_values;
    let least = values.imin();
    let mut signs = Vector3::repeat(1.0);
    if u.determinant() * v_t.determinant() < 0.0 {
        // A reflection would fit better; taking it back along the smallest singular value costs the least.
        signs[least] = -1.0;
    }
    let rotation = u * Matrix3::from_diagonal(&signs) * v_t;
    (rotation, scale * values.dot(&signs))
}
