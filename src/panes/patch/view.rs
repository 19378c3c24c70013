//! Patches of the selected subject: the table, from where each is seen, what is not assessed and why.

use crate::analysis::thickening::Patch;
use crate::analysis::verdicts::SubjectThickening;
use crate::document::state::State;
use crate::engine::Showing;
use crate::panes::patch::words::standing_note;
use crate::panes::viewport::shown_subject::ShownSubject;
use crate::panes::work_state::WorkState;
use crate::picture::{
    facing_patch, patch_heading, segment_words, smallest_words, wall_thickening_words,
};
use crate::render::Camera;
use crate::report::PatchRow;

use super::{PatchLine, PatchPanelView};

/// A framed patch has this much of the heart around it, as a share of the heart's size.
const MIN_HALF_HEIGHT: f64 = 0.42;

/// What is known of the selected subject's wall. `shown` is the subject on screen, for cameras.
pub fn patch_view<'a>(state: &'a State, shown: Option<&ShownSubject>) -> PatchPanelView<'a> {
    let document = &state.document;
    let view = PatchPanelView {
        subject: document.selected().map(|subject| &*subject.id),
        state: wall_state(state),
        settings: document.thickening,
        ..PatchPanelView::default()
    };
    let known = state.wall_of(document.subject);
    let (Some((Ok(found), _)), Some(subject)) = (known, document.selected()) else {
        return view;
    };
    let thickening = &found.thickening;
    let standing = state.patch_standing(document.subject);
    let rows = thickening.patches.iter().enumerate();
    let rows = rows.map(|(index, patch)| PatchLine {
        row: PatchRow::new(&subject.id, subject.unit, index, patch),
        segments: match patch.segments.as_slice() {
            [] => without_segments(found),
            _ => segment_words(patch),
        },
        selected: document.selected_patch() == Some(index),
        camera: shown.and_then(|shown| patch_camera(found, patch, shown)),
    });
    PatchPanelView {
        standing,
        heading: patch_heading(thickening, standing),
        note: [
            wall_thickening_words(thickening),
            standing_note(state, thickening),
            sentences_after(&smallest_words(thickening)),
        ]
        .join(""),
        rows: rows.collect(),
        noise: Some(thickening.noise),
        tolerance: Some(thickening.tolerance),
        remote: Some(thickening.remote.exp() - 1.0),
        ..view
    }
}

/// Words after a sentence that ends without a stop; nothing for no words.
fn sentences_after(words: &str) -> String {
    if words.is_empty() {
        String::new()
    } else {
        format!(". {words}")
    }
}

/// How the wall of the selected subject stands.
pub fn wall_state(state: &State) -> WorkState {
    let subject = state.document.subject;
    match state.wall_of(subject) {
        _ if state.document.selected().is_none() => WorkState::Empty,
        Some((Ok(_), true)) => WorkState::Ready,
        Some((Err(why), true)) => WorkState::Unanswerable(why.clone()),
        // Only a failure has a reason, and it is said above: the work itself was stopped.
        _ => match state.answers.wall(subject).map(|wall| &wall.showing) {
            Some(Showing::Interrupted { .. }) => WorkState::Stopped,
            Some(computing @ Showing::Computing { .. }) => WorkState::of(Some(computing)),
            Some(Showing::Ready(_)) | None => WorkState::computing(0.0),
        },
    }
}

fn without_segments(found: &SubjectThickening) -> String {
    match &found.without_axis {
        Some(why) => format!("segments unknown: {why}"),
        None => "segments unknown: orientation unknown".to_owned(),
    }
}

/// A camera in the subject's axes that looks straight at a patch, base up.
fn patch_camera(found: &SubjectThickening, patch: &Patch, shown: &ShownSubject) -> Option<Camera> {
    let rest = found.beat.frames.get(found.thickening.end_diastole)?;
    let reach = (patch.atoms.iter())
        .filter_map(|&atom| rest.atoms.get(atom as usize))
        .map(|atom| (atom.position - patch.centroid).norm())
        .fold(0.0, f64::max);
    let half_height = (1.25 * reach).max(MIN_HALF_HEIGHT * found.thickening.size);
    let [x, y, z] = patch.centroid.coords.into();
    let camera = Camera {
        target: glam::DVec3::new(x, y, z).as_vec3(),
        world_from_camera: facing_patch(found, patch, &shown.placed.prepared.axes)?,
        half_height: half_height as f32,
        ..Camera::default()
    };
    Some(shown.placed.frame.heart_camera(camera))
}
