//! Patches of the selected heart: the table, from where each is seen, what is not assessed and why.

use crate::analysis::thickening::Patch;
use crate::document::state::State;
use crate::engine::{Showing, SubjectThickening};
use crate::panes::patch::words::standing_note;
use crate::panes::viewport::shown_heart::ShownHeart;
use crate::panes::{PatchLine, PatchPanelView, WallState};
use crate::picture::{
    PatchStanding, WallPart, extent_words, facing_patch, patch_heading, segment_words,
    smallest_words,
};
use crate::render::Camera;
use crate::report::PatchRow;
use crate::study::Subject;

/// A framed patch has this much of the heart around it, as a share of the heart's size.
const MIN_HALF_HEIGHT: f64 = 0.42;

/// Texts of the patch pane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchData {
    state: WallState,
    standing: PatchStanding,
    heading: String,
    note: String,
    rows: Vec<PatchLine>,
    noise: Option<f64>,
    tolerance: Option<f64>,
    well: Option<f64>,
}

impl PatchData {
    /// What is known of the selected heart's wall. `shown` is the heart on screen, for cameras.
    pub fn of(state: &State, shown: Option<&ShownHeart>) -> Self {
        let document = &state.document;
        let known = state.wall_of(document.subject);
        let wall = wall_state(state);
        let (Some((Ok(found), _)), Some(subject)) = (known, document.selected()) else {
            return Self {
                state: wall,
                ..Self::default()
            };
        };
        let thickening = &found.thickening;
        let standing = state.patch_standing(document.subject);
        let selected = match document.part {
            Some(WallPart::Patch(patch)) => Some(patch),
            _ => None,
        };
        let rows = thickening.patches.iter().enumerate();
        Self {
            standing,
            heading: patch_heading(thickening, standing),
            note: [
                extent_words(thickening),
                standing_note(state, thickening),
                sentences_after(&smallest_words(thickening)),
            ]
            .join(""),
            rows: rows
                .map(|(index, patch)| PatchLine {
                    selected: selected == Some(index),
                    camera: shown.and_then(|shown| patch_camera(found, patch, shown)),
                    ..line(found, subject, index, patch)
                })
                .collect(),
            noise: Some(thickening.noise),
            tolerance: Some(thickening.tolerance),
            well: Some(thickening.remote.exp() - 1.0),
            state: wall,
        }
    }

    /// How the wall stands.
    pub fn state(&self) -> &WallState {
        &self.state
    }

    /// What the pane shows.
    pub fn view<'a>(&'a self, state: &'a State) -> PatchPanelView<'a> {
        PatchPanelView {
            subject: state.document.selected().map(|subject| &*subject.id),
            state: &self.state,
            standing: self.standing,
            heading: &self.heading,
            note: &self.note,
            rows: &self.rows,
            settings: state.document.thickening,
            noise: self.noise,
            tolerance: self.tolerance,
            well: self.well,
        }
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

/// How the wall of the selected heart stands.
fn wall_state(state: &State) -> WallState {
    if state.document.selected().is_none() {
        return WallState::Empty;
    }
    let known = state.wall_of(state.document.subject);
    match known {
        Some((Ok(_), true)) => return WallState::Ready,
        Some((Err(why), true)) => return WallState::NotAssessed(why.clone()),
        _ => {}
    }
    let wall = state.answers.wall(state.document.subject);
    match wall.map(|wall| &wall.showing) {
        Some(Showing::Interrupted { .. }) => WallState::Stopped,
        Some(Showing::Computing { watch, .. }) => WallState::Computing {
            fraction: watch.fraction(),
        },
        Some(Showing::Ready(_)) | None => WallState::Computing { fraction: 0.0 },
    }
}

fn line(found: &SubjectThickening, subject: &Subject, index: usize, patch: &Patch) -> PatchLine {
    PatchLine {
        row: PatchRow::new(&subject.id, subject.unit, index, patch),
        segments: if patch.segments.is_empty() {
            without_segments(found)
        } else {
            segment_words(patch)
        },
        ..PatchLine::default()
    }
}

fn without_segments(found: &SubjectThickening) -> String {
    match &found.without_axis {
        Some(why) => format!("segments unknown: {why}"),
        None => "segments unknown: orientation unknown".to_owned(),
    }
}

/// A camera in the heart's axes that looks straight at a patch, base up.
fn patch_camera(found: &SubjectThickening, patch: &Patch, shown: &ShownHeart) -> Option<Camera> {
    let rest = found.beat.frames.get(found.thickening.end_diastole)?;
    let reach = (patch.atoms.iter())
        .filter_map(|&atom| rest.atoms.get(atom as usize))
        .map(|atom| (atom.position - patch.centroid).norm())
        .fold(0.0, f64::max);
    let half_height = (1.25 * reach).max(MIN_HALF_HEIGHT * found.thickening.size);
    let [x, y, z] = patch.centroid.coords.into();
    let camera = Camera {
        target: glam::DVec3::new(x, y, z).as_vec3(),
        world_from_camera: facing_patch(found, patch, &shown.heart.prepared.axes)?,
        half_height: half_height as f32,
        ..Camera::default()
    };
    Some(shown.heart.frame.heart_camera(camera))
}
