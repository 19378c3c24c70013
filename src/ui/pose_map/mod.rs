//! The map of poses: a point is a heart at a frame, near points are alike, a click plays that heart.

mod draw;
mod header;
mod hover;
mod lens;
#[cfg(test)]
mod tests;

pub use header::{pose_map_choosers_ui, pose_map_header_ui};

use egui::{Key, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};

use crate::engine::{PoseMapParams, WorkKind};
use crate::study::LabelRole;
use crate::ui::command::Command;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::pose_map::lens::Lens;
use crate::ui::status_bar::progress_text;
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

/// How near to a point, in points of the screen, a click counts as on it.
const REACH: f32 = 12.0;

/// A subject of the map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapSubject {
    /// Pseudonym.
    pub id: String,
    /// Free text, as the study says it.
    pub label: Option<String>,
    /// What the label counts as.
    pub role: LabelRole,
    /// Ejection fraction as a fraction.
    pub ejection_fraction: Option<f64>,
}

/// What a pose is within its beat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PosePhase {
    /// Greatest filling.
    EndDiastole,
    /// Least filling.
    EndSystole,
    /// Any other pose.
    #[default]
    Between,
}

/// One pose. Poses of a subject follow each other in order of frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MapPoint {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Frame of its sequence.
    pub frame: usize,
    /// Place on the map; it has no unit.
    pub at: [f64; 2],
    /// What it is within its beat.
    pub phase: PosePhase,
}

/// How the map stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum MapState {
    /// Nothing to map.
    #[default]
    Empty,
    /// The points are those of the settings.
    Ready,
    /// A new map is being computed; the points are those of the one before, if any.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// Estimated seconds left, once they can be told.
        seconds_left: Option<f64>,
    },
    /// The user stopped it.
    Stopped,
    /// It could not be computed, and why.
    Failed(String),
}

/// What the map shows.
#[derive(Clone, Debug)]
pub struct PoseMapView<'a> {
    /// How the map stands.
    pub state: MapState,
    /// All subjects of the study.
    pub subjects: &'a [MapSubject],
    /// All poses on the map.
    pub points: &'a [MapPoint],
    /// The selected subject.
    pub selected: Option<usize>,
    /// The frame that is shown.
    pub selected_frame: usize,
    /// Where the position between frames lies.
    pub current: Option<[f64; 2]>,
    /// The second heart of the side-by-side view.
    pub compared: Option<usize>,
    /// How poses are compared and mapped.
    pub params: PoseMapParams,
    /// Kruskal's stress 1 of these points.
    pub stress: Option<f64>,
    /// Who is not on the map, and why; empty when all are.
    pub left_out: &'a str,
}

/// Draws the map below its header.
pub fn pose_map_ui(ui: &mut Ui, view: &PoseMapView, commands: &mut Vec<Command>) {
    if view.points.is_empty() {
        without_points_ui(ui, view, commands);
        return;
    }
    let legend_height = 26.0;
    let size = vec2(
        ui.available_width().max(60.0),
        (ui.available_height() - legend_height).max(40.0),
    );
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Pose map"));
    let id = response.id.with("lens");
    let kept: Option<Lens> = ui.data(|data| data.get_temp(id));
    let plot = rect.shrink2(vec2(34.0, 26.0));
    let fitted = Lens::fit(view.points, plot.width(), plot.height());
    let mut lens = kept.unwrap_or(fitted);
    let moved = turn_lens(ui, &response, rect, &mut lens);
    if response.double_clicked() {
        ui.data_mut(|data| data.remove::<Lens>(id));
        lens = fitted;
    } else if moved {
        ui.data_mut(|data| data.insert_temp(id, lens));
    }
    let nearest = response
        .hover_pos()
        .and_then(|pointer| nearest_point(view.points, &lens, rect, pointer));
    draw::draw_map(ui, view, rect, &lens, nearest);
    if response.clicked()
        && let Some(pointer) = response.interact_pointer_pos()
        && let Some(point) = nearest_point(view.points, &lens, rect, pointer)
    {
        commands.push(Command::SelectPose {
            subject: view.points[point].subject,
            frame: view.points[point].frame,
            play: true,
        });
    }
    over_map_ui(ui, view, rect, commands);
    hover::hover_ui(response, view, nearest);
    draw::legend_ui(ui, view, legend_height);
}

/// Dragging moves, scrolling and pinching zoom, and so do the keys while the map has the keyboard.
fn turn_lens(ui: &Ui, response: &Response, rect: Rect, lens: &mut Lens) -> bool {
    let before = *lens;
    if response.dragged() {
        lens.drag(response.drag_delta());
    }
    if response.contains_pointer()
        && let Some(pointer) = response.hover_pos()
    {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let factor = pinch * (scroll * 0.004).exp();
        lens.zoom_about(pointer - rect.center(), f64::from(factor));
    }
    if response.has_focus() {
        for (key, factor) in [(Key::Plus, 1.25), (Key::Equals, 1.25), (Key::Minus, 0.8)] {
            if ui.input(|input| input.key_pressed(key)) {
                lens.zoom_about(vec2(0.0, 0.0), factor);
            }
        }
    }
    before != *lens
}

/// The point nearest to a place on screen, if it is within reach.
fn nearest_point(points: &[MapPoint], lens: &Lens, rect: Rect, place: Pos2) -> Option<usize> {
    points
        .iter()
        .enumerate()
        .map(|(index, point)| (index, (lens.on_screen(rect, point.at) - place).length()))
        .filter(|(_, distance)| *distance <= REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}

fn without_points_ui(ui: &mut Ui, view: &PoseMapView, commands: &mut Vec<Command>) {
    match &view.state {
        MapState::Empty | MapState::Ready => {
            empty_pane_ui(
                ui,
                "No poses",
                "Every pose of every heart becomes a point here; near points deform alike.",
                |_| {},
            );
        }
        MapState::Computing {
            fraction,
            seconds_left,
        } => {
            empty_pane_ui(
                ui,
                "Computing the map",
                "Hearts can be looked at meanwhile.",
                |ui| {
                    progress_ui(ui, *fraction, *seconds_left, commands);
                },
            );
        }
        MapState::Stopped => empty_pane_ui(
            ui,
            "The map was stopped",
            "It can be computed again at any time.",
            |ui| {
                retry_ui(ui, "Compute the map", commands);
            },
        ),
        MapState::Failed(why) => empty_pane_ui(ui, "No map", why, |ui| {
            retry_ui(ui, "Retry", commands);
        }),
    }
}

fn progress_ui(ui: &mut Ui, fraction: f32, seconds_left: Option<f64>, commands: &mut Vec<Command>) {
    progress_bar_ui(
        ui,
        200f32.min(ui.available_width()),
        fraction,
        "Computing the map",
    );
    ui.label(note(progress_text(fraction, seconds_left)));
    if ui
        .button("Cancel")
        .on_hover_text("Stop computing the map")
        .clicked()
    {
        commands.push(Command::Cancel(WorkKind::PoseMap));
    }
}

fn retry_ui(ui: &mut Ui, name: &str, commands: &mut Vec<Command>) {
    if ui.button(name).clicked() {
        commands.push(Command::Retry(WorkKind::PoseMap));
    }
}

/// What is said over a map that is not that of the settings: it is the one before.
fn over_map_ui(ui: &mut Ui, view: &PoseMapView, rect: Rect, commands: &mut Vec<Command>) {
    if matches!(view.state, MapState::Ready | MapState::Empty) {
        return;
    }
    let width = (rect.width() - 24.0).min(300.0);
    let card = Rect::from_min_size(
        rect.center_top() + vec2(-0.5 * width, 10.0),
        vec2(width, 30.0),
    );
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(card));
    let frame = egui::Frame::popup(child.style()).inner_margin(egui::Margin::symmetric(10, 4));
    frame.show(&mut child, |ui| {
        ui.set_width(width - 20.0);
        ui.horizontal(|ui| match &view.state {
            MapState::Computing {
                fraction,
                seconds_left,
            } => {
                progress_bar_ui(
                    ui,
                    (width - 190.0).max(30.0),
                    *fraction,
                    "Computing the map",
                );
                ui.label(note(progress_text(*fraction, *seconds_left)));
                if ui
                    .button(note("Cancel"))
                    .on_hover_text("Stop computing the map")
                    .clicked()
                {
                    commands.push(Command::Cancel(WorkKind::PoseMap));
                }
            }
            MapState::Failed(why) => {
                let colour = colours(ui).error;
                retry_ui(ui, "Retry", commands);
                ui.add(egui::Label::new(egui::RichText::new(why).small().color(colour)).truncate());
            }
            _ => {
                ui.label(note("Stopped; this is the map before"));
                retry_ui(ui, "Retry", commands);
                ui.add_space(space::SMALL);
            }
        });
    });
}
