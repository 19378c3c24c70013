//! What the slices show, and what is done in them.

use std::sync::Arc;

use egui_kittest::{Harness, kittest::Queryable as _};

use super::plane::SlicePlane;
use super::slice::SliceTile;
use crate::document::GreyWindow;
use crate::image::{Image, VolumeFrame};
use crate::io::{ImageSeries, Provenance};
use crate::mesh::{Point3, Vector3};
use crate::panes::commands::{Command, ImagesCommand};

/// A series of one volume on a grid in LPS, 2 × 2 × 5 mm.
pub fn series_of(size: [usize; 3], value: impl Fn([usize; 3]) -> f32) -> Arc<ImageSeries> {
    let steps = [
        Vector3::new(2.0, 0.0, 0.0),
        Vector3::new(0.0, 2.0, 0.0),
        Vector3::new(0.0, 0.0, 5.0),
    ];
    let frame = VolumeFrame::new(size, Point3::origin(), steps).unwrap();
    let mut values = Vec::new();
    for k in 0..size[2] {
        for j in 0..size[1] {
            values.extend((0..size[0]).map(|i| value([i, j, k])));
        }
    }
    Arc::new(ImageSeries {
        name: "made".to_owned(),
        format: "NIfTI-1",
        modality: None,
        image: Image::new(frame, vec![values.into()], None).unwrap(),
        gates: None,
        spacing: Provenance::Stated,
        times: Provenance::Stated,
        position_known: true,
        notices: Vec::new(),
    })
}

struct Slice {
    commands: Vec<Command>,
    clicked: Vec<Point3>,
}

/// An axial slice of 20 × 20 voxels of 2 mm in a tile of 208 points: with its margin of 4, 10 points a voxel.
fn slice() -> Harness<'static, Slice> {
    let series = series_of([20, 20, 10], |[i, _, _]| i as f32);
    Harness::builder()
        .with_size([208.0, 208.0])
        .with_step_dt(1.0 / 30.0)
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, state: &mut Slice| {
                let frame = *series.image.frame();
                let tile = SliceTile {
                    frame: &frame,
                    plane: SlicePlane::new(&frame, 2),
                    cross: Point3::new(10.0, 10.0, 4.0),
                    texture: None,
                    window: GreyWindow::between(0.0, 20.0),
                    outlines: Vec::new(),
                    marks: Vec::new(),
                    oriented: true,
                    measured: true,
                    value: &|_| Some(1.0),
                };
                let rect = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(208.0, 208.0));
                let clicked = tile.ui(ui, rect, &mut state.commands);
                state.clicked.extend(clicked.map(|place| place.voxel));
            },
            Slice {
                commands: Vec::new(),
                clicked: Vec::new(),
            },
        )
}

#[test]
fn a_click_is_the_place_of_the_grid_under_it() {
    let mut harness = slice();
    harness.run();
    harness.get_by_label("Axial 5 of 10 slice");
    let at = egui::pos2(4.0 + 10.0 * 3.5, 4.0 + 10.0 * 7.5);
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    harness.run();
    let clicked = harness.state().clicked.last().copied().unwrap();
    assert!(
        (clicked - Point3::new(3.0, 7.0, 4.0)).norm() < 1e-4,
        "{clicked}"
    );
}

#[test]
fn the_wheel_steps_through_slices_and_a_double_click_resets_the_window() {
    let mut harness = slice();
    harness.run();
    let at = egui::pos2(100.0, 100.0);
    harness.hover_at(at);
    harness.step();
    harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, -35.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: egui::Modifiers::NONE,
    });
    harness.run_steps(20);
    let next = Command::Images(ImagesCommand::MoveTo(Point3::new(20.0, 20.0, 25.0)));
    assert_eq!(harness.state().commands, [next]);
    for pressed in [true, false, true, false] {
        harness.event(egui::Event::PointerButton {
            pos: at,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        });
    }
    harness.run();
    let reset = Command::Images(ImagesCommand::SetWindow(None));
    assert_eq!(harness.state().commands.last(), Some(&reset));
}

#[test]
fn a_drag_with_the_second_button_widens_the_window_and_moves_no_crosshair() {
    let mut harness = slice();
    harness.run();
    let button = |pos, pressed| egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Secondary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    };
    let at = egui::pos2(60.0, 100.0);
    harness.hover_at(at);
    harness.step();
    harness.event(button(at, true));
    harness.step();
    let to = at + egui::vec2(100.0, 0.0);
    harness.hover_at(to);
    harness.step();
    harness.event(button(to, false));
    harness.run();
    let state = harness.state();
    assert!(state.clicked.is_empty());
    let windows: Vec<GreyWindow> = (state.commands.iter())
        .filter_map(|command| match command {
            Command::Images(ImagesCommand::SetWindow(window)) => *window,
            _ => None,
        })
        .collect();
    let widest = windows
        .iter()
        .map(|window| window.width)
        .fold(0.0, f64::max);
    assert!((widest - 20.0 * 0.5_f64.exp()).abs() < 1e-3, "{windows:?}");
}

#[test]
fn arrows_move_the_crosshair_of_the_slice_that_has_the_keyboard() {
    let mut harness = slice();
    harness.run();
    harness.get_by_label("Axial 5 of 10 slice").focus();
    harness.run();
    harness.key_press(egui::Key::ArrowRight);
    harness.run();
    harness.key_press(egui::Key::Enter);
    harness.run();
    let right = Command::Images(ImagesCommand::MoveTo(Point3::new(22.0, 20.0, 20.0)));
    assert_eq!(harness.state().commands, [right]);
    assert_eq!(harness.state().clicked, [Point3::new(10.0, 10.0, 4.0)]);
}
