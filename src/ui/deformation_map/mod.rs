//! The map of deformations: a point is a whole beat of one heart, near points move alike, a click plays that heart.

mod classes;
mod clusters;
mod draw;
mod hover;
mod keys;
#[cfg(test)]
mod tests;

pub use classes::{ClassesView, RuleView};
pub use draw::deformation_note;

use egui::{Role, Sense, Ui, WidgetInfo, vec2};

use crate::engine::Topic;
use crate::ui::command::Command;
use crate::ui::map_ground::{
    MapState, MapSubject, MapWords, ground_ui, over_map_ui, without_map_ui,
};
use crate::ui::marks::role_name;

/// One heart: its whole beat as a point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeformationPoint {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place on the map; it has no unit.
    pub at: [f64; 2],
    /// Where playing begins: end-diastole, where it is known.
    pub first_frame: usize,
    /// The cluster that k-means puts it in.
    pub cluster: Option<usize>,
    /// Subjects that move most alike, nearest first.
    pub nearest: Vec<usize>,
}

/// What the map of deformations shows.
#[derive(Clone, Debug)]
pub struct DeformationMapView<'a> {
    /// How the map stands.
    pub state: MapState,
    /// What Cancel and Retry mean: the poses are mapped first.
    pub job: Topic,
    /// All subjects of the study.
    pub subjects: &'a [MapSubject],
    /// All hearts on the map.
    pub points: &'a [DeformationPoint],
    /// The selected subject.
    pub selected: Option<usize>,
    /// The second heart of the side-by-side view.
    pub compared: Option<usize>,
    /// Size of the neighbourhoods that the map keeps.
    pub neighbours: Option<usize>,
    /// How far points are from what their neighbours say of them; no unit.
    pub reconstruction_error: Option<f64>,
    /// How much of the map's unit one beat counts for.
    pub time_weight: Option<f64>,
    /// Whether clusters are drawn.
    pub shows_clusters: bool,
    /// How well classes can be told apart.
    pub classes: ClassesView<'a>,
    /// Who is not on the map, and why; empty when all are.
    pub left_out: &'a str,
}

fn words(view: &DeformationMapView) -> MapWords {
    MapWords {
        job: view.job,
        empty: "No deformations",
        what: "Every heart becomes one point here; hearts that move alike lie near each other.",
        none: "No deformation map",
    }
}

/// Height of the strip below the map.
const LEGEND: f32 = 26.0;

/// Draws the map with its legend and, below, how well classes can be told apart.
pub fn deformation_map_ui(ui: &mut Ui, view: &DeformationMapView, commands: &mut Vec<Command>) {
    let words = words(view);
    if view.points.is_empty() {
        without_map_ui(ui, &view.state, &words, commands);
        return;
    }
    let card = classes::height(ui.available_size(), &view.classes);
    let places = || view.points.iter().map(|point| point.at);
    let ground = ground_ui(ui, "Deformation map", places(), LEGEND + card);
    let pointed = ground.nearest(places(), ground.response.hover_pos());
    let on_key = keys::step(ui, view, &ground, commands);
    draw::draw_map(ui, view, &ground, pointed.or(on_key));
    if ground.response.clicked()
        && let Some(point) = ground.nearest(places(), ground.response.interact_pointer_pos())
    {
        commands.push(play(&view.points[point]));
    }
    say_points(ui, view, &ground);
    over_map_ui(ui, &view.state, &words, ground.rect, commands);
    hover::hover_ui(ground.response, view, pointed);
    draw::legend_ui(ui, view, LEGEND, commands);
    if card > 0.0 {
        classes::classes_ui(ui, &view.classes, card);
    }
}

/// Shows a heart from the beginning of its beat and plays it.
fn play(point: &DeformationPoint) -> Command {
    Command::SelectPose {
        subject: point.subject,
        frame: point.first_frame,
        play: true,
    }
}

/// Names points for whoever does not see them.
fn say_points(ui: &Ui, view: &DeformationMapView, ground: &crate::ui::map_ground::Ground) {
    for point in view.points {
        let Some(subject) = view.subjects.get(point.subject) else {
            continue;
        };
        let place = egui::Rect::from_center_size(ground.on_screen(point.at), vec2(8.0, 8.0));
        let id = ground.response.id.with(("point", point.subject));
        let response = ui.interact(place, id, Sense::hover());
        let chosen = view.selected == Some(point.subject);
        response.widget_info(|| {
            let name = format!("Deformation of {}, {}", subject.id, role_name(subject.role));
            WidgetInfo::selected(Role::ListItem, true, chosen, name)
        });
    }
}
