//! The pane in the window's table. The spatiotemporal plot: poses and time in three dimensions.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pose_map::spec::map_data;

use super::space_time_ui;

impl Pane {
    /// The spatiotemporal plot: poses and time in three dimensions.
    pub const SPATIOTEMPORAL: Self = Self::named("space_time");
}

/// The spatiotemporal plot: poses and time in three dimensions.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::SPATIOTEMPORAL,
    title: "3D plot",
    toggle: "Pane: spatiotemporal plot",
    place: Place::Above,
    header: Header::Title,
    ui,
};

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let data = map_data(ui, look);
    let data = data.borrow_mut();
    let map = look.state().answers.map.as_ref();
    space_time_ui(ui, &data.space_time(look.state(), map), commands);
}
