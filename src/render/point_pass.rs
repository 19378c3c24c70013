//! Points as draws: each an instance that the vertex stage widens to a disc of pixels.

use super::Points;
use super::drawn::Drawn;
use super::line_pass::mark_group;
use super::pipelines::Layouts;
use super::shaders::Kind;
use super::uniforms::MarkUniform;
use super::uploads::{Gpu, Uploads};

/// Triangles of a disc: the polygon stays within 0.1 pixel of the circle up to 40 pixels.
fn disc_triangles(diameter_pixels: f32) -> u32 {
    (diameter_pixels.sqrt() * 5.0).ceil().clamp(8.0, 48.0) as u32
}

/// What points need to be drawn; `None` if nothing of them can be seen.
pub(super) fn drawn(
    gpu: Gpu<'_>,
    uploads: &mut Uploads,
    layouts: &Layouts,
    points: &Points,
    pixels_per_point: f32,
    (uniforms, offset): (&wgpu::Buffer, u32),
) -> Option<(Drawn, MarkUniform)> {
    if points.diameter.is_nan() || points.diameter <= 0.0 {
        return None;
    }
    let centres = uploads.centres(gpu, points);
    let centre_buffer = centres.buffer.clone()?;
    let colours = uploads.colours(gpu, points);
    // A list shorter than the points gives all of them its last colour.
    let own = colours.count >= centres.count && colours.count > 1;
    let shared = points
        .colours
        .last()
        .copied()
        .unwrap_or([0.8, 0.8, 0.8, 1.0]);
    let colour_buffer = match &colours.buffer {
        Some(buffer) if own => buffer.clone(),
        _ => centre_buffer.clone(),
    };
    let triangles = disc_triangles(points.diameter * pixels_per_point);
    let uniform = MarkUniform {
        first: [
            points.diameter,
            triangles as f32,
            f32::from(u8::from(own)),
            0.0,
        ],
        second: shared,
    };
    let draw = Drawn {
        kind: Kind::Points,
        group: mark_group(gpu, layouts, uniforms),
        offset,
        indices: None,
        buffers: vec![centre_buffer, colour_buffer],
        vertices: 3 * triangles,
        instances: centres.count,
        translucent: if own {
            colours.translucent
        } else {
            shared[3] < 1.0
        },
        bounds: None,
        layers: 1,
    };
    Some((draw, uniform))
}
