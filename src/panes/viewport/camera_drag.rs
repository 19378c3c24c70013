//! The camera under the pointer: drag to turn, Shift, middle or right drag to move, wheel to zoom.

use egui::{PointerButton, Pos2, Response, Ui};
use glam::{DVec3, Vec2};

use crate::panes::{Command, ViewCommand};
use crate::render::Camera;
use crate::ui::controls::dragged_from_within;

use crate::document::state::State;
use crate::panes::viewport::shown_subject::Tile;

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
    tiles: &[Tile],
) -> Option<Command> {
    if response.dragged() {
        if !dragged_from_within(ui, response) {
            return None;
        }
        let start = ui.input(|input| input.pointer.press_origin())?;
        let tile = cell_at(tiles, start).or(tiles.first())?;
        let delta = response.drag_delta();
        if delta == egui::Vec2::ZERO {
            return None;
        }
        let pan =
            ui.input(|input| input.modifiers.shift) || !response.dragged_by(PointerButton::Primary);
        let to = response.interact_pointer_pos()?;
        let camera = if pan {
            tile.camera.panned(vector(delta), size(tile))
        } else {
            turned(state, tile, to - delta, to)
        };
        return Some(command(tile, camera, true));
    }
    let at = response.hover_pos()?;
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = (scroll * ZOOM_PER_POINT).exp() * pinch;
    if factor == 1.0 {
        return None;
    }
    let tile = cell_at(tiles, at)?;
    let camera = tile
        .camera
        .zoomed(factor, vector(at - tile.rect.min), size(tile));
    HALF_HEIGHTS
        .contains(&camera.half_height)
        .then(|| command(tile, camera, false))
}

fn turned(state: &State, tile: &Tile, from: Pos2, to: Pos2) -> Camera {
    let (from, to) = (vector(from - tile.rect.min), vector(to - tile.rect.min));
    if state.document.free_camera {
        return tile.camera.rolled(from, to, size(tile));
    }
    let up = tile.shown.placed.prepared.axes.up;
    let up = DVec3::new(up.x, up.y, up.z).as_vec3();
    let turn = (to - from) * (TURN_PER_SIDE_RAD / size(tile).min_element());
    tile.camera.turned(up, turn.x, turn.y)
}

fn command(tile: &Tile, camera: Camera, drag: bool) -> Command {
    Command::View(ViewCommand::SetCamera {
        camera: tile.shown.placed.frame.heart_camera(camera),
        drag,
    })
}

fn cell_at<'a, 'b>(tiles: &'b [Tile<'a>], at: Pos2) -> Option<&'b Tile<'a>> {
    tiles.iter().find(|tile| tile.rect.contains(at))
}

fn size(tile: &Tile) -> Vec2 {
    vector(tile.rect.size()).max(Vec2::ONE)
}

fn vector(v: egui::Vec2) -> Vec2 {
    Vec2::new(v.x, v.y)
}
