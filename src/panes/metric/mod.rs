//! Settings of the metric and the maps, each with its explanation, and their reset.

pub(crate) mod choices;
mod deformation_settings;
mod metric_settings;
mod pose_settings;
mod rows;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
mod values;
pub(crate) mod words;

use rows::{choice_row_ui, heading_ui, sentence_ui};
pub use values::MetricPanelView;

use egui::{Margin, Ui};

use crate::analysis::deformations::DeformationMapParams;
use crate::engine::PoseMapQuery;
use crate::panes::commands::{Command, MapCommand};
use crate::ui::controls::{empty_pane_ui, scrolled_ui};
use crate::ui::theme::space;

/// Draws all settings; each change is one command.
pub fn metric_panel_ui(ui: &mut Ui, view: &MetricPanelView, commands: &mut Vec<Command>) {
    if view.subjects.is_empty() {
        let what = "The metric and the maps are set here";
        return empty_pane_ui(ui, "No study open", what, |_| {});
    }
    let margin = Margin::symmetric(space::LARGE as i8, space::MEDIUM as i8);
    scrolled_ui(ui, "metric panel", margin, |ui| {
        settings_ui(ui, view, commands);
    });
}

fn settings_ui(ui: &mut Ui, view: &MetricPanelView, commands: &mut Vec<Command>) {
    let (mut poses, mut deformations) = (view.poses, view.deformations);
    heading_ui(ui, "Metric");
    metric_settings::metric_ui(ui, &mut poses);
    heading_ui(ui, "Weights");
    metric_settings::weights_ui(ui, &mut poses);
    if let Some(shares) = &view.shares {
        sentence_ui(ui, shares);
    }
    heading_ui(ui, "Pose map");
    pose_settings::pose_map_ui(ui, view, &mut poses);
    heading_ui(ui, "Deformation map");
    deformation_settings::deformation_map_ui(ui, view, &mut deformations);
    if poses != view.poses {
        commands.push(MapCommand::SetPoseMap(poses).into());
    }
    if deformations != view.deformations {
        commands.push(MapCommand::SetDeformationMap(deformations).into());
    }
    ui.add_space(space::LARGE);
    let default = view.poses == PoseMapQuery::default()
        && view.deformations == DeformationMapParams::default();
    let reset = egui::Button::new("Reset to defaults");
    if ui.add_enabled(!default, reset).clicked() {
        commands.push(MapCommand::ResetMaps.into());
    }
}
