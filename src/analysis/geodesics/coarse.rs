//! The same path found on fewer vertices, and carried over to all of them.

use crate::mesh::{Decimation, Point3};

use super::ends::flat;
use super::minimise::{Inner, resampled};
use super::{GeodesicError, GeodesicSolver};

/// The same question on fewer of the vertices.
#[derive(Clone, Debug)]
pub(super) struct Coarse {
    pub decimation: Decimation,
    pub solver: GeodesicSolver,
}

impl Coarse {
    /// The path of the coarse mesh, its offsets from the straight line prolonged to all vertices.
    pub fn search(
        &self,
        start: &[Point3],
        end: &[Point3],
        ends: &[&[f64]; 2],
        go_on: &dyn Fn() -> bool,
    ) -> Result<Inner, GeodesicError> {
        let [start, end] = [start, end].map(|pose| self.decimation.restricted(pose));
        let few = [flat(&start), flat(&end)];
        let mut inner = self
            .solver
            .search(&start, &end, [&few[0], &few[1]], go_on)?;
        let count = usize::from(self.solver.params.in_betweens);
        let straight = resampled(&few[0], &[], &few[1], count);
        let mut fine = resampled(ends[0], &[], ends[1], count);
        let size = few[0].len().max(1);
        let offsets: Vec<f64> = (inner.coordinates.iter().zip(&straight))
            .map(|(found, straight)| found - straight)
            .collect();
        for (pose, offsets) in
            (fine.chunks_exact_mut(ends[0].len().max(1))).zip(offsets.chunks_exact(size))
        {
            for (x, offset) in pose.iter_mut().zip(self.decimation.prolonged(offsets)) {
                *x += offset;
            }
        }
        inner.coordinates = fine;
        Ok(inner)
    }
}
