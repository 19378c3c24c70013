//! Settings of the metric and the maps, each with its explanation, and their reset.

mod deformation_settings;
mod metric_settings;
mod pose_settings;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub mod words;

use egui::{Margin, ScrollArea, Ui};

use crate::analysis::deformations::DeformationMapParams;
use crate::engine::PoseMapParams;
use crate::panes::commands::{Command, MapCommand};
use crate::panes::scatter_map::MapSubject;
use crate::ui::controls::{chooser_ui, empty_pane_ui};
use crate::ui::number_field::row_ui;
use crate::ui::style::{medium, note};
use crate::ui::theme::space;

/// What the panel shows.
#[derive(Clone, Debug)]
pub struct MetricPanelView<'a> {
    /// How poses are compared and mapped.
    pub poses: PoseMapParams,
    /// How deformations are mapped.
    pub deformations: DeformationMapParams,
    /// All subjects of the study: one may be the reference.
    pub subjects: &'a [MapSubject],
    /// The selected subject: first among the references.
    pub selected: Option<usize>,
    /// The neighbours that the map of deformations has now.
    pub neighbours: Option<usize>,
    /// The weight of time that the map of deformations has now.
    pub time_weight: Option<f64>,
}

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
    heading_ui(ui, "Map of poses");
    poses = pose_settings::pose_map_ui(ui, view).or(poses);
    heading_ui(ui, "Map of deformations");
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

fn heading_ui(ui: &mut Ui, name: &str) {
    ui.add_space(space::MEDIUM);
    ui.label(medium(name));
}

/// A sentence below a control, over the whole width.
fn sentence_ui(ui: &mut Ui, text: &str) {
    ui.add(egui::Label::new(note(text)).wrap());
    ui.add_space(space::SMALL);
}

/// A name with a menu of choices behind it.
fn choice_row_ui(
    ui: &mut Ui,
    name: &str,
    what: &str,
    shown: &str,
    enabled: bool,
    menu: impl FnOnce(&mut Ui),
) {
    row_ui(ui, name, what, enabled, |ui| {
        // The name of what is chosen among is read from the row.
        let font = crate::ui::style::text_font();
        let galley = ui
            .painter()
            .layout_no_wrap(name.to_owned(), font, egui::Color32::PLACEHOLDER);
        let widest = (ui.available_width() - galley.size().x - space::LARGE).max(60.0);
        ui.scope(|ui| {
            ui.set_max_width(widest);
            chooser_ui(ui, name, shown, menu);
        });
    });
}
