//! Patches of the selected subject: heading, table and thresholds.

mod settings;
pub(crate) mod spec;
mod table;
#[cfg(test)]
mod tests;
pub(crate) mod view;
pub(crate) mod words;

use egui::{Margin, RichText, ScrollArea, Ui};

use crate::engine::{ThickeningSettings, Topic, WallThickening};
use crate::panes::commands::{Command, WorkCommand};
use crate::picture::PatchStanding;
use crate::render::Camera;
use crate::report::PatchRow;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// State of the thickening of the selected subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WallState {
    /// No subject is selected.
    #[default]
    Empty,
    /// What is shown is that of the settings.
    Ready,
    /// It is being computed; what is shown, if anything, is that of the settings before.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
    },
    /// The user stopped it.
    Stopped,
    /// The wall cannot be assessed, and why.
    NotAssessed(String),
}

/// One patch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchLine {
    /// Its numbers.
    pub row: PatchRow,
    /// Segments in words, or why there are none.
    pub segments: String,
    /// Whether it is selected.
    pub selected: bool,
    /// The camera that looks at it, in the heart's axes; `None` while the heart is not on screen.
    pub camera: Option<Camera>,
}

/// What the pane shows.
#[derive(Clone, Debug)]
pub struct PatchPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of its measurement.
    pub state: &'a WallState,
    /// What the parts may be called.
    pub standing: PatchStanding,
    /// "1 patch · 31 % of the LV"; empty while nothing is known.
    pub heading: &'a str,
    /// What the whole wall does.
    pub note: &'a str,
    /// The patches, by falling area.
    pub rows: &'a [PatchLine],
    /// The thresholds.
    pub settings: ThickeningSettings,
    /// Standard deviation of the noise of ln r.
    pub noise: Option<f64>,
    /// Tolerance of |ln PT| in force.
    pub tolerance: Option<f64>,
    /// Thickening of remote myocardium, 0.5 for 50 %.
    pub well: Option<f64>,
}

/// Draws the pane.
pub fn patch_panel_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to see its patches (regional wall-thickening abnormalities)",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("patch panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            egui::Frame::new()
                .inner_margin(Margin::same(space::LARGE as i8))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 2.0;
                    found_ui(ui, view, commands);
                    settings::settings_ui(ui, view, commands);
                });
        });
}

fn found_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if let WallState::NotAssessed(why) = view.state {
        ui.label(medium("Not assessed"));
        ui.add(egui::Label::new(RichText::new(why.as_str()).weak()).wrap());
        ui.add_space(space::LARGE);
        return;
    }
    if !view.heading.is_empty() {
        let little = view.standing == PatchStanding::LowThickening;
        let colour = if view.rows.is_empty() || little {
            colours(ui).strong
        } else {
            colours(ui).selection
        };
        ui.add(egui::Label::new(medium(view.heading).color(colour)).wrap());
        ui.add(egui::Label::new(note(view.note)).wrap());
    }
    match view.state {
        WallState::Computing { fraction } => {
            let words = if view.heading.is_empty() {
                "Measuring wall thickness"
            } else {
                "Results of the previous thresholds"
            };
            ui.label(note(words));
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, *fraction, "Measuring wall thickness");
        }
        WallState::Stopped => {
            ui.label(note("Stopped"));
            if ui.button("Measure again").clicked() {
                commands.push(Command::Work(WorkCommand::Retry(
                    Topic::of::<WallThickening>(),
                )));
            }
        }
        _ => {}
    }
    if !view.rows.is_empty() {
        ui.add_space(space::SMALL);
        table::table_ui(ui, view.rows, view.standing, commands);
    }
    ui.add_space(space::MEDIUM);
}
