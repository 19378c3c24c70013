//! Wall thickness by each method: box strips on one axis, and differences from the medial spheres.

pub(crate) mod spec;
mod strips;
#[cfg(test)]
mod tests;
pub(crate) mod view;

use egui::{Margin, ScrollArea, Ui};

use crate::engine::{PoseThickness, Topic};
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::note;
use crate::ui::theme::space;

/// State of the measurement.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ThicknessState {
    /// No subject is selected.
    #[default]
    Empty,
    /// Everything on screen is measured.
    Ready,
    /// A pose is being measured.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// Which pose: "ED", "frame 3".
        moment: String,
    },
    /// The user stopped it.
    Stopped,
    /// Nothing can be measured, and why.
    Failed(String),
}

/// Thickness at one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct ThicknessStrip {
    /// "ED", "ES", "frame 3".
    pub moment: String,
    /// Whether it is the pose on screen.
    pub on_screen: bool,
    /// 5, 25, 50, 75 and 95 % of vertices are thinner than these, in the unit of the view.
    pub quantiles: [f64; 5],
}

/// Difference of a method from twice the medial radius at the pose on screen, in the unit of the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Mean difference.
    pub bias: f64,
    /// Standard deviation of the differences.
    pub deviation: f64,
    /// Vertices compared.
    pub pairs: usize,
}

/// One method.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThicknessRow {
    /// "Laplace field lines".
    pub name: String,
    /// What it measures.
    pub hint: &'static str,
    /// By pose; empty while nothing is known.
    pub strips: Vec<ThicknessStrip>,
    /// Against the medial radius; `None` for that itself, and while not known.
    pub difference: Option<Difference>,
    /// Whether the others are compared with it.
    pub reference: bool,
    /// Time for one pose.
    pub seconds: Option<f64>,
    /// Why it does not apply at a pose.
    pub reason: Option<String>,
}

/// What the pane shows.
#[derive(Clone, Debug)]
pub struct ThicknessPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of the measurement.
    pub state: &'a ThicknessState,
    /// The pose that differences are of: "ES", "frame 3".
    pub moment: &'a str,
    /// Unit of lengths.
    pub unit: &'a str,
    /// The methods, medial spheres first.
    pub rows: &'a [ThicknessRow],
    /// Upper end of the axis; it begins at 0.
    pub max: f64,
}

/// Draws the pane.
pub fn thickness_panel_ui(ui: &mut Ui, view: &ThicknessPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to measure its wall thickness by five methods",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("thickness panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            let margin = Margin::symmetric(space::LARGE as i8, space::SMALL as i8);
            egui::Frame::new().inner_margin(margin).show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 2.0;
                state_ui(ui, view, commands);
                if view.rows.iter().any(|row| !row.strips.is_empty()) {
                    strips::axis_ui(ui, view);
                }
                for row in view.rows {
                    strips::row_ui(ui, view, row);
                }
                if !view.rows.is_empty() {
                    ui.add(egui::Label::new(note(footnote(view))).wrap());
                }
            });
        });
}

fn footnote(view: &ThicknessPanelView) -> String {
    format!(
        "Median (5–95 % of vertices) in {}; right: mean difference from medial spheres ± standard \
         deviation at {}",
        view.unit, view.moment
    )
}

fn state_ui(ui: &mut Ui, view: &ThicknessPanelView, commands: &mut Vec<Command>) {
    match view.state {
        ThicknessState::Computing { fraction, moment } => {
            ui.horizontal(|ui| {
                let width = (ui.available_width() - 130.0).clamp(30.0, 120.0);
                progress_bar_ui(ui, width, *fraction, "Measuring wall thickness");
                ui.label(note(format!("{moment}, {:.0} %", 100.0 * fraction)));
                if ui.button(note("Cancel")).clicked() {
                    commands.push(Command::Work(WorkCommand::Cancel(
                        Topic::of::<PoseThickness>(),
                    )));
                }
            });
        }
        ThicknessState::Stopped => {
            ui.horizontal(|ui| {
                ui.label(note("Stopped"));
                if ui.button(note("Measure")).clicked() {
                    commands.push(Command::Work(WorkCommand::Retry(
                        Topic::of::<PoseThickness>(),
                    )));
                }
            });
        }
        ThicknessState::Failed(why) => {
            ui.add(egui::Label::new(note(why)).wrap());
        }
        ThicknessState::Empty | ThicknessState::Ready => {}
    }
}
