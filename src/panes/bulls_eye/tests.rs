//! The bull's-eye: clicks, choosers, the empty states.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::panes::WallCommand;
use crate::picture::{BullsEyeScale, PolarMap, PolarPatch, PolarValues};

struct Shown {
    state: WorkState,
    oriented: bool,
    selected: Option<Segment>,
    map: bool,
    patches: Vec<BullsEyePatch>,
}

impl Default for Shown {
    fn default() -> Self {
        Self {
            state: WorkState::Ready,
            oriented: true,
            selected: None,
            map: true,
            patches: Vec::new(),
        }
    }
}

fn ratio_scale() -> BullsEyeScale {
    let quantity = BullsEyeQuantity::ThicknessRatio;
    BullsEyeScale::of(quantity, &Default::default(), None, Default::default())
}

fn harness(shown: Shown) -> Harness<'static, Vec<Command>> {
    let points = [[0.0, 0.0], [0.9, 0.0], [0.0, 0.9], [-0.9, 0.0], [0.0, -0.9]];
    let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
    let mut harness = Harness::builder()
        .with_size([260.0, 300.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let mut flat = PolarMap::default();
                flat.points.extend(points.iter().filter(|_| shown.map));
                flat.faces = faces.to_vec();
                flat.oriented = shown.oriented;
                let values = PolarValues {
                    values: vec![1.0, 1.2, 1.5, f32::NAN, 0.8],
                    segments: [Some(1.52); Segment::COUNT],
                };
                let view = BullsEyeView {
                    state: shown.state.clone(),
                    without_axis: None,
                    scale: &ratio_scale(),
                    subject: "P05",
                    moment: "ES",
                    by_segment: true,
                    flat: &flat,
                    shown: &values,
                    patches: &shown.patches,
                    selected: shown.selected,
                };
                bulls_eye_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

fn click_on(harness: &mut Harness<'static, Vec<Command>>, segment: Segment, named: bool) {
    let area = harness.get_by_label("Bull's-eye map").rect();
    let (disc, _) = layout::places(area, named);
    click_at(harness, disc.middle_of(segment));
}

fn click_at(harness: &mut Harness<'static, Vec<Command>>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    harness.run();
}

#[test]
fn a_click_selects_the_segment_and_a_second_one_lets_it_go() {
    for segment in Segment::all() {
        let mut shown = harness(Shown::default());
        click_on(&mut shown, segment, true);
        let wanted = Command::Wall(WallCommand::SelectPart(Some(WallPart::Segment(segment))));
        assert_eq!(*shown.state(), [wanted]);
    }
    let segment = Segment::new(9);
    let mut shown = harness(Shown {
        selected: segment,
        ..Shown::default()
    });
    click_on(&mut shown, segment.unwrap(), true);
    assert_eq!(
        *shown.state(),
        [Command::Wall(WallCommand::SelectPart(None))]
    );
}

#[test]
fn a_click_on_a_border_selects_its_patch() {
    let patch = |selected| BullsEyePatch {
        shape: PolarPatch {
            borders: vec![vec![[0.3, 0.3], [0.8, 0.3], [0.3, 0.8]]],
            ..PolarPatch::default()
        },
        number: "1".to_owned(),
        name: "Patch 1".to_owned(),
        selected,
        faint: false,
    };
    for (selected, part) in [(false, Some(WallPart::Patch(0))), (true, None)] {
        let mut shown = harness(Shown {
            patches: vec![patch(selected)],
            ..Shown::default()
        });
        let area = shown.get_by_label("Bull's-eye map").rect();
        let (disc, _) = layout::places(area, true);
        click_at(&mut shown, disc.at([0.55, 0.32]));
        assert_eq!(
            *shown.state(),
            [Command::Wall(WallCommand::SelectPart(part))]
        );
    }
}

#[test]
fn without_orientation_there_are_no_segments_to_select() {
    let mut shown = harness(Shown {
        oriented: false,
        ..Shown::default()
    });
    click_on(&mut shown, Segment::new(3).unwrap(), false);
    assert!(shown.state().is_empty());
}

#[test]
fn what_is_not_assessed_says_why() {
    let why = "the wall is one surface without an inner side";
    let shown = harness(Shown {
        state: WorkState::Unanswerable(why.to_owned()),
        map: false,
        ..Shown::default()
    });
    shown.get_by_label("Not assessed");
    shown.get_by_label(why);
}

#[test]
fn the_quantity_is_chosen_from_a_menu_and_segments_by_a_switch() {
    let mut shown = harness(Shown::default());
    shown.get_by_label("Bull's-eye: PT, this pose").click();
    shown.run();
    shown.get_by_label("Thickening").click();
    shown.run();
    shown.get_by_label("Segment values").click();
    shown.run();
    let wanted = [
        Command::Wall(WallCommand::SetBullsEye(BullsEyeQuantity::Thickening)),
        Command::Wall(WallCommand::ToggleBullsEyeSegments),
    ];
    assert_eq!(*shown.state(), wanted);
}
