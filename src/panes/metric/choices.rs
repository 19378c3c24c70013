//! Choices of a metric that its pane and the header of the pose map offer alike.

use egui::{Response, Ui};

use crate::analysis::metrics::{Corners, METRICS, MetricParams};
use crate::panes::metric::words::FORMS;
use crate::ui::controls::choices_ui;

/// All kinds in a menu; a chosen one comes with its weights.
pub fn kinds_ui(ui: &mut Ui, metric: &mut MetricParams) {
    let kinds = METRICS.map(|kind| (kind, kind.words().name));
    if let Some(kind) = choices_ui(ui, kinds, metric.kind) {
        *metric = metric.with_kind(kind);
    }
}

/// All forms in a menu.
pub fn forms_ui(ui: &mut Ui, metric: &mut MetricParams) {
    let forms = FORMS.map(|form| (form, form.name()));
    metric.form = choices_ui(ui, forms, metric.form).unwrap_or(metric.form);
}

/// A box to tick where size has no effect.
pub fn scale_free_ui(ui: &mut Ui, metric: &mut MetricParams) -> Response {
    let mut scale_free = metric.corners == Corners::ScaleFree;
    let response = ui.checkbox(&mut scale_free, "Scale-invariant");
    if response.clicked() {
        metric.corners = match scale_free {
            true => Corners::ScaleFree,
            false => Corners::Raw,
        };
    }
    response
}
