//! From a path on fewer vertices to one on all of them.

use crate::mesh::Decimation;

use super::minimise::resampled;

/// The offsets of a coarse path from its straight line, prolonged to all vertices and added to theirs.
///
/// `found` holds the poses between `coarse_ends`; what is returned, as many poses between `ends`.
pub(super) fn prolonged(
    decimation: &Decimation,
    found: &[f64],
    coarse_ends: [&[f64]; 2],
    ends: [&[f64]; 2],
    interpolated_poses: usize,
) -> Vec<f64> {
    let straight = resampled(coarse_ends[0], &[], coarse_ends[1], interpolated_poses);
    let mut fine = resampled(ends[0], &[], ends[1], interpolated_poses);
    let size = coarse_ends[0].len().max(1);
    // Only how the path departs from the straight line is coarse: the ends keep all their detail.
    let offsets: Vec<f64> = (found.iter().zip(&straight))
        .map(|(found, straight)| found - straight)
        .collect();
    let poses = fine.chunks_exact_mut(ends[0].len().max(1));
    for (pose, offsets) in poses.zip(offsets.chunks_exact(size)) {
        for (x, offset) in pose.iter_mut().zip(decimation.prolonged(offsets)) {
            *x += offset;
        }
    }
    fine
}
