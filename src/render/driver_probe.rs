//! Tests what an OpenGL driver can do by drawing a small picture, since its version alone does not say.

use std::sync::Arc;

use super::error_scope::ErrorScope;
use super::targets::Capabilities;
use super::uniforms::{Quality, Shot, Tile};
use super::uploads::Gpu;
use super::{
    Camera, Geometry, GeometryPose, Lines, Points, Scene, Shading, Surface, SurfaceColour,
};

/// Records a picture with these capabilities.
type Draw<'a> = &'a dyn Fn(
    Capabilities,
    &mut wgpu::CommandEncoder,
    (&Scene, &Camera),
    Shot,
) -> Result<(), String>;

/// The best capabilities by which `draw` makes a small picture without an error, or the driver's message about the last.
pub(super) fn capabilities(gpu: Gpu<'_>, draw: Draw<'_>) -> Result<Capabilities, String> {
    works(gpu, draw, Capabilities::Peeled).or_else(|_| works(gpu, draw, Capabilities::Plain))
}

fn works(gpu: Gpu<'_>, draw: Draw<'_>, capabilities: Capabilities) -> Result<Capabilities, String> {
    let error_scope = ErrorScope::begin(gpu.device);
    let descriptor = wgpu::CommandEncoderDescriptor::default();
    let mut encoder = gpu.device.create_command_encoder(&descriptor);
    let shot = Shot {
        tile: Tile::all([8, 8]),
        quality: Quality::Full,
        pixels_per_point: 1.0,
        folds: true,
        occlusion_of: None,
    };
    draw(
        capabilities,
        &mut encoder,
        (&scene(), &Camera::default()),
        shot,
    )?;
    gpu.queue.submit([encoder.finish()]);
    error_scope.end().map(|()| capabilities)
}

/// One of everything, opaque and translucent.
fn scene() -> Scene {
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let geometry = Arc::new(Geometry {
        triangles: vec![[0, 1, 2]],
        positions: vec![corners.clone()],
        normals: vec![vec![[0.0, 0.0, 1.0]; 3]],
    });
    let surface = |opacity| Surface {
        geometry: Arc::clone(&geometry),
        pose: GeometryPose::default(),
        colour: SurfaceColour::Uniform([0.5; 3]),
        opacity,
        shading: Shading::Smooth,
        wireframe: None,
        silhouette: 0.5,
        pickable: false,
    };
    let (lines, points) = (Arc::new(vec![corners.clone()]), Arc::new(corners));
    let marks = [1.0, 0.5].map(|opacity| [0.5, 0.5, 0.5, opacity]);
    Scene {
        surfaces: [1.0, 0.5].map(surface).into(),
        lines: marks
            .map(|colour| Lines {
                strips: Arc::clone(&lines),
                colour,
                width: 2.0,
            })
            .into(),
        points: marks
            .map(|colour| Points {
                positions: Arc::clone(&points),
                colours: Arc::new(vec![colour]),
                diameter: 3.0,
            })
            .into(),
        background: [0.0, 0.0, 0.0, 1.0],
    }
}
