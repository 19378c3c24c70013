//! Metrics, forms and methods in the words of the window, with what each ignores.

use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::{Corners, CurvatureRole, Form, MetricParams, MetricWords};

/// All forms in the order in which they are offered.
pub const FORMS: [Form; 4] = [Form::Additive, Form::Bilinear, Form::Frozen, Form::Printed];

/// Name of an embedding method.
pub fn method_name(method: MapMethod) -> &'static str {
    match method {
        MapMethod::ClassicalMds => "MDS",
        MapMethod::Smacof => "SMACOF",
        MapMethod::Isomap { .. } => "Isomap",
    }
}

/// Whether the weight μ plays a part.
pub fn has_curvature_weight(metric: &MetricParams) -> bool {
    metric.curvature_role() == CurvatureRole::Term
}

/// Whether the rings over which curvature is averaged play a part.
pub fn has_rings(metric: &MetricParams) -> bool {
    metric.curvature_role() != CurvatureRole::Unused && metric.area_weights
}

/// One sentence: what a metric ignores and what it penalises.
pub fn metric_sentence(metric: &MetricParams) -> String {
    let MetricWords {
        name,
        ignores,
        penalises,
        ..
    } = metric.kind.words();
    let displacement = if metric.lambda > 0.0 && !metric.kind.penalises_displacement() {
        ", and every displacement with weight λ"
    } else {
        ""
    };
    format!("{name}: ignores {ignores}; penalises {penalises}{displacement}")
}

/// One sentence: how a form puts its terms together, and what it is good for.
pub fn form_sentence(metric: &MetricParams) -> &'static str {
    match metric.form {
        Form::Additive if !has_curvature_weight(metric) => {
            "Additive: an inner product everywhere; without curvature equal to the bilinear form"
        }
        Form::Additive => "Additive: an inner product everywhere; angle term + μ × curvature term",
        Form::Bilinear => {
            "Bilinear: ignores changes of angles where curvature is constant; can be zero along a path"
        }
        Form::Frozen => {
            "Frozen weights: ignores how curvature changes along the path; an inner product for each pair"
        }
        Form::Printed => {
            "As printed: absolute values, so not an inner product; for single steps only"
        }
    }
}

/// One sentence: the effect of size.
pub fn corners_sentence(corners: Corners) -> &'static str {
    match corners {
        Corners::ScaleFree => "Scale-invariant: corner terms are relative to edge lengths",
        Corners::Raw => "As printed: corner terms scale with the fourth power of edge length",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::metrics::METRICS;

    #[test]
    fn every_metric_says_what_it_ignores() {
        for kind in METRICS {
            let mut metric = MetricParams::of(kind);
            let sentence = metric_sentence(&metric);
            assert!(sentence.starts_with(kind.words().name) && sentence.contains("ignores"));
            metric.lambda = 0.0;
            assert!(!metric_sentence(&metric).contains('λ'));
        }
    }
}
