//! The pane "Cohort": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::panes::verdict::view::classifying;

use super::cohort_table_ui;
use super::rows::count_text;
use super::view::cohort_data;

impl Pane {
    /// The list of subjects.
    pub const COHORT: Self = Self::named("cohort");
}

/// The list of subjects.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::COHORT,
    title: "Cohort",
    toggle: "Pane: cohort",
    open: None,
    place: Place::Left,
    header: Header::Beside(count_ui),
    figure: None,
    ui,
};

fn count_ui(ui: &mut Ui, cx: &PaneContext<'_>, _: f32, _: &mut Vec<Command>) {
    let study = cx.state().document.study();
    let (count, unread) = (study.count(), study.unread.len());
    if unread > 0 {
        ui.weak(format!("{count} of {} read", count + unread));
    } else if count > 0 {
        let shown = cohort_data(cx).borrow_mut().shown_count();
        ui.weak(count_text(shown, count));
    }
}

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let (state, data) = (cx.state(), cohort_data(cx));
    let coming = [state.is_measuring(), classifying(state)];
    cohort_table_ui(ui, &data.borrow_mut().view(state, coming), commands);
}
