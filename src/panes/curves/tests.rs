//! What the plot reads off and does under the pointer.

use super::*;
use crate::panes::PlaybackCommand;

#[test]
fn the_last_frame_runs_into_the_first() {
    let curve = Curve {
        kind: CurveKind::Endocardium,
        values: vec![100.0, 60.0],
    };
    assert!((value_at(&curve, 1.5) - 80.0).abs() < 1e-12);
    assert!((value_at(&curve, 0.25) - 90.0).abs() < 1e-12);
}

#[test]
fn values_that_are_not_known_do_not_widen_the_range() {
    let curves = [Curve {
        kind: CurveKind::Epicardium,
        values: vec![f64::NAN, 60.0, 100.0],
    }];
    let (low, high) = range(&curves).unwrap();
    assert!(low > 50.0 && low < 60.0 && high > 100.0 && high < 110.0);
    assert_eq!(range(&[]), None);
}

#[test]
fn a_click_on_the_plot_moves_through_the_cycle() {
    use egui_kittest::{Harness, kittest::Queryable as _};
    let mut harness = Harness::builder()
        .with_size([400.0, 250.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            |ui, commands: &mut Vec<Command>| {
                let view = CurvesView {
                    curves: vec![Curve {
                        kind: CurveKind::Endocardium,
                        values: vec![100.0, 60.0],
                    }],
                    unit: "ml",
                    axis: CycleAxis {
                        frame_shares: vec![0.0, 0.5],
                    },
                    cycle_ms: None,
                    position: 0.0,
                    end_diastole: Some(0),
                    end_systole: Some(1),
                    computing: false,
                };
                curves_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    let rect = harness.get_by_label("Volume over the cardiac cycle").rect();
    let plot = Plot::new(rect, 20.0, 0.0, 1.0);
    let place = pos2(plot.x(0.75), rect.center().y);
    harness.drag_at(place);
    harness.drop_at(place);
    harness.run();
    let Some(Command::Playback(PlaybackCommand::SetPosition(position))) = harness.state().last()
    else {
        panic!("no position");
    };
    assert!((position - 1.5).abs() < 0.01, "{position}");
}

#[test]
fn a_share_of_a_cycle_without_times_is_not_one_of_the_r_r_interval() {
    let mut view = CurvesView {
        axis: CycleAxis {
            frame_shares: vec![0.0, 0.5],
        },
        ..CurvesView::default()
    };
    assert_eq!(hover_text(&view, 1.0), "50 % of the cycle by frames");
    view.cycle_ms = Some(800.0);
    assert_eq!(hover_text(&view, 1.0), "400 ms · 50 % R-R");
}
