//! Distance from each vertex of the inner side to the nearest point of the outer one.

use rayon::prelude::*;

use crate::mesh::{ClosestPoint, Point3};
use crate::progress::{Progress, Stopped};

/// Vertices between two steps: some 1 ms.
const PIECE: usize = 512;

/// The nearest point of a surface for each vertex that is a member; `None` for the others.
pub(super) fn nearest_points(
    vertices: &[Point3],
    members: &[bool],
    outer: &ClosestPoint,
    progress: &Progress,
) -> Result<Vec<Option<Point3>>, Stopped> {
    progress.expect_steps(vertices.len().div_ceil(PIECE));
    let pieces: Vec<Vec<Option<Point3>>> = (vertices.par_chunks(PIECE))
        .zip(members.par_chunks(PIECE))
        .map(|(vertices, members)| {
            progress.step()?;
            Ok((vertices.iter().zip(members))
                .map(|(&vertex, member)| member.then(|| outer.closest(vertex)))
                .collect())
        })
        .collect::<Result<_, Stopped>>()?;
    Ok(pieces.into_iter().flatten().collect())
}
