//! A surface with fewer vertices.

use super::SurfaceError;
use super::volume_keeping::EnclosedVolumes;
use crate::mesh::{Decimation, Point3, TriMesh};
use crate::progress::{Progress, Stopped};

/// Vertices that are removed between two questions whether to go on, as [`Decimation`] has it.
const ASK_EVERY: usize = 64;

/// The mesh with at most `max_vertices` vertices, or as few as its topology allows, and of every closed part the same volume.
///
/// Short edges are collapsed where the surface is flat, see [`Decimation`]; what chords cut off from the volume is made up for
/// by a move along the normals, but where that is more than half of it.
///
/// # Errors
/// If stopped.
pub fn decimated(
    mesh: &TriMesh,
    max_vertices: usize,
    progress: &Progress,
) -> Result<TriMesh, SurfaceError> {
    let (points, faces) = (mesh.vertices(), mesh.faces());
    progress.check()?;
    if points.len() <= max_vertices {
        return Ok(mesh.clone());
    }
    progress.expect_steps((points.len() - max_vertices) / ASK_EVERY);
    let go_on = || progress.step().is_ok();
    let (kept, coarse) = Decimation::one_way(points, faces, max_vertices, go_on).ok_or(Stopped)?;
    let volumes = EnclosedVolumes::of(points, faces);
    let places: Vec<Point3> = kept.iter().map(|&v| points[v as usize]).collect();
    let volumes = volumes.for_kept(&kept, &places, &coarse);
    let mut restored = places.clone();
    volumes.restore(&mut restored, &places);
    Ok(TriMesh::new(restored, coarse)?)
}
