//! Transport before poses are compared, and the embedding of their distances.

use egui::{ScrollArea, Ui};

use crate::analysis::embedding::MapMethod;
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::engine::PoseMapParams;
use crate::panes::metric::words::method_name;
use crate::panes::metric::{MetricPanelView, choice_row_ui, sentence_ui};
use crate::ui::controls::choice_ui;
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
        None => "off".to_owned(),
        Some(Reference::Mean) => "onto the mean subject".to_owned(),
        Some(Reference::Subject(subject)) => format!("onto {}", name(subject)),
    };
    let what = "Parallel transport of every motion onto one subject before poses are compared, so that \
                only motions differ";
    choice_row_ui(ui, "Transport", what, &shown, true, |ui| {
        let mut choose = |reference: Option<Reference>| {
            wanted.distances.transport = reference.map(|reference| CohortTransportParams {
                reference,
                ..transfer.unwrap_or_default()
            });
        };
        let now = transfer.map(|transfer| transfer.reference);
        if choice_ui(ui, "off: compare subjects as recorded", now.is_none()) {
            choose(None);
        }
        if choice_ui(
            ui,
            "onto the mean subject of the cohort",
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
                if choice_ui(
                    ui,
                    &format!("onto {}", name(subject)),
                    now == Some(reference),
                ) {
                    choose(Some(reference));
                }
            }
        });
    });
    sentence_ui(
        ui,
        match transfer {
            None => "Distances of aligned poses: shape and motion both contribute",
            Some(_) => "Distances of transported motions: only motion contributes; takes longer",
        },
    );
}

fn method_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut PoseMapParams) {
    let what = "Embedding of the distances between poses in the plane";
    let method = wanted.method;
    let isomap = match method {
        MapMethod::Isomap { .. } => method,
        _ => MapMethod::ISOMAP,
    };
    choice_row_ui(ui, "Method", what, method_name(method), true, |ui| {
        for (offered, name) in [
            (MapMethod::Smacof, "SMACOF: minimises stress"),
            (MapMethod::ClassicalMds, "MDS: classical scaling"),
            (isomap, "Isomap: neighbour graph"),
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
            what: "Number of nearest poses to which each pose is connected",
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
