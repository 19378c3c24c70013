//! One frame of the window: bars, tiles, and what lies over them.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::{CentralPanel, Frame, Margin, Panel, Ui};

use crate::app::CommandPaletteView;
use crate::engine::Engine;
use crate::panes::Command;
use crate::ui::theme::{colours, line, radius, space};
use crate::ui::{self};

use super::bars;
use super::layout::Layout;
use super::panes::{Panes, tab_containers};
use super::sheets;
use crate::app::bars::action_states::action_state;
use crate::app::bars::status_view::status_bar_view;
use crate::app::sheets::report_view::report_entries;
use crate::document::state::State;
use crate::panes::cohort::view::CohortData;
use crate::panes::{Memo, PaneContext};

/// Height of the bar with the menus.
const MENU_HEIGHT: f32 = 34.0;
/// Height of the bar with the cycle.
const TIME_HEIGHT: f32 = 72.0;
/// Height of the bar with the work.
const STATUS_HEIGHT: f32 = 36.0;

/// What is drawn and by whom it is kept.
pub struct Drawing<'a> {
    /// The state; drawing changes nothing of it.
    pub state: &'a State,
    /// The tiles, which the pointer moves.
    pub layout: &'a mut Layout,
    /// Says how work stands.
    pub engine: &'a Engine,
    /// What panes made in earlier frames.
    pub memo: &'a Memo,
    /// What the pictures are drawn with.
    pub adapter: &'a str,
    /// Takes the time of the paint callbacks.
    pub meter: Arc<AtomicU64>,
    /// What the user asked for.
    pub commands: &'a mut Vec<Command>,
}

/// Draws the whole window.
pub fn frame_ui(ui: &mut Ui, drawing: &mut Drawing) {
    let state = drawing.state;
    let actions = action_state(state, drawing.layout);
    let window = colours(ui).window;
    let bar = Frame::new().fill(window);
    Panel::top("menu bar")
        .exact_size(MENU_HEIGHT)
        .frame(bar.inner_margin(Margin::symmetric(space::MEDIUM as i8, 3)))
        .show_separator_line(true)
        .show(ui, |ui| {
            bars::menu_bar_ui(ui, &actions, drawing.commands);
        });
    Panel::bottom("status bar")
        .exact_size(STATUS_HEIGHT)
        .frame(bar)
        .show_separator_line(false)
        .show(ui, |ui| {
            let running = drawing.engine.running();
            let view = status_bar_view(state, running, drawing.adapter);
            bars::status_bar_ui(ui, &view, drawing.commands);
        });
    if state.document.selected().is_some() || state.document.shown_series().is_some() {
        Panel::bottom("time bar")
            .exact_size(TIME_HEIGHT)
            .frame(bar.inner_margin(Margin {
                left: space::PANE_GAP as i8,
                right: space::PANE_GAP as i8,
                top: 0,
                bottom: 0,
            }))
            .show_separator_line(false)
            .show(ui, |ui| {
                let colours = colours(ui);
                Frame::new()
                    .fill(colours.pane)
                    .stroke((line::THIN, colours.line))
                    .corner_radius(radius::PANE)
                    .show(ui, |ui| {
                        ui.set_min_size(ui.available_size());
                        bars::time_bar_ui(ui, &bars::time_bar_view(state), drawing.commands);
                    });
            });
    }
    CentralPanel::no_frame().show(ui, |ui| {
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, window);
        let inner = area.shrink(space::PANE_GAP);
        ui.scope_builder(egui::UiBuilder::new().max_rect(inner), |ui| {
            tiles_ui(ui, drawing);
        });
    });
    sheets_ui(ui, drawing, &actions);
}

fn tiles_ui(ui: &mut Ui, drawing: &mut Drawing) {
    let activities = drawing.engine.activities();
    let (framed, tabbed) = tab_containers(&drawing.layout.tree);
    let mut panes = Panes {
        cx: PaneContext {
            state: drawing.state,
            store: drawing.engine.store(),
            memo: drawing.memo,
            activities: &activities,
            opening: drawing.engine.opening(),
            pointer_held: ui.input(|input| input.pointer.any_down()),
            meter: &drawing.meter,
        },
        commands: drawing.commands,
        framed,
        tabbed,
        gaps: std::collections::HashMap::new(),
    };
    drawing.layout.tree.ui(&mut panes, ui);
}

fn sheets_ui(ui: &mut Ui, drawing: &mut Drawing, actions: &crate::panes::ActionState) {
    let state = drawing.state;
    let commands = &mut *drawing.commands;
    sheets::error_cards_ui(ui, &state.errors, commands);
    if state.sheets.load_report {
        sheets::load_report_ui(ui, &report_entries(state), commands);
    }
    if state.sheets.about {
        sheets::about_ui(ui, drawing.adapter, commands);
    }
    if state.sheets.figure {
        sheets::figure_sheet_ui(ui, state.figure_look, commands);
    }
    if let Some(entry) = &state.path_entry {
        sheets::path_sheet_ui(ui, entry, commands);
    }
    if state.sheets.shortcuts {
        sheets::shortcut_sheet_ui(ui, commands);
    }
    if state.sheets.palette {
        let cohort = drawing.memo.get::<CohortData>();
        let mut cohort = cohort.borrow_mut();
        cohort.refresh(state);
        let view = CommandPaletteView {
            actions,
            subjects: cohort.all_rows(),
        };
        sheets::command_palette_ui(ui, &view, commands);
    }
    if let Some(leaving) = &state.leaving {
        sheets::leaving_ui(ui, leaving, commands);
    }
    files_hover_ui(ui, state);
    crate::panes::dragged_subject_ui(ui);
}

/// While files are held over an open study, a frame says that they can be let go.
fn files_hover_ui(ui: &Ui, state: &State) {
    let hovering = ui.input(|input| !input.raw.hovered_files.is_empty());
    if !hovering || state.document.selected().is_none() {
        return;
    }
    let colours = colours(ui);
    let layer = egui::LayerId::new(egui::Order::Foreground, egui::Id::unique("drop"));
    let painter = ui.ctx().layer_painter(layer);
    let area = ui.ctx().content_rect();
    painter.rect_filled(area, 0.0, colours.window.gamma_multiply(0.75));
    painter.rect_stroke(
        area.shrink(space::LARGE),
        f32::from(radius::PANE),
        (line::STRONG, colours.accent),
        egui::StrokeKind::Inside,
    );
    painter.text(
        area.center(),
        egui::Align2::CENTER_CENTER,
        "Drop to open, with Shift to add to the study",
        egui::FontId::proportional(ui::theme::type_size::TITLE),
        colours.strong,
    );
}
