//! Files that the person at the screen chooses: what is opened, where figures and tables go, whose view is restored.

use std::path::PathBuf;
use std::sync::Arc;

use crate::engine::{Engine, OpenSource};
use crate::panes::{ClassifierCommand, Command, FileCommand, Pane, spec_of};
use crate::picture::Quantity;
use crate::picture::plot::PlotFigure;
use crate::study::Subject;

use super::dialogs::Dialogs;
use super::errors::push_card;
use super::export::{FigureColours, FigureExport, FigureKind, NoFigure, TableExport};
use super::opened_classifiers::{ClassifierExport, OpenedClassifiers, split_classifier};
use super::path_question::{AskPaths, PathQuestion};
use super::plot_export::PlotExport;
use super::saved_views::{SavedViews, split_picture};
use super::settings::remember_recent;
use super::study_export::write_study_into;
use crate::document::Leaving;
use crate::document::document::Document;
use crate::document::state::State;
use crate::panes::figure::PaneFigure;
use crate::panes::pane_context::{Memo, PaneContext};
use crate::panes::viewport::viewport::Viewport;

/// A figure as it was asked for. It waits where the selected subject is not on screen yet, or its wall not measured.
struct WantedFigure {
    kind: FigureKind,
    /// Where it goes; asked for if `None`.
    path: Option<PathBuf>,
    /// What was on screen at the command, or about to be.
    document: Document,
    colours: FigureColours,
}

impl WantedFigure {
    /// Whether what the store says is about what the figure shows: in the frame in which settings change, it is still
    /// about those before.
    fn is_answered_by(&self, answered: &Document) -> bool {
        let same_colours = answered.bar_quantity() == self.document.bar_quantity();
        answered.thickening == self.document.thickening && (same_colours || !self.needs_numbers())
    }

    /// Whether its colours are computed beside the subject.
    fn needs_numbers(&self) -> bool {
        matches!(
            self.document.bar_quantity(),
            Quantity::ThicknessRatio | Quantity::Contribution | Quantity::MotionDifference
        )
    }

    /// Why it can no longer be had once the window shows `now`; `None` as long as it can.
    fn left_behind_by(&self, now: &Document) -> Option<&'static str> {
        let colours_changed = now.bar_quantity() != self.document.bar_quantity();
        if self.subject() != now.selected().map(Arc::as_ptr) {
            Some("another subject was selected before this one was drawn and measured")
        } else if now.thickening != self.document.thickening {
            Some("the thresholds of patches were changed before its wall was measured")
        } else if colours_changed && self.needs_numbers() {
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
    /// What panes made in earlier frames.
    pub memo: &'a Memo,
    pub engine: &'a mut Engine,
    /// Whether the window is dark; a figure looks like the window.
    pub dark: bool,
}

impl Exporting<'_> {
    /// What the figure of a pane holds now.
    fn content_of(&self, figure: &PaneFigure) -> Result<PlotFigure, String> {
        (figure.content)(&PaneContext {
            state: self.state,
            store: self.engine.store(),
            memo: self.memo,
            activities: &[],
            opening: self.engine.opening(),
            pointer_held: false,
            meter: &Arc::default(),
        })
    }
}

/// The dialog that is open, the picture that is read and the figures that wait for their subject.
pub struct ChosenFiles {
    dialogs: Dialogs,
    saved_views: SavedViews,
    rules: OpenedClassifiers,
    waiting_figures: Vec<WantedFigure>,
    /// The document that the store was asked for last.
    answered: Document,
}

impl ChosenFiles {
    /// Asks for files through `ask_paths`.
    pub fn new(ask_paths: AskPaths) -> Self {
        Self {
            dialogs: Dialogs::new(ask_paths),
            saved_views: SavedViews::default(),
            rules: OpenedClassifiers::default(),
            waiting_figures: Vec::new(),
            answered: State::default().document,
        }
    }

    /// Says that the answers of this frame are about this document.
    pub fn answers_are_of(&mut self, document: &Document) {
        self.answered.clone_from(document);
    }

    /// Opens what the window begins with: of paths, a picture restores its view.
    pub fn begin(&mut self, state: &mut State, engine: &mut Engine, source: OpenSource) {
        let OpenSource::Paths(paths) = source else {
            return engine.open(source);
        };
        let (rule, paths) = split_classifier(paths);
        let alone = rule.is_some() && paths.is_empty();
        if let Some(rule) = rule {
            self.read_classifier(state, engine, rule, true);
        }
        if alone {
            return engine.open(OpenSource::BuiltIn(state.built_in));
        }
        let (picture, paths) = split_picture(paths);
        if let Some(picture) = picture {
            self.read_view(engine, picture, !paths.is_empty());
        }
        if !paths.is_empty() {
            remember_recent(&mut state.recent, &paths);
            engine.open(OpenSource::Paths(paths));
        }
    }

    /// Completes a path that is typed.
    pub fn complete_path(&mut self, engine: &Engine, text: String) {
        self.dialogs.typed.complete(engine, text);
    }

    /// Takes a path that was typed.
    pub fn take_path(&mut self, engine: &Engine, text: String, replace: bool) {
        self.dialogs.typed.take(engine, text, replace);
    }

    /// Gives up typing a path.
    pub fn cancel_path(&mut self, state: &mut State) {
        self.dialogs.typed.cancel(state);
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

    /// Fixes the study at the moment it is asked for, then asks where it goes if that is not known. It is left for `then`
    /// once it is written.
    pub fn ask_for_study(
        &mut self,
        exporting: &mut Exporting<'_>,
        folder: Option<PathBuf>,
        then: Option<Leaving>,
    ) {
        let study = Arc::clone(exporting.state.document.study());
        if let Some(folder) = folder {
            return write_study_into(exporting.state, exporting.engine, study, &folder, then);
        }
        let write = |state: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
            write_study_into(state, engine, study, &paths.swap_remove(0), then);
            None
        };
        let question = PathQuestion::SaveStudy;
        self.dialogs
            .ask(exporting.engine, question, Box::new(write));
    }

    /// Asks which classifier to open, for the study on screen.
    pub fn ask_for_classifier(&mut self, exporting: &Exporting<'_>) {
        let opening = exporting.state.document.study.opening;
        let open = move |state: &mut State, _: &mut Engine, mut paths: Vec<PathBuf>| {
            let same = state.document.study.opening == opening;
            if !same {
                let why = "another study was opened before it was chosen";
                push_card(&mut state.errors, "No classifier was opened", why);
            }
            same.then(|| ClassifierCommand::Open(paths.swap_remove(0)).into())
        };
        let question = PathQuestion::OpenClassifier;
        self.dialogs.ask(exporting.engine, question, Box::new(open));
    }

    /// Begins to read a classifier; `next` says whether it is for a study that was named with it.
    pub fn read_classifier(&mut self, state: &State, engine: &Engine, rule: PathBuf, next: bool) {
        self.rules.read(state, engine, rule, next);
    }

    /// Fixes on what a classifier is trained at the moment it is asked for, then asks where it goes if that is not known.
    pub fn ask_to_save_classifier(&mut self, exporting: &mut Exporting<'_>, path: Option<PathBuf>) {
        let rule = ClassifierExport::now(exporting.state);
        if let Some(path) = path {
            return rule.write(exporting.engine, path);
        }
        let write = |_: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
            rule.write(engine, paths.swap_remove(0));
            None
        };
        let question = PathQuestion::SaveClassifier;
        self.dialogs
            .ask(exporting.engine, question, Box::new(write));
    }

    /// Begins to read the view that a picture contains; `named` says whether its study was named with it.
    pub fn read_view(&mut self, engine: &Engine, picture: PathBuf, named: bool) {
        self.saved_views.read(engine, picture, named);
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
            colours: FigureColours::of(exporting.state.figure_look, exporting.dark),
        };
        self.make_figure(exporting, wanted);
    }

    /// Fixes what a pane shows at the moment it is asked for, then asks where it goes if that is not known.
    pub fn ask_for_plot(
        &mut self,
        exporting: &mut Exporting<'_>,
        pane: Pane,
        path: Option<PathBuf>,
    ) {
        let Some(figure) = spec_of(pane).and_then(|spec| spec.figure.as_ref()) else {
            return;
        };
        let colours = FigureColours::of(exporting.state.figure_look, exporting.dark);
        let content = exporting.content_of(figure);
        let plot = content.and_then(|content| PlotExport::of(content, colours));
        match (plot, path) {
            (Ok(plot), Some(path)) => {
                let begun = plot.write(exporting.engine, path);
                report_unwritten(exporting.state, begun);
            }
            (Ok(plot), None) => {
                let question = PathQuestion::SaveFigure {
                    title: figure.save,
                    suggested: plot.file_name(),
                };
                let write = |state: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
                    report_unwritten(state, plot.write(engine, paths.swap_remove(0)));
                    None
                };
                self.dialogs
                    .ask(exporting.engine, question, Box::new(write));
            }
            (Err(why), _) => push_card(&mut exporting.state.errors, figure.none, why),
        }
    }

    fn make_figure(&mut self, exporting: &mut Exporting<'_>, mut wanted: WantedFigure) {
        let state = &mut *exporting.state;
        let viewport = exporting.memo.get::<Viewport>();
        let viewport = viewport.borrow_mut();
        let (document, kind) = (&wanted.document, wanted.kind);
        let figure = match wanted.is_answered_by(&self.answered) {
            true => FigureExport::of(document, state, &viewport, &wanted.colours, kind),
            false => Err(NoFigure::NotYet),
        };
        match (figure, wanted.path.take()) {
            (Ok(figure), Some(path)) => {
                report_unwritten(state, figure.write(exporting.engine, path));
            }
            (Ok(figure), None) => {
                let question = PathQuestion::SaveFigure {
                    title: kind.dialog_title(),
                    suggested: figure.file_name(),
                };
                let write = |state: &mut State, engine: &mut Engine, mut paths: Vec<PathBuf>| {
                    report_unwritten(state, figure.write(engine, paths.swap_remove(0)));
                    None
                };
                self.dialogs
                    .ask(exporting.engine, question, Box::new(write));
            }
            (Err(NoFigure::Refused(reason)), _) => {
                let title = match kind {
                    FigureKind::Patch => "No patch figure",
                    FigureKind::View => "No figure",
                };
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
        commands.extend(self.saved_views.poll(state, engine));
        commands.extend(self.rules.poll(state, engine));
        commands
    }
}

/// Says why a figure was not begun to be written.
fn report_unwritten(state: &mut State, begun: Result<(), String>) {
    if let Err(reason) = begun {
        let title = "The figure could not be written";
        push_card(&mut state.errors, title, reason);
    }
}
