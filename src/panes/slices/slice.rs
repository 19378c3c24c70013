//! One slice: drawn with crosshair, letters and outlines, and heard for clicks, drags, wheel and keys.

use egui::{
    Align2, Color32, EventFilter, FontId, Key, PointerButton, Pos2, Rect, Response, Role, Sense,
    Stroke, TextureId, Ui, WidgetInfo, pos2, vec2,
};

use super::plane::SlicePlane;
use crate::document::GreyWindow;
use crate::image::VolumeFrame;
use crate::mesh::Point3;
use crate::panes::commands::{Command, ImagesCommand};
use crate::ui::controls::{clicked_twice, dragged_from_within};
use crate::ui::theme::{Colours, line, radius, space, type_size};

/// A drag over so many points makes the window e times as wide.
const WIDEN_POINTS: f32 = 200.0;
/// A drag over so many points moves the level by the width of the window.
const LEVEL_POINTS: f32 = 300.0;
/// So many points of a smooth wheel are one slice: a notch is about 50.
const WHEEL_POINTS: f32 = 30.0;
/// Points of the crosshair that are left free around the place that it points at.
const CROSSHAIR_GAP: f32 = 7.0;

/// Lines over a slice, such as the outline of a surface: ends of pieces in voxels.
pub struct Outline {
    /// The pieces.
    pub pieces: Vec<[Point3; 2]>,
    /// Their colour.
    pub colour: Color32,
}

/// A point over a slice.
pub struct Mark {
    /// Where it is on the grid.
    pub voxel: Point3,
    /// What it is called.
    pub name: &'static str,
}

/// A place that was clicked or dragged over.
pub struct Place {
    /// Where on the grid.
    pub voxel: Point3,
    /// Whether the pointer is held and moves.
    pub dragged: bool,
}

/// What one slice shows.
pub struct SliceTile<'a> {
    /// The grid of the image.
    pub frame: &'a VolumeFrame,
    /// How the slice lies.
    pub plane: SlicePlane,
    /// Where the slices cross, on the grid.
    pub cross: Point3,
    /// Its picture.
    pub texture: Option<TextureId>,
    /// Black and white.
    pub window: GreyWindow,
    /// Over it.
    pub outlines: Vec<Outline>,
    /// Over it.
    pub marks: Vec<Mark>,
    /// Whether its directions are those of a patient.
    pub oriented: bool,
    /// Whether distances are in millimetres.
    pub measured: bool,
    /// The value at a place of the grid.
    pub value: &'a dyn Fn(Point3) -> Option<f32>,
}

impl SliceTile<'_> {
    /// The voxel along the normal that is shown.
    pub fn depth(&self) -> usize {
        let last = self.frame.size()[self.plane.normal] - 1;
        (self.cross[self.plane.normal].round().max(0.0) as usize).min(last)
    }

    fn name(&self) -> String {
        let name = match self.oriented {
            true => self.plane.name(self.frame),
            false => ["Across i", "Across j", "Across k"][self.plane.normal.min(2)],
        };
        let count = self.frame.size()[self.plane.normal];
        format!("{name} {} of {count}", self.depth() + 1)
    }

    /// Where the picture stands within a tile: as large as fits, at its physical shape.
    fn image_rect(&self, tile: Rect) -> Rect {
        let size = self.plane.size_mm(self.frame).map(|length| length as f32);
        let scale = (tile.width() / size[0]).min(tile.height() / size[1]);
        Rect::from_center_size(tile.center(), scale * vec2(size[0], size[1]))
    }

    fn at(&self, image: Rect, voxel: Point3) -> Pos2 {
        let [x, y] = self.plane.shares(self.frame, voxel);
        pos2(
            egui::lerp(image.x_range(), x as f32),
            egui::lerp(image.y_range(), y as f32),
        )
    }

    fn voxel_at(&self, image: Rect, at: Pos2, depth: f64) -> Point3 {
        let x = (at.x - image.left()) / image.width();
        let y = (at.y - image.top()) / image.height();
        self.plane.voxel(self.frame, [x.into(), y.into()], depth)
    }

    /// Draws the slice; the place that was clicked, or is dragged over, with the primary button.
    pub fn ui(&self, ui: &mut Ui, tile: Rect, commands: &mut Vec<Command>) -> Option<Place> {
        let id = ui.scope_id().with(("slice", self.plane.normal));
        let response = ui.interact(tile, id, Sense::click_and_drag());
        let name = self.name();
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, format!("{name} slice")));
        let image = self.image_rect(tile.shrink(space::SMALL));
        self.draw(ui, tile, image, &response);
        self.wheel(ui, &response, commands);
        let by_key = self.keys(ui, &response, commands);
        let by_pointer = self.pointer(ui, image, &response, commands);
        by_pointer.or(by_key)
    }

    fn pointer(
        &self,
        ui: &Ui,
        image: Rect,
        response: &Response,
        commands: &mut Vec<Command>,
    ) -> Option<Place> {
        if clicked_twice(response) {
            commands.push(ImagesCommand::SetWindow(None).into());
            return None;
        }
        let at = response.interact_pointer_pos()?;
        let with_key = ui.input(|input| input.modifiers.command);
        let secondary = response.dragged_by(PointerButton::Secondary);
        if dragged_from_within(ui, response)
            && (secondary || (with_key && response.dragged_by(PointerButton::Primary)))
        {
            let delta = response.drag_delta();
            if delta != egui::Vec2::ZERO {
                let window = self.dragged_window(delta);
                commands.push(ImagesCommand::SetWindow(Some(window)).into());
            }
            return None;
        }
        let dragged =
            response.dragged_by(PointerButton::Primary) && dragged_from_within(ui, response);
        if with_key || !(response.clicked() || dragged) {
            return None;
        }
        Some(Place {
            voxel: self.voxel_at(image, at, self.cross[self.plane.normal]),
            dragged,
        })
    }

    fn dragged_window(&self, delta: egui::Vec2) -> GreyWindow {
        let GreyWindow { width, level } = self.window;
        GreyWindow {
            width: width * f64::from(delta.x / WIDEN_POINTS).exp(),
            // As on a workstation: down is brighter, for the level falls.
            level: level - width * f64::from(delta.y / LEVEL_POINTS),
        }
    }

    /// The wheel steps through the slices of this direction.
    fn wheel(&self, ui: &Ui, response: &Response, commands: &mut Vec<Command>) {
        if !response.hovered() {
            return;
        }
        let scrolled = ui.input(|input| input.smooth_scroll_delta().y);
        if scrolled == 0.0 {
            return;
        }
        let kept = response.id.with("wheel");
        let sum = ui.data(|data| data.get_temp::<f32>(kept)).unwrap_or(0.0) + scrolled;
        let steps = (sum / WHEEL_POINTS).trunc();
        ui.data_mut(|data| data.insert_temp(kept, sum - steps * WHEEL_POINTS));
        if steps != 0.0 {
            commands.push(self.stepped(self.plane.normal, -f64::from(steps)));
        }
    }

    /// So many voxels along an axis, from the middle of the one on screen.
    fn stepped(&self, axis: usize, step: f64) -> Command {
        let mut voxel = self.cross;
        voxel[axis] = voxel[axis].round() + step;
        ImagesCommand::MoveTo(self.frame.position(voxel)).into()
    }

    /// With the keyboard on a slice, arrows move the crosshair, page keys step through slices, and Enter is a click.
    fn keys(&self, ui: &Ui, response: &Response, commands: &mut Vec<Command>) -> Option<Place> {
        if !response.has_focus() {
            return None;
        }
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..Default::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key| ui.input(|input| input.key_pressed(key) && input.modifiers.is_none());
        let sign = |flipped| if flipped { -1.0 } else { 1.0 };
        let (right, down) = (self.plane.right, self.plane.down);
        for (key, axis, step) in [
            (Key::ArrowLeft, right.axis, -sign(right.flipped)),
            (Key::ArrowRight, right.axis, sign(right.flipped)),
            (Key::ArrowUp, down.axis, -sign(down.flipped)),
            (Key::ArrowDown, down.axis, sign(down.flipped)),
            (Key::PageUp, self.plane.normal, -1.0),
            (Key::PageDown, self.plane.normal, 1.0),
        ] {
            if pressed(key) {
                commands.push(self.stepped(axis, step));
            }
        }
        pressed(Key::Enter).then_some(Place {
            voxel: self.cross,
            dragged: false,
        })
    }

    fn draw(&self, ui: &Ui, tile: Rect, image: Rect, response: &Response) {
        // Images are looked at before black, in a light window too.
        let colours = Colours::of(true);
        let painter = ui.painter().with_clip_rect(tile.intersect(ui.clip_rect()));
        let corner = f32::from(radius::CONTROL);
        painter.rect_filled(tile, corner, Color32::BLACK);
        if let Some(texture) = self.texture {
            let whole = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
            painter.image(texture, image, whole, Color32::WHITE);
        }
        for outline in &self.outlines {
            let stroke = Stroke::new(line::MARK, outline.colour);
            for piece in &outline.pieces {
                let ends = piece.map(|voxel| self.at(image, voxel));
                painter.line_segment(ends, stroke);
            }
        }
        self.draw_crosshair(&painter, tile, image);
        self.draw_marks(&painter, image);
        self.draw_words(&painter, tile, image, response);
        if response.has_focus() {
            let stroke = Stroke::new(line::STRONG, colours.accent);
            painter.rect_stroke(tile, corner, stroke, egui::StrokeKind::Inside);
        }
    }

    fn draw_crosshair(&self, painter: &egui::Painter, tile: Rect, image: Rect) {
        let at = self.at(image, self.cross);
        let stroke = Stroke::new(line::THIN, Colours::of(true).accent.gamma_multiply(0.7));
        let gap = CROSSHAIR_GAP;
        painter.hline(tile.left()..=at.x - gap, at.y, stroke);
        painter.hline(at.x + gap..=tile.right(), at.y, stroke);
        painter.vline(at.x, tile.top()..=at.y - gap, stroke);
        painter.vline(at.x, at.y + gap..=tile.bottom(), stroke);
    }

    fn draw_marks(&self, painter: &egui::Painter, image: Rect) {
        for mark in &self.marks {
            let near = (mark.voxel[self.plane.normal] - self.depth() as f64).abs() <= 0.75;
            let colour = Colours::of(true).selection;
            let colour = if near {
                colour
            } else {
                colour.gamma_multiply(0.45)
            };
            let at = self.at(image, mark.voxel);
            painter.circle_stroke(at, 4.5, Stroke::new(line::STRONG, colour));
            words(
                painter,
                at + vec2(8.0, 0.0),
                Align2::LEFT_CENTER,
                mark.name,
                colour,
            );
        }
    }

    fn draw_words(&self, painter: &egui::Painter, tile: Rect, image: Rect, response: &Response) {
        let colours = Colours::of(true);
        let inner = tile.shrink(space::MEDIUM);
        words(
            painter,
            inner.min,
            Align2::LEFT_TOP,
            &self.name(),
            colours.strong,
        );
        if self.oriented {
            let [left, right, above, below] = self.plane.letters(self.frame);
            for (at, anchor, text) in [
                (inner.left_center(), Align2::LEFT_CENTER, left),
                (inner.right_center(), Align2::RIGHT_CENTER, right),
                (inner.center_top(), Align2::CENTER_TOP, above),
                (inner.center_bottom(), Align2::CENTER_BOTTOM, below),
            ] {
                words(painter, at, anchor, &text, colours.strong);
            }
        }
        self.draw_scale(painter, inner, image);
        let hovered = response.hover_pos().filter(|at| image.contains(*at));
        let text = hovered.map(|at| {
            let voxel = self.voxel_at(image, at, self.cross[self.plane.normal]);
            self.place_words(voxel)
        });
        if let Some(text) = text {
            words(
                painter,
                inner.left_bottom(),
                Align2::LEFT_BOTTOM,
                &text,
                colours.text,
            );
        }
    }

    /// "L 12 P 4 H 33 mm · 842": a place of the patient and the value there.
    fn place_words(&self, voxel: Point3) -> String {
        let at = self.frame.position(voxel);
        let value = (self.value)(voxel).map_or_else(|| "no value".to_owned(), value_text);
        if !self.oriented {
            let [i, j, k] = [voxel.x, voxel.y, voxel.z].map(|index| index.round() as i64);
            return format!("voxel {i}, {j}, {k} · {value}");
        }
        let side = |x: f64, [less, more]: [&str; 2]| {
            format!("{} {:.0}", if x < 0.0 { less } else { more }, x.abs())
        };
        let unit = if self.measured { "mm" } else { "voxels" };
        format!(
            "{} {} {} {unit} · {value}",
            side(at.x, ["R", "L"]),
            side(at.y, ["A", "P"]),
            side(at.z, ["F", "H"])
        )
    }

    fn draw_scale(&self, painter: &egui::Painter, inner: Rect, image: Rect) {
        let per_mm = image.width() / self.plane.size_mm(self.frame)[0] as f32;
        let fits = |length: &f32| length * per_mm <= 0.3 * inner.width();
        let Some(length) = [100.0, 50.0, 20.0, 10.0, 5.0, 1.0].into_iter().find(fits) else {
            return;
        };
        if !self.measured {
            return;
        }
        let colour = Colours::of(true).text;
        let end = inner.right_bottom() - vec2(0.0, 2.0);
        let start = end - vec2(length * per_mm, 0.0);
        painter.line_segment([start, end], Stroke::new(line::STRONG, colour));
        let above = start + vec2(0.5 * length * per_mm, -3.0);
        words(
            painter,
            above,
            Align2::CENTER_BOTTOM,
            &format!("{length} mm"),
            colour,
        );
    }
}

/// A value with no more digits than it deserves.
pub fn value_text(value: f32) -> String {
    match value.abs() {
        size if size >= 100.0 || value.fract() == 0.0 => format!("{value:.0}"),
        size if size >= 1.0 => format!("{value:.1}"),
        _ => format!("{value:.3}"),
    }
}

/// Small words over an image, readable before black and white alike.
fn words(painter: &egui::Painter, at: Pos2, anchor: Align2, text: &str, colour: Color32) {
    let font = FontId::proportional(type_size::NOTE);
    let galley = painter.layout_no_wrap(text.to_owned(), font, colour);
    let rect = anchor.anchor_size(at, galley.size());
    painter.rect_filled(
        rect.expand2(vec2(3.0, 1.0)),
        3.0,
        Color32::from_black_alpha(110),
    );
    painter.galley(rect.min, galley, colour);
}
