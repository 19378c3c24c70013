//! The hook by which our renderer draws into egui's pass.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use egui::{PaintCallbackInfo, Rect, Shape};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};

use crate::render::{Camera, Renderer, Scene, ViewId};

/// The renderer with how many views the last picture had.
struct PaintResources {
    renderer: Renderer,
    views: u32,
}

/// Gives the window's device our renderer; without a device, pictures stay empty.
pub fn install(state: &RenderState) {
    let renderer = Renderer::new(&state.device, state.target_format);
    state
        .renderer
        .write()
        .callback_resources
        .insert(PaintResources { renderer, views: 0 });
}

/// What the driver refused of the last picture, if it did.
pub fn failure(state: &RenderState) -> Option<String> {
    let renderer = state.renderer.read();
    let drawing: &PaintResources = renderer.callback_resources.get()?;
    drawing.renderer.failure().map(str::to_owned)
}

/// What the status bar says of the device.
pub fn adapter_name(state: &RenderState) -> String {
    let info = state.adapter.get_info();
    let software = info.device_type == wgpu::DeviceType::Cpu;
    let name = info.name.split(" (").next().unwrap_or(&info.name);
    if software {
        format!("software {:?}", info.backend)
    } else {
        name.to_owned()
    }
}

/// One scene of the 3D view.
pub struct ScenePaint {
    /// Which of the views side by side.
    pub view: ViewId,
    /// How many views the picture has.
    pub views: u32,
    /// What is drawn.
    pub scene: Scene,
    /// From where.
    pub camera: Camera,
    /// Width and height in pixels of the screen.
    pub size: [u32; 2],
    /// Where the time that this takes is added.
    pub meter: Arc<AtomicU64>,
}

impl ScenePaint {
    /// The shape that draws this into `rect`.
    pub fn shape(self, rect: Rect) -> Shape {
        Shape::Callback(egui_wgpu::Callback::new_paint_callback(rect, self))
    }
}

/// The pixels that egui gives to a rectangle: its edges are rounded, not its size.
pub fn pixels(rect: Rect, pixels_per_point: f32) -> [u32; 2] {
    let span = |low: f32, high: f32| {
        ((high * pixels_per_point).round() - (low * pixels_per_point).round()).max(1.0) as u32
    };
    [
        span(rect.left(), rect.right()),
        span(rect.top(), rect.bottom()),
    ]
}

impl CallbackTrait for ScenePaint {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let begin = Instant::now();
        if let Some(drawing) = resources.get_mut::<PaintResources>() {
            for gone in self.views..drawing.views {
                drawing.renderer.forget(ViewId(gone));
            }
            drawing.views = self.views;
            drawing.renderer.prepare(
                device,
                queue,
                encoder,
                self.view,
                &self.scene,
                &self.camera,
                self.size,
                screen.pixels_per_point,
            );
        }
        let spent = u64::try_from(begin.elapsed().as_nanos()).unwrap_or(u64::MAX);
        self.meter.fetch_add(spent, Ordering::Relaxed);
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(drawing) = resources.get::<PaintResources>() {
            drawing.renderer.blit(pass, self.view);
        }
    }
}
