//! The pane in the window's table. Volumes over the cardiac cycle.

use egui::Ui;

use crate::panes::beat::BeatData;
use crate::panes::cohort::spec::measuring;
use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};

use super::curves_ui;

impl Pane {
    /// Volumes over the cardiac cycle.
    pub const CURVES: Self = Self::named("curves");
}

/// Volumes over the cardiac cycle.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::CURVES,
    title: "Volume",
    toggle: "Pane: volume curve",
    place: Place::BelowRight,
    header: Header::Note(unit),
    ui,
};

fn unit(look: &Look<'_>) -> Option<String> {
    let subject = look.state().document.selected()?;
    Some(subject.unit.volume_symbol().to_owned())
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let state = look.state();
    let beat = BeatData::of(state);
    let curves = beat.curves();
    curves_ui(
        ui,
        &beat.curves_view(state, &curves, measuring(state)),
        commands,
    );
}
