//! Curves of poses through time: the map's two axes and the share of the beat, seen from any side.

mod axes;
mod draw;
mod eye;
mod hover;
#[cfg(test)]
mod tests;

use egui::{EventFilter, Key, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};

use crate::engine::{PoseMapParams, Topic};
use crate::study::LabelRole;
use crate::ui::command::Command;
use crate::ui::map_ground::{MapState, MapSubject, MapWords, over_map_ui, without_map_ui};
use crate::ui::marks::role_name;
use crate::ui::pose_map::PosePhase;
use crate::ui::space_time::eye::{Eye, Turn};

/// One pose of a beat.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpaceTimePoint {
    /// Frame of the sequence.
    pub frame: usize,
    /// Place on the map of poses; no unit.
    pub at: [f64; 2],
    /// Share of the beat, in `0..1`.
    pub share: f64,
    /// What it is within its beat.
    pub phase: PosePhase,
}

/// The beat of one heart, frame after frame; after the last one it runs into the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpaceTimeCurve {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Its poses.
    pub points: Vec<SpaceTimePoint>,
}

/// What the plot shows.
#[derive(Clone, Debug)]
pub struct SpaceTimeView<'a> {
    /// How the map of poses stands.
    pub state: MapState,
    /// All subjects of the study.
    pub subjects: &'a [MapSubject],
    /// One curve per heart on the map.
    pub curves: &'a [SpaceTimeCurve],
    /// The selected subject.
    pub selected: Option<usize>,
    /// The second heart of the side-by-side view.
    pub compared: Option<usize>,
    /// Where the beat stands, as a share in `0..1`.
    pub share: f64,
}

impl SpaceTimeView<'_> {
    fn role(&self, curve: &SpaceTimeCurve) -> LabelRole {
        self.subjects
            .get(curve.subject)
            .map(|subject| subject.role)
            .unwrap_or_default()
    }
}

const WORDS: MapWords = MapWords {
    job: Topic::of::<PoseMapParams>(),
    empty: "No poses",
    what: "The beat of every heart becomes a curve here, through the map of poses and time.",
    none: "No map",
};

/// How near to a curve, in points of the screen, a click counts as on it.
const REACH: f32 = 9.0;

/// Draws the plot: dragging turns it, scrolling zooms, a double click turns it back.
pub fn space_time_ui(ui: &mut Ui, view: &SpaceTimeView, commands: &mut Vec<Command>) {
    if view.curves.is_empty() {
        without_map_ui(ui, &view.state, &WORDS, commands);
        return;
    }
    let size = ui.available_size().max(vec2(60.0, 60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response
        .widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Curves through poses and time"));
    let eye = Eye::new(turned(ui, &response), rect, view.curves);
    let pointed = response
        .hover_pos()
        .filter(|_| !response.dragged())
        .and_then(|pointer| nearest(view, &eye, pointer));
    draw::draw(ui, view, &eye, pointed.map(|hit| hit.curve));
    if response.clicked()
        && let Some(hit) = response
            .interact_pointer_pos()
            .and_then(|pointer| nearest(view, &eye, pointer))
    {
        commands.push(Command::SelectPose {
            subject: view.curves[hit.curve].subject,
            frame: view.curves[hit.curve].points[hit.point].frame,
            play: true,
        });
    }
    say_curves(ui, view, &eye, &response);
    over_map_ui(ui, &view.state, &WORDS, rect, commands);
    hover::hover_ui(response, view, pointed);
}

/// The side that the plot is seen from, after what the pointer and the keys did to it.
fn turned(ui: &Ui, response: &Response) -> Turn {
    let id = response.id.with("turn");
    let before: Turn = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let mut turn = before;
    if response.double_clicked() {
        turn = Turn::default();
    }
    if response.dragged() {
        turn.drag(response.drag_delta());
    }
    if response.contains_pointer() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        turn.zoom_by(pinch * (scroll * 0.004).exp());
    }
    if response.has_focus() {
        let arrows = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
        turn_by_keys(ui, &mut turn);
    }
    if turn != before {
        ui.data_mut(|data| data.insert_temp(id, turn));
    }
    turn
}

fn turn_by_keys(ui: &Ui, turn: &mut Turn) {
    // One press turns by about six degrees.
    let step = 16.0;
    for (key, delta) in [
        (Key::ArrowLeft, vec2(-step, 0.0)),
        (Key::ArrowRight, vec2(step, 0.0)),
        (Key::ArrowUp, vec2(0.0, -step)),
        (Key::ArrowDown, vec2(0.0, step)),
    ] {
        if ui.input(|input| input.key_pressed(key)) {
            turn.drag(delta);
        }
    }
    for (key, factor) in [(Key::Plus, 1.25), (Key::Equals, 1.25), (Key::Minus, 0.8)] {
        if ui.input(|input| input.key_pressed(key)) {
            turn.zoom_by(factor);
        }
    }
}

/// A curve under the pointer, and the pose on it that is nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Hit {
    curve: usize,
    point: usize,
}

/// The curve nearest to a place on screen, if it is within reach; of curves that cross there, the
/// one in front.
fn nearest(view: &SpaceTimeView, eye: &Eye, place: Pos2) -> Option<Hit> {
    let mut best: Option<(f32, Hit)> = None;
    for (curve, track) in view.curves.iter().enumerate() {
        let seen: Vec<(Pos2, f32)> = track
            .points
            .iter()
            .map(|p| eye.see(p.at, p.share))
            .collect();
        let segments = seen.len().saturating_sub(1).max(1);
        for segment in 0..segments {
            let from = seen[segment];
            let to = seen[(segment + 1).min(seen.len() - 1)];
            let (distance, along) = distance_to(from.0, to.0, place);
            if distance > REACH {
                continue;
            }
            // A pixel nearer to the pointer weighs as much as a twentieth of the depth.
            let rank = distance + 20.0 * (from.1 + along * (to.1 - from.1));
            if best.is_none_or(|(least, _)| rank < least) {
                let point = if along < 0.5 { segment } else { segment + 1 };
                let point = point.min(seen.len() - 1);
                best = Some((rank, Hit { curve, point }));
            }
        }
    }
    best.map(|(_, hit)| hit)
}

/// How far a place is from a straight line, and how far along it the nearest place lies.
fn distance_to(from: Pos2, to: Pos2, place: Pos2) -> (f32, f32) {
    let line = to - from;
    let length_squared = line.length_sq();
    let along = if length_squared > 0.0 {
        ((place - from).dot(line) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    ((from + along * line - place).length(), along)
}

/// Names curves for whoever does not see them, each in the middle of its beat.
fn say_curves(ui: &Ui, view: &SpaceTimeView, eye: &Eye, canvas: &Response) {
    for curve in view.curves {
        let middle = curve.points.get(curve.points.len() / 2);
        let (Some(subject), Some(point)) = (view.subjects.get(curve.subject), middle) else {
            continue;
        };
        let (place, _) = eye.see(point.at, point.share);
        let rect = Rect::from_center_size(place, vec2(8.0, 8.0));
        let id = canvas.id.with(("curve", curve.subject));
        let chosen = view.selected == Some(curve.subject);
        let name = format!("Curve of {}, {}", subject.id, role_name(subject.role));
        ui.interact(rect, id, Sense::hover())
            .widget_info(|| WidgetInfo::selected(Role::ListItem, true, chosen, &name));
    }
}
