//! The pane "3D plot": its word, title, place and how it is drawn.

use egui::Ui;

use crate::document::document::cycle_share;
use crate::panes::cohort::view::cohort_data;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::panes::pose_map::view::pose_map;
use crate::panes::work_state::WorkState;

use super::{SPACE_TIME, space_time_ui};

impl Pane {
    /// The spatiotemporal plot: poses and time in three dimensions.
    pub const SPATIOTEMPORAL: Self = Self::named("space_time");
}

/// The spatiotemporal plot: poses and time in three dimensions.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::SPATIOTEMPORAL,
    title: "3D plot",
    toggle: "Pane: spatiotemporal plot",
    open: Some((2, "Spatiotemporal plot (3D)")),
    place: Place::Above,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let (points, cohort) = (pose_map(ui, cx), cohort_data(cx));
    let (points, cohort) = (points.borrow_mut(), cohort.borrow_mut());
    let (state, work) = (cx.state(), WorkState::of(cx.state().answers.map.as_ref()));
    let map = points.view(state, &SPACE_TIME, work, cohort.rows());
    let selected = state.document.selected();
    let share = selected.map_or(0.0, |subject| cycle_share(subject, state.document.position));
    space_time_ui(ui, &map, share, commands);
}
