//! The beat of the selected heart: time bar, volume curves and measures.

use crate::analysis::measures::FrameMeasures;
use crate::document::document::phase_of;
use crate::document::interpolated_poses::{BetweenWords, between_words, geodesic_params};
use crate::document::state::State;
use crate::panes::{BeatAxis, Curve, CurveKind, CurvesView, MeasuresView};
use crate::report::SubjectRow;

/// Numbers of the selected heart's beat.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BeatData {
    pub(crate) frame_shares: Vec<f64>,
    pub(crate) endo_volumes: Vec<f64>,
    pub(crate) epi_volumes: Vec<f64>,
    pub(crate) interpolated_poses: Vec<f64>,
    pub(crate) between: BetweenWords,
    pub(crate) note: String,
}

impl BeatData {
    /// Numbers of the heart that is selected now.
    pub fn of(state: &State) -> Self {
        let Some(subject) = state.document.selected() else {
            return Self::default();
        };
        let frames = state
            .measures_of(state.document.subject)
            .map_or(&[][..], |measures| &measures.frames);
        let volumes = |volume: fn(&FrameMeasures) -> Option<f64>| {
            if frames.iter().all(|frame| volume(frame).is_none()) {
                return Vec::new();
            }
            frames
                .iter()
                .map(|frame| volume(frame).unwrap_or(f64::NAN))
                .collect()
        };
        let interpolated_poses = state.interpolated_poses_of(state.document.subject);
        let between = between_words(
            interpolated_poses.map(|beat| &**beat),
            state.document.position,
            straight_because(state),
        );
        Self {
            frame_shares: (0..subject.sequence.frame_count())
                .map(|frame| phase_of(subject, frame as f64))
                .collect(),
            endo_volumes: volumes(|frame| frame.endo_volume),
            epi_volumes: volumes(|frame| frame.epi_volume),
            interpolated_poses: interpolated_poses.map_or_else(Vec::new, |beat| beat.positions()),
            note: line_note(state, &between),
            between,
        }
    }

    /// Where the frames lie within the beat.
    pub fn axis(&self) -> BeatAxis<'_> {
        BeatAxis {
            frame_shares: &self.frame_shares,
        }
    }

    /// The curves that have numbers.
    pub fn curves(&self) -> Vec<Curve<'_>> {
        [
            (CurveKind::Endocardium, &self.endo_volumes),
            (CurveKind::Epicardium, &self.epi_volumes),
        ]
        .into_iter()
        .filter(|(_, values)| !values.is_empty())
        .map(|(kind, values)| Curve { kind, values })
        .collect()
    }

    /// What the volume pane shows.
    pub fn curves_view<'a>(
        &'a self,
        state: &State,
        curves: &'a [Curve<'a>],
        computing: bool,
    ) -> CurvesView<'a> {
        let document = &state.document;
        let (end_diastole, end_systole) = state.phases_of(document.subject);
        let subject = document.selected();
        CurvesView {
            curves,
            unit: subject.map_or("", |subject| subject.unit.volume_symbol()),
            axis: self.axis(),
            beat_ms: subject
                .and_then(|subject| subject.timing.rr)
                .map(|rr| 1e3 * rr.0),
            position: document.position,
            end_diastole,
            end_systole,
            computing,
        }
    }
}

/// Why poses between frames are straight, where that is not for want of time.
pub fn straight_because(state: &State) -> &'static str {
    let Some(params) = geodesic_params(&state.document) else {
        return "Interpolated poses are off (menu Analysis)";
    };
    let beat = state.answers.interpolated_poses(state.document.subject);
    let stopped = beat.is_some_and(|beat| beat.stopped);
    if params.check().is_err() {
        "The metric of the map has no geodesics: choose the additive form"
    } else if stopped {
        "The computation of interpolated poses was stopped"
    } else {
        ""
    }
}

/// What the line of the time bar says to whoever points at it.
fn line_note(state: &State, between: &BetweenWords) -> String {
    if between.badge.is_some() {
        return between.note.clone();
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
