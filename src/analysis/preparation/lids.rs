//! Surfaces closed at the base.

use std::sync::Arc;

use super::PreparationError;
use crate::mesh::{Faces, TriMesh, mean_point};
use crate::study::{MeshSequence, SurfaceSequence};

/// The surfaces with a lid on each of their boundary loops: a fan from the loop to a new vertex at the mean of its vertices.
/// New vertices come after the others, so that these keep their numbers, and surfaces of equal faces get equal lids.
///
/// # Errors
/// If the surfaces with lids are no sequence.
pub(super) fn with_lids(sequence: &MeshSequence) -> Result<MeshSequence, PreparationError> {
    let closed = sequence.surfaces().iter().map(closed);
    Ok(MeshSequence::new(closed.collect::<Result<_, _>>()?)?)
}

fn closed(surface: &SurfaceSequence) -> Result<SurfaceSequence, PreparationError> {
    let loops = surface.faces().boundary_loops();
    let count = surface.faces().vertex_count();
    let mut triangles = surface.faces().triangles().to_vec();
    for (centre, around) in (count as u32..).zip(&loops) {
        let next = around.iter().cycle().skip(1);
        // Against the direction of the sheet's own sides, so that normals agree.
        triangles.extend(around.iter().zip(next).map(|(&a, &b)| [b, a, centre]));
    }
    let faces = Arc::new(Faces::new(count + loops.len(), triangles)?);
    let mut frames = Vec::with_capacity(surface.frames().len());
    for mesh in surface.frames() {
        let mut vertices = mesh.vertices().to_vec();
        for around in &loops {
            let corners = around.iter().map(|&v| mesh.vertices()[v as usize]);
            vertices.push(mean_point(corners));
        }
        frames.push(TriMesh::new(vertices, Arc::clone(&faces))?);
    }
    Ok(SurfaceSequence::new(surface.kind(), frames)?)
}
