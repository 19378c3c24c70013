//! Means of directions: the normalised average, and the point from which squared angles are least.

use crate::mesh::Vector3;

use super::sphere::{exp, log, unit};

/// Length of the last step of a mean, in radians: some ten times what round-off leaves of it.
const TOLERANCE_RAD: f64 = 1e-14;
/// Steps after which the mean is taken as it is. Each divides the error by at least some five
/// where directions lie within 60°; half around the sphere, 200 still do.
const MAX_STEPS: usize = 200;

/// The normalised average of directions (the ANV of 4.4.1) with the length of the average before it
/// was normalised: 1 where all agree, 0 where they cancel. `None` where they do.
pub fn mean_direction<'a>(
    directions: impl IntoIterator<Item = &'a Vector3>,
) -> Option<(Vector3, f64)> {
    let (sum, count) = (directions.into_iter()).fold((Vector3::zeros(), 0), |(sum, count), d| {
        (sum + d, count + 1)
    });
    let mean = sum / f64::from(count.max(1));
    // Below that the direction is made of round-off.
    let length = mean.norm();
    (length > 1e-12).then(|| (mean / length, length))
}

/// Fréchet mean of weighted unit directions: the point m of least Σ wᵢ angle(m, dᵢ)².
///
/// By m ← Exp_m(Σ wᵢ Log_m(dᵢ) / Σ wᵢ) from the normalised average. It is unique where all lie within
/// a half sphere (Karcher). `None` without positive weight or where the average cancels.
pub fn frechet_mean(directions: &[Vector3], weights: &[f64]) -> Option<Vector3> {
    let total: f64 = weights.iter().sum();
    let pairs = || directions.iter().zip(weights);
    let sum: Vector3 = pairs().map(|(d, &w)| d * w).sum();
    // Directions that cancel have no mean; any answer would be made of round-off.
    if total.is_nan() || total <= 0.0 || sum.norm() <= 1e-12 * total {
        return None;
    }
    // Within a half sphere the average lies in the region where the mean is unique.
    let mut mean = unit(&sum)?;
    for _ in 0..MAX_STEPS {
        let step: Vector3 = pairs().map(|(d, &w)| log(&mean, d).tangent * w).sum();
        let step = step / total;
        // Normalised in every step, or round-off would leave the sphere.
        mean = unit(&exp(&mean, &step))?;
        if step.norm() <= TOLERANCE_RAD {
            break;
        }
    }
    Some(mean)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::medial_space::sphere::angle;

    #[test]
    fn the_mean_of_two_directions_lies_half_way() {
        let (a, b) = (Vector3::x(), Vector3::new(0.0, 0.6, 0.8));
        let mean = frechet_mean(&[a, b], &[1.0, 1.0]).unwrap();
        assert!((mean - (a + b).normalize()).norm() < 1e-14);
        let nearer = frechet_mean(&[a, b], &[3.0, 1.0]).unwrap();
        let quarter = std::f64::consts::FRAC_PI_8;
        assert!((angle(&a, &nearer) - quarter).abs() < 1e-12);
    }

    #[test]
    fn the_mean_is_where_tangents_cancel() {
        let directions: Vec<Vector3> = (0..9)
            .map(f64::from)
            .map(|i| {
                Vector3::new((2.0 * i).sin(), 0.7 * (3.0 * i).cos(), 1.0 + 0.1 * i).normalize()
            })
            .collect();
        let mean = frechet_mean(&directions, &[1.0; 9]).unwrap();
        let pull: Vector3 = directions.iter().map(|d| log(&mean, d).tangent).sum();
        assert!(pull.norm() < 1e-12);
    }

    #[test]
    fn directions_that_cancel_have_no_mean() {
        let opposite = [Vector3::x(), -Vector3::x()];
        assert_eq!(mean_direction(&opposite), None);
        assert_eq!(frechet_mean(&opposite, &[1.0, 1.0]), None);
        assert_eq!(frechet_mean(&[], &[]), None);
        let (mean, length) = mean_direction(&[Vector3::x(), Vector3::y()]).unwrap();
        assert!((mean.x - 0.5_f64.sqrt()).abs() < 1e-15 && (length - 0.5_f64.sqrt()).abs() < 1e-15);
    }
}
