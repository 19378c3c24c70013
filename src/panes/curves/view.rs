//! The volume pane of a state.

use crate::analysis::measures::FrameMeasures;
use crate::document::state::State;
use crate::panes::cycle_axis::CycleAxis;

use super::{Curve, CurveKind, CurvesView};

/// What the volume pane shows; `computing` says whether volumes are still to come.
pub fn curves_view(state: &State, computing: bool) -> CurvesView<'_> {
    let document = &state.document;
    let Some(subject) = document.selected() else {
        return CurvesView::default();
    };
    let frames = state
        .measures_of(document.subject)
        .map_or(&[][..], |measures| &measures.frames);
    let curve = |kind, volume: fn(&FrameMeasures) -> Option<f64>| {
        let known = frames.iter().any(|frame| volume(frame).is_some());
        let values = frames.iter().map(|frame| volume(frame).unwrap_or(f64::NAN));
        known.then(|| Curve {
            kind,
            values: values.collect(),
        })
    };
    let curves = [
        curve(CurveKind::Endocardium, |frame| frame.endo_volume),
        curve(CurveKind::Epicardium, |frame| frame.epi_volume),
    ];
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    CurvesView {
        curves: curves.into_iter().flatten().collect(),
        unit: subject.unit.volume_symbol(),
        axis: CycleAxis::of(subject),
        cycle_ms: subject.timing.rr.map(|rr| 1e3 * rr.0),
        position: document.position,
        end_diastole,
        end_systole,
        computing,
    }
}
