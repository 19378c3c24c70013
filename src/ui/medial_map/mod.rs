//! The map of the medial shape space: a point is a step of the beat as the part that stands still has it.

mod draw;
mod header;
mod hover;
#[cfg(test)]
mod tests;

pub use header::{medial_map_choosers_ui, medial_map_header_ui};

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::engine::{MedialMapParams, Topic};
use crate::ui::command::Command;
use crate::ui::map_ground::{
    MapState, MapSubject, MapWords, ground_ui, over_map_ui, without_map_ui,
};
use crate::ui::pose_map::PosePhase;

/// One step of one path. Steps of a path follow each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MedialPoint {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place of the patch in its list, from 0; `None` for all that stands still.
    pub patch: Option<usize>,
    /// Frame at which the step begins.
    pub from: usize,
    /// Frame at which it ends.
    pub to: usize,
    /// Place on the map; it has no unit.
    pub at: [f64; 2],
    /// What the first frame is within the beat.
    pub phase: PosePhase,
    /// r̂: mean ratio of thickness over the step.
    pub ratio: f64,
    /// Mean distance of two poses of its path; `None` with one pose.
    pub spread: Option<f64>,
}

impl MedialPoint {
    /// Whether another point is of the same path.
    fn shares_path(&self, other: &Self) -> bool {
        (self.subject, self.patch) == (other.subject, other.patch)
    }
}

/// What the map shows.
#[derive(Clone, Debug)]
pub struct MedialMapView<'a> {
    /// How the map stands.
    pub state: MapState,
    /// All subjects of the study.
    pub subjects: &'a [MapSubject],
    /// Those on the map, for the legend.
    pub mapped: &'a [MapSubject],
    /// All steps on the map.
    pub points: &'a [MedialPoint],
    /// The selected subject.
    pub selected: Option<usize>,
    /// Where the position between frames lies on each of its paths.
    pub current: Vec<[f64; 2]>,
    /// The second heart of the side-by-side view.
    pub compared: Option<usize>,
    /// How distances become the map.
    pub method: MapMethod,
    /// Kruskal's stress 1 of these points.
    pub stress: Option<f64>,
    /// In which axes hearts were compared.
    pub frame: &'static str,
    /// How many hearts are not on the map.
    pub left_out_count: usize,
    /// Who they are, and why; empty when all are.
    pub left_out: &'a str,
}

const WORDS: MapWords = MapWords {
    job: Topic::of::<MedialMapParams>(),
    empty: "No poses",
    what: "The part of each wall that stands still becomes a path here: poses of a patch lie together, \
           those of a wall that thickens wander.",
    none: "No map",
};

/// Height of the strip below the map.
const LEGEND: f32 = 26.0;

/// Draws the map below its header.
pub fn medial_map_ui(ui: &mut Ui, view: &MedialMapView, commands: &mut Vec<Command>) {
    if view.points.is_empty() {
        without_map_ui(ui, &view.state, &WORDS, commands);
        return;
    }
    let places = || view.points.iter().map(|point| point.at);
    let ground = ground_ui(ui, "Medial map", places(), LEGEND);
    let nearest = ground.nearest(places(), ground.response.hover_pos());
    draw::draw_map(ui, view, &ground, nearest);
    if ground.response.clicked()
        && let Some(point) = ground.nearest(places(), ground.response.interact_pointer_pos())
    {
        commands.push(Command::SelectPose {
            subject: view.points[point].subject,
            frame: view.points[point].from,
            play: true,
        });
    }
    over_map_ui(ui, &view.state, &WORDS, ground.rect, commands);
    hover::hover_ui(ground.response, view, nearest);
    draw::legend_ui(ui, view, LEGEND);
}
