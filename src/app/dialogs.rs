//! File dialogs of the operating system, asked off the window's thread.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::engine::{Engine, Job};
use crate::io::openable_extensions;

use super::export::{FigureExport, FigureKind, TableExport};

/// Extensions of files that can be opened: studies, and pictures that hold a view.
fn readable() -> Vec<&'static str> {
    let mut extensions = openable_extensions();
    extensions.push("png");
    extensions
}

/// An empty answer that comes sooner was not given by a person: no dialog could be shown.
const MIN_ANSWER_TIME: Duration = Duration::from_millis(150);

/// What is asked. What a file will hold is fixed before its place is asked for: while a dialog is open, the
/// window goes on, and another subject may be selected.
pub enum Question {
    /// Which files to open.
    Files,
    /// Which folder to open.
    Folder,
    /// Where a figure goes.
    Figure(Box<FigureExport>),
    /// Into which folder tables go.
    Tables(Box<TableExport>),
}

/// What was answered, with what the question was about.
pub enum Answer {
    /// Open these.
    Open(Vec<PathBuf>),
    /// Write this figure there.
    Figure(Box<FigureExport>, PathBuf),
    /// Write these tables there.
    Tables(Box<TableExport>, PathBuf),
}

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

/// The dialog that is open, if one is.
pub struct Dialogs {
    open: Option<Job<Option<Answer>, NoDialog>>,
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
    pub fn ask(&mut self, engine: &Engine, question: Question) {
        if self.open.is_some() {
            return;
        }
        let ask_paths = Arc::clone(&self.ask_paths);
        let job = engine.spawn_aside(move |_| {
            let asked = Instant::now();
            let paths = ask_paths(&question.about_paths());
            if paths.is_none() && asked.elapsed() < MIN_ANSWER_TIME {
                return Err(NoDialog);
            }
            Ok(paths.and_then(|paths| question.answer(paths)))
        });
        self.open = Some(job);
    }

    /// What was answered; once.
    pub fn poll(&mut self) -> Option<Result<Answer, NoDialog>> {
        let outcome = self.open.as_mut()?.poll()?;
        self.open = None;
        match outcome {
            Ok(answer) => answer.map(Ok),
            Err(_) => Some(Err(NoDialog)),
        }
    }
}

impl Question {
    fn about_paths(&self) -> PathQuestion {
        match self {
            Self::Files => PathQuestion::OpenFiles,
            Self::Folder => PathQuestion::OpenFolders,
            Self::Figure(figure) => PathQuestion::SaveFigure {
                title: match figure.kind() {
                    FigureKind::View => "Save the 3D view as a figure",
                    FigureKind::Patch => "Save the patch figure",
                },
                suggested: figure.file_name(),
            },
            Self::Tables(_) => PathQuestion::SaveTables,
        }
    }

    /// The answer that chosen paths are; none if nothing was chosen.
    fn answer(self, paths: Vec<PathBuf>) -> Option<Answer> {
        Some(match self {
            Self::Files | Self::Folder if paths.is_empty() => return None,
            Self::Files | Self::Folder => Answer::Open(paths),
            Self::Figure(figure) => {
                Answer::Figure(figure, with_png_ending(paths.into_iter().next()?))
            }
            Self::Tables(tables) => Answer::Tables(tables, paths.into_iter().next()?),
        })
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
            PathQuestion::SaveTables => one(dialog
                .set_title("Save all tables into a folder")
                .pick_folder()),
        }
    })
}

fn with_png_ending(path: PathBuf) -> PathBuf {
    if path.extension().is_some() {
        path
    } else {
        path.with_extension("png")
    }
}
