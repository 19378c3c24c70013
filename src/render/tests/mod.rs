//! Pictures of small scenes, measured pixel by pixel.

mod blitted;
mod marks;
mod moving;
mod opengl;
mod pictures;
mod shaders;
mod upkeep;

use std::io::Write;
use std::sync::Arc;

use super::*;
use crate::mesh::{TriMesh, phantom, vertex_normals};

/// A background that no light gives by chance: bytes 26, 51, 77.
pub(super) const BACKGROUND: Rgba = [26.0 / 255.0, 51.0 / 255.0, 77.0 / 255.0, 1.0];

/// A headless renderer, or a message that this test is skipped.
pub(super) fn headless() -> Option<Headless> {
    found(Headless::new())
}

/// What there is, or a message that this test is skipped.
pub(super) fn found(headless: Result<Headless, RenderError>) -> Option<Headless> {
    match headless {
        Ok(headless) => Some(headless),
        Err(error) => {
            // Not captured by the test runner, so that a skipped test is seen.
            let _ = writeln!(std::io::stderr(), "skipped: {error}");
            None
        }
    }
}

/// A mesh as a geometry of one pose.
pub(super) fn geometry_of(mesh: &TriMesh) -> Arc<Geometry> {
    let single = |v: [f64; 3]| v.map(|x| x as f32);
    let normals = vertex_normals(mesh.vertices(), mesh.triangles());
    Arc::new(Geometry {
        triangles: mesh.triangles().to_vec(),
        positions: vec![
            mesh.vertices()
                .iter()
                .map(|p| single(p.coords.into()))
                .collect(),
        ],
        normals: vec![normals.into_iter().map(|n| single(n.into())).collect()],
    })
}

/// A sphere about the origin.
pub(super) fn ball(subdivisions: u32, radius: f64) -> Arc<Geometry> {
    geometry_of(&phantom::sphere(subdivisions, radius))
}

/// A square of half side `half` at height z, facing +z.
pub(super) fn square(half: f32, z: f32) -> Arc<Geometry> {
    Arc::new(Geometry {
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        positions: vec![vec![
            [-half, -half, z],
            [half, -half, z],
            [half, half, z],
            [-half, half, z],
        ]],
        normals: vec![vec![[0.0, 0.0, 1.0]; 4]],
    })
}

/// A red surface without lines.
pub(super) fn surface_of(geometry: Arc<Geometry>) -> Surface {
    Surface {
        geometry,
        pose: GeometryPose::default(),
        colour: SurfaceColour::Uniform([0.8, 0.1, 0.1]),
        opacity: 1.0,
        shading: Shading::Smooth,
        wireframe: None,
        silhouette: 0.0,
        pickable: true,
    }
}

/// Surfaces on the test background.
pub(super) fn scene_of(surfaces: Vec<Surface>) -> Scene {
    Scene {
        surfaces,
        lines: Vec::new(),
        points: Vec::new(),
        background: BACKGROUND,
    }
}

/// A parallel camera that sees −2..=2 upwards.
pub(super) fn parallel() -> Camera {
    Camera {
        half_height: 2.0,
        field_of_view_rad: 0.0,
        ..Camera::default()
    }
}

/// The background as bytes.
pub(super) fn background() -> [u8; 4] {
    BACKGROUND.map(|x| (x * 255.0).round() as u8)
}

/// The greatest difference of any channel between two pictures of one size.
pub(super) fn greatest_difference(a: &Picture, b: &Picture) -> u8 {
    assert_eq!((a.width, a.height), (b.width, b.height));
    a.rgba
        .iter()
        .zip(&b.rgba)
        .map(|(a, b)| a.abs_diff(*b))
        .max()
        .unwrap_or(0)
}
