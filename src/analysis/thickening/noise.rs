//! How much of ln r is noise, estimated from the data themselves.

use super::curve::ThickeningCurve;
use super::neighbours::Neighbours;
use crate::numeric::lower_median;

/// 1 / Φ⁻¹(¾): standard deviation of a normal distribution over its median absolute value.
const NORMAL_FROM_MEDIAN: f64 = 1.482_602_218_505_602;

/// Fewest poses from which noise can be estimated: with four, two numbers per atom are left when
/// its mean and its share of the curve are taken out.
pub(super) const MIN_POSES: usize = 4;

/// Standard deviation of the noise of ln r of one atom at one pose, from centred ln r of one column per
/// pose.
///
/// With four poses and more: what the subject's own curve leaves, Σₜ (x(t) − (x · c) c(t))² / (T − 2), of the
/// median atom, over the median of χ² of T − 2 degrees, ν (1 − 2 / 9ν)³ (Wilson and Hilferty). With fewer nothing is left
/// over time, and noise is what an atom has apart from its neighbours: median |a − mean of neighbours|
/// / 0.6745 / √(1 + 1/k), too little where noise is the same for neighbours.
pub(super) fn noise_of(
    columns: &[Vec<f64>],
    curve: &ThickeningCurve,
    areas: &[f64],
    neighbours: &Neighbours,
) -> f64 {
    let regular = || (0..areas.len()).filter(|&atom| areas[atom] > 0.0);
    if columns.len() < MIN_POSES {
        let thickening = curve.thickening(columns);
        let apart = regular().filter_map(|atom| {
            let around = neighbours.of(atom);
            let count = around.len() as f64;
            let mean = around.iter().map(|&n| thickening[n as usize]).sum::<f64>() / count;
            // The mean of the neighbours is noisy as well.
            let scale = (1.0 + 1.0 / count).sqrt();
            (!around.is_empty()).then(|| (thickening[atom] - mean).abs() / scale)
        });
        // Thickening is ln r times c, times c(ES) − c(ED): its noise is as many times that of ln r.
        return NORMAL_FROM_MEDIAN * lower_median(apart.collect()) / curve.rise.max(f64::EPSILON);
    }
    // The mean and the share of the curve are fitted, which takes two degrees of freedom from each atom.
    let degrees = columns.len() as f64 - 2.0;
    let left = regular().map(|atom| {
        let along: f64 = (columns.iter().zip(&curve.shape))
            .map(|(x, c)| x[atom] * c)
            .sum();
        (columns.iter().zip(&curve.shape))
            .map(|(x, c)| (x[atom] - along * c).powi(2))
            .sum()
    });
    // Wilson and Hilferty’s median of χ², by which a median of squares becomes a variance.
    let chi2 = degrees * (1.0 - 2.0 / (9.0 * degrees)).powi(3);
    // The median atom, since atoms of a patch or a rim follow the curve badly without being noisy.
    (lower_median(left.collect()) / chi2).sqrt()
}
