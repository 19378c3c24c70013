//! The pane "Poses": its word, title, place and how it is drawn.

use egui::Ui;

use super::figure::FIGURE;
use super::pose_map_choosers_ui;
use super::view::pose_map;
use crate::panes::cohort::view::cohort_data;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::panes::scatter_map::scatter_map_ui;

impl Pane {
    /// The pose map.
    pub const POSE_MAP: Self = Self::named("pose_map");
}

/// The pose map.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::POSE_MAP,
    title: "Poses",
    toggle: "Pane: poses",
    open: Some((2, "Pose map")),
    place: Place::Above,
    header: Header::Named(choosers_ui),
    figure: Some(FIGURE),
    ui,
};

fn choosers_ui(ui: &mut Ui, cx: &PaneContext<'_>, taken: f32, commands: &mut Vec<Command>) {
    pose_map_choosers_ui(ui, cx.state().document.map, taken, commands);
}

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let (points, cohort) = (pose_map(ui, cx), cohort_data(cx));
    let (points, cohort) = (points.borrow_mut(), cohort.borrow_mut());
    scatter_map_ui(
        ui,
        &super::view::view(&points, cx.state(), cohort.rows()),
        0.0,
        commands,
    );
}
