//! Beats in the window: poses between frames, one heart's beat on another, where two hearts differ.

use cardiomorph::document::TransportState;
use cardiomorph::engine::{InterpolatedPosesQuery, MotionTransportQuery, PoseMapQuery, Topic};
use cardiomorph::picture::Quantity;

use super::*;
use cardiomorph::panes::{
    EditCommand, PlaybackCommand, SelectCommand, TransportCommand, ViewCommand, WallCommand,
    WorkCommand,
};

/// Takes what is at `from` and lets it go at `onto`, as a person does: in several steps.
fn drag(harness: &mut Harness<'_, App>, from: egui::Pos2, onto: egui::Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    for step in 1..=5 {
        harness.hover_at(from.lerp(onto, step as f32 / 5.0));
        harness.step();
    }
    harness.drop_at(onto);
    harness.step();
    harness.step();
}

fn row(harness: &Harness<'_, App>, id: &str) -> egui::Pos2 {
    harness.get_by_label(id).rect().center()
}

fn shows(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

fn transported(app: &App) -> bool {
    app.state().transported_subject().is_some() && app.hearts_on_screen().len() == 2
}

#[test]
fn the_slider_runs_through_computed_poses_and_says_so() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(2.4)),
    );
    assert!(
        shows(&harness, "linear interpolation"),
        "until the pose is computed"
    );
    wait(&mut harness, "the poses between frames", |app| {
        app.state()
            .interpolated_poses_of(0)
            .is_some_and(|beat| beat.complete())
            && !app.busy()
    });
    harness.run();
    assert!(shows(&harness, "R-R · interpolated"));
    assert!(!shows(&harness, "linear interpolation"));
    let beat = harness
        .state()
        .state()
        .interpolated_poses_of(0)
        .unwrap()
        .clone();
    assert_eq!(
        beat.positions().len(),
        8 * 3,
        "three in each of eight intervals"
    );
    for interval in 0..8 {
        let path = beat.path(interval).unwrap();
        assert!(
            path.energy <= path.energy_linear,
            "{interval}: no dearer than straight"
        );
    }
    // The keys lead from one pose to the next, and a frame needs no words.
    harness.key_press(egui::Key::Period);
    harness.run();
    assert_eq!(harness.state().state().document.position, 2.5);
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(3.0)),
    );
    harness.run();
    assert!(!shows(&harness, "interpolated"));
    // Another number of poses is another question; none at all is one too.
    give(
        &mut harness,
        Command::Transport(TransportCommand::SetInterpolatedPoses(1)),
    );
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(2.4)),
    );
    wait(&mut harness, "one pose per interval", |app| {
        let beat = app.state().interpolated_poses_of(0);
        beat.is_some_and(|beat| beat.positions().len() == 8)
    });
    give(
        &mut harness,
        Command::Transport(TransportCommand::SetInterpolatedPoses(0)),
    );
    harness.run();
    assert!(shows(&harness, "linear interpolation"));
    assert!(!harness.state().busy());
}

#[test]
fn playing_finds_the_poses_of_the_heart_on_screen() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectSubject(4)),
    );
    assert!(
        harness.state().state().interpolated_poses_of(4).is_none(),
        "nothing moves yet"
    );
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    wait(&mut harness, "the poses between frames", |app| {
        app.state()
            .interpolated_poses_of(4)
            .is_some_and(|beat| beat.complete())
    });
    assert!(harness.state().state().play.playing);
}

#[test]
fn stopped_poses_stay_stopped_until_they_are_asked_for() {
    let mut harness = window(AppOptions::built_in(BuiltInParams {
        vertices: 6_000,
        ..BuiltInParams::default()
    }));
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>())),
    );
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(0.5)),
    );
    harness.step();
    let works = |app: &App| app.works_on(Topic::of::<InterpolatedPosesQuery>());
    assert!(works(harness.state()));
    let begin = Instant::now();
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<InterpolatedPosesQuery>())),
    );
    wait(&mut harness, "the end of the work", |app| !works(app));
    assert!(begin.elapsed() < Duration::from_secs(2));
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(4.5)),
    );
    harness.run_steps(3);
    assert!(
        !works(harness.state()),
        "another interval does not begin it again"
    );
    assert!(shows(&harness, "linear interpolation"));
    give(
        &mut harness,
        Command::Work(WorkCommand::Retry(Topic::of::<InterpolatedPosesQuery>())),
    );
    harness.step();
    assert!(works(harness.state()));
}

#[test]
fn a_drag_that_arrives_in_one_frame_moves_the_subject_that_was_pressed() {
    let mut harness = cohort_window();
    harness.run();
    let (from, onto) = (row(&harness, "P05"), row(&harness, "N02"));
    let (between, after) = (row(&harness, "P04"), row(&harness, "N04"));
    let button = |pos, pressed| egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    };
    harness.input_mut().events.extend([
        egui::Event::PointerMoved(from),
        button(from, true),
        egui::Event::PointerMoved(between),
        egui::Event::PointerMoved(from.lerp(onto, 0.5)),
        egui::Event::PointerMoved(onto),
        button(onto, false),
        egui::Event::PointerMoved(after),
    ]);
    harness.run_steps(8);
    let state = harness.state().state();
    let beat = state
        .document
        .visible_transport()
        .expect("a motion is transported");
    let id = |index: usize| state.subject(index).unwrap().id.clone();
    assert_eq!((id(beat.from), id(beat.onto)), ("P05".into(), "N02".into()));
}

#[test]
fn a_subject_dragged_onto_another_plays_its_beat_there() {
    let mut harness = cohort_window();
    harness.run();
    let (from, onto) = (row(&harness, "P07"), row(&harness, "N03"));
    drag(&mut harness, from, onto);
    let state = harness.state().state();
    let beat = state
        .document
        .visible_transport()
        .expect("a motion is transported");
    assert_eq!((beat.from, beat.onto), (15, 2));
    assert_eq!(state.document.view_mode, ViewMode::SideBySide);
    assert!(state.play.playing, "it plays beside the original");
    wait(&mut harness, "the transported motion", transported);
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(3.0)),
    );
    harness.run();
    assert!(shows(&harness, "Motion of P07 on N03"));
    assert!(shows(&harness, "transported motion · frame 3 (0–7)"));
    assert!(shows(&harness, "long a geodesic"));
    assert_eq!(harness.state().hearts_on_screen(), [(15, 3.0), (2, 3.0)]);
    // At end-diastole it is the heart itself; later it moves otherwise than by its own.
    let heart = harness
        .state()
        .state()
        .transported_subject()
        .unwrap()
        .clone();
    assert_eq!(heart.subject.sequence.frame_count(), 8);
    assert!(heart.distances[0].iter().all(|distance| *distance < 1e-3));
    assert!(heart.distances[3].iter().any(|distance| *distance > 1.0));
    assert_eq!(
        harness.state().state().document.quantity,
        Quantity::MotionDifference
    );
    assert!(shows(&harness, "Difference from own motion, mm"));
    // Atoms of both have a bar of their own, and this one stays.
    give(&mut harness, Command::Wall(WallCommand::ToggleAtoms));
    wait(&mut harness, "the atoms", |app| !app.busy());
    harness.run();
    assert!(shows(&harness, "Difference from own motion, mm"));
    give(&mut harness, Command::Edit(EditCommand::Undo));
    harness.run();
    // Without colours the bar goes; undo brings them, and then the view before, back.
    give(
        &mut harness,
        Command::View(ViewCommand::SetQuantity(Quantity::Tissue)),
    );
    harness.run();
    assert!(!shows(&harness, "Difference from own motion, mm"));
    harness.get_by_label("Show own motion").click();
    harness.run();
    assert_eq!(harness.state().state().document.transported, None);
    assert!(!shows(&harness, "Motion of P07 on N03"));
    for _ in 0..8 {
        give(&mut harness, Command::Edit(EditCommand::Undo));
    }
    harness.run();
    assert_eq!(harness.state().state().document.view_mode, ViewMode::Single);
    assert_eq!(harness.state().state().document.subject, 0);
}

#[test]
fn a_subject_let_go_on_a_picture_plays_on_that_heart() {
    let mut harness = cohort_window();
    harness.run();
    let picture = harness.get_by_label("3D viewport").rect().center();
    let from = row(&harness, "P02");
    drag(&mut harness, from, picture);
    let beat = harness.state().state().document.visible_transport();
    assert_eq!(beat.map(|beat| (beat.from, beat.onto)), Some((10, 0)));
    let look = harness.state().state().document.viewpoint;
    assert_eq!(look, Default::default(), "the drag turned no heart");
    wait(&mut harness, "both hearts", |app| {
        app.hearts_on_screen().len() == 2
    });
    assert!(
        shows(&harness, "transport from P02 is being computed") || transported(harness.state())
    );
    // By keyboard: the beat of the selected heart on the one beside it, there and back.
    give(
        &mut harness,
        Command::Transport(TransportCommand::StopTransport),
    );
    harness.key_press(egui::Key::T);
    harness.run_steps(3);
    assert_eq!(harness.state().state().document.visible_transport(), beat);
}

#[test]
fn a_transport_can_be_stopped_and_asked_for_again() {
    let mut harness = window(AppOptions::built_in(BuiltInParams {
        vertices: 6_000,
        ..BuiltInParams::default()
    }));
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>())),
    );
    give(
        &mut harness,
        Command::Transport(TransportCommand::SetInterpolatedPoses(0)),
    );
    give(
        &mut harness,
        Command::Transport(TransportCommand::TransportMotion { from: 9, onto: 3 }),
    );
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    assert!(harness.state().busy());
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<MotionTransportQuery>())),
    );
    wait(&mut harness, "the end of the work", |app| !app.busy());
    wait(&mut harness, "both hearts", |app| {
        app.hearts_on_screen().len() == 2
    });
    assert_eq!(
        harness.state().state().answers.transport_state(),
        TransportState::Stopped
    );
    assert!(shows(&harness, "transport from P01 was stopped"));
    assert!(harness.state().state().errors.is_empty());
    harness.get_by_label("Transport again").click();
    harness.run_steps(3);
    assert!(harness.state().busy());
    assert_eq!(
        harness.state().state().answers.transport_state(),
        TransportState::Computing
    );
}

#[test]
fn two_hearts_show_where_they_differ() {
    let mut harness = cohort_window();
    harness.key_press(egui::Key::D);
    harness.run_steps(3);
    assert!(shows(
        &harness,
        "The contribution to the distance needs two subjects side by side"
    ));
    assert!(!shows(&harness, "relative to the mean"));
    give(
        &mut harness,
        Command::View(ViewCommand::SetViewMode(ViewMode::SideBySide)),
    );
    give(
        &mut harness,
        Command::Select(SelectCommand::CompareWith(Some(12))),
    );
    wait(&mut harness, "the difference", |app| {
        app.state().answers.difference().is_some() && app.hearts_on_screen().len() == 2
    });
    harness.run();
    assert!(shows(
        &harness,
        "Contribution to the distance, relative to the mean"
    ));
    let at_rest = harness
        .state()
        .state()
        .answers
        .difference()
        .unwrap()
        .clone();
    let mean = at_rest[0].iter().sum::<f32>() / at_rest[0].len() as f32;
    assert!(
        (0.2..5.0).contains(&mean),
        "densities lie about 1, not {mean}"
    );
    // At another frame the old one stays until the new one is there.
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(3.0)),
    );
    assert!(harness.state().state().answers.difference().is_some());
    wait(&mut harness, "the next difference", |app| {
        app.state()
            .answers
            .difference()
            .is_some_and(|now| *now != at_rest)
    });
    give(
        &mut harness,
        Command::View(ViewCommand::SetViewMode(ViewMode::Single)),
    );
    harness.run();
    assert!(shows(
        &harness,
        "The contribution to the distance needs two subjects side by side"
    ));
}
