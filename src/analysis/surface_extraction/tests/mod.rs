//! What surfaces of volumes must and must not be.

mod isosurface;
mod smoothing;

use crate::image::VolumeFrame;
use crate::mesh::{Point3, TriMesh, Vector3, signed_volume};

/// A grid along the axes of the world, around its origin.
fn centred_frame(size: [usize; 3], spacing: [f64; 3]) -> VolumeFrame {
    let origin = [0, 1, 2].map(|axis| -0.5 * spacing[axis] * (size[axis] as f64 - 1.0));
    let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, spacing[axis]));
    VolumeFrame::new(size, Point3::from(origin), steps).unwrap()
}

/// The values of a function at the voxels of a grid.
fn sampled(frame: &VolumeFrame, f: impl Fn(Point3) -> f64) -> Vec<f32> {
    let [nx, ny, nz] = frame.size();
    let mut values = Vec::new();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let at = Point3::new(i as f64, j as f64, k as f64);
                values.push(f(frame.position(at)) as f32);
            }
        }
    }
    values
}

fn volume(mesh: &TriMesh) -> f64 {
    let corners = (mesh.triangles().iter()).map(|t| t.map(|v| mesh.vertices()[v as usize]));
    signed_volume(corners, Point3::origin())
}

fn euler(mesh: &TriMesh) -> i64 {
    let counts = [
        mesh.vertices().len(),
        mesh.faces().edges().len(),
        mesh.triangles().len(),
    ];
    let [vertices, edges, faces] = counts.map(|n| n as i64);
    vertices - edges + faces
}

/// Whether a mesh is closed, oriented, manifold and without a vertex that no face has.
fn is_closed_manifold(mesh: &TriMesh) -> bool {
    let borders = mesh.faces().borders();
    let mut used = vec![false; mesh.vertices().len()];
    for &vertex in mesh.triangles().iter().flatten() {
        used[vertex as usize] = true;
    }
    borders.rims.is_empty()
        && borders.branching.is_empty()
        && borders.turned == 0
        && borders.pinched == 0
        && used.iter().all(|&used| used)
}
