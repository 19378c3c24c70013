//! The text of the pane and the commands of its buttons.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::panes::WorkCommand;

fn strip(moment: &str, median: f64) -> ThicknessStrip {
    ThicknessStrip {
        moment: moment.to_owned(),
        on_screen: moment == "ES",
        quantiles: [-3.0, -1.0, 0.0, 1.0, 3.5].map(|offset| median + offset),
    }
}

fn rows() -> Vec<ThicknessRow> {
    vec![
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

fn harness(state: WorkState, subject: Option<&'static str>) -> Harness<'static, Vec<Command>> {
    let rows = rows();
    Harness::builder()
        .with_size([280.0, 360.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = ThicknessPanelView {
                    subject,
                    state: state.clone(),
                    moment: "ES".to_owned(),
                    unit: "mm",
                    rows: rows.clone(),
                    max: 16.0,
                };
                thickness_panel_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

#[test]
fn each_method_has_its_numbers_with_their_unit_and_its_difference() {
    let mut shown = harness(WorkState::Ready, Some("P05"));
    shown.run();
    shown.get_by_label(
        "Medial spheres, ED 9.0 (6.0–12.5) mm, ES 12.0 (9.0–15.5) mm, 0.02 s per pose",
    );
    shown.get_by_label_contains("+0.31 ± 0.20 mm from medial spheres at ES over 800 vertices");
    shown.get_by_label_contains("Median (5–95 % of vertices) in mm");
}

#[test]
fn a_method_that_is_not_applicable_says_why() {
    let mut shown = harness(WorkState::Ready, Some("P05"));
    shown.run();
    shown.get_by_label("Not applicable: no landmarks");
}

#[test]
fn measuring_can_be_cancelled_and_begun_again() {
    let computing = WorkState::Computing {
        fraction: 0.4,
        phase: "ES".to_owned(),
        seconds_left: None,
    };
    let mut shown = harness(computing, Some("P05"));
    shown.run();
    shown.get_by_label("Measuring ES");
    shown.get_by_label("40 %");
    shown.get_by_label("Cancel").click();
    shown.run();
    assert_eq!(
        *shown.state(),
        [Command::Work(WorkCommand::Cancel(Topic::of::<
            PoseThicknessQuery,
        >()))]
    );
    let mut shown = harness(WorkState::Stopped, Some("P05"));
    shown.run();
    shown.get_by_label("Measure").click();
    shown.run();
    assert_eq!(
        *shown.state(),
        [Command::Work(WorkCommand::Retry(Topic::of::<
            PoseThicknessQuery,
        >()))]
    );
}

#[test]
fn without_a_subject_the_pane_says_what_would_fill_it() {
    let mut shown = harness(WorkState::Empty, None);
    shown.run();
    shown.get_by_label("No subject selected");
}
