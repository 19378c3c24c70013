//! Panes of the window on the built-in cohort, each alone in a small window and cut out of its bars.

use cardiomorph::analysis::segments::Segment;
use cardiomorph::app::App;
use cardiomorph::document::{ThemeChoice, ViewMode};
use cardiomorph::engine::MedialMapQuery;
use cardiomorph::panes::{
    Command, EditCommand, PANES, Pane, PlaybackCommand, SelectCommand, TransportCommand,
    ViewCommand, WallCommand, Whose, WindowCommand,
};
use cardiomorph::picture::{BullsEyeQuantity, Quantity, WallPart};
use cardiomorph::ui::theme::space;
use egui::{Rect, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};

use super::{FRAME, SUBJECT, compare_part, on_reference_driver, window_after};

pub const NAMES: [&str; 18] = [
    "atoms",
    "bulls_eye",
    "bulls_eye_segments",
    "cohort",
    "cohort_excluded",
    "cohort_menu",
    "deformations",
    "difference",
    "measures",
    "medial_map",
    "metric",
    "patch",
    "pose_map",
    "space_time",
    "thickness_ratio",
    "transport",
    "verdict",
    "volume",
];

/// Heights of the bars above and below the panes, as `app/frame_ui.rs` has them.
const BARS: [f32; 2] = [34.0, 72.0 + 36.0];

/// Compares a pane of this size alone in the window, after these commands.
fn compare_pane(
    name: &str,
    pane: Pane,
    size: [f32; 2],
    theme: ThemeChoice,
    commands: &[Command],
    ready: impl Fn(&App) -> bool,
) {
    if !on_reference_driver() {
        return;
    }
    let (mut harness, place) = pane_alone(pane, size, theme, commands, ready);
    compare_part(&harness.render().unwrap(), place, &format!("panes/{name}"));
}

/// A window with a pane of this size alone, after these commands, and where the pane is.
fn pane_alone(
    pane: Pane,
    [width, height]: [f32; 2],
    theme: ThemeChoice,
    commands: &[Command],
    ready: impl Fn(&App) -> bool,
) -> (Harness<'static, App>, Rect) {
    let [above, below] = BARS;
    let gap = space::PANE_GAP;
    let window = [width + 2.0 * gap, above + height + 2.0 * gap + below];
    // Closed one after another in the order of their tabs, each is in front when its turn comes.
    // Some are closed at first: all are opened, then closed.
    let toggles = (PANES.iter()).flat_map(|spec| {
        [
            WindowCommand::ShowPane(spec.pane),
            WindowCommand::TogglePane(spec.pane),
        ]
    });
    let mut all: Vec<Command> = toggles.map(Command::Window).collect();
    all.push(Command::Window(WindowCommand::ShowPane(pane)));
    all.extend_from_slice(commands);
    let place = Rect::from_min_size(pos2(gap, above + gap), vec2(width, height));
    (window_after(window, theme, all, ready), place)
}

fn wall_is_known(app: &App) -> bool {
    matches!(app.state().wall_of(SUBJECT), Some((Ok(_), true)))
}

fn verdict_is_known(app: &App) -> bool {
    wall_is_known(app) && matches!(app.state().verdicts(), Some((_, true)))
}

const DARK: ThemeChoice = ThemeChoice::Dark;
const LIGHT: ThemeChoice = ThemeChoice::Light;

#[test]
fn the_cohort_looks_as_it_did() {
    compare_pane("cohort", Pane::COHORT, [300.0, 360.0], LIGHT, &[], |app| {
        verdict_is_known(app)
    });
}

#[test]
fn a_cohort_with_an_excluded_subject_looks_as_it_did() {
    let exclude = [Command::Edit(EditCommand::Exclude(Whose::Subject(13)))];
    let (name, size) = ("cohort_excluded", [300.0, 360.0]);
    compare_pane(name, Pane::COHORT, size, DARK, &exclude, |app| {
        verdict_is_known(app)
    });
}

#[test]
fn the_menu_of_a_row_looks_as_it_did() {
    if !on_reference_driver() {
        return;
    }
    let size = [460.0, 420.0];
    let (mut harness, place) = pane_alone(Pane::COHORT, size, LIGHT, &[], verdict_is_known);
    harness.get_by_label("P01").click_secondary();
    harness.run();
    harness.remove_cursor();
    harness.run();
    compare_part(&harness.render().unwrap(), place, "panes/cohort_menu");
}

#[test]
fn measures_look_as_they_did() {
    let size = [240.0, 280.0];
    compare_pane("measures", Pane::MEASURES, size, DARK, &[], |_| true);
}

#[test]
fn volumes_over_the_beat_look_as_they_did() {
    let size = [320.0, 240.0];
    compare_pane("volume", Pane::CURVES, size, LIGHT, &[], |_| true);
}

#[test]
fn the_map_of_poses_looks_as_it_did() {
    let size = [360.0, 320.0];
    compare_pane("pose_map", Pane::POSE_MAP, size, DARK, &[], |_| true);
}

#[test]
fn the_map_of_deformations_looks_as_it_did() {
    let (pane, size) = (Pane::DEFORMATION_MAP, [360.0, 400.0]);
    compare_pane("deformations", pane, size, LIGHT, &[], |app| {
        app.state().deformations().is_some()
    });
}

#[test]
fn poses_through_time_look_as_they_did() {
    let size = [360.0, 360.0];
    compare_pane("space_time", Pane::SPATIOTEMPORAL, size, DARK, &[], |_| {
        true
    });
}

#[test]
fn the_map_of_the_medial_shape_space_looks_as_it_did() {
    let size = [360.0, 320.0];
    compare_pane("medial_map", Pane::MEDIAL_MAP, size, LIGHT, &[], |app| {
        let document = &app.state().document;
        let query = MedialMapQuery {
            thickening: document.thickening,
            method: document.map.method,
        };
        app.known(&query).is_some()
    });
}

#[test]
fn settings_of_metric_and_maps_look_as_they_did() {
    let size = [300.0, 480.0];
    compare_pane("metric", Pane::METRIC, size, DARK, &[], |_| true);
}

#[test]
fn a_patch_looks_as_it_did() {
    let commands = [Command::Wall(WallCommand::SelectPart(Some(
        WallPart::Patch(0),
    )))];
    let size = [300.0, 420.0];
    compare_pane("patch", Pane::PATCH, size, LIGHT, &commands, wall_is_known);
}

#[test]
fn a_verdict_looks_as_it_did() {
    let size = [320.0, 480.0];
    compare_pane("verdict", Pane::VERDICT, size, DARK, &[], verdict_is_known);
}

#[test]
fn the_bulls_eye_looks_as_it_did() {
    let commands = [Command::Wall(WallCommand::SelectPart(Some(
        WallPart::Patch(0),
    )))];
    let (pane, size) = (Pane::BULLS_EYE, [300.0, 320.0]);
    compare_pane("bulls_eye", pane, size, DARK, &commands, wall_is_known);
}

#[test]
fn the_bulls_eye_with_a_colour_for_each_segment_looks_as_it_did() {
    let commands = [
        Command::Wall(WallCommand::ToggleBullsEyeSegments),
        Command::Wall(WallCommand::SetBullsEye(BullsEyeQuantity::Thickening)),
        Command::Wall(WallCommand::SelectPart(Some(WallPart::Segment(
            Segment::new(8).unwrap(),
        )))),
    ];
    let (name, pane, size) = ("bulls_eye_segments", Pane::BULLS_EYE, [300.0, 320.0]);
    compare_pane(name, pane, size, LIGHT, &commands, wall_is_known);
}

#[test]
fn atoms_and_the_outline_of_a_patch_look_as_they_did() {
    let commands = [
        Command::Wall(WallCommand::ToggleAtoms),
        Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(0)))),
    ];
    let size = [420.0, 360.0];
    compare_pane(
        "atoms",
        Pane::VIEWPORT,
        size,
        DARK,
        &commands,
        wall_is_known,
    );
}

#[test]
fn the_thickness_ratio_looks_as_it_did() {
    let commands = [Command::View(ViewCommand::SetQuantity(
        Quantity::ThicknessRatio,
    ))];
    let (name, size) = ("thickness_ratio", [420.0, 360.0]);
    compare_pane(name, Pane::VIEWPORT, size, LIGHT, &commands, wall_is_known);
}

#[test]
fn a_motion_on_another_subject_looks_as_it_did() {
    let commands = [
        Command::Transport(TransportCommand::TransportMotion {
            from: SUBJECT,
            onto: 2,
        }),
        Command::Playback(PlaybackCommand::TogglePlay),
        Command::Playback(PlaybackCommand::SetPosition(FRAME as f64 + 0.5)),
    ];
    let (name, size) = ("transport", [480.0, 320.0]);
    compare_pane(name, Pane::VIEWPORT, size, DARK, &commands, |app| {
        let interpolated_poses = app.state().interpolated_poses_of(SUBJECT);
        app.state().transported_subject().is_some()
            && interpolated_poses.is_some_and(|beat| beat.complete())
    });
}

#[test]
fn the_difference_of_two_hearts_looks_as_it_did() {
    let commands = [
        Command::View(ViewCommand::SetViewMode(ViewMode::SideBySide)),
        Command::Select(SelectCommand::CompareWith(Some(2))),
        Command::View(ViewCommand::SetQuantity(Quantity::Contribution)),
    ];
    let (name, size) = ("difference", [480.0, 320.0]);
    compare_pane(name, Pane::VIEWPORT, size, LIGHT, &commands, |app| {
        app.state().answers.difference().is_some()
    });
}
