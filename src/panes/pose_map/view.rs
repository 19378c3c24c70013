//! Points of the pose map from the latest map, kept until it or the study changes; the spatiotemporal plot has the same.

use egui::Ui;

use crate::analysis::embedding::PoseMap;
use crate::analysis::pose_distances::PoseId;
use crate::document::document::cycle_share;
use crate::document::state::State;
use crate::panes::cohort::rows::CohortRow;
use crate::panes::pane_context::{Kept, PaneContext};
use crate::panes::scatter_map::from_state::{MapPoints, left_out, plane};
use crate::panes::scatter_map::{EstimateView, PosePhase, ScatterPoint, ScatterView};
use crate::panes::viewport::overlay_view::{estimated_words, source_words};
use crate::panes::work_state::WorkState;
use crate::picture::sentence;

use super::{POSE_MAP, pose_map_note};

/// The points of the pose map, which other panes show, too; asks for another picture while they walk.
pub fn pose_map(ui: &Ui, cx: &PaneContext<'_>) -> Kept<MapPoints<PoseMap>> {
    let (state, kept) = (cx.state(), cx.memo().get::<MapPoints<PoseMap>>());
    let study = state.document.study();
    kept.borrow_mut()
        .refresh(ui, state, state.map(), (), |map| {
            let missing = map.distances.left_out.iter();
            let missing = missing.map(|left| (left.subject, &left.reason));
            (points(map, state), left_out(study, missing))
        });
    kept
}

/// The pose map as the document shows it.
pub fn view<'a>(
    points: &'a MapPoints<PoseMap>,
    state: &State,
    subjects: &'a [CohortRow],
) -> ScatterView<'a> {
    let embedding = state.map().map(|map| &map.embedding);
    let [note, explanation] = pose_map_note(
        embedding.and_then(|embedding| embedding.stress),
        embedding.and_then(|embedding| embedding.neighbours),
    );
    let work = WorkState::of(state.answers.map.as_ref());
    ScatterView {
        note,
        explanation,
        ground: points.turn(),
        estimate: estimate(points.points(), state),
        ..points.view(state, &POSE_MAP, work, subjects)
    }
}

/// What is estimated at the place that is looked at.
fn estimate(points: &[ScatterPoint], state: &State) -> Option<EstimateView> {
    let at = state.estimate_at?;
    let lines = match (state.estimate(), state.without_estimate()) {
        (Some(pose), _) => {
            let title = sentence(&estimated_words(pose));
            std::iter::once(title)
                .chain(source_words(state, pose))
                .collect()
        }
        (None, Some(why)) => vec![sentence(&why.to_string())],
        (None, None) => Vec::new(),
    };
    let sources = state.estimate().map_or(&[][..], |pose| &pose.sources);
    let source = |(pose, weight): &(PoseId, f64)| {
        let key = (pose.subject, None, Some(pose.frame));
        let place = points.iter().position(|point| point.key() == key)?;
        Some((place, *weight))
    };
    Some(EstimateView {
        at,
        sources: sources.iter().filter_map(source).collect(),
        lines,
    })
}

/// One point per pose.
pub(super) fn points(map: &PoseMap, state: &State) -> Vec<ScatterPoint> {
    let poses = map.distances.poses.iter().enumerate();
    poses
        .filter(|(row, _)| *row < map.embedding.len())
        .filter_map(|(row, pose)| {
            let subject = state.subject(pose.subject)?;
            let phase = PosePhase::of(pose.frame, state.phases_of(pose.subject));
            Some(ScatterPoint {
                subject: pose.subject,
                frames: Some([pose.frame, pose.frame]),
                start_frame: pose.frame,
                at: plane(map.embedding.point(row)),
                share: cycle_share(subject, pose.frame as f64),
                rr_is_known: subject.timing.rr.is_some(),
                phase,
                label: match phase {
                    PosePhase::EndDiastole => Some("ED"),
                    PosePhase::EndSystole => Some("ES"),
                    PosePhase::Between | PosePhase::WholeMotion => None,
                },
                ..ScatterPoint::default()
            })
        })
        .collect()
}
