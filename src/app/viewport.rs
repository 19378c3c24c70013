//! The 3D view: hearts drawn by our renderer, the camera under the pointer, and what lies over them.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::{Rect, Response, Role, Sense, Stroke, Ui, UiBuilder, WidgetInfo};

use crate::picture::{CohortLimits, ColourLegend, PictureTheme, SceneSettings, subject_scene};
use crate::render::{Camera, ViewId};
use crate::study::Subject;
use crate::ui::theme::{colours, line, radius, type_size};
use crate::ui::{Command, ViewMode, viewport_overlay_ui};

use super::camera_drag::camera_command;
use super::paint::{HeartPaint, pixels};
use super::pick_label::{Picked, picked, picked_ui};
use super::pictures::{Heart, Pictures};
use super::play::pose_at;
use super::stage::{on_stage, places};
use super::state::State;
use super::views::{OverlayData, phase_name};

/// Room left and right, above and below a fitted heart, in points: name and scale stand there.
const ROOM: [f32; 2] = [24.0, 46.0];
/// The same in a grid, whose names stand above it.
const GRID_ROOM: [f32; 2] = [8.0, 10.0];

/// A heart on screen: it stays until the next one is ready.
#[derive(Clone)]
pub struct ShownHeart {
    /// Index into the study's subjects.
    pub index: usize,
    /// Whose heart it is.
    pub subject: Arc<Subject>,
    /// Place in its beat.
    pub position: f64,
    /// Its geometry.
    pub heart: Arc<Heart>,
    overlay: OverlayData,
}

/// A camera that fits a heart, kept while heart, direction and shape of the view stay.
struct Fit {
    heart: Arc<Heart>,
    world_from_camera: glam::Quat,
    aspect: f32,
    camera: Camera,
}

/// The hearts on screen and what was worked out for them.
#[derive(Default)]
pub struct Viewport {
    shown: Vec<ShownHeart>,
    mode: ViewMode,
    limits: CohortLimits,
    fits: Vec<Fit>,
    pinned: Option<Picked>,
    has_device: bool,
}

/// One heart of this frame's picture.
pub struct Cell<'a> {
    /// Which heart.
    pub heart: &'a ShownHeart,
    /// Where on the screen.
    pub rect: Rect,
    /// From where it is looked at.
    pub camera: Camera,
}

impl Viewport {
    /// A view that draws if there is a device to draw with.
    pub fn new(has_device: bool) -> Self {
        Self {
            has_device,
            ..Self::default()
        }
    }

    /// Asks for the hearts of the state; shows them together once all are ready.
    pub fn prepare(&mut self, state: &State, pictures: &mut Pictures, reference_frames: &[usize]) {
        let study = state.document.study();
        let mut ready = Vec::new();
        let mut complete = true;
        for place in on_stage(state) {
            let Some(subject) = state.subject(place.subject) else {
                continue;
            };
            let reference = reference_frames.get(place.subject).copied().unwrap_or(0);
            match pictures.heart(subject, reference) {
                Some(heart) => ready.push(ShownHeart {
                    index: place.subject,
                    subject: Arc::clone(subject),
                    position: place.position,
                    heart,
                    overlay: OverlayData::of(state, &place),
                }),
                None => complete = false,
            }
        }
        if complete {
            self.shown = ready;
            self.mode = state.document.view_mode;
        }
        if !study.subjects.is_empty() {
            self.limits = pictures.cohort_limits(study, reference_frames);
        }
        let shown = &self.shown;
        self.fits.retain(|fit| {
            shown
                .iter()
                .any(|shown| Arc::ptr_eq(&shown.heart, &fit.heart))
        });
    }

    /// Hearts on screen.
    pub fn shown(&self) -> &[ShownHeart] {
        &self.shown
    }

    /// The camera of a heart on screen, as last drawn; fitted to a square where it never was.
    pub fn camera(&self, state: &State, shown: &ShownHeart) -> Camera {
        let look = state.document.look;
        let fit = self
            .fits
            .iter()
            .find(|fit| Arc::ptr_eq(&fit.heart, &shown.heart));
        let fitted = fit.map_or_else(
            || {
                let rotation = look.rotation(&shown.heart.prepared.axes);
                shown.heart.fitted(rotation, 1.0)
            },
            |fit| fit.camera,
        );
        look.camera(&shown.heart.frame, fitted)
    }

    /// How hearts are drawn now.
    pub fn settings(&self, state: &State, dark: bool) -> SceneSettings {
        let document = &state.document;
        let visible = document.visibility;
        SceneSettings {
            quantity: document.quantity,
            cohort_limits: self.limits,
            typed_limits: document.limits(),
            inner: visible.endocardium,
            outer: visible.epicardium,
            wireframe: visible.wireframe,
            vertices: visible.vertices,
            shading: visible.shading,
            theme: if dark {
                PictureTheme::DARK
            } else {
                PictureTheme::LIGHT
            },
            ..SceneSettings::default()
        }
    }

    /// Draws the view into all room left; `meter` takes the time of the callback.
    pub fn ui(
        &mut self,
        ui: &mut Ui,
        state: &State,
        meter: &Arc<AtomicU64>,
        commands: &mut Vec<Command>,
    ) {
        let (area, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "3D viewport"));
        let cameras = self.cameras(state, area);
        let cells: Vec<Cell> = self
            .shown
            .iter()
            .zip(places(self.mode, area, self.shown.len()))
            .zip(cameras)
            .map(|((heart, rect), camera)| Cell {
                heart,
                rect,
                camera,
            })
            .collect();
        commands.extend(camera_command(ui, &response, state, &cells));
        commands.extend(self.click_command(&response, &cells));
        let settings = self.settings(state, ui.visuals().dark_mode);
        let (hovered, clicked) = pointed(&response, state, &cells, &settings);
        let legend = self.draw(ui, &settings, &cells, meter);
        self.overlays_ui(ui, state, &cells, (area, legend.as_ref()), commands);
        let quantity = state.document.quantity;
        let pinned = match clicked {
            Some(now) => now,
            None => self.pinned.clone(),
        };
        for picked in hovered.iter().chain(&pinned) {
            for cell in cells.iter().filter(|cell| picked.is_on(cell)) {
                picked_ui(ui, cell, picked, quantity);
            }
        }
        self.pinned = pinned;
    }

    /// A camera for every heart on screen. Hearts beside each other have one scale.
    fn cameras(&mut self, state: &State, area: Rect) -> Vec<Camera> {
        let look = state.document.look;
        let rects = places(self.mode, area, self.shown.len());
        let shown: Vec<Arc<Heart>> = self.shown.iter().map(|s| Arc::clone(&s.heart)).collect();
        let mut fitted: Vec<Camera> = shown
            .iter()
            .zip(&rects)
            .map(|(heart, rect)| {
                let rotation = look.rotation(&heart.prepared.axes);
                self.fitted(heart, rotation, *rect)
            })
            .collect();
        let greatest = fitted
            .iter()
            .map(|camera| camera.half_height)
            .fold(0.0, f32::max);
        for camera in &mut fitted {
            camera.half_height = greatest;
        }
        shown
            .iter()
            .zip(fitted)
            .map(|(heart, fitted)| look.camera(&heart.frame, fitted))
            .collect()
    }

    /// A camera that fits a heart into a cell, with room around it for name, scale and cube.
    fn fitted(&mut self, heart: &Arc<Heart>, rotation: glam::Quat, rect: Rect) -> Camera {
        let room = if self.mode == ViewMode::AllPhases {
            GRID_ROOM
        } else {
            ROOM.map(|room| room.min(0.12 * rect.height()))
        };
        let inner =
            (rect.size() - egui::vec2(2.0 * room[0], 2.0 * room[1])).max(egui::Vec2::splat(1.0));
        let camera = self.tightly_fitted(heart, rotation, inner.x / inner.y);
        Camera {
            half_height: camera.half_height * rect.height().max(1.0) / inner.y,
            ..camera
        }
    }

    fn tightly_fitted(&mut self, heart: &Arc<Heart>, rotation: glam::Quat, aspect: f32) -> Camera {
        let found = self.fits.iter().find(|fit| {
            Arc::ptr_eq(&fit.heart, heart)
                && fit.world_from_camera == rotation
                && (fit.aspect - aspect).abs() < 1e-4
        });
        if let Some(fit) = found {
            return fit.camera;
        }
        let camera = heart.fitted(rotation, aspect);
        self.fits.retain(|fit| !Arc::ptr_eq(&fit.heart, heart));
        self.fits.push(Fit {
            heart: Arc::clone(heart),
            world_from_camera: rotation,
            aspect,
            camera,
        });
        camera
    }

    /// A double click fits the heart; a click on one of all phases goes there.
    fn click_command(&self, response: &Response, cells: &[Cell]) -> Option<Command> {
        if response.double_clicked() {
            return Some(Command::FrameAll);
        }
        let at = response
            .interact_pointer_pos()
            .filter(|_| response.clicked())?;
        let cell = cells.iter().find(|cell| cell.rect.contains(at))?;
        (self.mode == ViewMode::AllPhases).then_some(Command::SetPosition(cell.heart.position))
    }

    /// Hands the hearts to our renderer; returns what the colours mean.
    fn draw(
        &self,
        ui: &Ui,
        settings: &SceneSettings,
        cells: &[Cell],
        meter: &Arc<AtomicU64>,
    ) -> Option<ColourLegend> {
        let mut legend = None;
        for (place, cell) in cells.iter().enumerate() {
            let prepared = &cell.heart.heart.prepared;
            let pose = pose_at(cell.heart.position, prepared.frame_count);
            let picture = subject_scene(prepared, settings, pose);
            legend = legend.or(picture.legend);
            if !self.has_device {
                continue;
            }
            let paint = HeartPaint {
                view: ViewId(place as u32),
                views: cells.len() as u32,
                scene: picture.scene,
                camera: cell.camera,
                size: pixels(cell.rect, ui.pixels_per_point()),
                meter: Arc::clone(meter),
            };
            ui.painter().add(paint.shape(cell.rect));
        }
        legend
    }

    fn overlays_ui(
        &self,
        ui: &mut Ui,
        state: &State,
        cells: &[Cell],
        (area, legend): (Rect, Option<&ColourLegend>),
        commands: &mut Vec<Command>,
    ) {
        let whole_beat = self.mode == ViewMode::AllPhases;
        let shown = if whole_beat {
            &cells[..cells.len().min(1)]
        } else {
            cells
        };
        for (place, cell) in shown.iter().enumerate() {
            let rect = if whole_beat { area } else { cell.rect };
            let last = place + 1 == shown.len();
            let legend = legend.filter(|_| place == 0);
            let view = cell.heart.overlay.view(
                legend,
                &cell.heart.heart.prepared,
                &cell.camera,
                cell.rect.height(),
                last,
            );
            let builder = UiBuilder::new().max_rect(rect).id_salt(("heart", place));
            let mut over = ui.new_child(builder);
            over.set_clip_rect(rect.intersect(ui.clip_rect()));
            viewport_overlay_ui(&mut over, &view, commands);
            if place > 0 {
                let line = Stroke::new(line::THIN, colours(ui).line);
                ui.painter().vline(rect.left(), rect.y_range(), line);
            }
        }
        if whole_beat {
            for cell in cells {
                frame_label(ui, state, cell);
            }
        }
    }
}

/// The vertex under a resting pointer, and the vertex that was clicked: `Some(None)` where a
/// click met nothing. While the beat plays or the heart turns, nothing is looked for.
fn pointed(
    response: &Response,
    state: &State,
    cells: &[Cell],
    settings: &SceneSettings,
) -> (Option<Picked>, Option<Option<Picked>>) {
    let at = |place: Option<egui::Pos2>| {
        let place = place?;
        let cell = cells.iter().find(|cell| cell.rect.contains(place))?;
        picked(cell, settings, place)
    };
    let clicked = response
        .clicked()
        .then(|| at(response.interact_pointer_pos()));
    let quiet = !state.play.playing && !response.dragged();
    let hovered = quiet.then(|| at(response.hover_pos())).flatten();
    (hovered, clicked)
}

/// The number of a frame over its heart in the grid of all phases; the one that the time bar
/// stands on is marked.
fn frame_label(ui: &Ui, state: &State, cell: &Cell) {
    let frame = cell.heart.position as usize;
    let phase = phase_name(state.phases_of(cell.heart.index), frame);
    let text = match phase {
        Some(phase) => format!("{frame} · {phase}"),
        None => frame.to_string(),
    };
    let colours = colours(ui);
    let here = state.document.subject == cell.heart.index && state.document.frame() == frame;
    let colour = if here {
        colours.selection
    } else {
        colours.muted
    };
    let at = cell.rect.left_top() + egui::vec2(10.0, 4.0);
    let font = egui::FontId::proportional(type_size::NOTE);
    ui.painter()
        .text(at, egui::Align2::LEFT_TOP, text, font, colour);
    if here {
        let rect = cell.rect.shrink(2.0);
        let stroke = Stroke::new(line::THIN, colours.selection);
        let radius = f32::from(radius::CONTROL);
        ui.painter()
            .rect_stroke(rect, radius, stroke, egui::StrokeKind::Inside);
    }
}
