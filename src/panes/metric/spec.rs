//! The pane in the window's table. How poses and deformations are compared and mapped.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::deformation_map::view::metric_panel_view;
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pose_map::spec::map_data;

use super::metric_panel_ui;

impl Pane {
    /// How poses and deformations are compared and mapped.
    pub const METRIC: Self = Self::named("metric");
}

/// How poses and deformations are compared and mapped.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::METRIC,
    title: "Metric and maps",
    toggle: "Pane: metric",
    place: Place::Left,
    header: Header::Title,
    ui,
};

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let data = map_data(ui, look);
    let data = data.borrow_mut();
    metric_panel_ui(
        ui,
        &metric_panel_view(look.state(), data.subjects()),
        commands,
    );
}
