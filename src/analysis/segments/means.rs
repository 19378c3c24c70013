//! Means over segments and levels of any quantity per vertex.

use super::{Level, Segment};

/// Mean of values over each segment, weighted, such as by [`vertex_areas`](crate::mesh::vertex_areas);
/// `None` for a segment without weight. Values that are not finite, and vertices past the end of any slice, do not count.
pub fn segment_means(
    segments: &[Option<Segment>],
    weights: &[f64],
    values: &[f64],
) -> [Option<f64>; Segment::COUNT] {
    group_means(segments, weights, values, Segment::index)
}

/// [`segment_means`] over levels, for subjects whose orientation is not known.
pub fn level_means(
    levels: &[Option<Level>],
    weights: &[f64],
    values: &[f64],
) -> [Option<f64>; Level::ALL.len()] {
    group_means(levels, weights, values, Level::index)
}

fn group_means<G: Copy, const N: usize>(
    groups: &[Option<G>],
    weights: &[f64],
    values: &[f64],
    index: impl Fn(G) -> usize,
) -> [Option<f64>; N] {
    let mut sums = [[0.0; 2]; N];
    for ((group, &weight), &value) in groups.iter().zip(weights).zip(values) {
        // One value that is not a number would otherwise spoil the mean of its whole segment.
        if let (Some(group), true) = (group, (weight * value).is_finite() && weight > 0.0) {
            let sum = &mut sums[index(*group)];
            sum[0] += weight;
            sum[1] += weight * value;
        }
    }
    sums.map(|[weight, sum]| (weight > 0.0).then(|| sum / weight))
}
