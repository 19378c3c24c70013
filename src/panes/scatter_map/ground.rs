//! The ground of a plane map: dragging moves it, scrolling and pinching zoom, a double click shows all.

use egui::{Pos2, Rect, Response, Role, Sense, Stroke, Ui, Vec2, WidgetInfo, vec2};

use crate::picture::nice_floor;
use crate::ui::controls::{clicked_twice, dragged_from_within};
use crate::ui::theme::{colours, line};

use super::input::{key_zoom, pointer_zoom};
use super::lens::{Lens, Moved};
use super::view::ScatterView;

/// How near to a point, in points of the screen, the pointer counts as on it.
const REACH: f32 = 12.0;

/// Air around the points, for marks and their names.
const AIR: Vec2 = vec2(34.0, 26.0);

/// A piece of ground on screen, as it lies in this frame.
pub struct Ground {
    /// Where it is on screen.
    pub rect: Rect,
    /// What the pointer does on it.
    pub response: Response,
    /// Which part of the map is seen.
    pub lens: Lens,
}

/// Takes the space above `below` points for a map, and moves its lens.
pub fn ground_ui(ui: &mut Ui, view: &ScatterView, below: f32) -> Ground {
    let size = vec2(
        ui.available_width().max(60.0),
        (ui.available_height() - below).max(40.0),
    );
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, view.words.name));
    let id = response.id.with("lens");
    let fitted = Lens::fit(
        view.points.iter().map(|point| point.at),
        rect.width() - 2.0 * AIR.x,
        rect.height() - 2.0 * AIR.y,
    );
    let kept: Option<Moved> = ui.data(|data| data.get_temp(id));
    let mut lens = kept.map_or(fitted, |moved| moved.applied_to(&fitted));
    if clicked_twice(&response) {
        ui.data_mut(|data| data.remove::<Moved>(id));
        lens = fitted;
    } else if turn_lens(ui, view, &response, rect, &mut lens) {
        let moved = Moved::between(&fitted, &lens);
        ui.data_mut(|data| data.insert_temp(id, moved));
    }
    Ground {
        rect,
        response,
        lens,
    }
}

impl Ground {
    /// Where a place of the map lies on screen.
    pub fn on_screen(&self, place: [f64; 2]) -> Pos2 {
        self.lens.on_screen(self.rect, place)
    }

    /// The point nearest to a pointer, if it is within reach.
    pub fn nearest(&self, view: &ScatterView, pointer: Option<Pos2>) -> Option<usize> {
        let pointer = pointer.filter(|pointer| self.rect.contains(*pointer))?;
        let points = view.points.iter().enumerate();
        points
            .filter(|(_, point)| !view.is_filtered_out(point.subject))
            .map(|(index, point)| (index, (self.on_screen(point.at) - pointer).length()))
            .filter(|(_, distance)| *distance <= REACH)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(index, _)| index)
    }

    /// Draws lines by which distances can be compared; they carry no numbers, for the axes have none.
    pub fn draw_grid(&self, ui: &Ui) {
        let painter = ui.painter_at(self.rect);
        let step = nice_floor(110.0 / self.lens.points_per_unit) * self.lens.points_per_unit;
        if !(step.is_finite() && step > 12.0) {
            return;
        }
        let origin = self.on_screen([0.0, 0.0]);
        let stroke = Stroke::new(line::THIN, colours(ui).grid);
        let (rect, step) = (self.rect, step as f32);
        let mut x = rect.left() + (origin.x - rect.left()).rem_euclid(step);
        while x < rect.right() {
            painter.vline(x, rect.y_range(), stroke);
            x += step;
        }
        let mut y = rect.top() + (origin.y - rect.top()).rem_euclid(step);
        while y < rect.bottom() {
            painter.hline(rect.x_range(), y, stroke);
            y += step;
        }
    }
}

/// Whether the pointer looks at the ground in place of moving the map.
fn looks_at_ground(ui: &Ui, view: &ScatterView) -> bool {
    let shift = ui.input(|input| input.modifiers.shift_only());
    view.ground.is_some() && (shift || view.estimate.is_some())
}

/// Dragging moves, scrolling and pinching zoom, and so do the keys while the map has the keyboard.
fn turn_lens(
    ui: &Ui,
    view: &ScatterView,
    response: &Response,
    rect: Rect,
    lens: &mut Lens,
) -> bool {
    let before = *lens;
    if dragged_from_within(ui, response) && !looks_at_ground(ui, view) {
        lens.drag(response.drag_delta());
    }
    if let Some(pointer) = response.hover_pos() {
        let factor = f64::from(pointer_zoom(ui, response));
        lens.zoom_about(pointer - rect.center(), factor);
    }
    lens.zoom_about(Vec2::ZERO, f64::from(key_zoom(ui, response)));
    before != *lens
}
