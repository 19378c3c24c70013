//! How settings are said.

use super::*;
use crate::analysis::metrics::MetricKind;

#[test]
fn settings_read_as_a_person_would_say_them() {
    let request = AnalysisRequest::PoseMap(PoseMapParams::default());
    assert_eq!(
        request.parameters(),
        "quasi-conformal, additive form, μ = 0.001, scale-free corners, λ = 3, \
         smoothed over 0.1 √area, SMACOF"
    );
    let mut metric = MetricParams {
        kind: MetricKind::Rigid,
        ..MetricParams::default()
    };
    assert_eq!(metric_words(&metric), "rigid");
    metric.kind = MetricKind::AnglePreserving;
    assert!(!metric_words(&metric).contains('μ'));
}
