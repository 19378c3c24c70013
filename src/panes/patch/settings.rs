//! The thresholds of patches as sliders in log scale, with the estimated noise.

use std::ops::RangeInclusive;

use egui::{Slider, Ui};

use crate::analysis::thickening::ThickeningParams;
use crate::engine::ThickeningSettings;
use crate::panes::commands::{Command, WallCommand};
use crate::panes::patch::PatchPanelView;
use crate::ui::style::{medium, note};
use crate::ui::theme::space;

/// Extent threshold: share of remote thickening below which a patch extends, in percent.
const BORDERS: RangeInclusive<f64> = 5.0..=90.0;
/// Deviation of PT from one up to which an atom is akinetic, in percent.
const TOLERANCES: RangeInclusive<f64> = 1.0..=50.0;

/// Draws the sliders; every change is one command, and a drag one step of undo.
pub(super) fn settings_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    ui.label(medium("Thresholds"));
    let now = view.settings.thickening;
    let mut wanted = now;
    let mut border = 100.0 * now.border;
    let what = "Thickening relative to remote myocardium below which tissue belongs to a patch; its core is \
                below half of this";
    if slider_ui(ui, "Extent threshold", &mut border, BORDERS, what) {
        wanted = with_border(now, 0.01 * border);
    }
    ui.add(egui::Label::new(note(border_note(view.well, now.border))).wrap());
    let in_force = now.tolerance.or(view.tolerance);
    let mut tolerance = 100.0 * in_force.map_or(0.05, |ln| ln.exp() - 1.0);
    let what = "An atom is akinetic if the thickness ratio PT of two successive frames deviates from 1 \
                by no more than this; the average normal vector (ANV) and the mean position (MP) \
                are those of akinetic atoms";
    if slider_ui(ui, "PT tolerance", &mut tolerance, TOLERANCES, what) {
        wanted.tolerance = Some((0.01 * tolerance).ln_1p());
    }
    ui.add(egui::Label::new(note(tolerance_note(view, now.tolerance))).wrap());
    if wanted != now {
        commands.push(Command::Wall(WallCommand::SetThickening(
            ThickeningSettings {
                thickening: wanted,
                ..view.settings
            },
        )));
    }
    ui.add_space(space::MEDIUM);
    let default = view.settings == ThickeningSettings::default();
    let reset = egui::Button::new("Reset to defaults");
    if ui.add_enabled(!default, reset).clicked() {
        commands.push(Command::Wall(WallCommand::ResetThickening));
    }
}

/// The core keeps its share of the border, so that one slider moves both.
fn with_border(now: ThickeningParams, border: f64) -> ThickeningParams {
    let default = ThickeningParams::default();
    ThickeningParams {
        border,
        core: border * default.core / default.border,
        ..now
    }
}

fn slider_ui(
    ui: &mut Ui,
    name: &str,
    value: &mut f64,
    range: RangeInclusive<f64>,
    what: &str,
) -> bool {
    ui.add_space(space::SMALL);
    let label = ui.label(name);
    // The slider rounds what it shows; only what a person does is a change.
    let before = value.round();
    let mut shown = before;
    ui.spacing_mut().slider_width = (ui.available_width() - 64.0).clamp(60.0, 240.0);
    let slider = Slider::new(&mut shown, range)
        .logarithmic(true)
        .smart_aim(false)
        .fixed_decimals(0)
        .suffix(" %");
    ui.add(slider).labelled_by(label.id).on_hover_text(what);
    let changed = shown != before;
    if changed {
        *value = shown;
    }
    changed
}

fn border_note(well: Option<f64>, border: f64) -> String {
    match well {
        Some(well) => format!(
            "relative to remote thickening ({:.0} %): thickening below {:.0} %",
            100.0 * well,
            100.0 * ((border * well.ln_1p()).exp() - 1.0)
        ),
        None => "relative to remote thickening".to_owned(),
    }
}

fn tolerance_note(view: &PatchPanelView, typed: Option<f64>) -> String {
    let noise = view.noise.map_or_else(String::new, |noise| {
        format!("noise SD of the radius {:.1} %", 100.0 * noise.exp_m1())
    });
    let source = if typed.is_some() {
        "set by the user"
    } else {
        "estimated from noise"
    };
    if noise.is_empty() {
        source.to_owned()
    } else {
        format!("{source} · {noise}")
    }
}
