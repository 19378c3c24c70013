//! Lines as draws: each segment an instance that the vertex stage widens to pixels.

use super::Lines;
use super::drawn::Drawn;
use super::pipelines::Layouts;
use super::shaders::Kind;
use super::surface_pass::block;
use super::uniforms::MarkUniform;
use super::uploads::{Gpu, Uploads};

/// Triangles that round an end: enough that the polygon stays within 0.1 pixel of the circle up to 20 pixels of width.
fn end_triangles(width_pixels: f32) -> u32 {
    if width_pixels <= 2.0 {
        0
    } else {
        (width_pixels.sqrt() * 2.0).ceil().clamp(4.0, 16.0) as u32
    }
}

/// What lines need to be drawn; `None` if nothing of them can be seen.
pub(super) fn drawn(
    gpu: Gpu<'_>,
    uploads: &mut Uploads,
    layouts: &Layouts,
    lines: &Lines,
    pixels_per_point: f32,
    (uniforms, offset): (&wgpu::Buffer, u32),
) -> Option<(Drawn, MarkUniform)> {
    if lines.width.is_nan() || lines.width <= 0.0 || lines.colour[3] <= 0.0 {
        return None;
    }
    let segments = uploads.lines(gpu, lines);
    let buffer = segments.buffer.clone()?;
    let triangles = end_triangles(lines.width * pixels_per_point);
    let uniform = MarkUniform {
        first: lines.colour,
        second: [lines.width, triangles as f32, 0.0, 0.0],
    };
    let draw = Drawn {
        kind: Kind::Lines,
        group: mark_group(gpu, layouts, uniforms),
        offset,
        indices: None,
        buffers: vec![buffer],
        vertices: 6 + 2 * 3 * triangles,
        instances: segments.count,
        translucent: lines.colour[3] < 1.0,
        bounds: None,
        layers: 1,
    };
    Some((draw, uniform))
}

/// Group 1 of lines and points.
pub(super) fn mark_group(
    gpu: Gpu<'_>,
    layouts: &Layouts,
    uniforms: &wgpu::Buffer,
) -> wgpu::BindGroup {
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("mark"),
        layout: &layouts.mark,
        entries: &[block::<MarkUniform>(uniforms)],
    })
}
