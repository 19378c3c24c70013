//! Settings of the metric and the maps, each with its explanation, and their reset.

mod deformation_settings;
mod metric_settings;
mod pose_settings;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub mod words;

mod rows;
mod values;

use rows::{choice_row_ui, heading_ui, sentence_ui};
pub use values::MetricPanelView;

use egui::{Margin, ScrollArea, Ui};

use crate::analysis::deformations::DeformationMapParams;
use crate::engine::PoseMapParams;
use crate::panes::commands::{Command, MapCommand};
use crate::ui::controls::empty_pane_ui;
use crate::ui::theme::space;

/// Draws all settings; each change is one command.
pub fn metric_panel_ui(ui: &mut Ui, view: &MetricPanelView, commands: &mut Vec<Command>) {
    if view.subjects.is_empty() {
        empty_pane_ui(
            ui,
            "No study open",
            "The metric and the maps are set here",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("metric panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            egui::Frame::new()
                .inner_margin(Margin::symmetric(space::LARGE as i8, space::MEDIUM as i8))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 2.0;
                    settings_ui(ui, view, commands);
                });
        });
}

fn settings_ui(ui: &mut Ui, view: &MetricPanelView, commands: &mut Vec<Command>) {
    let mut poses = None;
    heading_ui(ui, "Metric");
    poses = metric_settings::metric_ui(ui, view).or(poses);
    heading_ui(ui, "Weights");
    poses = metric_settings::weights_ui(ui, view).or(poses);
    heading_ui(ui, "Pose map");
    poses = pose_settings::pose_map_ui(ui, view).or(poses);
    heading_ui(ui, "Deformation map");
    let deformations = deformation_settings::deformation_map_ui(ui, view);
    commands.extend(
        poses
            .filter(|poses| *poses != view.poses)
            .map(|value| Command::Map(MapCommand::SetPoseMap(value))),
    );
    commands.extend(
        deformations
            .filter(|deformations| *deformations != view.deformations)
            .map(|value| Command::Map(MapCommand::SetDeformationMap(value))),
    );
    ui.add_space(space::LARGE);
    let default = view.poses == PoseMapParams::default()
        && view.deformations == DeformationMapParams::default();
    let reset = egui::Button::new("Reset to defaults");
    if ui.add_enabled(!default, reset).clicked() {
        commands.push(Command::Map(MapCommand::ResetMaps));
    }
}
