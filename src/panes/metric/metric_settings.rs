//! Which metric in which form, and its weights.

use egui::Ui;

use crate::analysis::metrics::{Corners, MetricParams, Regulariser};
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::engine::PoseMapParams;
use crate::panes::metric::words::{
    FORMS, METRICS, corners_sentence, form_name, form_sentence, has_curvature_weight, has_forms,
    has_rings, metric_name, metric_sentence,
};
use crate::panes::metric::{MetricPanelView, choice_row_ui, sentence_ui};
use crate::ui::controls::choice_ui;
use crate::ui::number_field::{NumberField, number_field_ui, whole};

/// Draws kind, form and what counts; the settings after a change.
pub fn metric_ui(ui: &mut Ui, view: &MetricPanelView) -> Option<PoseMapParams> {
    let mut wanted = view.poses;
    let metric = &mut wanted.distances.metric;
    let kind = metric.kind;
    choice_row_ui(
        ui,
        "Kind",
        "Which changes of shape the metric penalises",
        metric_name(kind),
        true,
        |ui| {
            for kind in METRICS {
                if choice_ui(ui, metric_name(kind), metric.kind == kind) {
                    metric.kind = kind;
                }
            }
        },
    );
    sentence_ui(ui, &metric_sentence(&view.poses.distances.metric));
    let forms = has_forms(kind);
    let what = "How the angle and curvature terms are combined";
    let form = metric.form;
    choice_row_ui(ui, "Form", what, form_name(form), forms, |ui| {
        for form in FORMS {
            if choice_ui(ui, form_name(form), metric.form == form) {
                metric.form = form;
            }
        }
    });
    if forms {
        sentence_ui(ui, form_sentence(&view.poses.distances.metric));
    }
    let mut scale_free = metric.corners == Corners::ScaleFree;
    let size = ui.checkbox(&mut scale_free, "Scale-invariant");
    if size
        .on_hover_text(corners_sentence(metric.corners))
        .clicked()
    {
        metric.corners = if scale_free {
            Corners::ScaleFree
        } else {
            Corners::Raw
        };
    }
    ui.checkbox(&mut metric.area_weights, "Area-weighted")
        .on_hover_text(
            "Faces, edges and vertices are weighted by their share of the surface, so that mesh density \
             has no effect; if off, all weights are 1, as printed",
        );
    Some(wanted).filter(|wanted| *wanted != view.poses)
}

/// Draws the numbers of the metric; the settings after a change.
pub fn weights_ui(ui: &mut Ui, view: &MetricPanelView) -> Option<PoseMapParams> {
    let metric = view.poses.distances.metric;
    let checked = |metric: MetricParams| match metric.check() {
        Ok(_) => Ok(metric),
        Err(error) => Err(error.to_string()),
    };
    let mut changed = None;
    let mu = NumberField {
        name: "Curvature, μ",
        unit: "",
        what: "Weight of a change of curvature relative to a change of angles; no unit",
        value: Some(metric.mu),
        automatic: None,
        enabled: has_curvature_weight(&metric),
    };
    let accept = |value: Option<f64>| {
        checked(MetricParams {
            mu: value.unwrap_or_default(),
            ..metric
        })
    };
    changed = number_field_ui(ui, &mu, accept).or(changed);
    let rings = NumberField {
        name: "Averaging",
        unit: "rings",
        what: "Rings of neighbours over which curvature is averaged, to reduce noise",
        value: Some(f64::from(metric.curvature_rings)),
        automatic: None,
        enabled: has_rings(&metric),
    };
    let accept = |value: Option<f64>| {
        checked(MetricParams {
            curvature_rings: whole(value.unwrap_or_default(), u32::MAX)?,
            ..metric
        })
    };
    changed = number_field_ui(ui, &rings, accept).or(changed);
    let lambda = NumberField {
        name: "Displacement, λ",
        unit: "",
        what: "Weight of displacement itself, relative to the radius of the heart; keeps every form \
               positive; no unit",
        value: Some(metric.lambda),
        automatic: None,
        enabled: true,
    };
    let accept = |value: Option<f64>| {
        checked(MetricParams {
            lambda: value.unwrap_or_default(),
            ..metric
        })
    };
    changed = number_field_ui(ui, &lambda, accept).or(changed);
    let mut wanted = view.poses;
    if let Some(metric) = changed {
        wanted.distances.metric = metric;
    }
    if let Some(distances) = smoothing_ui(ui, view.poses.distances) {
        wanted.distances = distances;
    }
    regulariser_ui(ui, &mut wanted.distances.metric);
    Some(wanted).filter(|wanted| *wanted != view.poses)
}

fn smoothing_ui(ui: &mut Ui, distances: PoseDistanceParams) -> Option<PoseDistanceParams> {
    let smoothing = NumberField {
        name: "Smoothing",
        unit: "√area",
        what: "Poses are smoothed below this radius before they are compared, so that mesh noise has \
               little effect on distances; 0: no smoothing",
        value: Some(distances.smoothing),
        automatic: None,
        enabled: true,
    };
    number_field_ui(ui, &smoothing, |value| {
        let wanted = PoseDistanceParams {
            smoothing: value.unwrap_or_default(),
            ..distances
        };
        match wanted.check() {
            Ok(_) => Ok(wanted),
            Err(error) => Err(error.to_string()),
        }
    })
}

fn regulariser_ui(ui: &mut Ui, metric: &mut MetricParams) {
    let what = "How the displacement of vertices is summed";
    let name = |regulariser| match regulariser {
        Regulariser::Area => "by area",
        Regulariser::Uniform => "by vertex",
    };
    let shown = name(metric.regulariser);
    choice_row_ui(ui, "Regulariser", what, shown, true, |ui| {
        for regulariser in [Regulariser::Area, Regulariser::Uniform] {
            if choice_ui(ui, name(regulariser), metric.regulariser == regulariser) {
                metric.regulariser = regulariser;
            }
        }
    });
}
