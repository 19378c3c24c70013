//! Which metric in which form, and its weights.

use egui::Ui;

use crate::analysis::metrics::{CurvatureMean, Regulariser};
use crate::engine::PoseMapQuery;
use crate::panes::metric::choices::{forms_ui, kinds_ui, scale_free_ui};
use crate::panes::metric::words::{
    corners_sentence, form_sentence, has_curvature_weight, has_rings, metric_sentence,
};
use crate::panes::metric::{choice_row_ui, sentence_ui};
use crate::ui::controls::choices_ui;
use crate::ui::number_field::Setting;

/// Draws kind, form and what counts; a choice goes into `wanted`.
pub fn metric_ui(ui: &mut Ui, wanted: &mut PoseMapQuery) {
    let metric = &mut wanted.distances.metric;
    let shown = *metric;
    let what = "Which changes of shape the metric penalises";
    let name = shown.kind.words().name;
    choice_row_ui(ui, "Kind", what, name, true, |ui| kinds_ui(ui, metric));
    sentence_ui(ui, &metric_sentence(&shown));
    let (what, forms) = (
        "How the angle and curvature terms are combined",
        shown.kind.has_forms(),
    );
    choice_row_ui(ui, "Form", what, shown.form.name(), forms, |ui| {
        forms_ui(ui, metric);
    });
    if forms {
        sentence_ui(ui, form_sentence(&shown));
    }
    scale_free_ui(ui, metric).on_hover_text(corners_sentence(shown.corners));
    ui.checkbox(&mut metric.area_weights, "Area-weighted")
        .on_hover_text(
            "Faces, edges and vertices are weighted by their share of the surface, so that mesh density \
             has no effect; if off, all weights are 1, as printed",
        );
}

const MU: Setting<PoseMapQuery> = Setting {
    name: "Curvature, μ",
    unit: "",
    what: "Weight of a change of curvature relative to a change of angles",
    range: [0.0, f64::INFINITY],
    get: |poses| Some(poses.distances.metric.mu),
    set: |poses, mu| {
        poses.distances.metric.mu = mu.unwrap_or_default();
        Ok(())
    },
};

const CURVATURE_RADIUS: Setting<PoseMapQuery> = Setting {
    name: "Averaging",
    unit: "√area",
    what: "Radius over which curvature is averaged, to reduce noise",
    range: [0.0, 0.5],
    get: |poses| match poses.distances.metric.curvature {
        CurvatureMean::Radius(share) => Some(share),
        CurvatureMean::Rings(_) => None,
    },
    set: |poses, share| {
        poses.distances.metric.curvature = CurvatureMean::Radius(share.unwrap_or_default());
        Ok(())
    },
};

const LAMBDA: Setting<PoseMapQuery> = Setting {
    name: "Displacement, λ",
    unit: "",
    what: "Weight of displacement itself, relative to the radius of the heart; keeps every form \
           positive",
    range: [0.0, f64::INFINITY],
    get: |poses| Some(poses.distances.metric.lambda),
    set: |poses, lambda| {
        poses.distances.metric.lambda = lambda.unwrap_or_default();
        Ok(())
    },
};

const SMOOTHING: Setting<PoseMapQuery> = Setting {
    name: "Smoothing",
    unit: "√area",
    what: "Poses are smoothed below this radius before they are compared, so that mesh noise has \
           little effect on distances; 0: no smoothing",
    range: [0.0, 1.0],
    get: |poses| Some(poses.distances.smoothing),
    set: |poses, smoothing| {
        poses.distances.smoothing = smoothing.unwrap_or_default();
        Ok(())
    },
};

/// Draws the numbers of the metric; a change goes into `wanted`.
pub fn weights_ui(ui: &mut Ui, wanted: &mut PoseMapQuery) {
    let metric = wanted.distances.metric;
    let metric_is_right = |poses: &PoseMapQuery| match poses.distances.metric.check() {
        Ok(_) => Ok(()),
        Err(error) => Err(error.to_string()),
    };
    for (setting, enabled) in [
        (MU, has_curvature_weight(&metric)),
        (CURVATURE_RADIUS, has_rings(&metric)),
        (LAMBDA, true),
    ] {
        setting.ui(ui, wanted, None, enabled, metric_is_right);
    }
    SMOOTHING.ui(ui, wanted, None, true, |poses| {
        match poses.distances.check() {
            Ok(_) => Ok(()),
            Err(error) => Err(error.to_string()),
        }
    });
    let what = "How the displacement of vertices is summed";
    let regularisers = [
        (Regulariser::Area, "by area"),
        (Regulariser::Uniform, "by vertex"),
    ];
    let shown = regularisers[usize::from(metric.regulariser == Regulariser::Uniform)].1;
    choice_row_ui(ui, "Regulariser", what, shown, true, |ui| {
        let chosen = choices_ui(ui, regularisers, metric.regulariser);
        wanted.distances.metric.regulariser = chosen.unwrap_or(metric.regulariser);
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::number_field::assert_takes_its_range;

    #[test]
    fn each_number_takes_what_its_range_says_and_no_more() {
        let takes = |params: &PoseMapQuery| params.distances.check().is_ok();
        for setting in [MU, CURVATURE_RADIUS, LAMBDA, SMOOTHING] {
            assert_takes_its_range(&setting, takes);
        }
    }
}
