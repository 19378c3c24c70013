//! Transport before poses are compared, and the embedding of their distances.

use egui::{ScrollArea, Ui};

use crate::analysis::embedding::MapMethod;
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::engine::PoseMapQuery;
use crate::panes::metric::words::method_name;
use crate::panes::metric::{MetricPanelView, choice_row_ui, sentence_ui};
use crate::panes::scatter_map::isomap;
use crate::ui::controls::choices_ui;
use crate::ui::number_field::{Setting, whole};

/// Draws reference and method; a change goes into `wanted`.
pub fn pose_map_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut PoseMapQuery) {
    reference_ui(ui, view, wanted);
    method_ui(ui, wanted);
}

fn reference_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut PoseMapQuery) {
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
        let whole = [
            (None, "off: compare subjects as recorded"),
            (Some(Reference::Mean), "onto the mean subject of the cohort"),
        ];
        if let Some(reference) = choices_ui(ui, whole, now) {
            choose(reference);
        }
        ui.separator();
        ScrollArea::vertical().max_height(260.0).show(ui, |ui| {
            let first = view.selected.into_iter();
            let rest = (0..view.subjects.len()).filter(|i| Some(*i) != view.selected);
            let subjects = first.chain(rest).map(|subject| {
                let reference = Some(Reference::Subject(subject));
                (reference, format!("onto {}", name(subject)))
            });
            if let Some(reference) = choices_ui(ui, subjects, now) {
                choose(reference);
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

fn method_ui(ui: &mut Ui, wanted: &mut PoseMapQuery) {
    let what = "Embedding of the distances between poses in the plane";
    let method = wanted.method;
    choice_row_ui(ui, "Method", what, method_name(method), true, |ui| {
        let methods = [
            (MapMethod::Smacof, "SMACOF: minimises stress"),
            (MapMethod::ClassicalMds, "MDS: classical scaling"),
            (isomap(method), "Isomap: neighbour graph"),
        ];
        wanted.method = choices_ui(ui, methods, method).unwrap_or(method);
    });
    if matches!(method, MapMethod::Isomap { .. }) {
        NEIGHBOURS.ui(ui, wanted, None, true, |_| Ok(()));
    }
}

const NEIGHBOURS: Setting<PoseMapQuery> = Setting {
    name: "Neighbours",
    unit: "poses",
    what: "Number of nearest poses to which each pose is connected",
    range: [1.0, 10_000.0],
    get: |poses| match poses.method {
        MapMethod::Isomap { neighbours } => Some(f64::from(neighbours)),
        MapMethod::ClassicalMds | MapMethod::Smacof => None,
    },
    set: |poses, neighbours| match whole(neighbours.unwrap_or_default(), 10_000)? {
        0 => Err("must be at least 1".to_owned()),
        neighbours => {
            let neighbours = neighbours as u16;
            poses.method = MapMethod::Isomap { neighbours };
            Ok(())
        }
    },
};
