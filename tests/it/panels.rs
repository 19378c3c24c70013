//! Panels as pictures: the whole window laid out by hand, for the eye, and a few small goldens.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;
use std::sync::Arc;

use cardiomorph::engine::PoseMapParams;
use cardiomorph::picture::Quantity;
use cardiomorph::study::{LabelRole, Notice};
use cardiomorph::ui::theme::{colours, space};
use cardiomorph::ui::*;
use egui::{Frame, Margin, Rect, Stroke, Ui, UiBuilder, pos2, vec2};
use egui_kittest::Harness;

/// A cohort made up for pictures: ids, labels and numbers that look like a study's.
struct Example {
    rows: Vec<CohortRow>,
    subjects: Vec<MapSubject>,
    points: Vec<MapPoint>,
    volumes: Vec<f64>,
    outer: Vec<f64>,
    shares: Vec<f64>,
    actions: ActionState,
}

impl Example {
    fn new() -> Self {
        let groups = [
            ("NOR", LabelRole::Normal, 9, 0.62),
            ("MINF", LabelRole::Abnormal, 8, 0.36),
            ("DCM", LabelRole::Abnormal, 4, 0.22),
            ("RV", LabelRole::Unknown, 2, 0.55),
        ];
        let (mut rows, mut subjects, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for (label, role, count, ef) in groups {
            for _ in 0..count {
                let subject = rows.len();
                let wobble = (subject as f64 * 2.399).sin();
                let ejection_fraction = Some(ef + 0.06 * wobble);
                rows.push(CohortRow {
                    id: format!("P-{:03}", 41 + subject),
                    label: Some(label.to_owned()),
                    role,
                    ejection_fraction,
                    frame_count: 8,
                    warning_count: usize::from(subject == 5),
                });
                subjects.push(MapSubject {
                    id: rows[subject].id.clone(),
                    label: Some(label.to_owned()),
                    role,
                    ejection_fraction,
                });
                for frame in 0..8 {
                    let turn = (1.0 - (TAU * frame as f64 / 8.0).cos()) / 2.0;
                    let aside = (TAU * frame as f64 / 8.0).sin() * 0.16;
                    let start = [wobble, 0.8 * (subject as f64 * 1.7).cos()];
                    points.push(MapPoint {
                        subject,
                        frame,
                        at: [
                            start[0] + ef * 4.0 * turn + aside * wobble,
                            start[1] + ef * 2.0 * turn * (0.4 + 0.5 * wobble) + aside,
                        ],
                        phase: match frame {
                            0 => PosePhase::EndDiastole,
                            4 => PosePhase::EndSystole,
                            _ => PosePhase::Between,
                        },
                    });
                }
            }
        }
        let shares: Vec<f64> = (0..8).map(|frame| frame as f64 / 8.0).collect();
        let volumes = shares
            .iter()
            .map(|s| 104.0 - 38.0 * (PI * s).sin().powi(2))
            .collect();
        let outer = shares
            .iter()
            .map(|s| 196.0 - 34.0 * (PI * s).sin().powi(2))
            .collect();
        let actions = ActionState {
            has_study: true,
            can_undo: true,
            shows_endocardium: true,
            shows_epicardium: true,
            looping: true,
            ..Default::default()
        };
        Self {
            rows,
            subjects,
            points,
            volumes,
            outer,
            shares,
            actions,
        }
    }

    fn axis(&self) -> BeatAxis<'_> {
        BeatAxis {
            frame_shares: &self.shares,
        }
    }

    fn map(&self, state: MapState) -> PoseMapView<'_> {
        let part = |axis: usize| {
            let (from, to) = (&self.points[9 * 8 + 2], &self.points[9 * 8 + 3]);
            from.at[axis] + 0.4 * (to.at[axis] - from.at[axis])
        };
        PoseMapView {
            state,
            subjects: &self.subjects,
            points: &self.points,
            selected: Some(9),
            selected_frame: 2,
            current: Some([part(0), part(1)]),
            compared: None,
            params: PoseMapParams::default(),
            stress: Some(0.083),
            left_out: "",
        }
    }
}

/// A pane of the window: a rounded frame on the window's colour.
fn pane(ui: &mut Ui, rect: Rect, add: impl FnOnce(&mut Ui)) {
    let colours = colours(ui);
    let frame = Frame::new()
        .fill(colours.pane)
        .stroke(Stroke::new(1.0, colours.line))
        .corner_radius(6);
    let mut child = ui.new_child(UiBuilder::new().max_rect(rect).id_salt(format!("{rect:?}")));
    frame.inner_margin(Margin::ZERO).show(&mut child, |ui| {
        ui.set_min_size(rect.size() - vec2(2.0, 2.0));
        ui.set_max_size(rect.size() - vec2(2.0, 2.0));
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.scope(|ui| {
            ui.reset_style();
            add(ui);
        });
    });
}

fn rect(left: f32, top: f32, right: f32, bottom: f32) -> Rect {
    Rect::from_min_max(pos2(left, top), pos2(right, bottom))
}

/// The whole window as `look/window_dark.png` has it.
fn window(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let whole = ui.ctx().content_rect();
    ui.set_clip_rect(whole);
    ui.painter().rect_filled(whole, 0.0, colours(ui).window);
    let (w, h, gap) = (whole.width(), whole.height(), space::PANE_GAP);
    let (left, right) = (278.0f32.min(0.22 * w), w - 476.0f32.min(0.32 * w));
    let (top, foot, bar) = (36.0, h - 72.0, h - 140.0);
    let mut menu = ui.new_child(UiBuilder::new().max_rect(rect(4.0, 4.0, w - 4.0, 32.0)));
    let view = MenuBarView {
        study_name: Some("Built-in cohort"),
        subject_count: example.rows.len(),
        pose_count: example.points.len(),
        recent: &[],
        actions: &example.actions,
    };
    menu_bar_ui(&mut menu, &view, commands);
    pane(ui, rect(gap, top, left, bar - gap), |ui| {
        cohort(ui, example, commands)
    });
    pane(ui, rect(left + gap, top, right, bar - gap), |ui| {
        viewport(ui, example, commands)
    });
    let middle = 0.5 * (top + bar) - 40.0;
    pane(ui, rect(right + gap, top, w - gap, middle), |ui| {
        let view = example.map(MapState::Ready);
        pose_map_header_ui(ui, &view, commands);
        pose_map_ui(ui, &view, commands);
    });
    pane(
        ui,
        rect(right + gap, middle + gap, w - gap, bar - gap),
        |ui| measures(ui, example, commands),
    );
    pane(ui, rect(gap, bar, w - gap, foot + 34.0 - gap), |ui| {
        time(ui, example, commands)
    });
    let mut status = ui.new_child(UiBuilder::new().max_rect(rect(0.0, foot + 34.0, w, h)));
    let view = StatusBarView {
        job: Some(StatusJob {
            kind: JobKind::PoseMap,
            text: "Quasi-conformal distances of 184 poses",
            fraction: 0.71,
            seconds_left: Some(3.4),
        }),
        adapter: "llvmpipe, software Vulkan",
        notice_count: 5,
        warning_count: 2,
        ..Default::default()
    };
    status_bar_ui(&mut status, &view, commands);
}

fn cohort(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let sort = Some(CohortSort {
        column: CohortColumn::Subject,
        descending: false,
    });
    let visible = visible_rows(&example.rows, "", sort);
    pane_header_ui(
        ui,
        |ui| {
            tab_ui(ui, "Cohort", true);
            tab_ui(ui, "Activity", false);
        },
        |ui| {
            ui.weak(example.rows.len().to_string());
        },
    );
    let view = CohortView {
        rows: &example.rows,
        visible: &visible,
        search: "",
        sort,
        selected: Some(9),
        compared: None,
        measuring: false,
    };
    cohort_table_ui(ui, &view, commands);
}

fn viewport(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let view = ViewportHeaderView {
        quantity: Quantity::AreaRatio,
        shows_endocardium: Some(true),
        shows_epicardium: Some(true),
        ..Default::default()
    };
    viewport_header_ui(ui, &view, commands);
    let picture = ui.available_rect_before_wrap();
    // Where the renderer draws, something like a heart.
    let colours = colours(ui);
    let size = picture.height() * 0.32;
    ui.painter().circle_filled(
        picture.center(),
        size,
        colours.epicardium.gamma_multiply(0.25),
    );
    ui.painter()
        .circle_filled(picture.center(), size * 0.7, colours.endocardium);
    let map: Arc<[[u8; 3]]> = (0..256)
        .map(|i| [43 + (i as u8 / 2), 108, 176 - i as u8 / 2])
        .collect();
    let view = ViewportOverlayView {
        title: &example.rows[9].id,
        subtitle: "MINF · frame 3 of 8",
        role: LabelRole::Abnormal,
        badge: Some("interpolated (linear)"),
        colour_bar: Some(ColourBarView {
            title: "Area relative to end-diastole",
            unit: "",
            map,
            limits: [0.5, 2.0],
            logarithmic: true,
            below: [20, 40, 90],
            above: [110, 20, 20],
            note: "fixed for all subjects",
            typed: false,
        }),
        scale_bar: Some(ScaleBarView {
            points_per_unit: 4.3,
            unit: "mm",
        }),
        cube: Some(CubeView {
            world_from_camera: glam::Quat::from_euler(glam::EulerRot::YXZ, 0.7, -0.45, 0.0),
            base: glam::Vec3::Y,
            septal: glam::Vec3::NEG_X,
            anterior: glam::Vec3::Z,
            known: true,
        }),
    };
    let mut over = ui.new_child(UiBuilder::new().max_rect(picture));
    viewport_overlay_ui(&mut over, &view, commands);
}

fn measures(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    pane_header_ui(
        ui,
        |ui| {
            tab_ui(ui, "Volume", true);
            tab_ui(ui, "Measures", false);
        },
        |ui| {
            ui.weak("P-050");
        },
    );
    let whole = ui.available_rect_before_wrap();
    let split = whole.left() + 0.64 * whole.width();
    let mut plot = ui.new_child(
        UiBuilder::new().max_rect(Rect::from_min_max(whole.min, pos2(split, whole.bottom()))),
    );
    let view = CurvesView {
        curves: &[
            Curve {
                kind: CurveKind::Endocardium,
                values: &example.volumes,
            },
            Curve {
                kind: CurveKind::Epicardium,
                values: &example.outer,
            },
        ],
        unit: "ml",
        axis: example.axis(),
        beat_ms: Some(920.0),
        position: 2.4,
        end_diastole: Some(0),
        end_systole: Some(4),
        computing: false,
    };
    curves_ui(&mut plot, &view, commands);
    let mut card = ui.new_child(
        UiBuilder::new().max_rect(Rect::from_min_max(pos2(split, whole.top()), whole.max)),
    );
    let view = MeasuresView {
        subject: Some("P-050"),
        ejection_fraction: Some(0.365),
        end_diastolic_volume: Some(104.0),
        end_systolic_volume: Some(66.0),
        stroke_volume: Some(38.0),
        volume_unit: "ml",
        mass_g: Some(92.4),
        end_diastole: Some(0),
        end_systole: Some(4),
        current_frame: 2,
        ..Default::default()
    };
    measures_card_ui(&mut card, &view, commands);
}

fn time(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let view = TimeBarView {
        playing: false,
        speed: 1.0,
        looping: true,
        position: 2.4,
        axis: example.axis(),
        end_diastole: Some(0),
        end_systole: Some(4),
        time_ms: Some(276.0),
        between: Some("interpolated (linear)"),
    };
    time_bar_ui(ui, &view, commands);
}

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
                retry: Some(JobKind::Open),
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
                view.points = &[];
                view.stress = None;
            }
            pose_map_header_ui(ui, &view, commands);
            pose_map_ui(ui, &view, commands);
        }
        "activity" => {
            let item = |title: &str, parameters: &str, duration_s, state| WorkItem {
                kind: JobKind::PoseMap,
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
        "activity",
        "empty",
        "empty_hover",
        "no_match",
    ];
    for (index, name) in names.into_iter().enumerate() {
        let example = Example::new();
        let mut harness = Harness::builder()
            .with_size([400.0, 330.0])
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
