//! One frame of the window: bars, tiles, and what lies over them.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::{CentralPanel, Frame, Margin, Panel, Ui};

use crate::app::{CommandPaletteView, StatusBarView};
use crate::engine::{Engine, Showing};
use crate::panes::Command;
use crate::ui::theme::{colours, line, radius, space};
use crate::ui::{self};

use super::bars;
use super::layout::Layout;
use super::panes::{Panes, tab_containers};
use super::sheets;
use crate::app::bars::menu_view::{action_state, menu_bar_view};
use crate::app::bars::status_view::{StatusData, activity_rows};
use crate::app::sheets::report_view::report_entries;
use crate::document::state::State;
use crate::panes::beat::{BeatData, measures_view};
use crate::panes::bulls_eye::data::BullsEyeData;
use crate::panes::cohort::view::CohortData;
use crate::panes::deformation_map::view::{DeformationData, metric_panel_view};
use crate::panes::medial_map::view::MedialMapData;
use crate::panes::patch::view::PatchData;
use crate::panes::pose_map::view::MapData;
use crate::panes::thickness::view::ThicknessData;
use crate::panes::verdict::view::VerdictData;
use crate::panes::viewport::hearts::Viewport;

/// Height of the bar with the menus.
const MENU_HEIGHT: f32 = 34.0;
/// Height of the bar with the beat.
const TIME_HEIGHT: f32 = 72.0;
/// Height of the bar with the work.
const STATUS_HEIGHT: f32 = 36.0;

/// What is drawn and by whom it is kept.
pub struct Drawing<'a> {
    /// The state; drawing changes nothing of it.
    pub state: &'a State,
    /// The tiles, which the pointer moves.
    pub layout: &'a mut Layout,
    /// Tells how work stands.
    pub engine: &'a Engine,
    /// The 3D view.
    pub viewport: &'a mut Viewport,
    /// Rows of the cohort.
    pub cohort: &'a CohortData,
    /// Points of the map.
    pub map: &'a MapData,
    /// Points of the map of deformations.
    pub deformations: &'a DeformationData,
    /// Points of the map of the medial shape space.
    pub medial_map: &'a MedialMapData,
    /// The wall laid flat.
    pub bulls_eye: &'a BullsEyeData,
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
    let beat = BeatData::of(state);
    let window = colours(ui).window;
    let bar = Frame::new().fill(window);
    Panel::top("menu bar")
        .exact_size(MENU_HEIGHT)
        .frame(bar.inner_margin(Margin::symmetric(space::MEDIUM as i8, 3)))
        .show_separator_line(true)
        .show(ui, |ui| {
            bars::menu_bar_ui(ui, &menu_bar_view(state, &actions), drawing.commands);
        });
    Panel::bottom("status bar")
        .exact_size(STATUS_HEIGHT)
        .frame(bar)
        .show_separator_line(false)
        .show(ui, |ui| {
            let data = StatusData::of(state, &drawing.engine.running());
            let view: StatusBarView = data.view(state, drawing.adapter);
            bars::status_bar_ui(ui, &view, drawing.commands);
        });
    if state.document.selected().is_some() {
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
                        bars::time_bar_ui(ui, &bars::time_bar_view(&beat, state), drawing.commands);
                    });
            });
    }
    CentralPanel::no_frame().show(ui, |ui| {
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, window);
        let inner = area.shrink(space::PANE_GAP);
        ui.scope_builder(egui::UiBuilder::new().max_rect(inner), |ui| {
            tiles_ui(ui, drawing, &beat);
        });
    });
    sheets_ui(ui, drawing, &actions);
}

fn tiles_ui(ui: &mut Ui, drawing: &mut Drawing, beat: &BeatData) {
    let state = drawing.state;
    let activity = activity_rows(drawing.engine.activities());
    let answers = &state.answers;
    let measuring = answers.measures.as_ref().is_some_and(Showing::computing);
    let patches = PatchData::of(state, drawing.viewport.shown().first());
    let verdict = VerdictData::of(state);
    let thickness = ThicknessData::of(state);
    let (framed, tabbed) = tab_containers(&drawing.layout.tree);
    let mut panes = Panes {
        state,
        cohort: drawing.cohort,
        beat,
        map: drawing.map.view(state, answers.map.as_ref()),
        deformations: drawing.deformations.view(
            state,
            drawing.map.subjects(),
            drawing.map.left_out(),
        ),
        medial_map: drawing.medial_map.view(
            state,
            drawing.map.subjects(),
            answers.medial_map.as_ref(),
        ),
        thickness: thickness.view(state),
        space_time: drawing.map.space_time(state, answers.map.as_ref()),
        metric: metric_panel_view(state, drawing.map.subjects()),
        measures: measures_view(state, measuring),
        patch: patches.view(state),
        verdict: verdict.view(state),
        bulls_eye: drawing.bulls_eye.view(state, patches.state()),
        activity: &activity,
        measuring,
        classifying: verdict.classifying(),
        opening: drawing.engine.opening(),
        viewport: drawing.viewport,
        meter: &drawing.meter,
        commands: drawing.commands,
        framed,
        tabbed,
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
    if state.sheets.shortcuts {
        sheets::shortcut_sheet_ui(ui, commands);
    }
    if state.sheets.palette {
        let view = CommandPaletteView {
            actions,
            subjects: drawing.cohort.rows(),
            selected: state.document.selected().map(|_| state.document.subject),
        };
        sheets::command_palette_ui(ui, &view, commands);
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
        "Drop to open",
        egui::FontId::proportional(ui::theme::type_size::TITLE),
        colours.strong,
    );
}
