//! File dialogs of the operating system, asked off the window's thread.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::engine::{Job, Wake, Workers};
use crate::io::openable_extensions;
use crate::ui::Command;

use super::export::FigureKind;

/// Extensions of files that can be opened: studies, and pictures that hold a view.
fn readable() -> Vec<&'static str> {
    let mut extensions = openable_extensions();
    extensions.push("png");
    extensions
}

/// An answer this quick was given by no person: no dialog could be shown.
const TOO_QUICK: Duration = Duration::from_millis(150);

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// Which files to open.
    Files,
    /// Which folder to open.
    Folder,
    /// Where a picture goes.
    Figure(FigureKind),
    /// Into which folder tables go.
    Tables,
}

/// Why no answer came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the system shows no file dialog; install zenity or a desktop portal, or drop files and \
     folders onto the window"
)]
pub struct NoDialog;

/// The dialog that is open, if one is.
pub struct Dialogs {
    // Stands before the thread: dropped first, which lets go of the answer.
    open: Option<Job<Option<Command>, NoDialog>>,
    thread: Workers,
    wake: Wake,
}

impl Dialogs {
    /// Starts the thread that waits for answers.
    ///
    /// # Errors
    /// If the operating system refuses a thread.
    pub fn start(wake: Wake) -> std::io::Result<Self> {
        Ok(Self {
            open: None,
            thread: Workers::start("dialog", 1)?,
            wake,
        })
    }

    /// Asks, unless a dialog is open already. `suggested` names a new file.
    pub fn ask(&mut self, question: Question, suggested: String) {
        if self.open.is_some() {
            return;
        }
        let job = Job::spawn(&self.thread, Arc::clone(&self.wake), move |_| {
            let asked = Instant::now();
            let answer = answer(question, &suggested);
            if answer.is_none() && asked.elapsed() < TOO_QUICK {
                return Err(NoDialog);
            }
            Ok(answer)
        });
        self.open = Some(job);
    }

    /// What was answered, as the command it stands for; once.
    pub fn poll(&mut self) -> Option<Result<Command, NoDialog>> {
        let outcome = self.open.as_mut()?.poll()?;
        self.open = None;
        match outcome {
            Ok(command) => command.map(Ok),
            Err(_) => Some(Err(NoDialog)),
        }
    }
}

fn answer(question: Question, suggested: &str) -> Option<Command> {
    let dialog = rfd::FileDialog::new();
    match question {
        Question::Files => dialog
            .set_title("Open meshes or a study")
            .add_filter("Meshes and studies", &readable())
            .add_filter("All files", &["*"])
            .pick_files()
            .map(Command::Open),
        Question::Folder => dialog
            .set_title("Open a folder of meshes")
            .pick_folders()
            .map(Command::Open),
        Question::Figure(kind) => {
            let (title, command): (_, fn(Option<PathBuf>) -> Command) = match kind {
                FigureKind::View => ("Save the 3D view as a figure", Command::ExportFigure),
                FigureKind::Patch => ("Save the patch figure", Command::ExportPatchFigure),
            };
            dialog
                .set_title(title)
                .set_file_name(suggested)
                .add_filter("PNG picture", &["png"])
                .add_filter("SVG drawing", &["svg"])
                .add_filter("PDF page", &["pdf"])
                .save_file()
                .map(|path| command(Some(with_png_ending(path))))
        }
        Question::Tables => dialog
            .set_title("Save all tables into a folder")
            .pick_folder()
            .map(|folder| Command::ExportTables(Some(folder))),
    }
}

fn with_png_ending(path: PathBuf) -> PathBuf {
    if path.extension().is_some() {
        path
    } else {
        path.with_extension("png")
    }
}
