//! The strip above the map: how poses are compared and mapped, with the way to all settings.

use egui::Ui;

use crate::analysis::metrics::Corners;
use crate::engine::PoseMapParams;
use crate::panes::commands::{Command, MapCommand, Pane, WindowCommand};
use crate::panes::metric::words::{
    FORMS, METRICS, form_name, has_forms, method_name, metric_name, metric_sentence,
};
use crate::panes::scatter_map::method_choices_ui;
use crate::ui::controls::{choice_ui, chooser_ui, pane_header_ui};
use crate::ui::style::{medium, note};

use super::map::PoseMapView;

/// Draws the name of the pane and the choosers.
pub fn pose_map_header_ui(ui: &mut Ui, view: &PoseMapView, commands: &mut Vec<Command>) {
    let wide = ui.available_width() > 330.0;
    pane_header_ui(
        ui,
        |ui| {
            ui.add(egui::Label::new(medium("Poses")).truncate());
        },
        |ui| pose_map_choosers_ui(ui, view, wide, commands),
    );
}

/// Draws the choosers of metric and method from right to left, for a header that has its own title.
/// A narrow strip keeps only one chooser.
pub fn pose_map_choosers_ui(
    ui: &mut Ui,
    view: &PoseMapView,
    wide: bool,
    commands: &mut Vec<Command>,
) {
    if wide {
        let params = view.params;
        chooser_ui(ui, "Method", method_name(params.method), |ui| {
            methods_ui(ui, params, commands);
        });
    }
    metric_ui(ui, view.params, !wide, commands);
}

fn methods_ui(ui: &mut Ui, params: PoseMapParams, commands: &mut Vec<Command>) {
    if let Some(method) = method_choices_ui(ui, params.method) {
        commands.push(Command::Map(MapCommand::SetPoseMap(PoseMapParams {
            method,
            ..params
        })));
    }
}

/// The metric and its form; in a narrow pane the method, too.
fn metric_ui(ui: &mut Ui, params: PoseMapParams, with_method: bool, commands: &mut Vec<Command>) {
    let mut wanted = params;
    let metric = &mut wanted.distances.metric;
    let response = chooser_ui(ui, "Metric", metric_name(metric.kind), |ui| {
        ui.label(note("Metric"));
        for kind in METRICS {
            if choice_ui(ui, metric_name(kind), metric.kind == kind) {
                metric.kind = kind;
            }
        }
        ui.separator();
        ui.label(note("Form"));
        ui.add_enabled_ui(has_forms(metric.kind), |ui| {
            for form in FORMS {
                if choice_ui(ui, form_name(form), metric.form == form) {
                    metric.form = form;
                }
            }
        });
        ui.separator();
        let mut scale_free = metric.corners == Corners::ScaleFree;
        if ui.checkbox(&mut scale_free, "Scale-invariant").clicked() {
            metric.corners = if scale_free {
                Corners::ScaleFree
            } else {
                Corners::Raw
            };
        }
        ui.checkbox(&mut metric.area_weights, "Area-weighted");
        if with_method {
            ui.separator();
            ui.label(note("Method"));
            methods_ui(ui, params, commands);
        }
        ui.separator();
        if ui.button("All settings…").clicked() {
            commands.push(Command::Window(WindowCommand::ShowPane(Pane::METRIC)));
            ui.close();
        }
    });
    response.on_hover_text(metric_sentence(&params.distances.metric));
    if wanted != params {
        commands.push(Command::Map(MapCommand::SetPoseMap(wanted)));
    }
}
