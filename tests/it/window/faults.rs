//! What a quick hand does: keys, clicks and drags that arrive at once, also while another study opens.

use super::*;
use cardiomorph::panes::{EditCommand, FileCommand, SelectCommand, ViewCommand, WallCommand};
use cardiomorph::picture::{Quantity, WallPart};
use egui::accesskit::Role;

/// P05 has a large patch.
const PATCHED: usize = 13;

fn key(key: egui::Key, modifiers: egui::Modifiers) -> egui::Event {
    egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

/// A key that types, as a keyboard sends it.
fn typed(letter: egui::Key, text: &str) -> [egui::Event; 2] {
    let text = egui::Event::Text(text.to_owned());
    [key(letter, egui::Modifiers::NONE), text]
}

fn button(pos: egui::Pos2, pressed: bool) -> egui::Event {
    egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    }
}

/// Events that all arrive in one frame, as they do where a frame takes long.
fn at_once(harness: &mut Harness<'_, App>, events: impl IntoIterator<Item = egui::Event>) {
    harness.input_mut().events.extend(events);
    harness.run_steps(6);
}

fn click_events(at: egui::Pos2) -> [egui::Event; 3] {
    [
        egui::Event::PointerMoved(at),
        button(at, true),
        button(at, false),
    ]
}

/// Presses at a place, moves on in several steps, and lets go.
fn drag(harness: &mut Harness<'_, App>, from: egui::Pos2, onto: egui::Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    for step in 1..=6 {
        harness.hover_at(from.lerp(onto, step as f32 / 6.0));
        harness.step();
    }
    harness.drop_at(onto);
    harness.run_steps(2);
}

fn look(harness: &Harness<'_, App>) -> cardiomorph::document::Viewpoint {
    harness.state().state().document.viewpoint
}

fn opening(harness: &Harness<'_, App>) -> u64 {
    harness.state().state().document.study.opening
}

fn shows(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn letters_of_the_frame_of_ctrl_k_go_to_the_palette() {
    let mut harness = cohort_window();
    harness.run();
    let before = (look(&harness), harness.state().state().document.visibility);
    let keys = [key(egui::Key::K, egui::Modifiers::COMMAND)].into_iter();
    let keys = keys.chain(typed(egui::Key::Num5, "5"));
    at_once(&mut harness, keys.chain(typed(egui::Key::W, "w")));
    let state = harness.state().state();
    assert!(state.sheets.palette);
    assert_eq!(
        before,
        (state.document.viewpoint, state.document.visibility)
    );
    let field = harness.get_by_label("Find a command or a subject");
    assert_eq!(field.accesskit_node().value().as_deref(), Some("5w"));
}

#[test]
fn letters_of_the_frame_of_a_click_go_to_the_field_that_was_clicked() {
    let mut harness = cohort_window();
    harness.run();
    let before = look(&harness);
    let at = harness.get_by_label("Filter subjects").rect().center();
    let events = click_events(at).into_iter();
    at_once(&mut harness, events.chain(typed(egui::Key::Num5, "5")));
    assert_eq!(look(&harness), before);
    assert_eq!(harness.state().state().document.search, "5");
}

#[test]
fn a_digit_after_a_click_on_a_colour_limit_is_typed_into_it() {
    let mut harness = cohort_window();
    let colours = ViewCommand::SetQuantity(Quantity::Displacement);
    give(&mut harness, Command::View(colours));
    harness.run();
    let (before, frame) = (look(&harness), harness.state().state().document.position);
    let at = harness.get_by_label_contains("Upper limit").rect().center();
    let events = click_events(at).into_iter();
    at_once(&mut harness, events.chain(typed(egui::Key::Num9, "9")));
    at_once(&mut harness, typed(egui::Key::Num5, "5"));
    at_once(
        &mut harness,
        [
            key(egui::Key::ArrowLeft, egui::Modifiers::NONE),
            key(egui::Key::Enter, egui::Modifiers::NONE),
        ],
    );
    assert_eq!(look(&harness), before, "the camera stays");
    let document = &harness.state().state().document;
    assert_eq!(document.position, frame, "the frame stays");
    assert_eq!(document.limits().map(|limits| limits[1]), Some(95.0));
}

#[test]
fn a_limit_that_was_typed_but_not_applied_is_not_offered_for_another_quantity() {
    let mut harness = cohort_window();
    let colours = |quantity| Command::View(ViewCommand::SetQuantity(quantity));
    give(&mut harness, colours(Quantity::Displacement));
    harness.run();
    harness.get_by_label_contains("Upper limit").click();
    harness.run();
    harness.get_by_label("To value").focus();
    harness.run();
    harness.get_by_label("To value").type_text("77");
    harness.run();
    let aside = harness.get_by_label("Filter subjects").rect().center();
    click_at(&mut harness, aside);
    harness.run();
    assert!(harness.query_by_label("To value").is_none());
    give(&mut harness, colours(Quantity::AreaRatio));
    harness.run();
    harness.get_by_label_contains("Upper limit").click();
    harness.run();
    let value = harness.get_by_label("To value").accesskit_node().value();
    assert!(!value.clone().unwrap().contains("77"), "{value:?}");
}

#[test]
fn letters_of_the_frame_of_the_question_mark_go_to_its_sheet() {
    let mut harness = cohort_window();
    harness.run();
    let before = look(&harness);
    let mut events = vec![key(egui::Key::Questionmark, egui::Modifiers::SHIFT)];
    events.push(egui::Event::Text("?".to_owned()));
    events.extend(typed(egui::Key::Num5, "5"));
    at_once(&mut harness, events);
    assert!(harness.state().state().sheets.shortcuts);
    assert_eq!(look(&harness), before);
    let field = harness.get_by_label("Search the shortcuts");
    assert_eq!(field.accesskit_node().value().as_deref(), Some("5"));
}

/// Where the pose map has the middle of the poses of N01.
fn mark(harness: &Harness<'_, App>) -> Vec<egui::Rect> {
    let paths = harness.query_all_by_label_contains("Poses of N01");
    paths.map(|node| node.rect()).collect()
}

#[test]
fn another_study_is_looked_at_as_a_whole_on_the_maps() {
    let mut harness = mapped_window();
    let whole = mark(&harness);
    let centre = harness.get_by_label("Pose map").rect().center();
    drag(&mut harness, centre, centre + egui::vec2(40.0, 20.0));
    assert_ne!(mark(&harness), whole);
    harness.remove_cursor();
    let before = opening(&harness);
    give(&mut harness, Command::File(FileCommand::OpenBuiltIn));
    wait(&mut harness, "the study and its map", |app| {
        let state = app.state();
        state.document.study.opening > before && state.map().is_some() && !app.busy()
    });
    harness.run();
    assert_eq!(mark(&harness), whole);
}

#[test]
fn a_drag_that_begins_above_a_map_does_not_move_it() {
    let mut harness = mapped_window();
    let rect = harness.get_by_label("Pose map").rect();
    let before = mark(&harness);
    assert!(!before.is_empty());
    // Beside the tabs and the choosers, which take their own drags.
    let taken: Vec<egui::Rect> = [Role::Tab, Role::Button, Role::ComboBox]
        .into_iter()
        .flat_map(|role| harness.query_all_by_role(role))
        .map(|node| node.rect().expand(6.0))
        .collect();
    let spots = (0..40).map(|step| rect.left() + rect.width() * step as f32 / 40.0);
    let spots = spots.flat_map(|x| [1.5, 3.0, 4.5].map(|above| egui::pos2(x, rect.top() - above)));
    let free = spots.filter(|at| !taken.iter().any(|rect| rect.contains(*at)));
    let free: Vec<egui::Pos2> = free.step_by(7).collect();
    assert!(!free.is_empty());
    for from in free {
        drag(&mut harness, from, rect.center());
        assert_eq!(mark(&harness), before, "from {from:?}, map {rect:?}");
    }
    let here = rect.center() + egui::vec2(0.0, 0.3 * rect.height());
    drag(&mut harness, here, here + egui::vec2(50.0, 0.0));
    assert_ne!(mark(&harness), before, "a drag on the map moves it");
}

#[test]
fn a_drag_that_begins_above_the_3d_view_does_not_turn_the_subject() {
    let mut harness = cohort_window();
    harness.run();
    let rect = harness.get_by_label("3D viewport").rect();
    let before = look(&harness);
    for x in [0.3, 0.5, 0.6] {
        let from = egui::pos2(egui::lerp(rect.x_range(), x), rect.top() - 2.0);
        drag(&mut harness, from, rect.center());
        assert_eq!(look(&harness), before, "at {x}");
    }
}

/// Where the first row of the table is.
fn first_row(harness: &Harness<'_, App>) -> egui::Rect {
    let mut named = harness.get_all_by_label("N01");
    let row = named.find(|node| node.accesskit_node().toggled().is_some());
    row.unwrap().rect()
}

#[test]
fn a_drag_that_begins_on_a_heading_of_the_table_carries_no_subject() {
    let mut harness = cohort_window();
    harness.run();
    let first = first_row(&harness);
    let from = egui::pos2(first.center().x, first.top() - 2.0);
    let onto = harness.get_by_label("N03").rect().center();
    drag(&mut harness, from, onto);
    assert_eq!(harness.state().state().document.transported, None);
}

#[test]
fn a_click_is_applied_before_a_study_that_finished_in_the_same_frame() {
    let mut harness = cohort_window();
    let before = opening(&harness);
    give(&mut harness, Command::File(FileCommand::OpenBuiltIn));
    assert_eq!(opening(&harness), before, "the study is not read at once");
    // The study is made while the window stands still.
    std::thread::sleep(Duration::from_secs(4));
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectSubject(5)));
    harness.step();
    assert_eq!(
        opening(&harness),
        before + 1,
        "the study came in this frame"
    );
    assert_eq!(harness.state().state().document.subject, 0);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(opening(&harness), before);
    assert_eq!(harness.state().state().document.subject, 5);
}

/// Takes a row of the table and holds it.
fn hold(harness: &mut Harness<'_, App>, id: &str) {
    let from = harness.get_by_label(id).rect().center();
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    harness.hover_at(from + egui::vec2(0.0, 30.0));
    harness.run_steps(2);
    assert!(
        egui::DragAndDrop::has_any_payload(&harness.ctx),
        "{id} is held"
    );
}

fn let_go_on(harness: &mut Harness<'_, App>, id: &str) {
    let onto = harness.get_by_label(id).rect().center();
    harness.hover_at(onto);
    harness.step();
    harness.drop_at(onto);
    harness.run_steps(2);
    assert_eq!(harness.state().state().document.transported, None);
}

#[test]
fn a_held_subject_is_let_go_when_a_study_opens() {
    let mut harness = cohort_window();
    harness.run();
    hold(&mut harness, "N02");
    let before = opening(&harness);
    give(&mut harness, Command::File(FileCommand::OpenBuiltIn));
    wait(&mut harness, "the study", |app| {
        app.state().document.study.opening > before
    });
    let_go_on(&mut harness, "N05");
}

#[test]
fn a_held_subject_is_let_go_when_undo_brings_the_study_before() {
    let mut harness = cohort_window();
    let before = opening(&harness);
    give(&mut harness, Command::File(FileCommand::OpenBuiltIn));
    wait(&mut harness, "the study", |app| {
        app.state().document.study.opening > before
    });
    wait_for_heart(&mut harness);
    harness.run();
    hold(&mut harness, "N02");
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(opening(&harness), before);
    let_go_on(&mut harness, "N05");
}

#[test]
fn a_menu_of_a_row_closes_when_a_study_opens() {
    let mut harness = cohort_window();
    harness.run();
    harness.get_by_label("N03").click_secondary();
    harness.run();
    assert!(shows(&harness, "Compare side by side"));
    let before = opening(&harness);
    give(&mut harness, Command::File(FileCommand::OpenBuiltIn));
    wait(&mut harness, "the study", |app| {
        app.state().document.study.opening > before
    });
    assert!(!shows(&harness, "Compare side by side"));
}

#[test]
fn a_patch_does_not_stay_selected_after_a_click_on_a_map() {
    let mut harness = mapped_window();
    let pose = |subject| {
        Command::Select(SelectCommand::SelectPose {
            subject,
            frame: 3,
            play: false,
        })
    };
    give(&mut harness, pose(PATCHED));
    give(
        &mut harness,
        Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(0)))),
    );
    give(&mut harness, pose(PATCHED));
    let part = |harness: &Harness<'_, App>| harness.state().state().document.part;
    assert_eq!(part(&harness), Some(WallPart::Patch(0)), "the same subject");
    give(&mut harness, pose(15));
    assert_eq!(part(&harness), None);
}
