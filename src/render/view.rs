//! What is kept of a view between pictures: textures, uniforms, and what the last picture shows.

use super::blit_pass::{BlitPass, BlitTarget};
use super::pipelines::Layouts;
use super::targets::{Resolved, moving_depth};
use super::uniforms::{Quality, Shot, UNIFORM_STRIDE, ViewUniform};
use super::{Camera, Scene};

/// What a picture was drawn from.
pub(super) struct Shown {
    pub scene: Scene,
    pub camera: Camera,
    pub shot: Shot,
}

/// A picture as passes finish it, and what lays it into the window.
pub(super) struct Finished {
    pub resolved: Resolved,
    pub blit: BlitTarget,
}

#[derive(Default)]
pub(super) struct View {
    pub shown: Option<Shown>,
    pub full: Option<Finished>,
    /// With its depths.
    pub moving: Option<(Finished, wgpu::TextureView)>,
    pub uniforms: Option<ViewUniforms>,
}

pub(super) struct ViewUniforms {
    pub view_uniform: wgpu::Buffer,
    pub view_group: wgpu::BindGroup,
    pub draw_uniforms: wgpu::Buffer,
}

impl View {
    /// The picture that was drawn last.
    pub fn finished(&self) -> Option<&Finished> {
        match self.shown.as_ref()?.shot.quality {
            Quality::Full => self.full.as_ref(),
            Quality::Moving => self.moving.as_ref().map(|(finished, _)| finished),
        }
    }

    /// Room for the uniforms of so many draws.
    pub fn uniforms(
        &mut self,
        device: &wgpu::Device,
        layouts: &Layouts,
        draws: usize,
    ) -> &ViewUniforms {
        let room = UNIFORM_STRIDE * (draws as u64).max(1).next_power_of_two();
        let kept = self.uniforms.take();
        let enough = kept.filter(|uniforms| uniforms.draw_uniforms.size() >= room);
        self.uniforms.insert(enough.unwrap_or_else(|| {
            let buffer = |size| {
                device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("view"),
                    size,
                    usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            };
            let view_uniform = buffer(size_of::<ViewUniform>() as u64);
            ViewUniforms {
                view_group: device.create_bind_group(&wgpu::BindGroupDescriptor {
                    label: Some("view"),
                    layout: &layouts.view,
                    entries: &[wgpu::BindGroupEntry {
                        binding: 0,
                        resource: view_uniform.as_entire_binding(),
                    }],
                }),
                view_uniform,
                draw_uniforms: buffer(room),
            }
        }))
    }

    /// Textures of the right size for a picture of this quality; with its depths if they are its own.
    pub fn target(
        &mut self,
        device: &wgpu::Device,
        blit: &BlitPass,
        shot: Shot,
    ) -> (&Finished, Option<wgpu::TextureView>) {
        let size = shot.tile.size;
        let finished = || {
            let resolved = Resolved::new(device, shot.tile);
            Finished {
                blit: blit.target(device, &resolved, shot.quality),
                resolved,
            }
        };
        match shot.quality {
            Quality::Full => {
                let kept = self.full.take().filter(|kept| kept.resolved.size == size);
                (self.full.insert(kept.unwrap_or_else(finished)), None)
            }
            Quality::Moving => {
                let kept = self.moving.take();
                let kept = kept.filter(|(kept, _)| kept.resolved.size == size);
                let (finished, depth) = self
                    .moving
                    .insert(kept.unwrap_or_else(|| (finished(), moving_depth(device, size))));
                (finished, Some(depth.clone()))
            }
        }
    }
}
