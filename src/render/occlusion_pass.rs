//! Ambient occlusion of opaque surfaces at half size: distances, gathering, blur.

use super::pipelines::{Layouts, PLAIN, layout, texture_entry};
use super::shaders::COMMON;
use super::targets::{OCCLUSION, Scratch};
use super::whole_picture::whole_picture_pipeline;

/// How occlusion and distance share a texel.
pub(super) const TEXEL: &str = include_str!("shaders/occlusion_texel.wgsl");

/// What a texel holds where nothing occludes and nothing lies: the bits of 1e30 and full openness.
const OPEN_AND_FAR: u32 = 0x7149_f2ff;

/// The whole shader text.
pub(super) fn shader_text() -> String {
    [COMMON, TEXEL, include_str!("shaders/occlusion.wgsl")].join("\n")
}

/// Pipelines of the three steps.
pub(super) struct OcclusionPass {
    depth_layout: wgpu::BindGroupLayout,
    before_layout: wgpu::BindGroupLayout,
    distance: wgpu::RenderPipeline,
    gather: wgpu::RenderPipeline,
    blur: wgpu::RenderPipeline,
}

impl OcclusionPass {
    pub fn new(device: &wgpu::Device, layouts: &Layouts) -> Self {
        let depth = texture_entry(0, PLAIN, true);
        let depth_layout = layout(device, "occlusion depth", &[depth]);
        let before_layout = layout(
            device,
            "occlusion before",
            &[texture_entry(1, wgpu::TextureSampleType::Uint, false)],
        );
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("occlusion"),
            source: wgpu::ShaderSource::Wgsl(shader_text().into()),
        });
        let pipeline = |entry, own| {
            let groups = [&layouts.view, own];
            whole_picture_pipeline(device, entry, &module, entry, &groups, OCCLUSION.into())
        };
        Self {
            distance: pipeline("fs_distance", &depth_layout),
            gather: pipeline("fs_gather", &before_layout),
            blur: pipeline("fs_blur", &before_layout),
            depth_layout,
            before_layout,
        }
    }

    /// Records the three steps; the result is in `scratch.occlusion[0]`.
    pub fn encode(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        view: &wgpu::BindGroup,
        scratch: &Scratch,
    ) {
        let group = |layout, binding, texture| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout,
                entries: &[wgpu::BindGroupEntry {
                    binding,
                    resource: wgpu::BindingResource::TextureView(texture),
                }],
            })
        };
        let [a, b] = &scratch.occlusion;
        let depth = group(&self.depth_layout, 0, &scratch.depth);
        let from_a = group(&self.before_layout, 1, a);
        let from_b = group(&self.before_layout, 1, b);
        let steps = [
            (&self.distance, &depth, a),
            (&self.gather, &from_a, b),
            (&self.blur, &from_b, a),
        ];
        for (pipeline, group, target) in steps {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("occlusion"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color {
                            r: f64::from(OPEN_AND_FAR),
                            ..wgpu::Color::BLACK
                        }),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, view, &[]);
            pass.set_bind_group(1, group, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}
