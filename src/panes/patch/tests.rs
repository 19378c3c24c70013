//! The pane of patches: states, table, sliders.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::analysis::thickening::ThickeningSettings;
use crate::engine::{Topic, WallThickeningQuery};
use crate::panes::{WallCommand, WorkCommand, WorkState};
use crate::picture::WallPart;
use crate::render::Camera;
use crate::report::PatchRow;

struct Shown {
    state: WorkState,
    rows: Vec<PatchLine>,
    settings: ThickeningSettings,
    heading: &'static str,
    standing: PatchStanding,
}

impl Shown {
    fn with(state: WorkState, heading: &'static str, rows: Vec<PatchLine>) -> Self {
        Self {
            state,
            rows,
            settings: ThickeningSettings::default(),
            heading,
            standing: PatchStanding::AbnormalPatch,
        }
    }
}

fn patch() -> PatchLine {
    PatchLine {
        row: PatchRow {
            area_cm2: Some(21.3),
            share: 0.31,
            thickness_ratio: 1.04,
            stability: 0.98,
            ..PatchRow::default()
        },
        segments: "basal and mid anteroseptal, apical septal".to_owned(),
        ..PatchLine::default()
    }
}

fn harness(shown: Shown) -> Harness<'static, Vec<Command>> {
    let mut harness = Harness::builder()
        .with_size([260.0, 420.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = PatchPanelView {
                    subject: Some("P07"),
                    state: shown.state.clone(),
                    standing: shown.standing,
                    heading: shown.heading.to_owned(),
                    note: "Remote myocardium thickens by 52 %".to_owned(),
                    rows: shown.rows.clone(),
                    settings: shown.settings,
                    noise: Some(0.012),
                    tolerance: Some(0.05),
                    remote: Some(0.52),
                };
                patch_panel_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

#[test]
fn a_click_on_a_row_selects_the_patch_and_frames_it_where_it_can() {
    let mut shown = harness(Shown::with(WorkState::Ready, "1 patch", vec![patch()]));
    shown
        .get_by_label_contains("Patch 1: Area 21 cm², LV share 31 %, Thickening 4 %")
        .click();
    shown.run();
    let wanted = Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(0))));
    assert_eq!(*shown.state(), [wanted]);
    let camera = Camera::default();
    let framed = PatchLine {
        camera: Some(camera),
        ..patch()
    };
    let mut shown = harness(Shown::with(WorkState::Ready, "1 patch", vec![framed]));
    shown.get_by_label_contains("anteroseptal").click();
    shown.run();
    assert_eq!(
        *shown.state(),
        [Command::Wall(WallCommand::ShowPatch { patch: 0, camera })]
    );
}

#[test]
fn a_region_of_low_thickening_without_a_verdict_of_a_patch_is_not_called_one() {
    let heading = "1 region of low thickening";
    let mut shown = Shown::with(WorkState::Ready, heading, vec![patch()]);
    shown.standing = PatchStanding::RegionOnly;
    let shown = harness(shown);
    shown.get_by_label_contains("Region 1: Area 21 cm²");
    assert!(shown.query_by_label_contains("Patch 1").is_none());
}

#[test]
fn what_is_not_assessed_says_why_and_has_no_table() {
    let why = "2 frames are too few";
    let shown = harness(Shown::with(
        WorkState::Unanswerable(why.to_owned()),
        "",
        Vec::new(),
    ));
    shown.get_by_label("Not assessed");
    shown.get_by_label(why);
    assert!(shown.query_by_label_contains("Patch 1").is_none());
}

#[test]
fn a_stopped_measurement_can_be_begun_again() {
    let mut shown = harness(Shown::with(WorkState::Stopped, "", Vec::new()));
    shown.get_by_label("Measure again").click();
    shown.run();
    assert_eq!(
        *shown.state(),
        [Command::Work(WorkCommand::Retry(Topic::of::<
            WallThickeningQuery,
        >()))]
    );
}

#[test]
fn the_border_moves_by_keyboard_and_takes_its_core_along() {
    let mut shown = harness(Shown::with(WorkState::Ready, "No patch", Vec::new()));
    let slider = egui::accesskit::Role::Slider;
    shown
        .get_by_role_and_label(slider, "Extent threshold")
        .focus();
    shown.run();
    shown.key_press(egui::Key::ArrowRight);
    shown.run();
    let commands = shown.into_state();
    let Some(Command::Wall(WallCommand::SetThickening(settings))) = commands.first() else {
        panic!("{commands:?}");
    };
    let (core, extent) = (
        settings.patches.core_threshold,
        settings.patches.extent_threshold,
    );
    assert!(extent > 0.4, "{extent}");
    assert!((core / extent - 0.5).abs() < 1e-9);
    assert!(settings.patches.check().is_ok());
}
