//! File dialogs of the operating system, asked off the window's thread; where it shows none, the window asks itself.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::document::state::State;
use crate::engine::{Engine, Job};
use crate::io::openable_extensions;
use crate::panes::Command;

use super::path_question::{AskPaths, PathQuestion, Then};
use super::typed_paths::TypedPaths;

/// Extensions of files that can be opened: studies, masks, and pictures that hold a view.
fn readable() -> Vec<&'static str> {
    let mut extensions = openable_extensions();
    extensions.extend(["nii", "gz", "nrrd", "mha", "mhd", "png", "svg", "pdf"]);
    extensions
}

/// An empty answer that comes sooner was not given by a person: no dialog could be shown. A person who did cancel so
/// quickly is asked for the path by the window, and cancels once more.
const MIN_ANSWER_TIME: Duration = Duration::from_millis(700);

/// The system shows no file dialog: it has neither zenity nor a desktop portal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the system shows no file dialog")]
pub struct NoDialog;

type PathJob = Job<Option<Vec<PathBuf>>, NoDialog>;

/// The dialog that is open, if one is.
pub struct Dialogs {
    open: Option<(PathJob, PathQuestion, Then)>,
    /// Where the system shows no dialog.
    pub typed: TypedPaths,
    /// Whether something was asked while a dialog was open.
    refused: bool,
    ask_paths: AskPaths,
}

impl Dialogs {
    /// Asks through `ask_paths`.
    pub fn new(ask_paths: AskPaths) -> Self {
        Self {
            open: None,
            typed: TypedPaths::default(),
            refused: false,
            ask_paths,
        }
    }

    /// Asks, unless a dialog is open already, which the status bar then says.
    pub fn ask(&mut self, engine: &Engine, question: PathQuestion, then: Then) {
        if self.open.is_some() || self.typed.is_open() {
            self.refused = true;
            return;
        }
        let (ask_paths, asked) = (Arc::clone(&self.ask_paths), question.clone());
        let job = engine.spawn_aside(move |_| {
            let begin = Instant::now();
            let paths = ask_paths(&asked);
            if paths.is_none() && begin.elapsed() < MIN_ANSWER_TIME {
                return Err(NoDialog);
            }
            Ok(paths)
        });
        self.open = Some((job, question, then));
    }

    /// Follows what was answered, once.
    pub fn poll(&mut self, state: &mut State, engine: &mut Engine) -> Option<Command> {
        if std::mem::take(&mut self.refused) {
            state.message = "Another file dialog is open: answer it first".to_owned();
        }
        if let Some((paths, then)) = self.typed.poll(state) {
            return then(state, engine, paths);
        }
        let outcome = self.open.as_mut()?.0.poll()?;
        let (_, question, then) = self.open.take()?;
        match outcome {
            Ok(paths) => {
                let Some(paths) = paths.filter(|paths| !paths.is_empty()) else {
                    state.message = "Cancelled: no file was chosen".to_owned();
                    return None;
                };
                then(state, engine, paths)
            }
            Err(_) => {
                self.typed.ask(state, question, then);
                None
            }
        }
    }
}

/// Whether the system can show a dialog at all: a desktop portal is reached by the bus of the session, zenity is a program.
fn can_show(variable: impl Fn(&str) -> Option<OsString>, is_there: impl Fn(&Path) -> bool) -> bool {
    if cfg!(not(all(unix, not(target_os = "macos"))))
        || variable("DBUS_SESSION_BUS_ADDRESS").is_some()
    {
        return true;
    }
    let bus = variable("XDG_RUNTIME_DIR").map(|folder| Path::new(&folder).join("bus"));
    let programs = variable("PATH").unwrap_or_default();
    bus.is_some_and(|bus| is_there(&bus))
        || std::env::split_paths(&programs).any(|folder| is_there(&folder.join("zenity")))
}

/// The dialogs of the operating system; `None` at once where it has none.
pub fn system_dialogs() -> AskPaths {
    Arc::new(|question| {
        if !can_show(|name| std::env::var_os(name), Path::exists) {
            return None;
        }
        let dialog = rfd::FileDialog::new().set_title(question.title());
        let one = |path: Option<PathBuf>| path.map(|path| vec![path]);
        let rules = |dialog: rfd::FileDialog| dialog.add_filter("Classifier", &["json"]);
        match question {
            PathQuestion::OpenFiles => dialog
                .add_filter("Meshes and studies", &readable())
                .add_filter("All files", &["*"])
                .pick_files(),
            PathQuestion::OpenFolders => dialog.pick_folders(),
            PathQuestion::OpenClassifier => one(rules(dialog).pick_file()),
            PathQuestion::SaveClassifier => {
                one(rules(dialog.set_file_name(question.suggested())).save_file())
            }
            PathQuestion::SaveFigure { suggested, .. } => one(dialog
                .set_file_name(suggested)
                .add_filter("PNG picture", &["png"])
                .add_filter("SVG drawing", &["svg"])
                .add_filter("PDF page", &["pdf"])
                .save_file()),
            PathQuestion::SaveStudy | PathQuestion::SaveTables => one(dialog.pick_folder()),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_bus_and_without_zenity_there_is_no_dialog() {
        let shown = |variables: &[(&str, &str)], there: &str| {
            let variable = |name: &str| {
                let found = variables.iter().find(|(known, _)| *known == name);
                found.map(|(_, value)| OsString::from(value))
            };
            can_show(variable, |path| path == Path::new(there))
        };
        if cfg!(all(unix, not(target_os = "macos"))) {
            assert!(!shown(&[], ""));
            assert!(!shown(
                &[("XDG_RUNTIME_DIR", "/run/1"), ("PATH", "/a:/b")],
                ""
            ));
        }
        assert!(shown(&[("DBUS_SESSION_BUS_ADDRESS", "unix:path=/x")], ""));
        assert!(shown(&[("XDG_RUNTIME_DIR", "/run/1")], "/run/1/bus"));
        assert!(shown(&[("PATH", "/a:/b")], "/b/zenity"));
    }
}
