//! Curvature at all vertices of a surface.

use rayon::prelude::*;

use crate::mesh::{CappedSheet, Sheet, TriMesh, sheets, vertex_normals};
use crate::numeric::median;
use crate::progress::{Progress, Stopped};

use super::fit::{ENOUGH_POINTS, fitted};
use super::rings::{Neighbours, RINGS, Surroundings};
use super::{Curvature, CurvatureError};

/// Rings that are gathered at most beyond those asked for, where a boundary leaves too few points.
const FURTHER_RINGS: usize = 2;
/// Vertices between two looks at whether to stop.
const BATCH: usize = 1024;

/// How a surface bends.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceCurvature {
    /// One for each vertex; `None` for a vertex of no face, or with too few others around it.
    pub vertices: Vec<Option<Curvature>>,
}

impl SurfaceCurvature {
    /// Median over the vertices that have a curvature; `None` if none has.
    pub fn median(&self, of: impl Fn(&Curvature) -> f64) -> Option<f64> {
        median(self.vertices.iter().flatten().map(of).collect())
    }
}

/// Curvature at each vertex of a surface, by a cubic fitted to the vertices up to `rings` edges away. Two rings follow what an
/// exact surface does; more smooth what measured ones have of noise.
///
/// Normals point outward: a part of the surface whose faces enclose a negative volume counts as turned over.
///
/// # Errors
/// If there are no faces, `rings` is out of range, or it was asked to stop.
pub fn surface_curvature(
    mesh: &TriMesh,
    rings: usize,
    progress: &Progress,
) -> Result<SurfaceCurvature, CurvatureError> {
    if !RINGS.contains(&rings) {
        return Err(CurvatureError::Rings(rings));
    }
    if mesh.triangles().is_empty() {
        return Err(CurvatureError::NoFaces);
    }
    let positions = mesh.vertices();
    let normals = vertex_normals(positions, &outward_triangles(mesh));
    let neighbours = Neighbours::of(mesh.faces());
    let mut vertices: Vec<Option<Curvature>> = vec![None; positions.len()];
    progress.expect_steps(positions.len().div_ceil(BATCH));
    vertices
        .par_chunks_mut(BATCH)
        .enumerate()
        .try_for_each_init(
            || Surroundings::new(positions.len()),
            |surroundings, (batch, curvatures)| {
                for (place, curvature) in curvatures.iter_mut().enumerate() {
                    let vertex = batch * BATCH + place;
                    let around = surroundings.gather(
                        &neighbours,
                        vertex as u32,
                        rings,
                        ENOUGH_POINTS,
                        rings + FURTHER_RINGS,
                    );
                    let points = around.iter().map(|&near| positions[near as usize]);
                    *curvature = fitted(points, normals[vertex]);
                }
                progress.step()
            },
        )
        .map_err(|stopped: Stopped| CurvatureError::Stopped(stopped))?;
    Ok(SurfaceCurvature { vertices })
}

/// All triangles, those of each sheet wound so that it encloses a positive volume together with lids on its boundaries; as they
/// are where the surface has no inside.
fn outward_triangles(mesh: &TriMesh) -> Vec<[u32; 3]> {
    let positions = mesh.vertices();
    let Ok(sheets) = sheets(mesh.faces()) else {
        return mesh.triangles().to_vec();
    };
    let outward = |sheet: Sheet| {
        let inside_out = CappedSheet::new(positions.len(), &sheet)
            .is_ok_and(|capped| capped.signed_volume(positions) < 0.0);
        let turned = move |[a, b, c]: [u32; 3]| if inside_out { [a, c, b] } else { [a, b, c] };
        sheet.triangles.into_iter().map(turned)
    };
    sheets.into_iter().flat_map(outward).collect()
}
