//! The pane in the window's table. The list of subjects.

use egui::Ui;

use crate::document::State;
use crate::engine::Showing;
use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::verdict::view::VerdictData;

use super::cohort_table_ui;
use super::view::CohortData;

impl Pane {
    /// The list of subjects.
    pub const COHORT: Self = Self::named("cohort");
}

/// The list of subjects.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::COHORT,
    title: "Cohort",
    toggle: "Pane: cohort",
    place: Place::Left,
    header: Header::Note(count),
    ui,
};

fn count(look: &Look<'_>) -> Option<String> {
    let count = look.state().document.study().subjects.len();
    (count > 0).then(|| count.to_string())
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let state = look.state();
    let data = look.memo().get::<CohortData>();
    let mut data = data.borrow_mut();
    data.refresh(state);
    let classifying = VerdictData::of(state).classifying();
    cohort_table_ui(
        ui,
        &data.view(state, [measuring(state), classifying]),
        commands,
    );
}

/// Whether volumes are being computed.
pub fn measuring(state: &State) -> bool {
    state
        .answers
        .measures
        .as_ref()
        .is_some_and(Showing::computing)
}
