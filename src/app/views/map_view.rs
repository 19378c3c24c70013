//! The map of poses and their curves through time: from the latest map, kept until it or the study changes.

use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::app::document::phase_of;
use crate::app::morph::Morph;
use crate::app::play::pose_at;
use crate::app::state::State;
use crate::engine::{Interrupted, PoseMap, Showing};
use crate::study::Revision;
use crate::ui::{
    MapPoint, MapState, MapSubject, PoseMapView, PosePhase, SpaceTimeCurve, SpaceTimePoint,
    SpaceTimeView, ViewMode,
};

/// The opening, the study, its map and its measures.
type MadeFrom = (
    u64,
    Revision,
    Option<Arc<PoseMap>>,
    Option<Arc<Vec<SubjectMeasures>>>,
);

/// Points and subjects of the map with what they were made from.
#[derive(Debug, Default)]
pub struct MapData {
    made_from: Option<MadeFrom>,
    subjects: Vec<MapSubject>,
    /// Where points belong.
    targets: Vec<MapPoint>,
    /// Where they are now: on their way, or there.
    points: Vec<MapPoint>,
    curves: Vec<SpaceTimeCurve>,
    morph: Morph,
    left_out: String,
}

impl MapData {
    /// Makes points again where the study, the map or the measures changed, and moves those that
    /// are under way; whether any still are. Without `motion` they are there at once.
    pub fn refresh(&mut self, state: &State, now_s: f64, motion: bool) -> bool {
        let opening = state.document.study.opening;
        let revision = state.document.study().revision;
        let (map, measures) = (state.map(), state.measures());
        let made = self.made_from.as_ref();
        let same_map = made.is_some_and(|made| made.0 == opening && same_arc(made.2.as_ref(), map));
        let same = same_map
            && made.is_some_and(|made| made.1 == revision && same_arc(made.3.as_ref(), measures));
        if !same {
            let same_opening = made.is_some_and(|made| made.0 == opening);
            self.subjects = map_subjects(state);
            self.targets = map.map_or_else(Vec::new, |map| map_points(state, map));
            self.left_out = map.map_or_else(String::new, |map| left_out(state, map));
            if !same_map {
                self.morph = if motion && same_opening {
                    let targets: Vec<_> = self.targets.iter().map(keyed).collect();
                    Morph::between(self.points.iter().map(keyed), &targets, now_s)
                } else {
                    Morph::default()
                };
            }
            self.made_from = Some((opening, revision, map.cloned(), measures.cloned()));
        }
        let moved = self.morph.is_under_way();
        let moves = self.morph.moves(now_s);
        if moved || !same {
            self.points = self
                .targets
                .iter()
                .enumerate()
                .map(|(index, point)| MapPoint {
                    at: self.morph.place(index, point.at, now_s),
                    ..*point
                })
                .collect();
            self.curves = curves(state, &self.points);
        }
        moves
    }

    /// All subjects of the study, as maps show them.
    pub fn subjects(&self) -> &[MapSubject] {
        &self.subjects
    }

    /// Who is not on the map, and why.
    pub fn left_out(&self) -> &str {
        &self.left_out
    }

    /// What the pane of poses shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        showing: Option<&Showing<PoseMap>>,
    ) -> PoseMapView<'a> {
        let document = &state.document;
        let embedding = state.map().map(|map| &map.embedding);
        PoseMapView {
            state: map_state(state, showing),
            subjects: &self.subjects,
            points: &self.points,
            selected: document.selected().map(|_| document.subject),
            selected_frame: document.frame(),
            current: self.current(state),
            compared: compared(state),
            params: document.map,
            stress: embedding.and_then(|embedding| embedding.stress),
            neighbours: embedding.and_then(|embedding| embedding.neighbours),
            left_out: &self.left_out,
        }
    }

    /// What the pane of poses through time shows.
    pub fn space_time<'a>(
        &'a self,
        state: &State,
        showing: Option<&Showing<PoseMap>>,
    ) -> SpaceTimeView<'a> {
        let document = &state.document;
        SpaceTimeView {
            state: map_state(state, showing),
            subjects: &self.subjects,
            curves: &self.curves,
            selected: document.selected().map(|_| document.subject),
            compared: compared(state),
            share: document
                .selected()
                .map_or(0.0, |subject| phase_of(subject, document.position)),
        }
    }

    /// Where the position between two poses lies: on the straight line between their points, as
    /// the heart on screen lies on the path between their vertices.
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

fn keyed(point: &MapPoint) -> ((usize, usize), [f64; 2]) {
    ((point.subject, point.frame), point.at)
}

/// The second heart of the side-by-side view.
pub fn compared(state: &State) -> Option<usize> {
    let document = &state.document;
    (document.view_mode == ViewMode::SideBySide)
        .then(|| document.compared())
        .flatten()
}

/// Whether both are the same value in memory, or both absent.
pub fn same_arc<T>(a: Option<&Arc<T>>, b: Option<&Arc<T>>) -> bool {
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
            let (end_diastole, end_systole) = state.phases_of(pose.subject);
            MapPoint {
                subject: pose.subject,
                frame: pose.frame,
                at: plane(map.embedding.point(row)),
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

/// The first two coordinates of a point.
pub fn plane(point: &[f64]) -> [f64; 2] {
    [0, 1].map(|axis| point.get(axis).copied().unwrap_or_default())
}

/// Runs of poses of one subject, each pose at its share of the beat.
fn curves(state: &State, points: &[MapPoint]) -> Vec<SpaceTimeCurve> {
    points
        .chunk_by(|a, b| a.subject == b.subject)
        .filter_map(|run| {
            let subject = state.subject(run[0].subject)?;
            let points = run
                .iter()
                .map(|point| SpaceTimePoint {
                    frame: point.frame,
                    at: point.at,
                    share: phase_of(subject, point.frame as f64),
                    phase: point.phase,
                })
                .collect();
            Some(SpaceTimeCurve {
                subject: run[0].subject,
                points,
            })
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

/// How a map stands, from how its work stands.
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
