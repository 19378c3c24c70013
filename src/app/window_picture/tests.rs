//! A kept picture shows, pixel by pixel, what a picture drawn anew shows.

use egui::{Color32, Context, Event, FullOutput, Pos2, RawInput, Rect, Ui, pos2, vec2};
use egui_wgpu::{RendererOptions, ScreenDescriptor};

use super::KeepPicture;
use super::kept::Kept;
use crate::render::{Headless, read_back};

const SIZE: [u32; 2] = [360, 240];
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A window without a screen.
struct Window {
    ctx: Context,
    device: wgpu::Device,
    queue: wgpu::Queue,
    renderer: egui_wgpu::Renderer,
    pixels_per_point: f32,
}

impl Window {
    fn new(
        (device, queue): (wgpu::Device, wgpu::Queue),
        pixels_per_point: f32,
        keep: bool,
    ) -> Self {
        let options = RendererOptions {
            dithering: false,
            ..RendererOptions::default()
        };
        let mut renderer = egui_wgpu::Renderer::new(&device, FORMAT, options);
        let ctx = Context::default();
        if keep {
            renderer
                .callback_resources
                .insert(Kept::new(&device, FORMAT));
            ctx.add_plugin(KeepPicture::default());
        }
        Self {
            ctx,
            device,
            queue,
            renderer,
            pixels_per_point,
        }
    }

    /// Draws a frame as eframe does, and reads it back.
    fn frame(&mut self, pointer: Pos2, ui: impl FnMut(&mut Ui)) -> Vec<u8> {
        let points = vec2(SIZE[0] as f32, SIZE[1] as f32) / self.pixels_per_point;
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, points)),
            events: vec![Event::PointerMoved(pointer)],
            ..RawInput::default()
        };
        let viewport = input.viewports.entry(egui::ViewportId::ROOT).or_default();
        viewport.native_pixels_per_point = Some(self.pixels_per_point);
        let output: FullOutput = self.ctx.run_ui(input, ui);
        for (id, changes) in &output.textures_delta.set {
            for change in changes {
                self.renderer
                    .update_texture(&self.device, &self.queue, *id, change);
            }
        }
        let primitives = self.ctx.tessellate(output.shapes, self.pixels_per_point);
        let screen = ScreenDescriptor {
            size_in_pixels: SIZE,
            pixels_per_point: self.pixels_per_point,
        };
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d {
                width: SIZE[0],
                height: SIZE[1],
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder =
            (self.device).create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let (device, queue) = (&self.device, &self.queue);
        self.renderer
            .update_buffers(device, queue, &mut encoder, &primitives, &screen);
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..wgpu::RenderPassDescriptor::default()
        });
        self.renderer
            .render(&mut pass.forget_lifetime(), &primitives, &screen);
        read_back(device, queue, encoder, &texture).unwrap()
    }
}

/// Something of everything that a pane draws: texts, a table under the pointer, lines, a shadow, a window that comes and goes.
fn interface(ui: &mut Ui, step: usize) {
    egui::CentralPanel::default().show(ui, |ui| {
        ui.heading(format!("Step {step}"));
        for row in 0..6 {
            let _ = ui.selectable_label(row == step % 6, format!("subject {row}"));
        }
        let painter = ui.painter();
        let at = |n: usize| {
            pos2(
                120.0 + 20.0 * n as f32,
                40.0 + 9.0 * ((n * step) % 11) as f32,
            )
        };
        let stroke = egui::Stroke::new(1.5, Color32::LIGHT_BLUE);
        for n in 0..6 {
            painter.line_segment([at(n), at(n + 1)], stroke);
            painter.circle_filled(at(n), 3.0, Color32::GOLD);
        }
        ui.add(egui::ProgressBar::new(step as f32 / 20.0));
    });
    if step % 4 > 1 {
        let frame = egui::Window::new("card").fixed_pos(pos2(60.0 + step as f32, 90.0));
        frame.show(ui.ctx(), |ui| ui.label("above all"));
    }
}

#[test]
fn a_kept_picture_is_the_picture_drawn_anew() {
    let Ok(headless) = Headless::new() else {
        return;
    };
    let gpu = headless.into_gpu();
    for pixels_per_point in [1.0, 1.5, 2.0] {
        let mut anew = Window::new(gpu.clone(), pixels_per_point, false);
        let mut kept = Window::new(gpu.clone(), pixels_per_point, true);
        let mut before = Vec::new();
        for step in 0..14 {
            let pointer = pos2(30.0, 20.0 + 11.0 * step as f32);
            let expected = anew.frame(pointer, |ui| interface(ui, step));
            let got = kept.frame(pointer, |ui| interface(ui, step));
            let apart = expected.iter().zip(&got).map(|(a, b)| a.abs_diff(*b)).max();
            assert!(
                apart <= Some(1),
                "step {step} at {pixels_per_point}: {apart:?} of 255"
            );
            assert_ne!(expected, before, "the steps differ");
            before = expected;
        }
    }
}
