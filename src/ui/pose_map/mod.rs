//! The map of poses: a point is a heart at a frame, near points are alike, a click plays that heart.

mod draw;
mod header;
mod hover;
#[cfg(test)]
mod tests;

pub use header::{pose_map_choosers_ui, pose_map_header_ui};

use egui::Ui;

use crate::engine::{PoseMapParams, Topic};
use crate::ui::command::Command;
use crate::ui::map_ground::{
    MapState, MapSubject, MapWords, ground_ui, over_map_ui, without_map_ui,
};

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

impl PosePhase {
    /// What follows the name of a pose; nothing where it is any other.
    pub fn after_name(self) -> &'static str {
        match self {
            Self::EndDiastole => " · end-diastole",
            Self::EndSystole => " · end-systole",
            Self::Between => "",
        }
    }
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
    /// Size of the neighbourhoods, where the method has them.
    pub neighbours: Option<usize>,
    /// Who is not on the map, and why; empty when all are.
    pub left_out: &'a str,
}

const WORDS: MapWords = MapWords {
    job: Topic::of::<PoseMapParams>(),
    empty: "No poses",
    what: "Every pose of every heart becomes a point here; near points deform alike.",
    none: "No map",
};

/// Draws the map below its header.
pub fn pose_map_ui(ui: &mut Ui, view: &PoseMapView, commands: &mut Vec<Command>) {
    if view.points.is_empty() {
        without_map_ui(ui, &view.state, &WORDS, commands);
        return;
    }
    let legend_height = 26.0;
    let places = || view.points.iter().map(|point| point.at);
    let ground = ground_ui(ui, "Pose map", places(), legend_height);
    let nearest = ground.nearest(places(), ground.response.hover_pos());
    draw::draw_map(ui, view, &ground, nearest);
    if ground.response.clicked()
        && let Some(point) = ground.nearest(places(), ground.response.interact_pointer_pos())
    {
        commands.push(Command::SelectPose {
            subject: view.points[point].subject,
            frame: view.points[point].frame,
            play: true,
        });
    }
    over_map_ui(ui, &view.state, &WORDS, ground.rect, commands);
    hover::hover_ui(ground.response, view, nearest);
    draw::legend_ui(ui, view, legend_height);
}
