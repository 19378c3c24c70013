//! Lays a finished picture over its background into the window's own pass.

use super::pipelines::{layout, texture_entry, uniform_entry};
use super::targets::Resolved;
use super::uniforms::{BlitUniform, Quality};
use super::uploads::Gpu;
use super::whole_picture::whole_picture_pipeline;

/// The whole shader text.
pub(super) const SHADER: &str = include_str!("shaders/blit.wgsl");

/// Pipeline for one window format.
pub(super) struct BlitPass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    nearest: wgpu::Sampler,
    /// For pictures of fewer pixels than their place in the window has.
    linear: wgpu::Sampler,
    encodes_srgb: bool,
}

/// What one view needs to be laid down.
pub(super) struct BlitTarget {
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl BlitPass {
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let layout = layout(
            device,
            "blit",
            &[
                uniform_entry(0, false),
                texture_entry(
                    1,
                    wgpu::TextureSampleType::Float { filterable: true },
                    false,
                ),
                wgpu::BindGroupLayoutEntry {
                    binding: 2,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                    count: None,
                },
            ],
        );
        Self {
            pipeline: blit_pipeline(device, &layout, format),
            layout,
            nearest: device.create_sampler(&wgpu::SamplerDescriptor::default()),
            linear: device.create_sampler(&wgpu::SamplerDescriptor {
                mag_filter: wgpu::FilterMode::Linear,
                ..wgpu::SamplerDescriptor::default()
            }),
            encodes_srgb: format.is_srgb(),
        }
    }

    /// Makes what a view needs for its finished picture.
    pub fn target(
        &self,
        device: &wgpu::Device,
        picture: &Resolved,
        quality: Quality,
    ) -> BlitTarget {
        let sampler = match quality {
            Quality::Full => &self.nearest,
            Quality::Moving => &self.linear,
        };
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("blit"),
            size: size_of::<BlitUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("blit"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: uniform.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::TextureView(&picture.view),
                },
                wgpu::BindGroupEntry {
                    binding: 2,
                    resource: wgpu::BindingResource::Sampler(sampler),
                },
            ],
        });
        BlitTarget { uniform, group }
    }

    /// Tells the card the background.
    pub fn set_background(&self, gpu: Gpu<'_>, target: &BlitTarget, background: [f32; 4]) {
        let uniform = BlitUniform {
            background,
            options: [f32::from(u8::from(self.encodes_srgb)), 0.0, 0.0, 0.0],
        };
        gpu.queue
            .write_buffer(&target.uniform, 0, bytemuck::bytes_of(&uniform));
    }

    /// Fills the pass's viewport with the picture.
    pub fn blit(&self, pass: &mut wgpu::RenderPass<'_>, target: &BlitTarget) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &target.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

fn blit_pipeline(
    device: &wgpu::Device,
    group: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("blit"),
        source: wgpu::ShaderSource::Wgsl(SHADER.into()),
    });
    let over = wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    };
    whole_picture_pipeline(device, "blit", &module, "fs_over", &[group], over)
}
