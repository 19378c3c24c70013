//! The strip above the map: how poses are compared and mapped, with the way to all settings.

use egui::Ui;

use crate::engine::PoseMapQuery;
use crate::panes::commands::{Command, MapCommand, Pane, WindowCommand};
use crate::panes::metric::choices::{forms_ui, kinds_ui, scale_free_ui};
use crate::panes::metric::words::{method_name, metric_sentence};
use crate::panes::scatter_map::method_choices_ui;
use crate::ui::controls::chooser_ui;
use crate::ui::style::note;

/// Draws the choosers of metric and method from right to left, beside a title or tabs that take `taken` points. A narrow
/// strip keeps only one chooser.
pub fn pose_map_choosers_ui(
    ui: &mut Ui,
    params: PoseMapQuery,
    taken: f32,
    commands: &mut Vec<Command>,
) {
    let room = ui.available_width() - taken;
    let wide = room > 250.0;
    if room <= 90.0 {
        return;
    }
    if wide {
        chooser_ui(ui, "Method", method_name(params.method), |ui| {
            methods_ui(ui, params, commands);
        });
    }
    metric_ui(ui, params, !wide, commands);
}

fn methods_ui(ui: &mut Ui, params: PoseMapQuery, commands: &mut Vec<Command>) {
    if let Some(method) = method_choices_ui(ui, params.method) {
        commands.push(MapCommand::SetPoseMap(PoseMapQuery { method, ..params }).into());
    }
}

/// The metric and its form; in a narrow pane the method, too.
fn metric_ui(ui: &mut Ui, params: PoseMapQuery, with_method: bool, commands: &mut Vec<Command>) {
    let mut wanted = params;
    let metric = &mut wanted.distances.metric;
    let response = chooser_ui(ui, "Metric", metric.kind.words().name, |ui| {
        ui.label(note("Metric"));
        kinds_ui(ui, metric);
        ui.separator();
        ui.label(note("Form"));
        ui.add_enabled_ui(metric.kind.has_forms(), |ui| forms_ui(ui, metric));
        ui.separator();
        scale_free_ui(ui, metric);
        ui.checkbox(&mut metric.area_weights, "Area-weighted");
        if with_method {
            ui.separator();
            ui.label(note("Method"));
            methods_ui(ui, params, commands);
        }
        ui.separator();
        if ui.button("All settings…").clicked() {
            commands.push(WindowCommand::ShowPane(Pane::METRIC).into());
            ui.close();
        }
    });
    response.on_hover_text(metric_sentence(&params.distances.metric));
    if wanted != params {
        commands.push(MapCommand::SetPoseMap(wanted).into());
    }
}
