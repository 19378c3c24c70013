//! What the views of all maps share: what they are made from, how they stand, and who is selected.

use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::document::ViewMode;
use crate::document::play::pose_at;
use crate::document::state::State;
use crate::engine::{Interrupted, Showing};
use crate::panes::{MapState, MapSubject, MapWords, ScatterPoint, ScatterView, places_between};
use crate::study::{Revision, Study};

/// A shared value that is equal only to itself, or to nothing where both are absent.
#[derive(Debug)]
pub struct Shared<T>(Option<Arc<T>>);

impl<T> Shared<T> {
    /// Holds the value.
    pub fn of(value: Option<&Arc<T>>) -> Self {
        Self(value.cloned())
    }
}

impl<T> PartialEq for Shared<T> {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (None, None) => true,
            (Some(_), None) | (None, Some(_)) => false,
        }
    }
}

/// What points depend on beside their map: the study, and its measures for the phases.
pub type Details = (Revision, Shared<Vec<SubjectMeasures>>);

/// The study on screen and its measures.
pub fn details(state: &State) -> Details {
    let revision = state.document.study().revision;
    (revision, Shared::of(state.measures()))
}

/// A map of these points as the document shows it.
pub fn scatter_view<'a>(
    state: &State,
    words: &'static MapWords,
    map_state: MapState,
    subjects: &'a [MapSubject],
    points: &'a [ScatterPoint],
) -> ScatterView<'a> {
    let document = &state.document;
    let pose = pose_at(document.position, document.frame_count());
    let frames = [pose.from, pose.to];
    let compared = (document.view_mode == ViewMode::SideBySide)
        .then(|| document.compared())
        .flatten();
    ScatterView {
        state: map_state,
        selected: document.selected().map(|_| document.subject),
        compared,
        current: places_between(points, document.subject, frames, f64::from(pose.blend)),
        shows_clusters: document.shows_clusters,
        ..ScatterView::new(words, subjects, points)
    }
}

/// The first two coordinates of a point.
pub fn plane(point: &[f64]) -> [f64; 2] {
    [0, 1].map(|axis| point.get(axis).copied().unwrap_or_default())
}

/// One line for each subject that is not on a map, with the reason.
pub fn left_out<R: std::fmt::Display>(
    study: &Study,
    left_out: impl Iterator<Item = (usize, R)>,
) -> Vec<String> {
    left_out
        .filter_map(|(subject, reason)| {
            let subject = study.subjects.get(subject)?;
            Some(format!("{}: {reason}", subject.id))
        })
        .collect()
}

/// How a map stands, from how its work stands; `None` where it is not asked for yet.
pub fn map_state<T>(state: &State, showing: Option<&Showing<T>>) -> MapState {
    if state.document.study().subjects.is_empty() {
        return MapState::Empty;
    }
    match showing {
        Some(Showing::Ready(_)) => MapState::Ready,
        None => MapState::Computing {
            fraction: 0.0,
            seconds_left: None,
        },
        Some(Showing::Computing { watch, .. }) => MapState::Computing {
            fraction: watch.fraction(),
            seconds_left: watch.time_left().map(|left| left.as_secs_f64()),
        },
        Some(Showing::Interrupted { why, .. }) => match why {
            Interrupted::Stopped => MapState::Stopped,
            Interrupted::Failed(error) => MapState::Failed(error.to_string()),
        },
    }
}
