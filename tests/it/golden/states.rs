//! Panes and sheets in states that the built-in cohort does not bring about, from views made by hand.

use std::time::Duration;

use cardiomorph::app::*;
use cardiomorph::document::ErrorCard;
use cardiomorph::engine::{Activity, ActivityState, PoseMapQuery, Topic};
use cardiomorph::panes::*;
use cardiomorph::study::Notice;
use cardiomorph::ui::*;
use egui::{Ui, pos2};
use egui_kittest::Harness;

use super::{compare, on_reference_driver};
use crate::panels::example::Example;
use crate::panels::window::pane;

pub const NAMES: [&str; 15] = [
    "about",
    "activity",
    "deformations_few",
    "empty",
    "error_card",
    "files_above",
    "load_report",
    "map_computing",
    "map_empty",
    "map_failed",
    "map_hover",
    "no_match",
    "palette",
    "shortcuts",
    "thickness",
];

/// What lies over the window, on an empty one.
fn over_ui(ui: &mut Ui, name: &str, example: &Example, commands: &mut Vec<Command>) {
    let whole = ui.ctx().content_rect();
    ui.set_clip_rect(whole);
    ui.painter()
        .rect_filled(whole, 0.0, theme::colours(ui).window);
    match name {
        "palette" => {
            let view = CommandPaletteView {
                actions: &example.actions(),
                subjects: &example.rows,
            };
            command_palette_ui(ui, &view, commands);
        }
        "shortcuts" => shortcut_sheet_ui(ui, commands),
        "load_report" => {
            let subjects = [
                ReportSubject {
                    id: "P-041".to_owned(),
                    summary: "8 frames · endo + epi · 2562 vertices · mm".to_owned(),
                    notices: vec![Notice::info(
                        "end-diastole found at the greatest volume, frame 1",
                    )],
                    error: None,
                },
                ReportSubject {
                    id: "P-042".to_owned(),
                    summary: "25 frames · cavity · 900 vertices · unit not said".to_owned(),
                    notices: vec![
                        Notice::info("times are not said: frames share the beat evenly"),
                        Notice::warning("endo, frames 3–7: 2 degenerate triangles"),
                    ],
                    error: None,
                },
                ReportSubject {
                    id: "broken.obj".to_owned(),
                    error: Some(
                        "line 812: face refers to vertex 9041, but only 9000 are defined"
                            .to_owned(),
                    ),
                    ..Default::default()
                },
            ];
            load_report_ui(ui, &subjects, commands);
        }
        "error_card" => {
            let cards = [ErrorCard {
                title: "1 of 24 files could not be read".to_owned(),
                message: "line 812: face refers to vertex 9041, but only 9000 are defined"
                    .to_owned(),
                details: "p12/endo_03.obj".to_owned(),
                retry: Some(Topic::OPENING),
            }];
            error_cards_ui(ui, &cards, commands);
        }
        _ => about_ui(ui, "llvmpipe", commands),
    }
}

/// A panel alone, in a state that the window above does not show.
fn state_ui(ui: &mut Ui, name: &str, example: &Example, commands: &mut Vec<Command>) {
    let whole = ui.ctx().content_rect();
    ui.set_clip_rect(whole);
    pane(ui, whole.shrink(2.0), |ui| match name {
        "map_hover" | "map_computing" | "map_failed" | "map_empty" => {
            let state = match name {
                "map_computing" => WorkState::Computing {
                    fraction: 0.42,
                    phase: String::new(),
                    seconds_left: Some(12.0),
                },
                "map_failed" => {
                    WorkState::Failed("no two subjects have corresponding vertices".to_owned())
                }
                "map_empty" => WorkState::Empty,
                _ => WorkState::Ready,
            };
            let mut view = example.map(state);
            if name == "map_empty" {
                view.points = &[];
            }
            named_header_ui(ui, "Poses", |ui| {
                pose_map_choosers_ui(ui, PoseMapQuery::default(), 56.0, commands);
            });
            scatter_map_ui(ui, &view, 0.0, commands);
        }
        "deformations_few" => {
            let too_few = "A deformation map needs at least 4 subjects, and there are 3";
            let mut view = example.deformation_map(WorkState::Unanswerable(too_few.to_owned()));
            view.map.points = &[];
            pane_header_ui(
                ui,
                |ui| {
                    tab_ui(ui, "Poses", false);
                    tab_ui(ui, "Deformations", true);
                    tab_ui(ui, "3D plot", false);
                },
                |ui| deformation_note(ui, &view, 200.0),
            );
            deformation_map_ui(ui, &view, commands);
        }
        "activity" => {
            let item = |name: &str, parameters: &str, seconds, state| Activity {
                number: 0,
                topic: Topic::of::<PoseMapQuery>(),
                name: name.to_owned(),
                parameters: parameters.to_owned(),
                asked_ago: Duration::from_secs_f64(seconds),
                duration: Duration::from_secs_f64(seconds),
                state,
            };
            let running = ActivityState::Running {
                fraction: 0.71,
                phase: "",
                time_left: Some(Duration::from_secs_f64(3.2)),
            };
            let items = [
                item(
                    "Pose map",
                    "quasi-conformal · additive · SMACOF · 184 poses",
                    2.4,
                    running,
                ),
                item("Measures", "23 subjects", 0.08, ActivityState::Done),
                item(
                    "Reading",
                    "acdc_walls/study.toml",
                    12.3,
                    ActivityState::Failed("no such folder".to_owned()),
                ),
                item("Pose map", "rigid · MDS", 0.9, ActivityState::Stopped),
            ];
            activity_ui(ui, &items, commands);
        }
        "empty" => empty_state_ui(ui, &EmptyStateView::default(), commands),
        "files_above" => {
            let view = EmptyStateView {
                files_hover: true,
                opening: false,
            };
            empty_state_ui(ui, &view, commands);
        }
        "thickness" => {
            let view = ThicknessPanelView {
                subject: Some("P-050"),
                state: WorkState::Ready,
                moment: "ES".to_owned(),
                unit: "mm",
                rows: thickness_rows().to_vec(),
                max: 16.0,
            };
            thickness_panel_ui(ui, &view, commands);
        }
        _ => {
            let view = CohortView {
                rows: &example.rows,
                visible: &[],
                search: "xyz",
                sort: None,
                selected: None,
                compared: None,
                measuring: true,
                classifying: true,
                ..CohortView::default()
            };
            cohort_table_ui(ui, &view, commands);
        }
    });
}

fn thickness_rows() -> [ThicknessRow; 3] {
    let strip = |moment: &str, median: f64| ThicknessStrip {
        moment: moment.to_owned(),
        on_screen: moment == "ES",
        quantiles: [-3.0, -1.0, 0.0, 1.0, 3.5].map(|offset| median + offset),
    };
    [
        ThicknessRow {
            name: "Medial spheres".to_owned(),
            strips: vec![strip("ED", 9.0), strip("ES", 12.0)],
            reference: true,
            seconds: Some(0.02),
            ..ThicknessRow::default()
        },
        ThicknessRow {
            name: "Laplace field lines".to_owned(),
            strips: vec![strip("ED", 9.2), strip("ES", 12.3)],
            difference: Some(Difference {
                bias: 0.31,
                deviation: 0.2,
                pairs: 800,
            }),
            seconds: Some(0.5),
            ..ThicknessRow::default()
        },
        ThicknessRow {
            name: "Centreline in slices".to_owned(),
            reason: Some("no landmarks".to_owned()),
            ..ThicknessRow::default()
        },
    ]
}

type Draw = fn(&mut Ui, &str, &Example, &mut Vec<Command>);

fn compare_states(draw: Draw, dark: bool, states: &[(&str, [f32; 2])]) {
    if !on_reference_driver() {
        return;
    }
    for &(name, size) in states {
        let example = Example::new();
        let mut harness = Harness::builder()
            .with_size(size)
            .with_theme(egui::Theme::from_dark_mode(dark))
            .with_context_setup(install)
            .wgpu()
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| draw(ui, name, &example, commands),
                Vec::new(),
            );
        harness.run();
        if name == "map_hover" {
            // The end-systole of the last subject, up on the right.
            harness.hover_at(pos2(347.0, 92.0));
            harness.run_steps(40);
        }
        compare(&harness.render().unwrap(), &format!("states/{name}"));
    }
}

#[test]
fn states_of_maps_look_as_they_did() {
    compare_states(
        state_ui,
        true,
        &[
            ("map_computing", [360.0, 280.0]),
            ("map_failed", [360.0, 280.0]),
            ("map_empty", [360.0, 280.0]),
            ("map_hover", [400.0, 330.0]),
            ("deformations_few", [360.0, 280.0]),
        ],
    );
}

#[test]
fn states_of_other_panes_look_as_they_did() {
    compare_states(
        state_ui,
        false,
        &[
            ("activity", [360.0, 240.0]),
            ("empty", [400.0, 300.0]),
            ("files_above", [400.0, 300.0]),
            ("no_match", [300.0, 240.0]),
            ("thickness", [320.0, 280.0]),
        ],
    );
}

#[test]
fn what_lies_over_the_window_looks_as_it_did() {
    compare_states(
        over_ui,
        true,
        &[
            ("about", [480.0, 360.0]),
            ("error_card", [480.0, 160.0]),
            ("load_report", [640.0, 400.0]),
            ("palette", [640.0, 400.0]),
            ("shortcuts", [640.0, 480.0]),
        ],
    );
}
