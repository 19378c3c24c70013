//! The order of passes in one picture.
//!
//! 1. Depth of opaque surfaces, then ambient occlusion from it, then depth of opaque lines and points.
//! 2. For each translucent layer, nearest first: its depth (behind the layer before, in front of what
//!    is opaque), then its light under what is already there.
//!    Where a device cannot read samples, translucent surfaces are laid over each other whole instead, nearest first.
//! 3. Light of opaque things under the layers, and the average of the four samples.
//!
//! Layers are found sample by sample, so translucency is exact to the number of layers and does not
//! depend on the order of surfaces or triangles.
//!
//! Source: Everitt (2001), "Interactive order-independent transparency", NVIDIA.

use super::drawn::Drawn;
use super::occlusion_pass::OcclusionPass;
use super::pipelines::{Layouts, Pipelines, Stage};
use super::targets::{Capabilities, Scratch};

/// Layers taken at most; what lies behind eight translucent layers adds less than one step of eight-bit colour at opacity 0.5.
const MAX_LAYERS: usize = 8;

/// Called with a pass's name once it is recorded: a bench submits it alone and takes its time.
pub type AfterPass = dyn Fn(&'static str, &mut wgpu::CommandEncoder) + Send + Sync;

/// All that the passes of one picture need.
pub(super) struct Frame<'a> {
    pub device: &'a wgpu::Device,
    pub layouts: &'a Layouts,
    pub pipelines: &'a Pipelines,
    /// `None` on devices that cannot find it.
    pub occlusion: Option<&'a OcclusionPass>,
    pub capabilities: Capabilities,
    /// Towards the viewer.
    pub backward: glam::Vec3,
    /// Whether a further layer is taken, for folds.
    pub folds: bool,
    pub view: &'a wgpu::BindGroup,
    pub drawn: &'a [Drawn],
    /// Occlusion of the whole picture found before, in the place of this tile's own.
    pub kept_occlusion: Option<&'a wgpu::TextureView>,
    /// Hears of every pass that is recorded.
    pub after_pass: Option<&'a AfterPass>,
}

/// Layers worth taking: those that a ray usually meets, and one more for folds where wanted.
fn layer_count(drawn: &[Drawn], folds: bool) -> usize {
    let translucent_surfaces = drawn.iter().filter(|drawn| drawn.translucent);
    match translucent_surfaces.map(|drawn| drawn.layers).sum() {
        0 => 0,
        layers => MAX_LAYERS.min(layers + usize::from(folds)),
    }
}

impl Frame<'_> {
    /// Records all passes; returns the number of draws.
    pub fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        scratch: &mut Scratch,
        resolved: &wgpu::TextureView,
    ) -> u64 {
        let mut draws = 0;
        let opaque_surface = |drawn: &Drawn| drawn.is_surface() && !drawn.translucent;
        draws += self.depth(encoder, &scratch.depth, Some(0.0), opaque_surface);
        self.passed(encoder, "depth of opaque surfaces");
        if let Some(occlusion) = self.occlusion
            && draws > 0
            && self.kept_occlusion.is_none()
        {
            occlusion.encode(self.device, encoder, self.view, scratch);
            self.passed(encoder, "ambient occlusion");
        }
        draws += self.depth(encoder, &scratch.depth, None, |drawn| {
            !drawn.is_surface() && !drawn.translucent
        });
        self.passed(encoder, "depth of lines and points");
        let layers = layer_count(self.drawn, self.folds);
        draws += match self.capabilities {
            _ if layers == 0 => 0,
            Capabilities::Peeled => self.layers(encoder, scratch, layers),
            Capabilities::Plain => self.translucent_surfaces(encoder, scratch),
        };
        draws += self.opaque(encoder, scratch, resolved, layers == 0);
        self.passed(encoder, "light of opaque things, average of samples");
        draws
    }

    fn passed(&self, encoder: &mut wgpu::CommandEncoder, name: &'static str) {
        if let Some(after_pass) = self.after_pass {
            after_pass(name, encoder);
        }
    }

    /// One pass with one sample a pixel, for a picture that another follows at once: translucent surfaces lie over what
    /// is opaque in the order of their triangles, which for a film of one colour is the same in any order.
    pub fn encode_moving(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        depth: &wgpu::TextureView,
        colour: &wgpu::TextureView,
    ) -> u64 {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("moving"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: colour,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, self.view, &[]);
        let draws = self.draw(&mut pass, Stage::Moving, |drawn| !drawn.translucent)
            + self.draw(&mut pass, Stage::MovingFilm, |drawn| drawn.translucent);
        drop(pass);
        self.passed(encoder, "the one pass of a moving picture");
        draws
    }

    fn depth(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        depth: &wgpu::TextureView,
        clear: Option<f32>,
        wanted: impl Fn(&Drawn) -> bool,
    ) -> u64 {
        if clear.is_none() && !self.drawn.iter().any(&wanted) {
            return 0;
        }
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("depth"),
            depth_stencil_attachment: Some(depth_attachment(depth, clear)),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, self.view, &[]);
        self.draw(&mut pass, Stage::OpaqueDepth, wanted)
    }

    fn layers(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        scratch: &mut Scratch,
        count: usize,
    ) -> u64 {
        let layers = scratch.layers(self.device);
        let groups = [0, 1].map(|taken: usize| {
            let entry = |binding, view| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::TextureView(view),
            };
            self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("peel"),
                layout: &self.layouts.peel,
                entries: &[entry(0, &layers[taken]), entry(1, &scratch.depth)],
            })
        });
        let occlusion = self.occlusion_group(scratch);
        let mut draws = 0;
        for layer in 0..count {
            let (depth, taken) = (&layers[layer % 2], &groups[(layer + 1) % 2]);
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("layer depth"),
                depth_stencil_attachment: Some(depth_attachment(depth, Some(0.0))),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_bind_group(0, self.view, &[]);
            pass.set_bind_group(2, taken, &[]);
            let stage = if layer == 0 {
                Stage::FirstDepth
            } else {
                Stage::PeelDepth
            };
            draws += self.draw(&mut pass, stage, |drawn| drawn.translucent);
            drop(pass);
            self.passed(encoder, "depth of translucent layers");
            let mut pass = self.colour_pass(encoder, &scratch.colour, depth, layer == 0, None);
            pass.set_bind_group(2, &occlusion, &[]);
            draws += self.draw(&mut pass, Stage::Colour, |drawn| drawn.translucent);
            drop(pass);
            self.passed(encoder, "light of translucent layers");
        }
        draws
    }

    /// Translucent surfaces whole, nearest first: right between translucent surfaces, not within one.
    fn translucent_surfaces(&self, encoder: &mut wgpu::CommandEncoder, scratch: &Scratch) -> u64 {
        let occlusion = self.occlusion_group(scratch);
        let (colour, depth) = (&scratch.colour, &scratch.depth);
        let mut pass = self.colour_pass(encoder, colour, depth, true, None);
        pass.set_bind_group(2, &occlusion, &[]);
        let mut translucent_surfaces: Vec<&Drawn> = self
            .drawn
            .iter()
            .filter(|drawn| drawn.translucent)
            .collect();
        // Of translucent surfaces about one place, the widest is met first.
        let farness = |surface: &Drawn| {
            let bounds = surface.bounds.as_ref();
            bounds.map_or(f32::INFINITY, |b| {
                -b.centre().dot(self.backward) - b.radius()
            })
        };
        translucent_surfaces.sort_by(|a, b| farness(a).total_cmp(&farness(b)));
        for surface in &translucent_surfaces {
            surface.draw(&mut pass, self.pipelines, Stage::Translucent);
        }
        translucent_surfaces.len() as u64
    }

    fn opaque(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        scratch: &Scratch,
        resolved: &wgpu::TextureView,
        first: bool,
    ) -> u64 {
        let occlusion = self.occlusion_group(scratch);
        let (colour, depth) = (&scratch.colour, &scratch.depth);
        let mut pass = self.colour_pass(encoder, colour, depth, first, Some(resolved));
        pass.set_bind_group(2, &occlusion, &[]);
        self.draw(&mut pass, Stage::Colour, |drawn| !drawn.translucent)
    }

    fn colour_pass<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        colour: &wgpu::TextureView,
        depth: &wgpu::TextureView,
        first: bool,
        resolve_target: Option<&wgpu::TextureView>,
    ) -> wgpu::RenderPass<'e> {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("colour"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: colour,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: if first {
                        wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT)
                    } else {
                        wgpu::LoadOp::Load
                    },
                    store: if resolve_target.is_some() {
                        wgpu::StoreOp::Discard
                    } else {
                        wgpu::StoreOp::Store
                    },
                },
            })],
            depth_stencil_attachment: Some(depth_attachment(depth, None)),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, self.view, &[]);
        pass
    }

    fn occlusion_group(&self, scratch: &Scratch) -> wgpu::BindGroup {
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("occlusion"),
            layout: &self.layouts.occlusion,
            entries: &[wgpu::BindGroupEntry {
                binding: 2,
                resource: wgpu::BindingResource::TextureView(
                    self.kept_occlusion.unwrap_or(&scratch.occlusion[0]),
                ),
            }],
        })
    }

    fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        stage: Stage,
        wanted: impl Fn(&Drawn) -> bool,
    ) -> u64 {
        let mut draws = 0;
        for drawn in self.drawn.iter().filter(|drawn| wanted(drawn)) {
            drawn.draw(pass, self.pipelines, stage);
            draws += 1;
        }
        draws
    }
}

fn depth_attachment(
    view: &wgpu::TextureView,
    clear: Option<f32>,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations {
            load: clear.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear),
            store: wgpu::StoreOp::Store,
        }),
        stencil_ops: None,
    }
}
