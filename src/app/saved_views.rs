//! Views that picture files contain: read off the window's thread, restored as one step of undo.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::{Quat, Vec3};

use crate::document::ViewMode;
use crate::engine::{Engine, Job};
use crate::io::read_head;
use crate::panes::{Command, ViewCommand};
use crate::picture::figure::SavedView;
use crate::picture::page::{PageFormat, VIEW_KEY, png_text};
use crate::render::Shading;

use super::apply::{Moment, change, is_usable};
use super::errors::push_card;
use crate::document::state::State;
use crate::document::viewpoint::{Direction, Viewpoint};
use crate::document::visibility::Visibility;

/// Settings stand before the pixels: further into a picture there is nothing to look for.
const MAX_HEAD_BYTES: u64 = 1 << 20;

/// What a card says where a picture gives no view.
const FAILED: &str = "The view of the picture could not be restored";

/// Reads picture files, one at a time; a later one takes the place of an earlier.
#[derive(Default)]
pub struct SavedViews {
    reading: Option<Job<SavedView, String>>,
}

/// Whether paths are one picture, from which a view can be restored, and no study.
pub fn is_picture(paths: &[PathBuf]) -> bool {
    matches!(paths, [only] if PageFormat::of(only) == Some(PageFormat::Png))
}

impl SavedViews {
    /// Begins to read a picture.
    pub fn read(&mut self, engine: &Engine, path: PathBuf) {
        let job = engine.spawn_aside(move |_| {
            saved_view(&path).map_err(|why| {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                format!("{name}: {why}")
            })
        });
        self.reading = Some(job);
    }

    /// The view that was read, as a command; or why there is none.
    pub fn poll(&mut self) -> Option<Result<Command, String>> {
        let outcome = self.reading.as_mut()?.poll()?;
        self.reading = None;
        Some(match outcome {
            Ok(view) => Ok(Command::View(ViewCommand::RestoreView(Box::new(view)))),
            Err(error) => Err(error.to_string()),
        })
    }
}

fn saved_view(path: &Path) -> Result<SavedView, String> {
    let head = read_head(path, MAX_HEAD_BYTES).map_err(|error| error.reason)?;
    let text = png_text(Cursor::new(head), VIEW_KEY).map_err(|error| error.to_string())?;
    let text = text.ok_or("this picture contains no view of Cardiomorph")?;
    SavedView::read(&text).map_err(|error| error.to_string())
}

/// Adds a card with the reason why no view is restored.
pub fn refuse(state: &mut State, reason: String) {
    push_card(&mut state.errors, FAILED, reason);
}

/// Restores the view of a picture, if its subject is open.
pub fn apply(state: &mut State, view: &SavedView, moment: &Moment) {
    let study = Arc::clone(state.document.study());
    let subject = match view.find_in(&study) {
        Ok(subject) => subject,
        Err(error) => return refuse(state, error.to_string()),
    };
    let settings = view.thickening;
    if !is_usable(&settings) {
        let reason = "its patch thresholds are out of range".to_owned();
        return refuse(state, reason);
    }
    state.play.playing = false;
    change(state, moment, None, |d| {
        d.select_subject_at(subject, view.position);
        d.view_mode = ViewMode::Single;
        let camera = view.camera;
        d.viewpoint = Viewpoint {
            direction: Direction::Turned(Quat::from_array(camera.rotation).normalize()),
            offset: Vec3::from_array(camera.offset),
            half_height: Some(camera.half_height),
        };
        d.quantity = view.quantity;
        d.set_limits_of(crate::picture::Quantity::ThicknessRatio, view.ratio_limits);
        d.set_limits_of(view.quantity, view.limits.or(d.limits_of(view.quantity)));
        let shows = view.shows;
        d.visibility = Visibility {
            endocardium: shows.inner,
            epicardium: shows.outer,
            wireframe: shows.wireframe,
            vertices: shows.vertices,
            atoms: shows.atoms,
            spokes: shows.spokes,
            patches: shows.patches,
            direction: shows.direction,
            shading: if shows.flat {
                Shading::Flat
            } else {
                Shading::Smooth
            },
        };
        d.part = view.part();
        d.bulls_eye = view.bulls_eye;
        d.thickening = settings;
    });
    state.message = format!("View of {} restored", view.subject.id);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::picture::figure::SavedCamera;
    use crate::picture::{BullsEyeQuantity, Quantity, SceneSettings, WallPart};
    use crate::study::Revision;

    fn moment() -> Moment {
        Moment {
            now_s: 0.0,
            pointer_held: false,
            fresh_revision: Revision(9),
        }
    }

    fn state() -> State {
        state_of(vec![
            subject_with_frames("a", 3),
            subject_with_frames("b", 4),
        ])
    }

    fn view(state: &State) -> SavedView {
        let camera = SavedCamera {
            rotation: [0.0, 0.6, 0.0, 0.8],
            offset: [1.0, 2.0, 3.0],
            half_height: 40.0,
        };
        let mut scene = SceneSettings {
            quantity: Quantity::AreaRatio,
            typed_limits: Some([0.8, 1.25]),
            wireframe: true,
            ..SceneSettings::default()
        };
        scene.medial.atoms = true;
        scene.medial.part = Some(WallPart::Patch(1));
        let mut thickening = state.document.thickening;
        thickening.patches.extent = 0.5;
        let subject = &state.document.study().subjects[1];
        let quantity = BullsEyeQuantity::Ratio;
        SavedView::of("study", subject, 2.5, camera, &scene, quantity, thickening)
    }

    #[test]
    fn all_of_a_view_comes_back_in_one_step_of_undo() {
        let mut state = state();
        let view = view(&state);
        let before = state.document.clone();
        apply(&mut state, &view, &moment());
        let document = &state.document;
        assert_eq!(document.subject, 1);
        assert_eq!(document.position, 2.5);
        assert_eq!(document.quantity, Quantity::AreaRatio);
        assert_eq!(document.limits(), Some([0.8, 1.25]));
        assert_eq!(document.part, Some(WallPart::Patch(1)));
        assert_eq!(document.bulls_eye, BullsEyeQuantity::Ratio);
        assert_eq!(document.thickening.patches.extent, 0.5);
        assert!(document.visibility.atoms && document.visibility.wireframe);
        assert_eq!(document.viewpoint.half_height, Some(40.0));
        assert!(state.errors.is_empty());
        let undone = state.history.undo(&state.document).unwrap();
        assert_eq!(undone, before);
    }

    #[test]
    fn a_position_at_the_end_of_the_cycle_stays_within_the_frames() {
        let mut state = state();
        let mut view = view(&state);
        view.position = 4.0;
        apply(&mut state, &view, &moment());
        assert!(state.document.position < 4.0, "{}", state.document.position);
    }

    #[test]
    fn a_subject_that_is_not_open_changes_nothing_and_is_named() {
        let mut state = state();
        let mut view = view(&state);
        view.subject.frames = 7;
        let before = state.document.clone();
        apply(&mut state, &view, &moment());
        assert_eq!(state.document, before);
        assert_eq!(state.errors[0].title, FAILED);
        assert!(state.errors[0].message.contains("shows b of the study"));
    }

    #[test]
    fn thresholds_out_of_range_are_refused() {
        let mut state = state();
        let mut view = view(&state);
        view.thickening.patches.core = -3.0;
        let before = state.document.clone();
        apply(&mut state, &view, &moment());
        assert_eq!(state.document, before);
        assert_eq!(state.errors.len(), 1);
    }

    #[test]
    fn only_a_single_png_is_a_picture() {
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        assert!(is_picture(&paths(&["a/P07.PNG"])));
        assert!(!is_picture(&paths(&["a/P07.png", "b"])));
        assert!(!is_picture(&paths(&["heart.obj"])));
        assert!(!is_picture(&[]));
    }
}
