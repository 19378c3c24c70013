//! The medial map: asked for where it is drawn, its points kept until it or the study changes.

use egui::Ui;

use crate::analysis::medial_map::{MedialMap, MedialPose};
use crate::document::document::cycle_share;
use crate::document::state::State;
use crate::engine::MedialMapQuery;
use crate::panes::cohort::view::cohort_data;
use crate::panes::commands::Command;
use crate::panes::pane_context::PaneContext;
use crate::panes::scatter_map::from_state::{MapPoints, left_out, plane};
use crate::panes::scatter_map::{PosePhase, ScatterPoint, ScatterView, scatter_map_ui};
use crate::panes::work_state::WorkState;

use super::{MEDIAL_MAP, medial_facts, medial_map_note};

/// What the pane asks the store.
pub(super) fn medial_map_query(state: &State) -> MedialMapQuery {
    MedialMapQuery {
        thickening: state.document.thickening,
        method: state.document.map.method,
    }
}

/// Asks for the map and draws it.
pub fn medial_map_ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    let showing = cx.ask_at_rest(&medial_map_query(state));
    let map = showing.latest();
    let (kept, cohort) = (cx.memo().get::<MapPoints<MedialMap>>(), cohort_data(cx));
    let (mut kept, cohort) = (kept.borrow_mut(), cohort.borrow_mut());
    kept.refresh(ui, state, map, (), |map| {
        let missing = map.left_out.iter().map(|(subject, why)| (*subject, why));
        (
            points(map, state),
            left_out(state.document.study(), missing),
        )
    });
    let [note, explanation] = medial_map_note(
        map.and_then(|map| map.embedding.stress),
        map.map_or("", |map| map.frame.words()),
    );
    let work = WorkState::of(Some(&showing));
    let view = ScatterView {
        note,
        explanation,
        ..kept.view(state, &MEDIAL_MAP, work, cohort.rows())
    };
    scatter_map_ui(ui, &view, 0.0, commands);
}

/// One point per step of a path.
pub(super) fn points(map: &MedialMap, state: &State) -> Vec<ScatterPoint> {
    let path = |pose: &MedialPose| (pose.subject, pose.part);
    let poses = map.poses.iter().enumerate();
    poses
        .filter(|(row, _)| *row < map.embedding.len())
        .filter_map(|(row, pose)| {
            let subject = state.subject(pose.subject)?;
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
                share: cycle_share(subject, pose.step_from as f64),
                rr_is_known: subject.timing.rr.is_some(),
                phase: PosePhase::of(pose.step_from, state.phases_of(pose.subject)),
                label: begins_path.then_some(""),
                facts: medial_facts(patch, pose.descriptor.ratio(), distance),
                ..ScatterPoint::default()
            })
        })
        .collect()
}
