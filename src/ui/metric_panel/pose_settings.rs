//! What hearts are carried onto before they are compared, and how distances become a map.

use egui::{ScrollArea, Ui};

use crate::analysis::embedding::MapMethod;
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::engine::PoseMapParams;
use crate::ui::controls::choice_ui;
use crate::ui::metric_panel::{MetricPanelView, choice_row_ui, sentence_ui};
use crate::ui::metric_words::method_name;
use crate::ui::number_field::{NumberField, number_field_ui, whole};

/// Draws reference and method; the settings after a change.
pub fn pose_map_ui(ui: &mut Ui, view: &MetricPanelView) -> Option<PoseMapParams> {
    let mut wanted = view.poses;
    reference_ui(ui, view, &mut wanted);
    method_ui(ui, view, &mut wanted);
    Some(wanted).filter(|wanted| *wanted != view.poses)
}

fn reference_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut PoseMapParams) {
    let transfer = wanted.distances.transport;
    let name = |subject: usize| {
        view.subjects
            .get(subject)
            .map_or_else(|| format!("subject {subject}"), |known| known.id.clone())
    };
    let shown = match transfer.map(|transfer| transfer.reference) {
        None => "no heart".to_owned(),
        Some(Reference::Mean) => "the mean heart".to_owned(),
        Some(Reference::Subject(subject)) => name(subject),
    };
    let what = "Carries every motion onto one heart before poses are compared, so that only the \
                motions differ";
    choice_row_ui(ui, "Transfer onto", what, &shown, true, |ui| {
        let mut choose = |reference: Option<Reference>| {
            wanted.distances.transport = reference.map(|reference| CohortTransportParams {
                reference,
                ..transfer.unwrap_or_default()
            });
        };
        let now = transfer.map(|transfer| transfer.reference);
        if choice_ui(ui, "no heart: compare as they are", now.is_none()) {
            choose(None);
        }
        if choice_ui(
            ui,
            "the mean heart of the cohort",
            now == Some(Reference::Mean),
        ) {
            choose(Some(Reference::Mean));
        }
        ui.separator();
        ScrollArea::vertical().max_height(260.0).show(ui, |ui| {
            let first = view.selected.into_iter();
            let rest = (0..view.subjects.len()).filter(|i| Some(*i) != view.selected);
            for subject in first.chain(rest) {
                let reference = Reference::Subject(subject);
                if choice_ui(ui, &name(subject), now == Some(reference)) {
                    choose(Some(reference));
                }
            }
        });
    });
    sentence_ui(
        ui,
        match transfer {
            None => "Shapes and motions both count: hearts are laid onto each other as they are",
            Some(_) => {
                "Only motions count: each is carried onto that heart first, which takes longer"
            }
        },
    );
}

fn method_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut PoseMapParams) {
    let what = "How distances between poses become places in the plane";
    let method = wanted.method;
    let isomap = match method {
        MapMethod::Isomap { .. } => method,
        _ => MapMethod::ISOMAP,
    };
    choice_row_ui(ui, "Method", what, method_name(method), true, |ui| {
        for (offered, name) in [
            (MapMethod::Smacof, "SMACOF: least stress"),
            (MapMethod::ClassicalMds, "MDS: classical scaling"),
            (isomap, "Isomap: along neighbours"),
        ] {
            if choice_ui(ui, name, method == offered) {
                wanted.method = offered;
            }
        }
    });
    if let MapMethod::Isomap { neighbours } = view.poses.method {
        let field = NumberField {
            name: "Neighbours",
            unit: "poses",
            what: "Nearest poses that each pose is linked to",
            value: Some(f64::from(neighbours)),
            automatic: None,
            enabled: true,
        };
        let accept = |value: Option<f64>| match whole(value.unwrap_or_default(), 10_000)? {
            0 => Err("must be at least 1".to_owned()),
            neighbours => Ok(neighbours as u16),
        };
        if let Some(neighbours) = number_field_ui(ui, &field, accept) {
            wanted.method = MapMethod::Isomap { neighbours };
        }
    }
}
