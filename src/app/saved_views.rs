//! Views that picture files contain: read off the window's thread, restored as one step of undo.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::{Quat, Vec3};

use crate::document::ViewMode;
use crate::engine::{Engine, Job};
use crate::io::read_head;
use crate::panes::{Command, FileCommand, ViewCommand};
use crate::picture::figure::SavedView;
use crate::picture::page::{PageFormat, VIEW_KEY};
use crate::render::Shading;
use crate::study::built_in::BUILT_IN_NAME;

use super::apply::{Moment, change, is_usable};
use super::errors::push_card;
use super::study_by_name::study_named;
use crate::document::state::State;
use crate::document::viewpoint::{Direction, Viewpoint};
use crate::document::visibility::Visibility;

/// Settings stand before the pixels: further into a picture or drawing there is nothing to look for.
const MAX_HEAD_BYTES: u64 = 1 << 20;
/// Settings stand at the end of a page for print, which is no larger than this.
const MAX_PAGE_BYTES: u64 = 256 << 20;

/// What a card says where a picture gives no view.
const FAILED: &str = "The view of the picture could not be restored";

/// A view that waits until its study is open.
struct Waiting {
    view: Box<SavedView>,
    /// What was on screen when it began to wait, or when a card last said that its subject is not there.
    opening: u64,
    /// Whether its study was looked for, or was named with the picture.
    sought: bool,
}

/// Reads picture files, one at a time; a later one takes the place of an earlier.
#[derive(Default)]
pub struct SavedViews {
    picture: PathBuf,
    /// Whether the study of the picture was named with it.
    named: bool,
    reading: Option<Job<SavedView, String>>,
    waiting: Option<Waiting>,
    /// Looks for the study of the view that waits.
    seeking: Option<Job<Option<PathBuf>, String>>,
}

/// The one picture among paths, from which a view can be restored, and the other paths. Of several pictures none is taken.
pub fn split_picture(mut paths: Vec<PathBuf>) -> (Option<PathBuf>, Vec<PathBuf>) {
    let is_picture = |path: &PathBuf| PageFormat::of(path).is_some();
    match paths.iter().filter(|path| is_picture(path)).count() {
        1 => {
            let picture = paths.iter().position(is_picture);
            (picture.map(|index| paths.remove(index)), paths)
        }
        _ => (None, paths),
    }
}

impl SavedViews {
    /// Begins to read a picture; `named` says whether its study was named with it, and so is being opened.
    pub fn read(&mut self, engine: &Engine, picture: PathBuf, named: bool) {
        let path = picture.clone();
        let job = engine.spawn_aside(move |_| {
            saved_view(&path).map_err(|why| {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                format!("{name}: {why}")
            })
        });
        *self = Self {
            picture,
            named,
            reading: Some(job),
            ..Self::default()
        };
    }

    /// What follows from what was read, found and opened: a view to restore, or a study to open for it.
    pub fn poll(&mut self, state: &mut State, engine: &Engine) -> Option<Command> {
        if let Some(outcome) = self.reading.as_mut().and_then(Job::poll) {
            self.reading = None;
            match outcome {
                Ok(view) => {
                    self.waiting = Some(Waiting {
                        view: Box::new(view),
                        opening: state.document.study.opening,
                        sought: self.named,
                    });
                }
                Err(error) => refuse(state, error.to_string()),
            }
        }
        let waiting = self.waiting.as_mut()?;
        let study = Arc::clone(state.document.study());
        let found = waiting.view.find_in(&study);
        let is_new = state.document.study.opening != waiting.opening;
        let is_named = study.name == waiting.view.study;
        let wanted = &waiting.view.subject.id;
        if (is_new || is_named) && study.unread.iter().any(|unread| unread.id == *wanted) {
            let asked = state.awaited.as_ref() == Some(wanted);
            return (!asked).then(|| FileCommand::ReadFirst(wanted.clone()).into());
        }
        let outcome = self.seeking.as_mut().and_then(Job::poll);
        match (found, outcome) {
            (Ok(_), None) if is_named || is_new => {}
            (_, Some(Ok(None))) if waiting.view.study == BUILT_IN_NAME && !is_named => {
                self.seeking = None;
                return Some(FileCommand::OpenBuiltIn.into());
            }
            (Ok(_), Some(Ok(None) | Err(_))) => {}
            (_, Some(Ok(Some(path)))) => {
                self.seeking = None;
                state.message = format!("Opening “{}” for its view", waiting.view.study);
                return Some(FileCommand::Open(vec![path]).into());
            }
            (Err(error), Some(_)) => {
                self.seeking = None;
                refuse(state, error.to_string());
                return None;
            }
            (Err(error), None) if is_new => {
                waiting.opening = state.document.study.opening;
                refuse(state, error.to_string());
                return None;
            }
            (_, None) if waiting.sought || engine.opening() => return None,
            (_, None) => {
                waiting.sought = true;
                let (name, picture) = (waiting.view.study.clone(), self.picture.clone());
                let recent = state.recent.clone();
                let seek = move |_: &_| Ok(study_named(&name, &recent, &picture));
                self.seeking = Some(engine.spawn_aside(seek));
                return None;
            }
        }
        let view = self.waiting.take()?.view;
        self.seeking = None;
        Some(Command::View(ViewCommand::RestoreView(view)))
    }
}

fn saved_view(path: &Path) -> Result<SavedView, String> {
    let format = PageFormat::of(path).unwrap_or_default();
    let most = match format {
        PageFormat::Png | PageFormat::Svg => MAX_HEAD_BYTES,
        PageFormat::Pdf => MAX_PAGE_BYTES,
    };
    let bytes = read_head(path, most).map_err(|error| error.reason)?;
    let text = format.setting_in(&bytes, VIEW_KEY)?;
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
    if view.study != study.name {
        let message = format!(
            "the picture was made from the study “{}”, and “{}” is open, which has a subject {} with as many frames and \
             vertices: check that it is the same",
            view.study, study.name, view.subject.id
        );
        push_card(
            &mut state.errors,
            "View of a study with another name",
            message,
        );
    }
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
        thickening.patches.extent_threshold = 0.5;
        let subject = &state.document.study().subjects[1];
        let quantity = BullsEyeQuantity::ThicknessRatio;
        let name = &state.document.study().name;
        SavedView::of(name, subject, 2.5, camera, &scene, quantity, thickening)
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
        assert_eq!(document.bulls_eye, BullsEyeQuantity::ThicknessRatio);
        assert_eq!(document.thickening.patches.extent_threshold, 0.5);
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
        view.thickening.patches.core_threshold = -3.0;
        let before = state.document.clone();
        apply(&mut state, &view, &moment());
        assert_eq!(state.document, before);
        assert_eq!(state.errors.len(), 1);
    }

    #[test]
    fn a_view_of_a_study_with_another_name_is_restored_with_a_warning() {
        let mut state = state();
        let mut view = view(&state);
        view.study = "Ward 3".to_owned();
        apply(&mut state, &view, &moment());
        assert_eq!(state.document.subject, 1);
        assert_eq!(state.errors.len(), 1);
        assert!(state.errors[0].message.contains("“Ward 3”"));
    }

    #[test]
    fn the_one_picture_among_paths_is_told_from_its_study() {
        let split = |names: &[&str]| {
            let (picture, rest) = split_picture(names.iter().map(PathBuf::from).collect());
            (picture, rest.len())
        };
        let png = || Some(PathBuf::from("a/P07.PNG"));
        assert_eq!(split(&["a/P07.PNG"]), (png(), 0));
        assert_eq!(split(&["b", "a/P07.PNG", "c.toml"]), (png(), 2));
        assert_eq!(split(&["P07.pdf"]).1, 0);
        assert_eq!(split(&["a.png", "b.svg"]), (None, 2));
        assert_eq!(split(&["heart.obj"]), (None, 1));
        assert_eq!(split(&[]), (None, 0));
    }
}
