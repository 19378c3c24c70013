//! The hook by which our renderer draws into egui's pass.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use egui::{PaintCallbackInfo, Rect, Shape};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};

use super::pace::Pace;
use crate::render::{Camera, Quality, Renderer, Resolution, Scene, ViewId};

/// What draws the scenes of the 3D view: shared by all who draw the window.
#[derive(Clone)]
pub struct SceneDrawing(Arc<Mutex<PaintResources>>);

/// The renderer with how many views the last picture had.
struct PaintResources {
    renderer: Renderer,
    views: u32,
    /// `None` where every picture is drawn in full.
    pace: Option<Pace>,
    /// Where scenes were drawn anew since this was last asked.
    redrawn: Vec<Rect>,
}

impl SceneDrawing {
    fn lock(&self) -> MutexGuard<'_, PaintResources> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Where commands of a picture are recorded.
struct Commands<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    encoder: &'a mut wgpu::CommandEncoder,
}

impl PaintResources {
    /// Draws a scene if it is not on screen yet as well as it should be; returns whether it did.
    fn draw(&mut self, paint: &ScenePaint, to: &mut Commands<'_>, pixels_per_point: f32) -> bool {
        let full = Resolution::full(paint.size, pixels_per_point);
        let Some(mut pace) = self.pace else {
            return self.record(paint, to, full);
        };
        let now = Instant::now();
        let shown = (self.renderer).shows(paint.view, &paint.scene, &paint.camera);
        let resolution = match shown {
            None => pace.of_change(full, self.views, now),
            Some(Quality::Moving) if !pace.until_rest(now).is_zero() => {
                paint.ctx.request_repaint_after(pace.until_rest(now));
                return false;
            }
            Some(_) => full,
        };
        let drawn = if pace.asks_time(resolution) {
            let (drawn, time) = self.record_timed(paint, to, resolution);
            if let Some(time) = time {
                pace.took(resolution, time);
            }
            drawn
        } else {
            self.record(paint, to, resolution)
        };
        if resolution.quality == Quality::Moving {
            paint.ctx.request_repaint_after(pace.until_rest(now));
        }
        self.pace = Some(pace);
        drawn
    }

    /// Draws at once and waits for it; the time is `None` where it is not that of a usual picture.
    fn record_timed(
        &mut self,
        paint: &ScenePaint,
        to: &mut Commands<'_>,
        resolution: Resolution,
    ) -> (bool, Option<Duration>) {
        let (device, queue) = (to.device, to.queue);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let uploads = self.renderer.counters().uploads;
        let begin = Instant::now();
        let mut own = Commands {
            device,
            queue,
            encoder: &mut encoder,
        };
        let drawn = self.record(paint, &mut own, resolution);
        queue.submit([encoder.finish()]);
        let waited = device.poll(wgpu::PollType::wait_indefinitely());
        // What is sent to the card for the first time is no part of the usual picture.
        let usual = drawn && waited.is_ok() && self.renderer.counters().uploads == uploads;
        (drawn, usual.then(|| begin.elapsed()))
    }

    fn record(
        &mut self,
        paint: &ScenePaint,
        to: &mut Commands<'_>,
        resolution: Resolution,
    ) -> bool {
        self.renderer.prepare(
            to.device,
            to.queue,
            to.encoder,
            paint.view,
            &paint.scene,
            &paint.camera,
            resolution,
        )
    }
}

/// Gives the window's device our renderer; without a device, pictures stay empty.
///
/// Where somebody looks on (`live`), scenes that change are drawn as well as there is time for, and in full once they rest.
pub fn install(state: &RenderState, live: bool) -> SceneDrawing {
    let drawing = SceneDrawing(Arc::new(Mutex::new(PaintResources {
        renderer: Renderer::new(&state.device, state.target_format),
        views: 0,
        pace: live.then(Pace::default),
        redrawn: Vec::new(),
    })));
    let mut window = state.renderer.write();
    window.callback_resources.insert(drawing.clone());
    drawing
}

/// What the driver refused of the last picture, if it did.
pub fn failure(state: &RenderState) -> Option<String> {
    let renderer = state.renderer.read();
    let drawing: &SceneDrawing = renderer.callback_resources.get()?;
    drawing.lock().renderer.failure().map(str::to_owned)
}

/// Rectangles whose scenes were drawn anew since this was last asked.
pub fn take_redrawn(resources: &CallbackResources) -> Vec<Rect> {
    let drawing = resources.get::<SceneDrawing>();
    drawing.map_or_else(Vec::new, |drawing| {
        std::mem::take(&mut drawing.lock().redrawn)
    })
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
    /// Where it stands in the window.
    pub rect: Rect,
    /// Width and height in pixels of the screen.
    pub size: [u32; 2],
    /// The window, which is asked for a further frame when it is due.
    pub ctx: egui::Context,
    /// Where the time that this takes is added.
    pub meter: Arc<AtomicU64>,
}

impl ScenePaint {
    /// The shape that draws this.
    pub fn shape(self) -> Shape {
        Shape::Callback(egui_wgpu::Callback::new_paint_callback(self.rect, self))
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
        if let Some(drawing) = resources.get::<SceneDrawing>() {
            let drawing = &mut *drawing.lock();
            // A view beyond those side by side says nothing of them.
            if self.view.0 < self.views {
                for gone in self.views..drawing.views {
                    drawing.renderer.forget(ViewId(gone));
                }
                drawing.views = self.views;
            }
            let mut commands = Commands {
                device,
                queue,
                encoder,
            };
            let drawn = drawing.draw(self, &mut commands, screen.pixels_per_point);
            drawing.redrawn.extend(drawn.then_some(self.rect));
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
        if let Some(drawing) = resources.get::<SceneDrawing>() {
            drawing.lock().renderer.blit(pass, self.view);
        }
    }
}
