//! Takes the shapes of a frame out of egui's hands before the window draws them.

use std::sync::{Arc, PoisonError};

use egui::epaint::{ClippedShape, Rect, Shape};
use egui::{Context, FullOutput, Plugin, ViewportId};

use super::kept::{FramePaint, WaitingTextures};

/// Hands each frame of the window to the kept picture, as one callback that covers the window.
#[derive(Default)]
pub struct KeepPicture {
    textures: WaitingTextures,
}

impl Plugin for KeepPicture {
    fn debug_name(&self) -> &'static str {
        "kept picture"
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        if ctx.viewport_id() != ViewportId::ROOT {
            return;
        }
        let delta = std::mem::take(&mut output.textures_delta);
        let waiting = &mut *self.textures.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.append(delta);
        let screen = ctx.viewport_rect();
        let paint = FramePaint {
            ctx: ctx.clone(),
            shapes: std::mem::take(&mut output.shapes).into(),
            textures: Arc::clone(&self.textures),
            screen,
            background: ctx.global_style().visuals.window_fill,
        };
        output.shapes.push(ClippedShape {
            clip_rect: Rect::EVERYTHING,
            shape: Shape::Callback(egui_wgpu::Callback::new_paint_callback(screen, paint)),
            transform_after_tessellation: egui::emath::TSTransform::IDENTITY,
        });
    }
}
