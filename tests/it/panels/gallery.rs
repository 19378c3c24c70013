//! Panels as pictures, for the eye: written where `CARDIOMORPH_GALLERY` says.

use std::path::PathBuf;

use cardiomorph::engine::{PoseMapParams, Topic};
use cardiomorph::study::Notice;
use cardiomorph::ui::*;
use egui::{Ui, UiBuilder, pos2};
use egui_kittest::Harness;

use super::example::Example;
use super::window::{pane, rect, window};

/// What lies over the window in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Over {
    Nothing,
    Palette,
    Sheet,
    Report,
    Errors,
    About,
}

fn over_ui(ui: &mut Ui, over: Over, example: &Example, commands: &mut Vec<Command>) {
    match over {
        Over::Nothing => {}
        Over::Palette => {
            let view = CommandPaletteView {
                actions: &example.actions,
                subjects: &example.rows,
                selected: Some(9),
            };
            command_palette_ui(ui, &view, commands);
        }
        Over::Sheet => shortcut_sheet_ui(ui, commands),
        Over::Report => {
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
        Over::Errors => {
            let cards = [ErrorCard {
                title: "1 of 24 files could not be read".to_owned(),
                message: "line 812: face refers to vertex 9041, but only 9000 are defined"
                    .to_owned(),
                details: "p12/endo_03.obj".to_owned(),
                retry: Some(Topic::OPENING),
            }];
            let whole = ui.ctx().content_rect();
            let middle = rect(0.0, 0.0, whole.right(), whole.bottom() - 140.0);
            let mut over = ui.new_child(UiBuilder::new().max_rect(middle));
            error_cards_ui(&mut over, &cards, commands);
        }
        Over::About => about_ui(ui, "llvmpipe", commands),
    }
}

/// A panel alone, in a state that the window above does not show.
fn state_ui(ui: &mut Ui, name: &str, example: &Example, commands: &mut Vec<Command>) {
    let whole = ui.ctx().content_rect();
    ui.set_clip_rect(whole);
    pane(ui, whole.shrink(2.0), |ui| match name {
        "map_hover" | "map_computing" | "map_failed" | "map_empty" | "map_first" => {
            let state = match name {
                "map_computing" | "map_first" => MapState::Computing {
                    fraction: 0.42,
                    seconds_left: Some(12.0),
                },
                "map_failed" => {
                    MapState::Failed("no two subjects have corresponding vertices".to_owned())
                }
                "map_empty" => MapState::Empty,
                _ => MapState::Ready,
            };
            let mut view = example.map(state);
            if matches!(name, "map_first" | "map_empty") {
                view.map.points = &[];
            }
            pose_map_header_ui(ui, &view, commands);
            pose_map_ui(ui, &view, commands);
        }
        "deformations" | "deformations_computing" | "deformations_few" => {
            let state = match name {
                "deformations" => MapState::Ready,
                "deformations_few" => {
                    MapState::Unanswerable("Fewer than 4 subjects: no deformation map".to_owned())
                }
                _ => MapState::Computing {
                    fraction: 0.42,
                    seconds_left: Some(12.0),
                },
            };
            let mut view = example.deformation_map(state);
            if name == "deformations_few" {
                view.map.points = &[];
            }
            pane_header_ui(
                ui,
                |ui| {
                    tab_ui(ui, "Poses", false);
                    tab_ui(ui, "Deformations", true);
                    tab_ui(ui, "Spatiotemporal", false);
                },
                |ui| deformation_note(ui, &view, 200.0),
            );
            deformation_map_ui(ui, &view, commands);
        }
        "space_time" => space_time_ui(ui, &example.space_time(MapState::Ready), commands),
        "metric" => metric_panel_ui(ui, &example.metric(), commands),
        "activity" => {
            let item = |title: &str, parameters: &str, duration_s, state| WorkItem {
                kind: Topic::of::<PoseMapParams>(),
                title: title.to_owned(),
                parameters: parameters.to_owned(),
                duration_s,
                state,
            };
            let running = WorkState::Running {
                fraction: 0.71,
                seconds_left: Some(3.2),
            };
            let items = [
                item(
                    "Map of poses",
                    "quasi-conformal · additive · SMACOF · 184 poses",
                    2.4,
                    running,
                ),
                item("Measures", "23 subjects", 0.08, WorkState::Done),
                item(
                    "Reading",
                    "acdc_walls/study.toml",
                    12.3,
                    WorkState::Failed("no such folder".to_owned()),
                ),
                item("Map of poses", "rigid · MDS", 0.9, WorkState::Stopped),
            ];
            activity_ui(ui, &items, commands);
        }
        "empty" => empty_state_ui(ui, &EmptyStateView::default(), commands),
        "empty_hover" => {
            let view = EmptyStateView {
                files_hover: true,
                opening: false,
            };
            empty_state_ui(ui, &view, commands);
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
            };
            cohort_table_ui(ui, &view, commands);
        }
    });
}

/// Writes pictures of single panels where `CARDIOMORPH_GALLERY` says; for the eye.
#[test]
fn the_states_of_panels_are_drawn_where_it_is_asked_for() {
    let Some(folder) = std::env::var_os("CARDIOMORPH_GALLERY").map(PathBuf::from) else {
        println!("skipped: CARDIOMORPH_GALLERY names no folder");
        return;
    };
    let names = [
        "map_hover",
        "map_computing",
        "map_failed",
        "map_empty",
        "map_first",
        "deformations",
        "space_time",
        "metric",
        "deformations_computing",
        "deformations_few",
        "activity",
        "empty",
        "empty_hover",
        "no_match",
    ];
    for (index, name) in names.into_iter().enumerate() {
        let example = Example::new();
        let mut harness = Harness::builder()
            .with_size(match name {
                "metric" => [280.0, 640.0],
                "space_time" | "deformations" => [400.0, 420.0],
                _ => [400.0, 330.0],
            })
            .with_theme(egui::Theme::from_dark_mode(index % 2 == 0))
            .with_context_setup(install)
            .wgpu()
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| state_ui(ui, name, &example, commands),
                Vec::new(),
            );
        harness.run();
        if name == "map_hover" {
            // The end-systole of the last subject, up on the right.
            harness.hover_at(pos2(347.0, 92.0));
            harness.run_steps(40);
        }
        let path = folder.join(format!("state_{name}.png"));
        harness.render().unwrap().save(path).unwrap();
    }
}

/// Writes pictures of the whole window where `CARDIOMORPH_GALLERY` says; for the eye.
#[test]
fn the_gallery_is_drawn_where_it_is_asked_for() {
    let Some(folder) = std::env::var_os("CARDIOMORPH_GALLERY").map(PathBuf::from) else {
        println!("skipped: CARDIOMORPH_GALLERY names no folder");
        return;
    };
    let pictures = [
        ("window", 1600.0, 1000.0, 1.0, Over::Nothing),
        ("window_2x", 1600.0, 1000.0, 2.0, Over::Nothing),
        ("narrow", 900.0, 640.0, 1.0, Over::Nothing),
        ("palette", 1280.0, 800.0, 1.0, Over::Palette),
        ("sheet", 1280.0, 800.0, 1.0, Over::Sheet),
        ("report", 1280.0, 800.0, 1.0, Over::Report),
        ("errors", 1280.0, 800.0, 1.0, Over::Errors),
        ("about", 1280.0, 800.0, 1.0, Over::About),
    ];
    for dark in [true, false] {
        for (name, width, height, scale, over) in pictures {
            let example = Example::new();
            let mut harness = Harness::builder()
                .with_size([width, height])
                .with_pixels_per_point(scale)
                .with_theme(egui::Theme::from_dark_mode(dark))
                .with_context_setup(move |ctx| apply(ctx, dark))
                .wgpu()
                .build_ui_state(
                    |ui, commands: &mut Vec<Command>| {
                        window(ui, &example, commands);
                        over_ui(ui, over, &example, commands);
                    },
                    Vec::new(),
                );
            harness.run();
            let theme = if dark { "dark" } else { "light" };
            let path = folder.join(format!("{name}_{theme}.png"));
            harness.render().unwrap().save(path).unwrap();
        }
    }
}
