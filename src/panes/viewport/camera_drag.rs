//! The camera under the pointer: drag to turn, Shift, middle or right drag to move, wheel to zoom.

use egui::{PointerButton, Pos2, Response, Ui};
use glam::{DVec3, Vec2};

use crate::panes::{Command, ViewCommand};
use crate::render::Camera;
use crate::ui::controls::dragged_from_within;

use crate::document::state::State;
use crate::panes::viewport::shown_subject::Cell;

/// A drag over the shorter side of the view turns the subject by this much.
const TURN_PER_SIDE_RAD: f32 = std::f32::consts::PI;

/// One notch of a wheel (about 50 points) magnifies by e^(50 · 0.004), about a fifth.
const ZOOM_PER_POINT: f32 = 0.004;

/// Nearest and farthest that the wheel goes, in coordinates.
const HALF_HEIGHTS: std::ops::RangeInclusive<f32> = 1e-4..=1e7;

/// The camera that drag or wheel ask for, in the axes of the subject under the pointer.
pub fn camera_command(
    ui: &Ui,
    response: &Response,
    state: &State,
    cells: &[Cell],
) -> Option<Command> {
    if response.dragged() {
        if !dragged_from_within(ui, response) {
            return None;
        }
        let start = ui.input(|input| input.pointer.press_origin())?;
        let cell = cell_at(cells, start).or(cells.first())?;
        let delta = response.drag_delta();
        if delta == egui::Vec2::ZERO {
            return None;
        }
        let pan =
            ui.input(|input| input.modifiers.shift) || !response.dragged_by(PointerButton::Primary);
        let to = response.interact_pointer_pos()?;
        let camera = if pan {
            cell.camera.panned(vector(delta), size(cell))
        } else {
            turned(state, cell, to - delta, to)
        };
        return Some(command(cell, camera, true));
    }
    let at = response.hover_pos()?;
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = (scroll * ZOOM_PER_POINT).exp() * pinch;
    if factor == 1.0 {
        return None;
    }
    let cell = cell_at(cells, at)?;
    let camera = cell
        .camera
        .zoomed(factor, vector(at - cell.rect.min), size(cell));
    HALF_HEIGHTS
        .contains(&camera.half_height)
        .then(|| command(cell, camera, false))
}

fn turned(state: &State, cell: &Cell, from: Pos2, to: Pos2) -> Camera {
    let (from, to) = (vector(from - cell.rect.min), vector(to - cell.rect.min));
    if state.document.free_camera {
        return cell.camera.rolled(from, to, size(cell));
    }
    let up = cell.shown.placed.prepared.axes.up;
    let up = DVec3::new(up.x, up.y, up.z).as_vec3();
    let turn = (to - from) * (TURN_PER_SIDE_RAD / size(cell).min_element());
    cell.camera.turned(up, turn.x, turn.y)
}

fn command(cell: &Cell, camera: Camera, drag: bool) -> Command {
    Command::View(ViewCommand::SetCamera {
        camera: cell.shown.placed.frame.heart_camera(camera),
        drag,
    })
}

fn cell_at<'a, 'b>(cells: &'b [Cell<'a>], at: Pos2) -> Option<&'b Cell<'a>> {
    cells.iter().find(|cell| cell.rect.contains(at))
}

fn size(cell: &Cell) -> Vec2 {
    vector(cell.rect.size()).max(Vec2::ONE)
}

fn vector(v: egui::Vec2) -> Vec2 {
    Vec2::new(v.x, v.y)
}
