//! The pane "Metric and maps": its word, title, place and how it is drawn.

use egui::Ui;

use crate::engine::{BeatSharesQuery, share_words};
use crate::panes::cohort::view::cohort_data;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

use super::{MetricPanelView, metric_panel_ui};

impl Pane {
    /// How poses and deformations are compared and mapped.
    pub const METRIC: Self = Self::named("metric");
}

/// How poses and deformations are compared and mapped.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::METRIC,
    title: "Metric and maps",
    toggle: "Pane: metric",
    open: Some((3, "Metric and maps…")),
    place: Place::Left,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let (document, cohort) = (&cx.state().document, cohort_data(cx));
    let (map, cohort) = (cx.state().deformations(), cohort.borrow_mut());
    let shares = cx.ask_at_rest(&BeatSharesQuery(document.map.distances));
    let kind = document.map.distances.metric.kind;
    let view = MetricPanelView {
        shares: shares.ready().map(|found| share_words(found, kind)),
        poses: document.map,
        deformations: document.deformation_map,
        subjects: cohort.rows(),
        // An excluded subject is no reference.
        selected: (document.selected_index()).filter(|&index| index < cohort.rows().len()),
        neighbours: map.and_then(|map| map.embedding.neighbours),
        time_weight: map.and_then(|map| map.time_weight),
    };
    metric_panel_ui(ui, &view, commands);
}
