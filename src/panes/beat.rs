//! The motion of the selected subject: time bar, volume curves and measures.

use crate::analysis::measures::FrameMeasures;
use crate::document::interpolated_poses::{BetweenWords, between_words, geodesic_params};
use crate::document::state::State;
use crate::panes::curves::{Curve, CurveKind, CurvesView};
use crate::panes::cycle_axis::CycleAxis;
use crate::panes::measures::MeasuresView;
use crate::report::SubjectRow;

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

/// What is said of the pose on screen of a subject.
pub fn between_words_of(state: &State, subject: usize, position: f64) -> BetweenWords {
    let motion = state.interpolated_poses_of(subject).map(|motion| &**motion);
    between_words(motion, position, straight_because(state))
}

/// Why poses between frames are straight, where that is not for want of time.
pub fn straight_because(state: &State) -> &'static str {
    let Some(params) = geodesic_params(&state.document) else {
        return "Interpolated poses are off (menu Analysis)";
    };
    let motion = state.answers.interpolated_poses(state.document.subject);
    let stopped = motion.is_some_and(|motion| motion.stopped);
    if params.check().is_err() {
        "The metric of the map has no geodesics: choose the additive form"
    } else if stopped {
        "The computation of interpolated poses was stopped"
    } else {
        ""
    }
}

/// What the line of the time bar says to whoever points at it.
pub fn line_note(state: &State, between: BetweenWords) -> String {
    if between.badge.is_some() {
        return between.note;
    }
    match state.document.interpolated_poses {
        0 => "Interpolated poses are off (menu Analysis)".to_owned(),
        1 => "1 interpolated pose per interval, computed while the subject plays".to_owned(),
        count => {
            format!("{count} interpolated poses per interval, computed while the subject plays")
        }
    }
}

/// What the measures card shows.
pub fn measures_view(state: &State, computing: bool) -> MeasuresView<'_> {
    let document = &state.document;
    let Some(subject) = document.selected() else {
        return MeasuresView::default();
    };
    let measures = state.measures_of(document.subject);
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    let row = measures.map_or_else(SubjectRow::default, |measured| {
        SubjectRow::new(subject.id.clone(), subject.label.clone(), measured)
    });
    let stated = subject.end_diastole.is_some() || subject.end_systole.is_some();
    MeasuresView {
        subject: Some(&subject.id),
        computing,
        measures: SubjectRow {
            unit: subject.unit,
            end_diastole,
            end_systole,
            phases_stated: row.phases_stated || stated,
            ..row
        },
        current_frame: document.frame(),
    }
}
