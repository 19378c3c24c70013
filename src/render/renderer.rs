//! Draws scenes into textures of its own, and lays them into a window's pass.

use std::collections::HashMap;

use super::blit_pass::BlitPass;
use super::drawn::Drawn;
use super::error_scope::ErrorScope;
use super::frame::{AfterPass, Frame};
use super::identity::same_scene;
use super::occlusion_pass::OcclusionPass;
use super::pipelines::{Layouts, Pipelines, Stage};
use super::surface_pass::Nothing;
use super::targets::{Capabilities, Scratch};
use super::uniforms::{Quality, Resolution, Shot, Tile, UNIFORM_STRIDE, ViewUniform};
use super::uploads::{Gpu, Uploads};
use super::view::{Shown, View};
use super::{Camera, Scene, driver_probe, line_pass, point_pass, surface_pass};

/// Names one of several pictures that are kept at the same time, such as two views side by side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ViewId(pub u32);

/// What was done so far; tests read it to see that nothing is done twice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Arrays sent to the graphics card.
    pub uploads: u64,
    /// Pictures drawn.
    pub redraws: u64,
    /// Draw calls recorded, over all passes.
    pub draws: u64,
}

/// Reach of ambient occlusion as a share of the radius of all opaque surfaces.
const OCCLUSION_REACH: f32 = 0.30;
/// Shared textures of a size that no view used for so many redraws are let go.
const SCRATCH_KEPT_REDRAWS: u64 = 64;

/// The renderer: one per device, for any number of views.
pub struct Renderer {
    layouts: Layouts,
    pipelines: Pipelines,
    /// `None` where the device refuses it.
    occlusion: Option<OcclusionPass>,
    blit: BlitPass,
    target_format: wgpu::TextureFormat,
    /// Found when first drawing where the interface does not promise it.
    capabilities: Option<Result<Capabilities, String>>,
    /// Whether the processor draws.
    software: bool,
    failure: Option<String>,
    nothing: Nothing,
    uploads: Uploads,
    scratch: Vec<Scratch>,
    views: HashMap<ViewId, View>,
    kept_occlusion: Option<wgpu::TextureView>,
    redraws: u64,
    draws: u64,
    after_pass: Option<Box<AfterPass>>,
}

impl Renderer {
    /// A renderer whose pictures go into a pass of this format (`RenderState::target_format` in a window).
    pub fn new(device: &wgpu::Device, target_format: wgpu::TextureFormat) -> Self {
        let info = device.adapter_info();
        let promised = info.backend != wgpu::Backend::Gl;
        let error_scope = ErrorScope::begin(device);
        let layouts = Layouts::new(device);
        let blit = BlitPass::new(device, target_format);
        let nothing = Nothing::new(device);
        let capabilities = match error_scope.end() {
            Err(reason) => Some(Err(reason)),
            Ok(()) => promised.then_some(Ok(Capabilities::Peeled)),
        };
        let error_scope = ErrorScope::begin(device);
        let occlusion = OcclusionPass::new(device, &layouts);
        Self {
            occlusion: error_scope.end().is_ok().then_some(occlusion),
            blit,
            target_format,
            capabilities,
            software: info.device_type == wgpu::DeviceType::Cpu,
            failure: None,
            nothing,
            pipelines: Pipelines::default(),
            uploads: Uploads::default(),
            scratch: Vec::new(),
            views: HashMap::new(),
            kept_occlusion: None,
            redraws: 0,
            draws: 0,
            after_pass: None,
            layouts,
        }
    }

    /// Whether a view's last picture shows this, in whatever quality; if so, in which.
    pub fn shows(&self, view: ViewId, scene: &Scene, camera: &Camera) -> Option<Quality> {
        let shown = self.views.get(&view)?.shown.as_ref()?;
        let same = shown.camera == *camera && same_scene(&shown.scene, scene);
        same.then_some(shown.shot.quality)
    }

    /// Draws a view's picture if anything changed since it was last drawn; returns whether it did.
    #[expect(
        clippy::too_many_arguments,
        reason = "the callback of the window has exactly these at hand"
    )]
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        view: ViewId,
        scene: &Scene,
        camera: &Camera,
        resolution: Resolution,
    ) -> bool {
        let most = device.limits().max_texture_dimension_2d;
        let shot = Shot {
            tile: Tile::all(resolution.pixels.map(|n| n.clamp(1, most))),
            quality: resolution.quality,
            pixels_per_point: resolution.pixels_per_point,
            folds: !self.software,
            occlusion_of: None,
        };
        let unchanged = self.views.get(&view).and_then(|view| view.shown.as_ref());
        if unchanged.is_some_and(|shown| {
            shown.camera == *camera && shown.shot == shot && same_scene(&shown.scene, scene)
        }) {
            return false;
        }
        let gpu = Gpu { device, queue };
        self.failure = self.draw(gpu, encoder, view, (scene, camera), shot).err();
        self.failure.is_none()
    }

    /// Has every pass told as soon as it is recorded.
    pub fn tell_passes(&mut self, after_pass: Box<AfterPass>) {
        self.after_pass = Some(after_pass);
    }

    /// What the driver said when it refused the last picture that was to be prepared.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// Lays a view's last picture over its background into the pass's viewport.
    pub fn blit(&self, pass: &mut wgpu::RenderPass<'_>, view: ViewId) {
        if let Some(finished) = self.views.get(&view).and_then(View::finished) {
            self.blit.blit(pass, &finished.blit);
        }
    }

    /// Lets go of a view that is no longer shown.
    pub fn forget(&mut self, view: ViewId) {
        self.views.remove(&view);
    }

    /// What was done so far.
    pub fn counters(&self) -> Counters {
        Counters {
            uploads: self.uploads.count,
            redraws: self.redraws,
            draws: self.draws,
        }
    }

    /// The finished picture of a view, premultiplied and without its background.
    pub(super) fn picture(&self, view: ViewId) -> Option<&wgpu::Texture> {
        let finished = self.views.get(&view)?.finished()?;
        Some(&finished.resolved.texture)
    }

    /// Keeps the occlusion of the last picture of this size for shots that name it, until the next picture in pieces.
    pub(super) fn keep_occlusion(&mut self, size: [u32; 2]) {
        let scratch = self.scratch.iter().position(|scratch| scratch.size == size);
        self.kept_occlusion = scratch.map(|place| {
            let scratch = self.scratch.swap_remove(place);
            let [found, _] = scratch.occlusion;
            found
        });
    }

    /// A renderer that draws translucent surfaces by these capabilities, whether or not its device can.
    pub(super) fn with_capabilities(mut self, capabilities: Capabilities) -> Self {
        self.capabilities = Some(Ok(capabilities));
        self
    }

    /// Draws whatever was drawn before. If the driver refuses anything, it says what, and nothing is recorded.
    pub(super) fn draw(
        &mut self,
        gpu: Gpu<'_>,
        encoder: &mut wgpu::CommandEncoder,
        id: ViewId,
        (scene, camera): (&Scene, &Camera),
        shot: Shot,
    ) -> Result<(), String> {
        let format = self.target_format;
        let capabilities = self
            .capabilities
            .get_or_insert_with(|| {
                driver_probe::capabilities(gpu, &|capabilities, encoder, view, shot| {
                    let mut probe = Self::new(gpu.device, format).with_capabilities(capabilities);
                    probe.draw(gpu, encoder, ViewId(0), view, shot)
                })
            })
            .clone()?;
        let error_scope = ErrorScope::begin(gpu.device);
        let (tile, pixels_per_point) = (shot.tile, shot.pixels_per_point);
        let moving = shot.quality == Quality::Moving;
        let count = scene.surfaces.len() + scene.lines.len() + scene.points.len();
        let mut view = self.views.remove(&id).unwrap_or_default();
        let uniforms = view.uniforms(gpu.device, &self.layouts, count);
        let (drawn, blocks, reach) =
            self.collect(gpu, scene, pixels_per_point, &uniforms.draw_uniforms);
        let occlusion = self
            .occlusion
            .as_ref()
            .filter(|_| capabilities == Capabilities::Peeled && !moving);
        let reach = occlusion.map_or(0.0, |_| reach);
        gpu.queue.write_buffer(&uniforms.draw_uniforms, 0, &blocks);
        let uniform = ViewUniform::new(camera, shot, reach, scene.background);
        gpu.queue
            .write_buffer(&uniforms.view_uniform, 0, bytemuck::bytes_of(&uniform));
        let view_group = uniforms.view_group.clone();
        let (finished, depth) = view.target(gpu.device, &self.blit, shot);
        self.blit
            .set_background(gpu, &finished.blit, scene.background);
        prepare_pipelines(
            &mut self.pipelines,
            (gpu.device, &self.layouts),
            &drawn,
            (capabilities, shot.quality),
        );
        let mut scratch =
            (!moving).then(|| take_scratch(&mut self.scratch, gpu.device, tile.size, capabilities));
        if let Some(scratch) = &mut scratch {
            scratch.last_used = self.redraws + 1;
            if capabilities == Capabilities::Peeled && drawn.iter().any(|drawn| drawn.translucent) {
                scratch.layers(gpu.device);
            }
        }
        if let Err(reason) = error_scope.end() {
            self.pipelines = Pipelines::default();
            self.scratch.clear();
            self.uploads.forget();
            return Err(reason);
        }
        let frame = Frame {
            device: gpu.device,
            layouts: &self.layouts,
            pipelines: &self.pipelines,
            occlusion,
            capabilities,
            backward: camera.backward(),
            folds: shot.folds,
            view: &view_group,
            drawn: &drawn,
            kept_occlusion: self
                .kept_occlusion
                .as_ref()
                .filter(|_| shot.occlusion_of.is_some()),
            after_pass: self.after_pass.as_deref(),
        };
        let resolved = &finished.resolved.view;
        self.draws += match (&mut scratch, depth) {
            (Some(scratch), _) => frame.encode(encoder, scratch, resolved),
            (None, Some(depth)) => frame.encode_moving(encoder, &depth, resolved),
            (None, None) => 0,
        };
        self.redraws += 1;
        self.scratch.extend(scratch);
        let now = self.redraws;
        self.scratch
            .retain(|scratch| now - scratch.last_used <= SCRATCH_KEPT_REDRAWS);
        self.uploads.evict();
        view.shown = Some(Shown {
            scene: scene.clone(),
            camera: *camera,
            shot,
        });
        self.views.insert(id, view);
        Ok(())
    }

    /// Everything to draw, its uniforms, and the reach of ambient occlusion in coordinates.
    fn collect(
        &mut self,
        gpu: Gpu<'_>,
        scene: &Scene,
        pixels_per_point: f32,
        uniforms: &wgpu::Buffer,
    ) -> (Vec<Drawn>, Vec<u8>, f32) {
        let mut drawn = Vec::new();
        let mut blocks = Vec::new();
        let mut opaque = None;
        let uploads = &mut self.uploads;
        for surface in &scene.surfaces {
            let place = (uniforms, blocks.len() as u32);
            let known = (&self.layouts, &self.nothing);
            if let Some((draws, block)) = surface_pass::drawn(gpu, uploads, known, surface, place) {
                if surface.opacity >= 1.0 {
                    let bounds = uploads.geometry(gpu, &surface.geometry).bounds;
                    opaque = opaque
                        .into_iter()
                        .chain(bounds)
                        .reduce(super::Bounds::joined);
                }
                drawn.extend(draws);
                push_block(&mut blocks, &block);
            }
        }
        for lines in &scene.lines {
            let place = (uniforms, blocks.len() as u32);
            let layouts = &self.layouts;
            if let Some((draw, block)) =
                line_pass::drawn(gpu, uploads, layouts, lines, pixels_per_point, place)
            {
                drawn.push(draw);
                push_block(&mut blocks, &block);
            }
        }
        for points in &scene.points {
            let place = (uniforms, blocks.len() as u32);
            let layouts = &self.layouts;
            if let Some((draw, block)) =
                point_pass::drawn(gpu, uploads, layouts, points, pixels_per_point, place)
            {
                drawn.push(draw);
                push_block(&mut blocks, &block);
            }
        }
        let reach = opaque.map_or(0.0, |bounds| OCCLUSION_REACH * bounds.radius());
        (drawn, blocks, reach)
    }
}

fn prepare_pipelines(
    pipelines: &mut Pipelines,
    (device, layouts): (&wgpu::Device, &Layouts),
    drawn: &[Drawn],
    (capabilities, quality): (Capabilities, Quality),
) {
    for draw in drawn {
        let stages: &[Stage] = match (quality, draw.translucent, capabilities) {
            (Quality::Moving, false, _) => &[Stage::Moving],
            (Quality::Moving, true, _) => &[Stage::MovingFilm],
            (Quality::Full, false, _) => &[Stage::OpaqueDepth, Stage::Colour],
            (Quality::Full, true, Capabilities::Peeled) => {
                &[Stage::FirstDepth, Stage::PeelDepth, Stage::Colour]
            }
            (Quality::Full, true, Capabilities::Plain) => &[Stage::Translucent],
        };
        for &stage in stages {
            pipelines.prepare(device, layouts, draw.kind, stage);
        }
    }
}

fn take_scratch(
    kept: &mut Vec<Scratch>,
    device: &wgpu::Device,
    size: [u32; 2],
    capabilities: Capabilities,
) -> Scratch {
    match kept.iter().position(|scratch| scratch.size == size) {
        Some(place) => kept.swap_remove(place),
        None => Scratch::new(device, size, capabilities),
    }
}

fn push_block(blocks: &mut Vec<u8>, block: &impl bytemuck::NoUninit) {
    let start = blocks.len();
    blocks.extend_from_slice(bytemuck::bytes_of(block));
    blocks.resize(start + UNIFORM_STRIDE as usize, 0);
}
