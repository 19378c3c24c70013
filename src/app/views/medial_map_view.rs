//! The map of the medial shape space: from the latest map, kept until it or the study changes.

use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial_map::{MedialMap, Spread};
use crate::app::morph::Morph;
use crate::app::play::pose_at;
use crate::app::state::State;
use crate::engine::Showing;
use crate::study::Revision;
use crate::ui::{MapSubject, MedialMapView, MedialPoint, PosePhase};

use super::map_view::{compared, map_state, plane, same_arc};

/// The opening, the study, its map and its measures.
type MadeFrom = (
    u64,
    Revision,
    Option<Arc<MedialMap>>,
    Option<Arc<Vec<SubjectMeasures>>>,
);

/// Points of the map with what they were made from.
#[derive(Debug, Default)]
pub struct MedialMapData {
    made_from: Option<MadeFrom>,
    /// Those on the map.
    mapped: Vec<MapSubject>,
    /// Where points belong.
    targets: Vec<MedialPoint>,
    /// Where they are now: on their way, or there.
    points: Vec<MedialPoint>,
    morph: Morph,
    left_out: String,
}

impl MedialMapData {
    /// Makes points again where the study, the map or the measures changed, and moves those that are under way; whether
    /// any still are. Without `motion` they are there at once. `subjects` are all of the study.
    pub fn refresh(
        &mut self,
        state: &State,
        subjects: &[MapSubject],
        now_s: f64,
        motion: bool,
    ) -> bool {
        let opening = state.document.study.opening;
        let revision = state.document.study().revision;
        let (map, measures) = (state.medial_map(), state.measures());
        let made = self.made_from.as_ref();
        let same_map = made.is_some_and(|made| made.0 == opening && same_arc(made.2.as_ref(), map));
        let same = same_map
            && made.is_some_and(|made| made.1 == revision && same_arc(made.3.as_ref(), measures));
        if !same {
            let same_opening = made.is_some_and(|made| made.0 == opening);
            self.targets = map.map_or_else(Vec::new, |map| points(state, map));
            self.left_out = map.map_or_else(String::new, |map| left_out(state, map));
            let on_map = |index: &usize| self.targets.iter().any(|point| point.subject == *index);
            self.mapped = (0..subjects.len())
                .filter(on_map)
                .map(|index| subjects[index].clone())
                .collect();
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
            self.points = (self.targets.iter().enumerate())
                .map(|(index, point)| MedialPoint {
                    at: self.morph.place(index, point.at, now_s),
                    ..*point
                })
                .collect();
        }
        moves
    }

    /// What the pane shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        subjects: &'a [MapSubject],
        showing: Option<&Showing<MedialMap>>,
    ) -> MedialMapView<'a> {
        let document = &state.document;
        let map = state.medial_map();
        MedialMapView {
            state: map_state(state, showing),
            subjects,
            mapped: &self.mapped,
            points: &self.points,
            selected: document.selected().map(|_| document.subject),
            current: self.current(state),
            compared: compared(state),
            method: document.map.method,
            stress: map.and_then(|map| map.embedding.stress),
            frame: map.map_or("", |map| map.frame.words()),
            left_out_count: map.map_or(0, |map| map.left_out.len()),
            left_out: &self.left_out,
        }
    }

    /// Where the position in the beat lies on each path of the selected heart: between the steps that begin at the
    /// frames around it, and nowhere where a path has neither.
    fn current(&self, state: &State) -> Vec<[f64; 2]> {
        let document = &state.document;
        let pose = pose_at(document.position, document.frame_count());
        let share = f64::from(pose.blend);
        let own = |point: &&MedialPoint| point.subject == document.subject;
        let mut patches: Vec<Option<usize>> = (self.points.iter().filter(own))
            .map(|point| point.patch)
            .collect();
        patches.dedup();
        let place = |patch: Option<usize>, frame: usize| {
            let mut steps = self.points.iter().filter(own);
            let found = steps.find(|point| (point.patch, point.from) == (patch, frame));
            found.map(|point| point.at)
        };
        let between = |patch: &Option<usize>| {
            let from = place(*patch, pose.from)?;
            if share <= 0.0 {
                return Some(from);
            }
            let to = place(*patch, pose.to)?;
            Some([0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis])))
        };
        patches.iter().filter_map(between).collect()
    }
}

/// What a point is known by from one map to the next.
fn keyed(point: &MedialPoint) -> ((usize, Option<usize>, usize), [f64; 2]) {
    ((point.subject, point.patch, point.from), point.at)
}

fn points(state: &State, map: &MedialMap) -> Vec<MedialPoint> {
    let rows = map.poses.iter().enumerate();
    rows.filter(|(row, _)| *row < map.embedding.len())
        .map(|(row, pose)| {
            let (end_diastole, end_systole) = state.phases_of(pose.subject);
            let same =
                |spread: &&Spread| (spread.subject, spread.part) == (pose.subject, pose.part);
            MedialPoint {
                subject: pose.subject,
                patch: pose.part.patch(),
                from: pose.step_from,
                to: pose.step_to,
                at: plane(map.embedding.point(row)),
                phase: if end_diastole == Some(pose.step_from) {
                    PosePhase::EndDiastole
                } else if end_systole == Some(pose.step_from) {
                    PosePhase::EndSystole
                } else {
                    PosePhase::Between
                },
                ratio: pose.descriptor.ratio(),
                spread: (map.spreads.iter().find(same)).and_then(|spread| spread.mean_distance),
            }
        })
        .collect()
}

fn left_out(state: &State, map: &MedialMap) -> String {
    let lines: Vec<String> = (map.left_out.iter())
        .filter_map(|(subject, reason)| {
            let subject = state.subject(*subject)?;
            Some(format!("{}: {reason}", subject.id))
        })
        .collect();
    lines.join("\n")
}
