//! Files that the person at the screen chooses: what is opened, where figures and tables go, whose view is restored.

use std::path::PathBuf;
use std::sync::Arc;

use crate::engine::Engine;
use crate::panes::{Command, FileCommand};
use crate::picture::Quantity;
use crate::study::Subject;

use super::dialogs::{AskPaths, Dialogs, PathQuestion};
use super::errors::push_card;
use super::export::{FigureExport, FigureKind, NoFigure, TableExport, write_study_into};
use super::saved_views::{self, SavedViews};
use crate::document::document::Document;
use crate::document::state::State;
use crate::panes::pane_context::Kept;
use crate::panes::viewport::hearts::Viewport;

/// A figure as it was asked for. It waits where the selected subject is not on screen yet, or its wall not measured.
struct WantedFigure {
    kind: FigureKind,
    /// Where it goes; asked for if `None`.
    path: Option<PathBuf>,
    /// What was on screen at the command, or about to be.
    document: Document,
    dark: bool,
}

impl WantedFigure {
    /// Why it can no longer be had once the window shows `now`; `None` as long as it can.
    fn left_behind_by(&self, now: &Document) -> Option<&'static str> {
        let needs_numbers = |document: &Document| {
            matches!(
                document.bar_quantity(),
                Quantity::ThicknessRatio | Quantity::Contribution | Quantity::MotionDifference
            )
        };
        let colours_changed = now.bar_quantity() != self.document.bar_quantity();
        if self.subject() != now.selected().map(Arc::as_ptr) {
            Some("another subject was selected before this one was drawn and measured")
        } else if now.thickening != self.document.thickening {
            Some("the thresholds of patches were changed before its wall was measured")
        } else if colours_changed && needs_numbers(&self.document) {
            Some("other colours were chosen before those of the figure were computed")
        } else {
            None
        }
    }

    fn subject(&self) -> Option<*const Subject> {
        self.document.selected().map(Arc::as_ptr)
    }
}

/// What an export is made from and reports to.
pub struct Exporting<'a> {
    pub state: &'a mut State,
    pub viewport: Kept<Viewport>,
    pub engine: &'a mut Engine,
    /// Whether the window is dark; a figure looks like the window.
    pub dark: bool,
}

/// The dialog that is open, the picture that is read and the figures that wait for their subject.
pub struct ChosenFiles {
    dialogs: Dialogs,
    saved_views: SavedViews,
    waiting_figures: Vec<WantedFigure>,
}

impl ChosenFiles {
    /// Asks for files through `ask_paths`.
    pub fn new(ask_paths: AskPaths) -> Self {
        Self {
            dialogs: Dialogs::new(ask_paths),
            saved_views: SavedViews::default(),
            waiting_figures: Vec::new(),
        }
    }

    /// Asks which files or folders to open.
    pub fn ask_to_open(&mut self, engine: &Engine, question: PathQuestion) {
        let open = |_: &mut State, _: &mut Engine, paths| Some(FileCommand::Open(paths).into());
        self.dialogs.ask(engine, question, Box::new(open));
    }

    /// Asks which files or folders are added to the study on screen.
    pub fn ask_to_add(&mut self, exporting: &Exporting<'_>, question: PathQuestion) {
        let opening = exporting.state.document.study.opening;
        let add = move |state: &mut State, _: &mut Engine, paths| {
            let same = state.document.study.opening == opening;
            if !same {
                let why = "another study was opened before they were chosen";
                push_card(&mut state.errors, "Nothing was added", why);
            }
            same.then(|| FileCommand::Add(paths).into())
        };
        self.dialogs.ask(exporting.engine, question, Box::new(add));
    }

    /// Fixes the study at the moment it is asked for, then asks where it goes if that is not known.
    pub fn ask_for_study(&mut self, exporting: &mut Exporting<'_>, folder: Option<PathBuf>) {
        let study = Arc::clone(exporting.state.document.study());
        if let Some(folder) = folder {
            return write_study_into(exporting.state, exporting.engine, study, &folder);
        }
        let write = |state: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
            write_study_into(state, engine, study, &paths.swap_remove(0));
            None
        };
        let question = PathQuestion::SaveStudy;
        self.dialogs
            .ask(exporting.engine, question, Box::new(write));
    }

    /// Begins to read the view that a picture contains.
    pub fn read_view(&mut self, engine: &Engine, picture: PathBuf) {
        self.saved_views.read(engine, picture);
    }

    /// Fixes what the tables hold at the moment they are asked for, then asks where they go if that is not known.
    pub fn ask_for_tables(&mut self, exporting: &mut Exporting<'_>, folder: Option<PathBuf>) {
        let Some(tables) = TableExport::now(exporting.state) else {
            return;
        };
        if let Some(folder) = folder {
            return tables.write(exporting.engine, folder);
        }
        let write = |_: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
            tables.write(engine, paths.swap_remove(0));
            None
        };
        let question = PathQuestion::SaveTables;
        self.dialogs
            .ask(exporting.engine, question, Box::new(write));
    }

    /// Fixes what a figure shows at the moment it is asked for, then asks where it goes if that is not known.
    pub fn ask_for_figure(
        &mut self,
        exporting: &mut Exporting<'_>,
        kind: FigureKind,
        path: Option<PathBuf>,
    ) {
        let wanted = WantedFigure {
            kind,
            path,
            document: exporting.state.document.clone(),
            dark: exporting.dark,
        };
        self.make_figure(exporting, wanted);
    }

    fn make_figure(&mut self, exporting: &mut Exporting<'_>, mut wanted: WantedFigure) {
        let state = &mut *exporting.state;
        let viewport = exporting.viewport.borrow_mut();
        let (document, kind) = (&wanted.document, wanted.kind);
        let figure = FigureExport::of(document, state, &viewport, wanted.dark, kind);
        match (figure, wanted.path.take()) {
            (Ok(figure), Some(path)) => write_figure(state, exporting.engine, figure, path),
            (Ok(figure), None) => {
                let question = PathQuestion::SaveFigure {
                    title: kind.dialog_title(),
                    suggested: figure.file_name(),
                };
                let write = |state: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
                    let path = with_png_ending(paths.swap_remove(0));
                    write_figure(state, engine, figure, path);
                    None
                };
                self.dialogs
                    .ask(exporting.engine, question, Box::new(write));
            }
            (Err(NoFigure::Refused(reason)), _) => {
                let title = "There is no patch figure of this subject";
                push_card(&mut state.errors, title, reason);
            }
            (Err(NoFigure::NotYet), path) => {
                if let Some(subject) = wanted.document.selected() {
                    state.message = format!("The figure waits for {}", subject.id);
                }
                self.waiting_figures.push(WantedFigure { path, ..wanted });
            }
        }
    }

    /// Takes the figures that wait for their subject, once that is on screen; never of another subject.
    pub fn take_waiting_figures(&mut self, exporting: &mut Exporting<'_>) {
        for waiting in std::mem::take(&mut self.waiting_figures) {
            let Some(reason) = waiting.left_behind_by(&exporting.state.document) else {
                self.make_figure(exporting, waiting);
                continue;
            };
            let subject = waiting.document.selected();
            let id = subject.map_or("the subject", |subject| subject.id.as_str());
            let title = format!("There is no figure of {id}");
            push_card(&mut exporting.state.errors, title, reason);
        }
    }

    /// What dialogs and pictures have brought: commands to apply; exports with a place begin.
    pub fn poll(&mut self, state: &mut State, engine: &mut Engine) -> Vec<Command> {
        let mut commands = Vec::from_iter(self.dialogs.poll(state, engine));
        match self.saved_views.poll() {
            Some(Ok(command)) => commands.push(command),
            Some(Err(reason)) => saved_views::refuse(state, reason),
            None => {}
        }
        commands
    }
}

fn with_png_ending(path: PathBuf) -> PathBuf {
    match path.extension() {
        Some(_) => path,
        None => path.with_extension("png"),
    }
}

fn write_figure(state: &mut State, engine: &mut Engine, figure: FigureExport, path: PathBuf) {
    if let Err(reason) = figure.write(engine, path) {
        let title = "The figure could not be written";
        push_card(&mut state.errors, title, reason);
    }
}
