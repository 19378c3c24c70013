//! Thickness of the selected subject by every method: strips by pose, differences at the pose on screen.

use std::sync::Arc;

use crate::analysis::thickness_methods::{ThicknessMethod, ThicknessSpread};
use crate::document::state::State;
use crate::engine::{
    ComparedMethod, FrameThickness, MethodResult, PoseThicknessQuery, Showing, ThicknessSettings,
};
use crate::panes::pane_context::PaneContext;
use crate::panes::work_state::WorkState;
use crate::picture::{nice_ceiling, sentence};

use super::values::*;

/// Thickness at a frame, as far as it is known.
pub type PoseThickness = (usize, Showing<FrameThickness>);

/// Asks for the thickness at the poses that the pane shows.
pub fn ask_thickness(cx: &PaneContext<'_>) -> Vec<PoseThickness> {
    let document = &cx.state().document;
    let mut after = [None; 2];
    let poses = shown_poses(cx.state()).into_iter().map(|frame| {
        let query = PoseThicknessQuery {
            subject: document.subject,
            frame,
            settings: ThicknessSettings {
                medial: document.thickening.medial,
                ..ThicknessSettings::default()
            },
            after,
        };
        after = [Some(frame), after[0]];
        (frame, cx.ask(&query))
    });
    poses.collect()
}

/// End-diastole, end-systole, and the pose on screen; while the motion plays only the first two, for the third is gone
/// before it is measured. None while the phases are not known.
fn shown_poses(state: &State) -> Vec<usize> {
    let document = &state.document;
    if document.selected().is_none() || state.measures_of(document.subject).is_none() {
        return Vec::new();
    }
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    let on_screen = (!state.play.playing).then(|| document.frame());
    let mut frames: Vec<usize> = Vec::new();
    for frame in [end_diastole, end_systole, on_screen].into_iter().flatten() {
        if !frames.contains(&frame) {
            frames.push(frame);
        }
    }
    frames
}

/// What is known of the selected subject.
pub fn thickness_view<'a>(state: &'a State, poses: &[PoseThickness]) -> ThicknessPanelView<'a> {
    let Some(subject) = state.document.selected() else {
        return ThicknessPanelView::default();
    };
    let known: Vec<(usize, &Arc<FrameThickness>)> = (poses.iter())
        .filter_map(|(frame, showing)| Some((*frame, showing.ready()?)))
        .collect();
    let on_screen = state.document.frame();
    // While the motion plays, differences are those at end-systole, or at the last pose measured.
    let shown = (known.iter().find(|(frame, _)| *frame == on_screen)).or(known.last());
    let rows: Vec<ThicknessRow> = methods()
        .filter(|_| !known.is_empty())
        .map(|method| row(state, method, &known, shown.map(|(_, found)| &***found)))
        .collect();
    let strips = rows.iter().flat_map(|row| &row.strips);
    let greatest = strips.map(|strip| strip.quantiles[4]).fold(0.0, f64::max);
    ThicknessPanelView {
        subject: Some(&subject.id),
        state: standing(state, poses),
        moment: shown.map_or_else(String::new, |(frame, _)| moment(state, *frame)),
        unit: subject.unit.length_symbol(),
        rows,
        max: 0.5 * nice_ceiling(2.0 * greatest),
    }
}

fn methods() -> impl Iterator<Item = ComparedMethod> {
    let others = ThicknessMethod::ALL.into_iter().map(ComparedMethod::Other);
    std::iter::once(ComparedMethod::Medial).chain(others)
}

fn moment(state: &State, frame: usize) -> String {
    state.moment_name(state.document.subject, frame)
}

/// How the first pose stands that is not measured; what cannot be measured is said once the others are there.
fn standing(state: &State, poses: &[PoseThickness]) -> WorkState {
    let waiting = |showing: &Showing<FrameThickness>| {
        showing.ready().is_none() && showing.failure().is_none()
    };
    let Some((frame, showing)) = poses.iter().find(|(_, showing)| waiting(showing)) else {
        let failure = poses.iter().find_map(|(_, showing)| showing.failure());
        return match failure {
            Some(error) => WorkState::Failed(error.to_string()),
            None if poses.is_empty() => measuring(0.0, "waiting".to_owned()),
            None => WorkState::Ready,
        };
    };
    match showing {
        Showing::Computing { watch, .. } => measuring(watch.fraction(), moment(state, *frame)),
        Showing::Ready(_) | Showing::Interrupted { .. } => WorkState::Stopped,
    }
}

fn measuring(fraction: f32, phase: String) -> WorkState {
    WorkState::Computing {
        fraction,
        phase,
        seconds_left: None,
    }
}

fn row(
    state: &State,
    method: ComparedMethod,
    known: &[(usize, &Arc<FrameThickness>)],
    shown: Option<&FrameThickness>,
) -> ThicknessRow {
    let on_screen = state.document.frame();
    let strips = known.iter().filter_map(|(frame, found)| {
        let spread = answer(found, method)?.thickness.as_ref().ok()?;
        Some(ThicknessStrip {
            moment: moment(state, *frame),
            on_screen: *frame == on_screen,
            quantiles: quantiles(spread),
        })
    });
    let shown = shown.and_then(|found| answer(found, method));
    let agreement = shown.and_then(|answer| answer.agreement);
    let mut reasons = known.iter().filter_map(|(_, found)| {
        let reason = answer(found, method)?.thickness.as_ref().err()?;
        Some(reason.clone())
    });
    ThicknessRow {
        name: sentence(method.name()),
        hint: hint(method),
        strips: strips.collect(),
        difference: agreement.map(|agreement| Difference {
            bias: agreement.bias,
            deviation: agreement.deviation,
            pairs: agreement.pairs,
        }),
        reference: method == ComparedMethod::Medial,
        seconds: shown
            .filter(|shown| shown.thickness.is_ok())
            .map(|shown| shown.seconds),
        reason: reasons.next_back(),
    }
}

fn answer(found: &FrameThickness, method: ComparedMethod) -> Option<&MethodResult> {
    found.results.iter().find(|result| result.method == method)
}

fn quantiles(spread: &ThicknessSpread) -> [f64; 5] {
    [
        spread.low,
        spread.quarter,
        spread.median,
        spread.three_quarters,
        spread.high,
    ]
}

fn hint(method: ComparedMethod) -> &'static str {
    match method {
        ComparedMethod::Medial => {
            "Twice the radius of the sphere inscribed in the wall at each endocardial vertex; spheres at the edge of \
             the medial surface, near the base, are left out"
        }
        ComparedMethod::Other(ThicknessMethod::Nearest) => {
            "Distance from an endocardial vertex to the nearest epicardial point: a lower bound of the other methods"
        }
        ComparedMethod::Other(ThicknessMethod::Centreline) => {
            "Length of chords across the centreline of short-axis slices: too long where a slice cuts the wall \
             obliquely, as near the apex"
        }
        ComparedMethod::Other(ThicknessMethod::Laplace) => {
            "Length of the field line of Laplace's equation from endocardium to epicardium"
        }
        ComparedMethod::Other(ThicknessMethod::VolumeOverArea) => {
            "Volume of a wall element divided by the mean of its endocardial and epicardial area: one value per element"
        }
    }
}
