//! The map of poses: points from the latest map, kept until it or the study changes.

use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::app::play::pose_at;
use crate::app::state::State;
use crate::engine::{AnalysisError, AnalysisOutcome, PoseMap, Showing};
use crate::study::Revision;
use crate::ui::{MapPoint, MapState, MapSubject, PoseMapView, PosePhase, ViewMode};

/// The study, its map and its measures.
type MadeFrom = (
    Revision,
    Option<Arc<PoseMap>>,
    Option<Arc<Vec<SubjectMeasures>>>,
);

/// Points and subjects of the map with what they were made from.
#[derive(Debug, Default)]
pub struct MapData {
    made_from: Option<MadeFrom>,
    subjects: Vec<MapSubject>,
    points: Vec<MapPoint>,
    left_out: String,
}

impl MapData {
    /// Makes points again where the study, the map or the measures changed.
    pub fn refresh(&mut self, state: &State) {
        let revision = state.document.study().revision;
        let (map, measures) = (state.map(), state.measures());
        let same = self.made_from.as_ref().is_some_and(|made| {
            made.0 == revision
                && same_arc(made.1.as_ref(), map)
                && same_arc(made.2.as_ref(), measures)
        });
        if same {
            return;
        }
        self.subjects = map_subjects(state);
        self.points = map.map_or_else(Vec::new, |map| map_points(state, map));
        self.left_out = map.map_or_else(String::new, |map| left_out(state, map));
        self.made_from = Some((revision, map.cloned(), measures.cloned()));
    }

    /// What the pane shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        showing: &Showing<'_, AnalysisOutcome, AnalysisError>,
    ) -> PoseMapView<'a> {
        let document = &state.document;
        PoseMapView {
            state: map_state(state, showing),
            subjects: &self.subjects,
            points: &self.points,
            selected: document.selected().map(|_| document.subject),
            selected_frame: document.frame(),
            current: self.current(state),
            compared: (document.view_mode == ViewMode::SideBySide)
                .then(|| document.compared())
                .flatten(),
            params: document.map,
            stress: state.map().and_then(|map| map.embedding.stress),
            left_out: &self.left_out,
        }
    }

    /// Where the position between two poses lies: on the straight line between their points, as
    /// the heart on screen lies on the straight path between their vertices.
    fn current(&self, state: &State) -> Option<[f64; 2]> {
        let document = &state.document;
        let pose = pose_at(document.position, document.frame_count());
        let place = |frame: usize| {
            self.points
                .iter()
                .find(|point| point.subject == document.subject && point.frame == frame)
                .map(|point| point.at)
        };
        let (from, to) = (place(pose.from)?, place(pose.to)?);
        let share = f64::from(pose.blend);
        Some([
            from[0] + share * (to[0] - from[0]),
            from[1] + share * (to[1] - from[1]),
        ])
    }
}

fn same_arc<T>(a: Option<&Arc<T>>, b: Option<&Arc<T>>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (None, None) => true,
        _ => false,
    }
}

fn map_subjects(state: &State) -> Vec<MapSubject> {
    let study = state.document.study();
    study
        .subjects
        .iter()
        .enumerate()
        .map(|(index, subject)| MapSubject {
            id: subject.id.clone(),
            label: subject.label.clone(),
            role: study.role(subject),
            ejection_fraction: state.measures_of(index).and_then(|measures| measures.ef),
        })
        .collect()
}

fn map_points(state: &State, map: &PoseMap) -> Vec<MapPoint> {
    let places = map.distances.poses.iter().enumerate();
    places
        .filter(|(row, _)| *row < map.embedding.len())
        .map(|(row, pose)| {
            let point = map.embedding.point(row);
            let (end_diastole, end_systole) = state.phases_of(pose.subject);
            MapPoint {
                subject: pose.subject,
                frame: pose.frame,
                at: [
                    point.first().copied().unwrap_or_default(),
                    point.get(1).copied().unwrap_or_default(),
                ],
                phase: if end_diastole == Some(pose.frame) {
                    PosePhase::EndDiastole
                } else if end_systole == Some(pose.frame) {
                    PosePhase::EndSystole
                } else {
                    PosePhase::Between
                },
            }
        })
        .collect()
}

fn left_out(state: &State, map: &PoseMap) -> String {
    let lines: Vec<String> = map
        .distances
        .left_out
        .iter()
        .filter_map(|left_out| {
            let subject = state.subject(left_out.subject)?;
            Some(format!("{}: {}", subject.id, left_out.reason))
        })
        .collect();
    lines.join("\n")
}

fn map_state(state: &State, showing: &Showing<'_, AnalysisOutcome, AnalysisError>) -> MapState {
    if state.document.study().subjects.is_empty() {
        return MapState::Empty;
    }
    match showing {
        Showing::Ready(_) => MapState::Ready,
        Showing::Nothing => MapState::Computing {
            fraction: 0.0,
            seconds_left: None,
        },
        Showing::Computing { watch, .. } => MapState::Computing {
            fraction: watch.fraction(),
            seconds_left: watch.time_left().map(|left| left.as_secs_f64()),
        },
        Showing::Stopped { .. } => MapState::Stopped,
        Showing::Failed { error, .. } => MapState::Failed(error.to_string()),
    }
}
