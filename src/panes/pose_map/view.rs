//! The pose map and the spatiotemporal plot: from the latest map, kept until it or the study
//! changes.

use crate::analysis::measures::SubjectMeasures;
use crate::document::document::phase_of;
use crate::document::state::State;
use crate::engine::{PoseMap, Showing};
use crate::panes::{
    MapSubject, POSE_MAP, PoseMapView, PosePhase, SPACE_TIME, ScatterData, ScatterPoint,
    ScatterView, SpaceTimeView, pose_map_note,
};
use crate::study::Study;

use crate::panes::scatter_map::from_state::{
    Details, Shared, details, left_out, map_state, plane, scatter_view,
};

/// Points and subjects of the pose map.
#[derive(Debug, Default)]
pub struct MapData {
    data: ScatterData<Shared<PoseMap>, Details>,
    subjects: Vec<MapSubject>,
    left_out: Vec<String>,
}

impl MapData {
    /// Makes points again where the study, the map or the measures changed, and moves those that
    /// are on their way; whether any still are. Without `motion` they are there at once.
    pub fn refresh(&mut self, state: &State, now_s: f64, motion: bool) -> bool {
        let (study, map) = (state.document.study(), state.map());
        let opening = state.document.study.opening;
        let sources = (opening, Shared::of(map), details(state));
        let changed = self.data.refresh(sources, now_s, motion, || {
            let points = |map| points(map, study, |subject| state.phases_of(subject));
            map.map_or_else(Vec::new, |map| points(map))
        });
        if changed {
            let measures = state.measures().map_or(&[][..], |measures| measures);
            self.subjects = map_subjects(study, measures);
            let missing = map.map(|map| &map.distances.left_out);
            let missing = missing.into_iter().flatten();
            self.left_out = left_out(study, missing.map(|left| (left.subject, &left.reason)));
        }
        self.data.advance(now_s)
    }

    /// All subjects of the study, as maps show them.
    pub fn subjects(&self) -> &[MapSubject] {
        &self.subjects
    }

    /// Who is not on the map, and why.
    pub fn left_out(&self) -> &[String] {
        &self.left_out
    }

    /// What the pane of poses shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        showing: Option<&Showing<PoseMap>>,
    ) -> PoseMapView<'a> {
        let embedding = state.map().map(|map| &map.embedding);
        let [note, explanation] = pose_map_note(
            embedding.and_then(|embedding| embedding.stress),
            embedding.and_then(|embedding| embedding.neighbours),
        );
        let map_state = map_state(state, showing);
        let points = self.data.points();
        PoseMapView {
            map: ScatterView {
                note,
                explanation,
                left_out: &self.left_out,
                ..scatter_view(state, &POSE_MAP, map_state, &self.subjects, points)
            },
            params: state.document.map,
        }
    }

    /// What the spatiotemporal plot shows.
    pub fn space_time<'a>(
        &'a self,
        state: &State,
        showing: Option<&Showing<PoseMap>>,
    ) -> SpaceTimeView<'a> {
        let document = &state.document;
        let map_state = map_state(state, showing);
        let points = self.data.points();
        SpaceTimeView {
            map: scatter_view(state, &SPACE_TIME, map_state, &self.subjects, points),
            share: document
                .selected()
                .map_or(0.0, |subject| phase_of(subject, document.position)),
        }
    }
}

fn map_subjects(study: &Study, measures: &[SubjectMeasures]) -> Vec<MapSubject> {
    let subjects = study.subjects.iter().enumerate();
    subjects
        .map(|(index, subject)| MapSubject {
            id: subject.id.clone(),
            label: subject.label.clone(),
            role: study.role(subject),
            ejection_fraction: measures.get(index).and_then(|measures| measures.ef),
        })
        .collect()
}

/// One point per pose; `phases` gives the frames of end-diastole and end-systole of a subject.
fn points(
    map: &PoseMap,
    study: &Study,
    phases: impl Fn(usize) -> (Option<usize>, Option<usize>),
) -> Vec<ScatterPoint> {
    let poses = map.distances.poses.iter().enumerate();
    poses
        .filter(|(row, _)| *row < map.embedding.len())
        .filter_map(|(row, pose)| {
            let subject = study.subjects.get(pose.subject)?;
            let phase = PosePhase::of(pose.frame, phases(pose.subject));
            Some(ScatterPoint {
                subject: pose.subject,
                frames: Some([pose.frame, pose.frame]),
                start_frame: pose.frame,
                at: plane(map.embedding.point(row)),
                share: phase_of(subject, pose.frame as f64),
                phase,
                label: match phase {
                    PosePhase::EndDiastole => Some("ED"),
                    PosePhase::EndSystole => Some("ES"),
                    PosePhase::Between | PosePhase::WholeBeat => None,
                },
                ..ScatterPoint::default()
            })
        })
        .collect()
}
