//! The kept picture: a texture of the window's size, into which changed areas are drawn.

use std::sync::{Arc, Mutex, PoisonError};

use egui::epaint::textures::TexturesDelta;
use egui::epaint::{ClippedPrimitive, ClippedShape, Primitive};
use egui::{Color32, Context, CornerRadius, PaintCallbackInfo, Rect, Shape, TextureId};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, RendererOptions, ScreenDescriptor};

use super::changes::{Areas, changed_areas, scene_pixels};
use super::target::{Copier, Target};
use crate::panes::viewport::paint::{self, SceneDrawing};

/// Changes of textures that no frame has drawn yet: a frame may be made and not shown.
pub(super) type WaitingTextures = Arc<Mutex<TexturesDelta>>;

/// All shapes of one frame.
pub(super) struct FramePaint {
    pub ctx: Context,
    pub shapes: Arc<[ClippedShape]>,
    pub textures: WaitingTextures,
    pub screen: Rect,
    /// What lies under all shapes.
    pub background: Color32,
}

/// What a picture was drawn for: if any of it changes, all is drawn again.
#[derive(Clone, Copy, PartialEq)]
struct Ground {
    screen: Rect,
    pixels_per_point: f32,
    background: Color32,
}

/// The picture with what draws into it.
pub(super) struct Kept {
    /// Draws shapes; holds the textures of the interface and what draws the 3D view.
    shapes: egui_wgpu::Renderer,
    copier: Copier,
    target: Option<(Target, Ground)>,
    /// The shapes that the picture shows.
    drawn: Arc<[ClippedShape]>,
    /// Textures that the last frame drew for the last time.
    freed: Vec<TextureId>,
}

/// The device and where its commands are recorded.
struct Recorder<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    encoder: &'a mut wgpu::CommandEncoder,
    screen: &'a ScreenDescriptor,
}

/// Gives the window's device what keeps the picture; scenes of the 3D view are drawn by `scenes`.
pub fn install(state: &RenderState, scenes: SceneDrawing) {
    let mut kept = Kept::new(&state.device, state.target_format);
    kept.shapes.callback_resources.insert(scenes);
    state.renderer.write().callback_resources.insert(kept);
}

impl CallbackTrait for FramePaint {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let recorder = Recorder {
            device,
            queue,
            encoder,
            screen,
        };
        match resources.get_mut::<Kept>() {
            Some(kept) => kept.draw(recorder, self),
            None => Vec::new(),
        }
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(kept) = resources.get::<Kept>()
            && let Some((target, _)) = &kept.target
        {
            kept.copier.copy(pass, target);
        }
    }
}

impl Kept {
    /// Nothing drawn yet, for windows of this format.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        // Without dithering the same shapes give the same pixels wherever an area begins.
        let options = RendererOptions {
            dithering: false,
            ..RendererOptions::default()
        };
        Self {
            shapes: egui_wgpu::Renderer::new(device, format, options),
            copier: Copier::new(device, format),
            target: None,
            drawn: Arc::new([]),
            freed: Vec::new(),
        }
    }

    fn draw(&mut self, recorder: Recorder<'_>, frame: &FramePaint) -> Vec<wgpu::CommandBuffer> {
        let Recorder {
            device,
            queue,
            encoder,
            screen,
        } = recorder;
        let images_changed = self.take_textures(device, queue, frame);
        let size = screen.size_in_pixels;
        let ground = Ground {
            screen: frame.screen,
            pixels_per_point: screen.pixels_per_point,
            background: frame.background,
        };
        let whole = images_changed
            || !self
                .target
                .as_ref()
                .is_some_and(|(t, g)| t.size == size && *g == ground);
        if self
            .target
            .as_ref()
            .is_none_or(|(target, _)| target.size != size)
        {
            self.target = Some((self.copier.target(device, size), ground));
        }
        // Scenes first: which of them drew themselves anew is part of what changed.
        let scenes: Vec<ClippedPrimitive> = frame.shapes.iter().filter_map(scene).collect();
        let mut commands = self
            .shapes
            .update_buffers(device, queue, encoder, &scenes, screen);
        let redrawn = paint::take_redrawn(&self.shapes.callback_resources);
        let areas = if whole {
            let mut all = Areas::new(frame.screen, screen.pixels_per_point);
            all.add(frame.screen);
            all
        } else {
            let scale = screen.pixels_per_point;
            let mut areas = changed_areas(&self.drawn, &frame.shapes, frame.screen, scale);
            redrawn.into_iter().for_each(|rect| areas.add_scene(rect));
            areas
        };
        self.drawn = Arc::clone(&frame.shapes);
        let primitives = primitives_within(frame, areas.rects(), screen.pixels_per_point);
        if !primitives.is_empty() {
            commands.extend((self.shapes).update_buffers(
                device,
                queue,
                encoder,
                &primitives,
                screen,
            ));
        }
        if let Some((target, drawn_for)) = &mut self.target {
            *drawn_for = ground;
            let load = if whole {
                wgpu::LoadOp::Clear(wgpu::Color::BLACK)
            } else {
                wgpu::LoadOp::Load
            };
            if !primitives.is_empty() {
                let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                    label: Some("changed areas"),
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: &target.view,
                        depth_slice: None,
                        resolve_target: None,
                        ops: wgpu::Operations {
                            load,
                            store: wgpu::StoreOp::Store,
                        },
                    })],
                    ..wgpu::RenderPassDescriptor::default()
                });
                self.shapes
                    .render(&mut pass.forget_lifetime(), &primitives, screen);
            }
        }
        commands
    }

    /// Takes textures in; returns whether images within the interface changed, which shapes do not tell.
    fn take_textures(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        frame: &FramePaint,
    ) -> bool {
        for id in self.freed.drain(..) {
            self.shapes.free_texture(&id);
        }
        let waiting = &mut *frame
            .textures
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let delta = std::mem::take(waiting);
        self.freed.extend(&delta.free);
        let mut images_changed = false;
        for (id, changes) in &delta.set {
            // Of the typeface only glyphs are added; places of those that are drawn stay.
            images_changed |= *id != TextureId::default() || changes.iter().any(|c| c.is_whole());
            for change in changes {
                self.shapes.update_texture(device, queue, *id, change);
            }
        }
        images_changed
    }
}

fn scene(clipped: &ClippedShape) -> Option<ClippedPrimitive> {
    match &clipped.shape {
        Shape::Callback(callback) => Some(ClippedPrimitive {
            clip_rect: clipped.clip_rect,
            primitive: Primitive::Callback(callback.clone()),
        }),
        _ => None,
    }
}

/// Everything that an area shows, from the last shape up that hides all below, area by area.
fn primitives_within(
    frame: &FramePaint,
    areas: &[Rect],
    pixels_per_point: f32,
) -> Vec<ClippedPrimitive> {
    let mut shapes = Vec::new();
    for &area in areas {
        let hiding = frame
            .shapes
            .iter()
            .rposition(|clipped| hides(clipped, area, pixels_per_point));
        if hiding.is_none() {
            shapes.push(ClippedShape {
                clip_rect: area,
                shape: Shape::rect_filled(area, CornerRadius::ZERO, frame.background.to_opaque()),
                transform_after_tessellation: egui::emath::TSTransform::IDENTITY,
            });
        }
        let within = frame.shapes[hiding.unwrap_or(0)..]
            .iter()
            .filter_map(|clipped| {
                let clip_rect = clipped.clip_rect.intersect(area);
                clip_rect.is_positive().then(|| ClippedShape {
                    clip_rect,
                    ..clipped.clone()
                })
            });
        shapes.extend(within);
    }
    frame.ctx.tessellate(shapes, pixels_per_point)
}

/// Whether a shape certainly covers all of an area, so that nothing below it can be seen there.
fn hides(clipped: &ClippedShape, area: Rect, pixels_per_point: f32) -> bool {
    let covered = match &clipped.shape {
        // A scene is laid over a background of its own.
        Shape::Callback(callback) => scene_pixels(callback.rect, pixels_per_point),
        Shape::Rect(rect) if rect.fill.is_opaque() && rect.blur_width == 0.0 => {
            let corner = rect.corner_radius;
            let radii = [corner.nw, corner.ne, corner.sw, corner.se];
            let radius = radii.into_iter().max().unwrap_or(0);
            // The edge itself is smoothed.
            rect.rect.shrink(f32::from(radius) + 1.0)
        }
        _ => return false,
    };
    clipped.transform_after_tessellation == egui::emath::TSTransform::IDENTITY
        && covered.contains_rect(area)
        // The clip that the card is given has whole pixels, too.
        && scene_pixels(clipped.clip_rect, pixels_per_point).contains_rect(area)
}
