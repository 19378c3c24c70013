//! The medial map: from the latest map, kept until it or the study changes.

use std::sync::Arc;

use crate::analysis::medial_map::{MedialMap, MedialPose};
use crate::document::document::phase_of;
use crate::document::state::State;
use crate::engine::Showing;
use crate::panes::{
    MEDIAL_MAP, MapSubject, MedialMapView, PosePhase, ScatterData, ScatterPoint, ScatterView,
    medial_facts, medial_map_note,
};
use crate::study::Study;

use crate::panes::scatter_map::from_state::{
    Details, Shared, details, left_out, map_state, plane, scatter_view,
};

/// Points of the medial map.
#[derive(Debug, Default)]
pub struct MedialMapData {
    data: ScatterData<Shared<MedialMap>, Details>,
    left_out: Vec<String>,
}

impl MedialMapData {
    /// Makes points again where the study, the map or the measures changed, and moves those that
    /// are on their way; whether any still are. Without `motion` they are there at once.
    pub fn refresh(
        &mut self,
        state: &State,
        map: Option<&Arc<MedialMap>>,
        now_s: f64,
        motion: bool,
    ) -> bool {
        let study = state.document.study();
        let opening = state.document.study.opening;
        let sources = (opening, Shared::of(map), details(state));
        let changed = self.data.refresh(sources, now_s, motion, || {
            let points = |map| points(map, study, |subject| state.phases_of(subject));
            map.map_or_else(Vec::new, |map| points(map))
        });
        if changed {
            let missing = map.map(|map| &map.left_out).into_iter().flatten();
            self.left_out = left_out(study, missing.map(|(subject, why)| (*subject, why)));
        }
        self.data.advance(now_s)
    }

    /// What the pane shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        subjects: &'a [MapSubject],
        showing: &Showing<MedialMap>,
    ) -> MedialMapView<'a> {
        let map = showing.latest();
        let [note, explanation] = medial_map_note(
            map.and_then(|map| map.embedding.stress),
            map.map_or("", |map| map.frame.words()),
        );
        let map_state = map_state(state, Some(showing));
        let points = self.data.points();
        MedialMapView {
            map: ScatterView {
                note,
                explanation,
                left_out: &self.left_out,
                ..scatter_view(state, &MEDIAL_MAP, map_state, subjects, points)
            },
            method: state.document.map.method,
        }
    }
}

/// One point per step of a path; `phases` gives the frames of end-diastole and end-systole of a
/// subject.
fn points(
    map: &MedialMap,
    study: &Study,
    phases: impl Fn(usize) -> (Option<usize>, Option<usize>),
) -> Vec<ScatterPoint> {
    let path = |pose: &MedialPose| (pose.subject, pose.part);
    let poses = map.poses.iter().enumerate();
    poses
        .filter(|(row, _)| *row < map.embedding.len())
        .filter_map(|(row, pose)| {
            let subject = study.subjects.get(pose.subject)?;
            let mut spreads = map.spreads.iter();
            let spread = spreads.find(|spread| (spread.subject, spread.part) == path(pose));
            let distance = spread.and_then(|spread| spread.mean_distance);
            let patch = pose.part.patch();
            let before = row.checked_sub(1).and_then(|before| map.poses.get(before));
            let begins_path = before.map(path) != Some(path(pose));
            Some(ScatterPoint {
                subject: pose.subject,
                patch,
                frames: Some([pose.step_from, pose.step_to]),
                start_frame: pose.step_from,
                at: plane(map.embedding.point(row)),
                share: phase_of(subject, pose.step_from as f64),
                phase: PosePhase::of(pose.step_from, phases(pose.subject)),
                label: begins_path.then_some(""),
                facts: medial_facts(patch, pose.descriptor.ratio(), distance),
                ..ScatterPoint::default()
            })
        })
        .collect()
}
