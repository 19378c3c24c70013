//! Nothing overlaps and nothing is cut off: a law over all widths of all panels.

use cardiomorph::app::*;
use cardiomorph::engine::{PoseMapQuery, Topic};
use cardiomorph::panes::*;
use cardiomorph::ui::*;
use egui::{Rect, Shape, Ui, epaint::ClippedShape};
use egui_kittest::Harness;

use super::example::Example;
use super::window::{cohort, measures, time, viewport};

/// Text on screen: what it says and where.
fn texts(shapes: &[ClippedShape]) -> Vec<(String, Rect, Rect)> {
    let mut found = Vec::new();
    for clipped in shapes {
        collect(&clipped.shape, clipped.clip_rect, &mut found);
    }
    found
}

fn collect(shape: &Shape, clip: Rect, found: &mut Vec<(String, Rect, Rect)>) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, found)),
        Shape::Text(text) => {
            let bounds = text.galley.mesh_bounds.translate(text.pos.to_vec2());
            let seen = bounds.intersect(clip);
            if seen.is_positive() && !text.galley.text().trim().is_empty() {
                found.push((text.galley.text().to_owned(), bounds, clip));
            }
        }
        _ => {}
    }
}

/// Faults of a panel at a size: texts that run into each other or beyond their clip to the side.
fn faults(
    width: f32,
    height: f32,
    mut panel: impl FnMut(&mut Ui, &Example, &mut Vec<Command>),
) -> Vec<String> {
    let example = Example::new();
    let mut harness = Harness::builder()
        .with_size([width, height])
        .with_context_setup(|ctx| apply(ctx, true))
        .build_ui(|ui| {
            let whole = ui.ctx().content_rect();
            let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(whole));
            inner.set_clip_rect(whole);
            panel(&mut inner, &example, &mut Vec::new());
        });
    harness.run();
    let texts = texts(&harness.output().shapes);
    assert!(!texts.is_empty(), "no text at {width} × {height}");
    let mut wrong = Vec::new();
    for (index, (text, rect, clip)) in texts.iter().enumerate() {
        if rect.left() < clip.left() - 1.0 || rect.right() > clip.right() + 1.0 {
            wrong.push(format!("{width} × {height}: {text:?} is cut off"));
        }
        for (other, place, other_clip) in &texts[index + 1..] {
            let shared = rect
                .intersect(*place)
                .intersect(*clip)
                .intersect(*other_clip)
                .shrink(0.75);
            if shared.is_positive() {
                wrong.push(format!("{width} × {height}: {text:?} runs into {other:?}"));
            }
        }
    }
    wrong
}

/// Widths from narrow to wide in odd steps.
fn widths(from: usize, to: usize) -> impl Iterator<Item = f32> {
    (from..=to).step_by(37).map(|width| width as f32)
}

#[test]
fn bars_hold_their_text_at_every_width() {
    let mut wrong = Vec::new();
    for width in widths(520, 1700) {
        wrong.extend(faults(width, 72.0, time));
        wrong.extend(faults(width, 36.0, |ui, example, commands| {
            menu_bar_ui(ui, &example.actions(), commands);
        }));
        wrong.extend(faults(width, 36.0, |ui, _, commands| {
            let view = StatusBarView {
                job: Some(StatusJob {
                    topic: Topic::of::<PoseMapQuery>(),
                    text: "Quasi-conformal distances of 2500 poses of 100 subjects".to_owned(),
                    fraction: 1.0,
                    seconds_left: Some(86.0),
                }),
                adapter: "llvmpipe, software Vulkan",
                notice_count: 120,
                warning_count: 112,
                ..Default::default()
            };
            status_bar_ui(ui, &view, commands);
        }));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn panes_hold_their_text_at_every_width() {
    let mut wrong = Vec::new();
    for width in widths(200, 900) {
        wrong.extend(faults(width, 420.0, cohort));
        wrong.extend(faults(width, 360.0, |ui, example, commands| {
            let view = example.map(WorkState::Ready);
            named_header_ui(ui, "Poses", |ui| {
                pose_map_choosers_ui(ui, PoseMapQuery::default(), 56.0, commands);
            });
            scatter_map_ui(ui, &view, 0.0, commands);
        }));
    }
    for width in widths(220, 900) {
        wrong.extend(faults(width, 420.0, |ui, example, commands| {
            let view = example.deformation_map(WorkState::Ready);
            pane_header_ui(
                ui,
                |ui| {
                    tab_ui(ui, "Deformations", true);
                },
                |ui| deformation_note(ui, &view, 120.0),
            );
            deformation_map_ui(ui, &view, commands);
        }));
        wrong.extend(faults(width, 360.0, |ui, example, commands| {
            space_time_ui(ui, &example.space_time(WorkState::Ready), 0.3, commands);
        }));
        wrong.extend(faults(width, 900.0, |ui, example, commands| {
            metric_panel_ui(ui, &example.metric(), commands);
        }));
    }
    for width in widths(320, 1200) {
        wrong.extend(faults(width, 500.0, viewport));
        wrong.extend(faults(width, 320.0, measures));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
