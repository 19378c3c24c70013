//! Smoothing that takes the steps of voxels out of a surface and keeps its volume.

use std::sync::Arc;

use rayon::prelude::*;

use super::SurfaceError;
use super::volume_keeping::EnclosedVolumes;
use crate::mesh::{Faces, Point3, TriMesh, Vector3};
use crate::progress::Progress;

/// Settings of [`taubin`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaubinParams {
    /// How often the surface is shrunk and inflated again.
    pub sweeps: usize,
    /// λ: how far a vertex goes towards the mean of its neighbours.
    pub shrink: f64,
    /// k: the frequency of the mesh, from 0 (the whole) to 2 (from vertex to vertex), up to which waves are kept.
    pub pass_band: f64,
}

impl Default for TaubinParams {
    /// 20 sweeps, λ = ½, k = 0.1: waves of voxels go, those of a ventricle stay.
    fn default() -> Self {
        Self {
            sweeps: 20,
            shrink: 0.5,
            pass_band: 0.1,
        }
    }
}

/// Settings that can be used.
#[derive(Clone, Copy, Debug)]
pub struct CheckedTaubinParams(TaubinParams);

/// A setting is out of range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{name} must lie in {range}, but is {value}")]
pub struct TaubinSettingError {
    /// Which.
    pub name: &'static str,
    /// Where it must lie.
    pub range: &'static str,
    /// What it is.
    pub value: f64,
}

impl TaubinParams {
    /// Checks the settings. Beyond λ = 0.65 waves from vertex to vertex could grow.
    ///
    /// # Errors
    /// At the first that is out of range.
    pub fn check(self) -> Result<CheckedTaubinParams, TaubinSettingError> {
        let setting = |name, range, value| Err(TaubinSettingError { name, range, value });
        if self.sweeps > 10_000 {
            return setting("the number of sweeps", "0 to 10,000", self.sweeps as f64);
        }
        if !(self.shrink > 0.0 && self.shrink <= 0.65) {
            return setting("λ", "0 (exclusive) to 0.65", self.shrink);
        }
        if !(self.pass_band > 0.0 && self.pass_band <= 0.5) {
            return setting("the pass band", "0 (exclusive) to 0.5", self.pass_band);
        }
        Ok(CheckedTaubinParams(self))
    }
}

/// The mesh smoothed, with the same connectivity and, of every closed part, the same volume.
///
/// In turns p ← p + λ Δp and p ← p + μ Δp, Δp the mean of the neighbours less p, and μ = 1 / (k − 1/λ) < −λ, which leaves
/// waves of frequency k as they are. What the volume of a closed part then lacks is made up for by a move along its normals,
/// equally far everywhere; a speck of few voxels that would shrink to less than half its volume stays as it is. Vertices on
/// a rim have their neighbours on the rim only.
///
/// Source: Taubin (1995), SIGGRAPH '95, 351–358, section 3, with equal weights.
///
/// # Errors
/// If stopped; that is heard once a sweep.
pub fn taubin(
    mesh: &TriMesh,
    params: &CheckedTaubinParams,
    progress: &Progress,
) -> Result<TriMesh, SurfaceError> {
    let params = params.0;
    let volumes = EnclosedVolumes::of(mesh.vertices(), mesh.faces());
    let neighbours = Neighbours::of(mesh.faces());
    let inflate = 1.0 / (params.pass_band - 1.0 / params.shrink);
    let mut points = mesh.vertices().to_vec();
    progress.expect_steps(params.sweeps);
    for _ in 0..params.sweeps {
        progress.step()?;
        for factor in [params.shrink, inflate] {
            points = neighbours.relaxed(&points, factor);
        }
    }
    volumes.restore(&mut points, mesh.vertices());
    Ok(TriMesh::new(points, Arc::clone(mesh.faces()))?)
}

/// The neighbours of each vertex, one list after the other.
struct Neighbours {
    ends: Vec<usize>,
    all: Vec<u32>,
}

impl Neighbours {
    fn of(faces: &Faces) -> Self {
        let on_rim = faces.boundary_vertices();
        let mut rims: Vec<[u32; 2]> = (faces.borders().rims.iter())
            .map(|&[a, b]| [a.min(b), a.max(b)])
            .collect();
        rims.sort_unstable();
        // A vertex on a rim is pulled along it only.
        let pulls = |vertex: u32, edge: &[u32; 2]| {
            !on_rim[vertex as usize] || rims.binary_search(edge).is_ok()
        };
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        for edge in faces.edges() {
            let [a, b] = edge;
            pairs.extend(pulls(a, &edge).then_some([a, b]));
            pairs.extend(pulls(b, &edge).then_some([b, a]));
        }
        pairs.sort_unstable();
        let mut ends = vec![0; faces.vertex_count()];
        for (place, [vertex, _]) in pairs.iter().enumerate() {
            ends[*vertex as usize] = place + 1;
        }
        // Vertices without neighbours end where the one before does.
        for vertex in 1..ends.len() {
            ends[vertex] = ends[vertex].max(ends[vertex - 1]);
        }
        Self {
            ends,
            all: pairs.iter().map(|pair| pair[1]).collect(),
        }
    }

    /// Every point moved by a factor towards the mean of its neighbours.
    fn relaxed(&self, points: &[Point3], factor: f64) -> Vec<Point3> {
        let moved = |vertex: usize| {
            let from = if vertex == 0 {
                0
            } else {
                self.ends[vertex - 1]
            };
            let around = &self.all[from..self.ends[vertex]];
            let point = points[vertex];
            if around.is_empty() {
                return point;
            }
            let sum: Vector3 = around.iter().map(|&v| points[v as usize] - point).sum();
            point + sum * (factor / around.len() as f64)
        };
        (0..points.len())
            .into_par_iter()
            .with_min_len(1_024)
            .map(moved)
            .collect()
    }
}
