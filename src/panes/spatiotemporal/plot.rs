//! What the pointer and the keyboard do with the spatiotemporal plot.

use egui::{Color32, Pos2, Response, Role, Sense, Ui, WidgetInfo, vec2};

use crate::engine::{PoseMapQuery, Topic};
use crate::panes::commands::Command;
use crate::panes::scatter_map::{
    MapWords, Projection, ScatterView, draw_points, key_zoom, paths, play_command, pointed_at,
    pointer_zoom, pressed_arrows, respond_ui, without_map_ui,
};
use crate::ui::controls::{clicked_twice, dragged_from_within};
use crate::ui::marks::distance_to;
use crate::ui::theme::colours;

use super::axes::draw_axes;
use super::eye::{Eye, Turn};
use super::phase_plane::{draw_phase_plane, places_at};

/// The words of the plot.
pub static SPACE_TIME: MapWords = MapWords {
    job: Topic::of::<PoseMapQuery>(),
    name: "Spatiotemporal plot",
    item: "Curve",
    empty: "No poses",
    what: "The motion of every subject is a curve here, through the pose map and time.",
    none: "The pose map could not be computed",
    hints: &[
        "Click to play this subject from this pose",
        "Drag to turn, scroll to zoom, double click to reset the view",
    ],
    command: play_command,
};

/// How near to a curve, in points of the screen, a click counts as on it.
const REACH: f32 = 9.0;

/// Draws the plot of a map while the motion stands at a share in `0..1`: dragging turns it, scrolling zooms, a double click
/// turns it back.
pub fn space_time_ui(ui: &mut Ui, map: &ScatterView, share: f64, commands: &mut Vec<Command>) {
    if map.points.is_empty() {
        without_map_ui(ui, map, commands);
        return;
    }
    let size = ui.available_size().max(vec2(60.0, 60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, map.words.name));
    let eye = Eye::new(turned(ui, &response), rect, map.points);
    let pointer = response.hover_pos().filter(|_| !response.dragged());
    let hovered = pointer.and_then(|pointer| nearest(map, &eye, pointer));
    let (painter, colours) = (ui.painter_at(rect), colours(ui));
    let rr_is_known = map.points.iter().all(|point| point.rr_is_known);
    draw_axes(&painter, &eye, colours, rr_is_known);
    draw_phase_plane(&painter, map, share, &eye, colours);
    let colour_of = |subject: usize| match Some(subject) {
        chosen if chosen == map.selected => Some(colours.selection),
        chosen if chosen == map.compared => Some(colours.strong),
        _ => None,
    };
    let current: Vec<(Pos2, Color32)> = places_at(map.points, share, &eye)
        .filter_map(|(subject, place)| Some((place, colour_of(subject)?)))
        .collect();
    let pointed = pointed_at(ui, map, &response, hovered);
    draw_points(ui, map, &eye, &current, pointed);
    let clicked = response.clicked().then(|| response.interact_pointer_pos());
    let clicked = clicked
        .flatten()
        .and_then(|pointer| nearest(map, &eye, pointer));
    respond_ui(ui, map, &eye, response, hovered, clicked, commands);
}

/// The side that the plot is seen from, after what the pointer and the keys did to it.
fn turned(ui: &Ui, response: &Response) -> Turn {
    let id = response.id.with("turn");
    let before: Turn = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let mut turn = before;
    if clicked_twice(response) {
        turn = Turn::default();
    }
    if dragged_from_within(ui, response) {
        turn.drag(response.drag_delta());
    }
    turn.zoom_by(pointer_zoom(ui, response) * key_zoom(ui, response));
    for arrow in pressed_arrows(ui, response) {
        // One press turns by about six degrees.
        turn.drag(16.0 * arrow);
    }
    if turn != before {
        ui.data_mut(|data| data.insert_temp(id, turn));
    }
    turn
}

/// The pose nearest to a place on screen on the curve nearest to it, if that is within reach; of
/// curves that cross there, the one in front.
fn nearest(view: &ScatterView, eye: &Eye, place: Pos2) -> Option<usize> {
    let mut best: Option<(f32, usize)> = None;
    let shown =
        |path: &std::ops::Range<usize>| !view.is_filtered_out(view.points[path.start].subject);
    for path in paths(view.points).filter(shown) {
        for from in path.start..(path.end - 1).max(path.start + 1) {
            let to = (from + 1).min(path.end - 1);
            let [start, end] = [from, to].map(|index| {
                let point = &view.points[index];
                eye.see(point.at, point.share)
            });
            let (distance, along) = distance_to(start.0, end.0, place);
            if distance > REACH {
                continue;
            }
            // A pixel nearer to the pointer weighs as much as a twentieth of the depth.
            let rank = distance + 20.0 * (start.1 + along * (end.1 - start.1));
            if best.is_none_or(|(least, _)| rank < least) {
                best = Some((rank, if along < 0.5 { from } else { to }));
            }
        }
    }
    best.map(|(_, point)| point)
}
