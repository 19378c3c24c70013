//! The strip above the map: how poses are compared and mapped, and how well the map keeps distances.

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::{Corners, Form, MetricKind};
use crate::engine::PoseMapParams;
use crate::ui::command::Command;
use crate::ui::controls::{choice_ui, chooser_ui, pane_header_ui};
use crate::ui::pose_map::PoseMapView;
use crate::ui::style::{medium, note};

/// Draws the name of the pane, the choosers and the stress.
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

/// Draws the choosers of metric and method, and the stress, from right to left: for a header that
/// has its own title. A narrow strip keeps only one chooser.
pub fn pose_map_choosers_ui(
    ui: &mut Ui,
    view: &PoseMapView,
    wide: bool,
    commands: &mut Vec<Command>,
) {
    if let Some(stress) = view.stress
        && wide
    {
        ui.label(note(format!("stress {stress:.2}"))).on_hover_text(
            "Kruskal's stress 1: how far distances on the map are from those between poses. \
                     Below 0.1 is good, above 0.2 the map misleads.",
        );
    }
    if wide {
        method_ui(ui, view.params, commands);
    }
    metric_ui(ui, view.params, !wide, commands);
}

fn method_ui(ui: &mut Ui, params: PoseMapParams, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Method", method_name(params.method), |ui| {
        methods_ui(ui, params, commands);
    });
}

fn methods_ui(ui: &mut Ui, params: PoseMapParams, commands: &mut Vec<Command>) {
    for method in [MapMethod::ClassicalMds, MapMethod::Smacof] {
        if choice_ui(ui, method_name(method), params.method == method) {
            commands.push(Command::SetPoseMap(PoseMapParams { method, ..params }));
        }
    }
}

/// The metric and its form; in a narrow pane the method, too.
fn metric_ui(ui: &mut Ui, params: PoseMapParams, with_method: bool, commands: &mut Vec<Command>) {
    let mut wanted = params;
    let metric = &mut wanted.distances.metric;
    chooser_ui(ui, "Metric", metric_name(metric.kind), |ui| {
        ui.label(note("Metric"));
        for kind in [
            MetricKind::QuasiConformal,
            MetricKind::AnglePreserving,
            MetricKind::Isometric,
            MetricKind::Rigid,
        ] {
            if choice_ui(ui, metric_name(kind), metric.kind == kind) {
                metric.kind = kind;
            }
        }
        let has_forms = matches!(
            metric.kind,
            MetricKind::QuasiConformal | MetricKind::AnglePreserving
        );
        ui.separator();
        ui.label(note("Form"));
        ui.add_enabled_ui(has_forms, |ui| {
            for form in [Form::Additive, Form::Bilinear, Form::Frozen, Form::Printed] {
                if choice_ui(ui, form_name(form), metric.form == form) {
                    metric.form = form;
                }
            }
        });
        ui.separator();
        let mut scale_free = metric.corners == Corners::ScaleFree;
        if ui
            .checkbox(&mut scale_free, "Size does not matter")
            .clicked()
        {
            metric.corners = if scale_free {
                Corners::ScaleFree
            } else {
                Corners::Raw
            };
        }
        ui.checkbox(&mut metric.area_weights, "Count by area");
        if with_method {
            ui.separator();
            ui.label(note("Method"));
            methods_ui(ui, params, commands);
        }
    });
    if wanted != params {
        commands.push(Command::SetPoseMap(wanted));
    }
}

fn method_name(method: MapMethod) -> &'static str {
    match method {
        MapMethod::ClassicalMds => "MDS",
        MapMethod::Smacof => "SMACOF",
        MapMethod::Isomap { .. } => "Isomap",
    }
}

fn metric_name(kind: MetricKind) -> &'static str {
    match kind {
        MetricKind::Isometric => "Isometric",
        MetricKind::Rigid => "Rigid",
        MetricKind::AnglePreserving => "Angle-preserving",
        MetricKind::QuasiConformal => "Quasi-conformal",
    }
}

fn form_name(form: Form) -> &'static str {
    match form {
        Form::Printed => "As printed",
        Form::Bilinear => "Bilinear",
        Form::Frozen => "Frozen weights",
        Form::Additive => "Additive",
    }
}
