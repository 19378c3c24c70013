//! One thing to draw, with all that the card needs for it.

use super::Bounds;
use super::pipelines::{Pipelines, Stage};
use super::shaders::Kind;

/// One surface, set of lines or set of points, ready to be drawn in any pass.
pub(super) struct Drawn {
    pub kind: Kind,
    pub group: wgpu::BindGroup,
    /// Place of its uniforms in the view's buffer.
    pub offset: u32,
    /// Indices of a surface.
    pub indices: Option<wgpu::Buffer>,
    /// Vertex buffers in order.
    pub buffers: Vec<wgpu::Buffer>,
    pub vertices: u32,
    pub instances: u32,
    pub translucent: bool,
    /// Where a surface lies at all its poses.
    pub bounds: Option<Bounds>,
    /// Translucent layers that a ray usually meets in it.
    pub layers: usize,
}

impl Drawn {
    /// Whether it is a surface, and not lines or points.
    pub fn is_surface(&self) -> bool {
        matches!(self.kind, Kind::Surface | Kind::EdgedSurface)
    }

    /// Records the draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pipelines: &Pipelines, stage: Stage) {
        let Some(pipeline) = pipelines.get(self.kind, stage) else {
            return;
        };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(1, &self.group, &[self.offset]);
        for (slot, buffer) in self.buffers.iter().enumerate() {
            pass.set_vertex_buffer(slot as u32, buffer.slice(..));
        }
        match &self.indices {
            Some(indices) => {
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(0..self.vertices, 0, 0..self.instances);
            }
            None => pass.draw(0..self.vertices, 0..self.instances),
        }
    }
}
