//! The pane "Bull's-eye": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::panes::viewport::viewport::Viewport;

use super::bulls_eye_ui;
use super::data::BullsEyeData;
use super::figure::FIGURE;

impl Pane {
    /// The polar map of the wall, by AHA segment.
    pub const BULLS_EYE: Self = Self::named("bulls_eye");
}

/// The polar map of the wall, by AHA segment.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::BULLS_EYE,
    title: "Bull's-eye",
    toggle: "Pane: bull's-eye",
    open: Some((3, "Bull's-eye")),
    place: Place::BelowRight,
    header: Header::Title,
    figure: Some(FIGURE),
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let data = cx.memo().get::<BullsEyeData>();
    let mut data = data.borrow_mut();
    let viewport = cx.memo().get::<Viewport>();
    data.refresh(cx.state(), viewport.borrow_mut().cohort_ranges());
    bulls_eye_ui(ui, &data.view(cx.state()), commands);
}
