//! File dialogs of the operating system, asked off the window's thread.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::document::state::State;
use crate::engine::{Engine, Job};
use crate::io::openable_extensions;
use crate::panes::Command;

use super::errors::push_card;

/// Extensions of files that can be opened: studies, and pictures that hold a view.
fn readable() -> Vec<&'static str> {
    let mut extensions = openable_extensions();
    extensions.push("png");
    extensions
}

/// An empty answer that comes sooner was not given by a person: no dialog could be shown.
const MIN_ANSWER_TIME: Duration = Duration::from_millis(150);

/// What a dialog asks the person at the screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PathQuestion {
    /// Files to open.
    OpenFiles,
    /// Folders to open.
    OpenFolders,
    /// A new file for a figure.
    SaveFigure {
        /// What the dialog is called.
        title: &'static str,
        /// The name that it proposes.
        suggested: String,
    },
    /// A folder for tables.
    SaveTables,
    /// An empty folder for a study.
    SaveStudy,
}

/// Answers questions about paths: the dialogs of the operating system, or a test. `None` if nothing was chosen.
pub type AskPaths = Arc<dyn Fn(&PathQuestion) -> Option<Vec<PathBuf>> + Send + Sync>;

/// Why no answer came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the system shows no file dialog; install zenity or a desktop portal, or drop files and \
     folders onto the window"
)]
pub struct NoDialog;

/// What is done with the paths that were chosen; files to open are a command. What a file will hold is fixed before its
/// place is asked for: while a dialog is open, the window goes on, and another subject may be selected.
pub type Then = Box<dyn FnOnce(&mut State, &mut Engine, Vec<PathBuf>) -> Option<Command>>;

type PathJob = Job<Option<Vec<PathBuf>>, NoDialog>;

/// The dialog that is open, if one is.
pub struct Dialogs {
    open: Option<(PathJob, Then)>,
    ask_paths: AskPaths,
}

impl Dialogs {
    /// Asks through `ask_paths`.
    pub fn new(ask_paths: AskPaths) -> Self {
        Self {
            open: None,
            ask_paths,
        }
    }

    /// Asks, unless a dialog is open already.
    pub fn ask(&mut self, engine: &Engine, question: PathQuestion, then: Then) {
        if self.open.is_some() {
            return;
        }
        let ask_paths = Arc::clone(&self.ask_paths);
        let job = engine.spawn_aside(move |_| {
            let asked = Instant::now();
            let paths = ask_paths(&question);
            if paths.is_none() && asked.elapsed() < MIN_ANSWER_TIME {
                return Err(NoDialog);
            }
            Ok(paths)
        });
        self.open = Some((job, then));
    }

    /// Follows what was answered, once.
    pub fn poll(&mut self, state: &mut State, engine: &mut Engine) -> Option<Command> {
        let outcome = self.open.as_mut()?.0.poll()?;
        let (_, then) = self.open.take()?;
        match outcome {
            Ok(paths) => then(state, engine, paths.filter(|paths| !paths.is_empty())?),
            Err(_) => {
                push_card(&mut state.errors, "No file dialog", NoDialog.to_string());
                None
            }
        }
    }
}

/// The dialogs of the operating system.
pub fn system_dialogs() -> AskPaths {
    Arc::new(|question| {
        let dialog = rfd::FileDialog::new();
        let one = |path: Option<PathBuf>| path.map(|path| vec![path]);
        match question {
            PathQuestion::OpenFiles => dialog
                .set_title("Open meshes or a study")
                .add_filter("Meshes and studies", &readable())
                .add_filter("All files", &["*"])
                .pick_files(),
            PathQuestion::OpenFolders => dialog.set_title("Open a folder of meshes").pick_folders(),
            PathQuestion::SaveFigure { title, suggested } => one(dialog
                .set_title(*title)
                .set_file_name(suggested)
                .add_filter("PNG picture", &["png"])
                .add_filter("SVG drawing", &["svg"])
                .add_filter("PDF page", &["pdf"])
                .save_file()),
            PathQuestion::SaveStudy => one(dialog
                .set_title("Save the study into an empty folder")
                .pick_folder()),
            PathQuestion::SaveTables => one(dialog
                .set_title("Save all tables into a folder")
                .pick_folder()),
        }
    })
}
