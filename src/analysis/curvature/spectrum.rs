//! How a surface shares its area among shapes.

use super::Curvature;

/// Bins of a shape spectrum, from −1 to 1: a tenth of the shape index each.
pub const SPECTRUM_BINS: usize = 20;

/// Share of the area in each bin of the shape index, from −1 to 1, so that they sum to 1; divided by the width of a bin it
/// is the shape spectrum γ, a density. What is flat or has no curvature counts nowhere; `None` if that is everything.
///
/// `areas` are those around the vertices, in any unit.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.1.2, read as an area-weighted histogram.
pub fn shape_spectrum(
    curvatures: &[Option<Curvature>],
    areas: &[f64],
) -> Option<[f64; SPECTRUM_BINS]> {
    let mut shares = [0.0; SPECTRUM_BINS];
    for (curvature, area) in curvatures.iter().zip(areas) {
        let Some(index) = curvature.and_then(|curvature| curvature.shape_index()) else {
            continue;
        };
        let place = ((index + 1.0) * 0.5 * SPECTRUM_BINS as f64) as usize;
        shares[place.min(SPECTRUM_BINS - 1)] += area;
    }
    let total: f64 = shares.iter().sum();
    (total > 0.0).then(|| shares.map(|share| share / total))
}
