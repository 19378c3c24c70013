//! The window as eframe sees it: `logic` takes in and applies, `ui` draws and collects commands.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use egui::{Context, Ui};

use crate::document::answers::Answers;

use crate::engine::{Query, Topic, Wake};
use crate::panes::{Command, FileCommand};
use crate::ui::{self};

use super::app_options::AppOptions;
use super::apply::{Effect, Moment, advance, apply};
use super::background::{Background, reference_frames};
use super::chosen_files::{ChosenFiles, Exporting};
use super::first_picture::FirstPicture;
use super::frame_ui::{Drawing, frame_ui};
use super::layout::Layout;
use super::let_go::{give_keyboard_back, let_go_of_study};
use super::path_question::PathQuestion;
use super::settings::{Settings, choose_theme};
use super::times::Times;
use super::typefaces::Typefaces;
use super::window_picture::{self, KeepPicture};
use crate::document::state::State;
use crate::panes::pane_context::{Kept, Memo};
use crate::panes::viewport::paint;
use crate::panes::viewport::queries::Pictures;
use crate::panes::viewport::viewport::Viewport;

/// While work goes on, bars move this often.
const BAR_PERIOD: Duration = Duration::from_millis(100);

/// Longest step of the play clock: a motion that was held up goes on where it was.
const LONGEST_STEP_S: f64 = 0.25;

/// The window.
pub struct App {
    state: State,
    layout: Layout,
    // Stands before the engine: dropped first, which lets go of its work.
    files: ChosenFiles,
    // And so does this.
    typefaces: Typefaces,
    background: Background,
    memo: Memo,
    adapter: String,
    times: Times,
    /// Where somebody looks on: a picture comes before analyses.
    first_picture: Option<FirstPicture>,
    queue: Vec<Command>,
    played_at_s: Option<f64>,
    /// Whether the window closes, whatever was not exported.
    leaves: bool,
    /// What the driver refused, so that it has one card.
    refused: Option<String>,
}

impl App {
    /// Prepares the window and begins to open what the options say.
    ///
    /// # Errors
    /// If the operating system refuses the threads for background work.
    pub fn new(cc: &eframe::CreationContext<'_>, options: AppOptions) -> std::io::Result<Self> {
        let ctx = cc.egui_ctx.clone();
        let settings = Settings::load(cc.storage);
        ui::install(&ctx);
        ctx.add_plugin(crate::panes::TabForSubjects);
        choose_theme(&ctx, settings.theme);
        if let Some(device) = &cc.wgpu_render_state {
            let scenes = paint::install(device, options.live);
            if options.live {
                window_picture::install(device, scenes);
                ctx.add_plugin(KeepPicture::default());
            }
        }
        let wake: Wake = Arc::new(move || ctx.request_repaint());
        let mut background = Background::start(&wake)?;
        let mut state = State {
            theme: settings.theme,
            figure_look: settings.figure,
            recent: settings.recent,
            play: settings.play,
            built_in: options.built_in,
            ..State::default()
        };
        let mut files = ChosenFiles::new(options.ask_paths);
        if let Some(source) = options.open {
            files.begin(&mut state, &mut background.engine, source);
        }
        let memo = Memo::default();
        memo.put(Viewport::new(cc.wgpu_render_state.is_some()));
        Ok(Self {
            state,
            layout: settings.layout,
            files,
            typefaces: Typefaces::default(),
            background,
            memo,
            adapter: cc
                .wgpu_render_state
                .as_ref()
                .map(paint::adapter_name)
                .unwrap_or_default(),
            times: Times::new(options.started),
            first_picture: options.live.then(FirstPicture::default),
            queue: Vec::new(),
            played_at_s: None,
            leaves: false,
            refused: None,
        })
    }

    /// Everything the window shows.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Asks for something as a panel would.
    pub fn push(&mut self, command: Command) {
        self.queue.push(command);
    }

    /// Whether work goes on behind the window.
    pub fn busy(&self) -> bool {
        self.background.engine.busy()
    }

    /// Whether one kind of work goes on.
    pub fn works_on(&self, topic: Topic) -> bool {
        self.background.engine.store().works_on(topic)
    }

    /// The answer to a question about the study on screen, if it is known.
    pub fn known<Q: Query>(&self, query: &Q) -> Option<Arc<Q::Answer>> {
        let store = self.background.engine.store();
        store.known(self.state.document.study(), query)
    }

    /// What is on screen, as subject and place in the cycle.
    pub fn hearts_on_screen(&self) -> Vec<(usize, f64)> {
        let viewport = self.viewport();
        let shown = viewport.borrow_mut();
        let hearts = shown.shown().iter();
        hearts.map(|shown| (shown.index, shown.position)).collect()
    }

    /// The 3D view, which its pane draws.
    fn viewport(&self) -> Kept<Viewport> {
        self.memo.get()
    }

    /// Whether what is asked whatever is on screen waits for the first picture of the study.
    fn first_picture_is_ahead(&mut self) -> bool {
        let drawn = self.viewport().borrow_mut().shown_opening();
        let first = self.first_picture.as_mut();
        let opening = self.state.document.study.opening;
        first.is_some_and(|first| first.holds_back(opening, drawn, Instant::now()))
    }

    fn report_refusal(&mut self, refused: Option<String>) {
        if let Some(reason) = refused.as_ref().filter(|_| refused != self.refused) {
            let title = "The 3D view could not be drawn";
            super::errors::push_card(&mut self.state.errors, title, reason);
        }
        self.refused = refused;
    }

    fn take_in(&mut self, ctx: &Context) {
        (self.queue).extend(self.background.poll(&mut self.state));
        (self.typefaces).poll(ctx, &mut self.state, &self.background.engine);
        let chosen = (self.files).poll(&mut self.state, &mut self.background.engine);
        self.queue.extend(chosen);
        let dropped: Vec<PathBuf> = ctx.input(|input| {
            let files = input.raw.dropped_files.iter();
            files.map(|file| file.path().to_owned()).collect()
        });
        if !dropped.is_empty() {
            // With Shift they are added to the study.
            self.queue
                .push(match ctx.input(|input| input.modifiers.shift) {
                    true => FileCommand::Add(dropped).into(),
                    false => FileCommand::Open(dropped).into(),
                });
        }
        let closes = ctx.input(|input| input.viewport().close_requested());
        if closes && !self.leaves && self.state.is_edited() {
            ctx.send_viewport_cmd(egui::ViewportCommand::CancelClose);
            self.queue.push(FileCommand::Quit.into());
        }
        self.queue.extend(crate::panes::pressed_commands(ctx));
    }

    fn apply_queue(&mut self, ctx: &Context) {
        let (now_s, pointer_held, let_go) = ctx.input(|input| {
            (
                input.time,
                input.pointer.any_down(),
                input.pointer.any_released(),
            )
        });
        for command in std::mem::take(&mut self.queue) {
            let moment = Moment {
                now_s,
                pointer_held,
                fresh_revision: self.background.engine.next_revision(),
            };
            for effect in apply(&mut self.state, command, &moment) {
                self.perform(ctx, effect);
            }
        }
        if let_go && !pointer_held {
            self.state.history.end_drag();
            give_keyboard_back(ctx);
        }
    }

    fn perform(&mut self, ctx: &Context, effect: Effect) {
        let (files, mut exporting) = self.exporting(ctx);
        match effect {
            Effect::ChooseFiles => files.ask_to_open(exporting.engine, PathQuestion::OpenFiles),
            Effect::ChooseFolder => files.ask_to_open(exporting.engine, PathQuestion::OpenFolders),
            Effect::ChooseFilesToAdd => {
                files.ask_to_add(&exporting, PathQuestion::OpenFiles);
            }
            Effect::ChooseFolderToAdd => {
                files.ask_to_add(&exporting, PathQuestion::OpenFolders);
            }
            Effect::AddWalls(images) => self.background.add_walls(&mut self.state, &images),
            Effect::Add(paths) => self.background.add(&self.state, paths),
            Effect::ExportStudy { folder, then } => {
                files.ask_for_study(&mut exporting, folder, then);
            }
            Effect::ChooseFigure(kind) => files.ask_for_figure(&mut exporting, kind, None),
            Effect::PaneFigure(pane, to) => files.ask_for_plot(&mut exporting, pane, to),
            Effect::ChooseTables => files.ask_for_tables(&mut exporting, None),
            Effect::ReadFirst(id) => self.background.engine.read_first(id),
            Effect::Open(source) => self.background.engine.open(source),
            Effect::FollowLinks => self.background.engine.open_following_links(),
            Effect::WriteFigure(kind, path) => {
                files.ask_for_figure(&mut exporting, kind, Some(path));
            }
            Effect::ReadPicture { picture, study } => {
                files.read_view(exporting.engine, picture, !study.is_empty());
                if !study.is_empty() {
                    self.queue.push(FileCommand::Open(study).into());
                }
            }
            Effect::ChooseClassifier => files.ask_for_classifier(&exporting),
            Effect::ExportClassifier(path) => files.ask_to_save_classifier(&mut exporting, path),
            Effect::ReadClassifier { rule, then } => {
                let next = (then.as_deref()).is_some_and(|then| !matches!(then, Effect::Add(_)));
                files.read_classifier(exporting.state, exporting.engine, rule, next);
                if let Some(then) = then {
                    self.perform(ctx, *then);
                }
            }
            Effect::CompletePath(text) => files.complete_path(exporting.engine, text),
            Effect::TakePath { text, replace } => files.take_path(exporting.engine, text, replace),
            Effect::CancelPath => files.cancel_path(exporting.state),
            Effect::WriteTables(folder) => files.ask_for_tables(&mut exporting, Some(folder)),
            Effect::Stop(topic) => self.background.engine.cancel(topic),
            Effect::Retry(topic) => self.background.engine.retry(topic),
            Effect::SetTheme(theme) => choose_theme(ctx, theme),
            Effect::TogglePane(pane) => {
                // A tab behind another one is brought forward first.
                let seen = self.layout.seen().contains(&pane);
                self.layout.set_open(pane, !seen);
            }
            Effect::ShowPane(pane) => self.layout.set_open(pane, true),
            Effect::ResetLayout => self.layout = Layout::default(),
            Effect::SetFullScreen(full) => {
                ctx.send_viewport_cmd(egui::ViewportCommand::Fullscreen(full));
            }
            Effect::Quit => {
                self.leaves = true;
                ctx.send_viewport_cmd(egui::ViewportCommand::Close);
            }
        }
    }

    /// What exports are made from, beside those who ask for their place.
    fn exporting(&mut self, ctx: &Context) -> (&mut ChosenFiles, Exporting<'_>) {
        let exporting = Exporting {
            state: &mut self.state,
            memo: &self.memo,
            engine: &mut self.background.engine,
            dark: ctx.global_style().visuals.dark_mode,
        };
        (&mut self.files, exporting)
    }

    /// Moves the motion on by the time since the last frame.
    fn advance(&mut self, ctx: &Context) {
        if !self.state.play.playing {
            self.played_at_s = None;
            return;
        }
        let now_s = ctx.input(|input| input.time);
        let elapsed_s = self.played_at_s.map_or(0.0, |last| now_s - last);
        self.played_at_s = Some(now_s);
        advance(&mut self.state, elapsed_s.min(LONGEST_STEP_S));
        if self.state.play.playing {
            ctx.request_repaint();
        }
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        self.times.begin_frame(self.state.play.playing);
        let begin = Instant::now();
        // What was clicked concerns what was drawn: it comes before anything that finished since, such as
        // another study, in whose table a row is another subject.
        let listing = self.state.document.study.listing;
        self.apply_queue(ctx);
        self.take_in(ctx);
        crate::panes::let_go_if_moved(ctx, self.state.document.study());
        self.report_refusal(frame.wgpu_render_state().and_then(paint::failure));
        self.apply_queue(ctx);
        if self.state.document.study.listing != listing {
            let_go_of_study(ctx);
        }
        let (files, mut exporting) = self.exporting(ctx);
        files.take_waiting_figures(&mut exporting);
        self.advance(ctx);
        if self.first_picture_is_ahead() {
            self.state.answers = Answers {
                listing: self.state.document.study.listing,
                ..Answers::default()
            };
            // Nothing else wakes the window once the picture is there.
            ctx.request_repaint();
        } else {
            let pointer_held = ctx.input(|input| input.pointer.any_down());
            self.background.ask(&mut self.state, pointer_held);
        }
        self.files.answers_are_of(&self.state.document);
        let reference_frames = reference_frames(&self.state);
        let store = self.background.engine.store();
        let pictures = Pictures::new(store, self.state.document.study());
        let viewport = self.viewport();
        let mut viewport = viewport.borrow_mut();
        viewport.prepare(&self.state, pictures, &reference_frames);
        drop(viewport);
        store.end_frame();
        if self.background.engine.busy() {
            ctx.request_repaint_after(BAR_PERIOD);
        }
        self.times.add(begin.elapsed());
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let begin = Instant::now();
        let mut drawing = Drawing {
            state: &self.state,
            layout: &mut self.layout,
            engine: &self.background.engine,
            memo: &self.memo,
            adapter: &self.adapter,
            meter: self.times.prepare_meter(),
            commands: &mut self.queue,
        };
        frame_ui(ui, &mut drawing);
        if !self.queue.is_empty() {
            ui.ctx().request_repaint();
        }
        if self
            .times
            .drawn(&self.state, self.viewport().borrow_mut().shown())
        {
            ui.ctx().request_repaint();
        }
        self.times.add(begin.elapsed());
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        Settings::save(storage, &self.state, &self.layout);
    }

    /// What egui itself would keep includes texts that were typed, so nothing of it is kept.
    fn persist_egui_memory(&self) -> bool {
        false
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        ui::theme::Colours::of(visuals.dark_mode)
            .window
            .to_normalized_gamma_f32()
    }
}
