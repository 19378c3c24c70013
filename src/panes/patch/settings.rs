//! The thresholds of patches as sliders in log scale, with the estimated noise.

use std::ops::RangeInclusive;

use egui::{Slider, Ui};

use crate::analysis::thickening::{ThickeningParams, ThickeningSettings};
use crate::panes::commands::{Command, WallCommand};
use crate::panes::patch::PatchPanelView;
use crate::ui::number_field::number_words;
use crate::ui::style::{medium, note};
use crate::ui::theme::space;

/// Extent threshold: share of remote thickening below which a patch extends, in percent.
const EXTENTS: RangeInclusive<f64> = 5.0..=90.0;
/// Deviation of PT from one up to which an atom is akinetic, in percent.
const TOLERANCES: RangeInclusive<f64> = 1.0..=50.0;

/// Draws the sliders; every change is one command, and a drag one step of undo.
pub(super) fn settings_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    ui.label(medium("Thresholds"));
    let now = view.settings.patches;
    let mut wanted = now;
    let mut extent = 100.0 * now.extent_threshold;
    let what = "Thickening relative to remote myocardium below which tissue belongs to a patch; its core is \
                below half of this";
    if slider_ui(ui, "Extent threshold", &mut extent, EXTENTS, what) {
        wanted = with_extent(now, 0.01 * extent);
    }
    ui.add(egui::Label::new(note(extent_note(view.remote, now.extent_threshold))).wrap());
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
        let settings = ThickeningSettings {
            patches: wanted,
            ..view.settings
        };
        commands.push(WallCommand::SetThickening(settings).into());
    }
    ui.add_space(space::MEDIUM);
    let default = view.settings == ThickeningSettings::default();
    let reset = egui::Button::new("Reset to defaults");
    if ui.add_enabled(!default, reset).clicked() {
        commands.push(WallCommand::ResetThickening.into());
    }
}

/// The core keeps its share of the extent, so that one slider moves both.
fn with_extent(now: ThickeningParams, extent: f64) -> ThickeningParams {
    let default = ThickeningParams::default();
    ThickeningParams {
        extent_threshold: extent,
        core_threshold: extent * default.core_threshold / default.extent_threshold,
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
    let ends = [*range.start(), *range.end()];
    let slider = Slider::new(&mut shown, range)
        .logarithmic(true)
        .smart_aim(false)
        .fixed_decimals(0)
        .suffix(" %");
    let (what, label) = (number_words(what, ends, "%"), label.id);
    ui.add(slider).labelled_by(label).on_hover_text(what);
    let changed = shown != before;
    if changed {
        *value = shown;
    }
    changed
}

fn extent_note(remote: Option<f64>, extent: f64) -> String {
    match remote {
        Some(remote) => format!(
            "relative to remote thickening ({:.0} %): thickening below {:.0} %",
            100.0 * remote,
            100.0 * ((extent * remote.ln_1p()).exp() - 1.0)
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
