//! Edits of a study in the window: in the row, in its menu and the palette, taken back, written and read again.

use super::*;
use cardiomorph::document::{TypedField, Typing};
use cardiomorph::engine::MeasuresQuery;
use cardiomorph::panes::{EditCommand, FileCommand, ViewCommand, WindowCommand};
use cardiomorph::study::{CoordinateUnit, LabelClass, Landmark, Study, Subject};
use egui::{Key, Modifiers};

pub fn study<'a>(harness: &'a Harness<'_, App>) -> &'a Study {
    harness.state().state().document.study()
}

pub fn ids(harness: &Harness<'_, App>) -> Vec<String> {
    let subjects = study(harness).subjects.iter();
    subjects.map(|subject| subject.id.clone()).collect()
}

pub fn subject<'a>(harness: &'a Harness<'_, App>, id: &str) -> &'a Subject {
    let study = study(harness);
    study.subject(study.index_of(id).unwrap()).unwrap()
}

/// The row of a subject; its id stands elsewhere, too.
pub fn row<'a>(harness: &'a Harness<'_, App>, id: &'a str) -> egui_kittest::Node<'a> {
    harness.get_by_role_and_label(egui::accesskit::Role::ListBoxOption, id)
}

/// Opens the menu of a row and chooses a line of it; a submenu by the beginning of its name.
pub fn choose(harness: &mut Harness<'_, App>, id: &str, lines: &[&str]) {
    row(harness, id).click_secondary();
    harness.run_steps(3);
    for line in lines {
        match harness.query_by_label(line) {
            Some(line) => line.click(),
            None => harness.get_by_label_contains(line).click(),
        }
        harness.run_steps(3);
    }
}

pub fn key(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run_steps(3);
}

pub fn undo(harness: &mut Harness<'_, App>) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(3);
}

pub fn redo(harness: &mut Harness<'_, App>) {
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    harness.run_steps(3);
}

fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run_steps(2);
}

/// Chooses from the palette by its keys.
fn by_palette(harness: &mut Harness<'_, App>, text: &str) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_steps(3);
    type_text(harness, text);
    key(harness, Key::Enter);
}

pub fn card(harness: &Harness<'_, App>) -> String {
    let cards = &harness.state().state().errors;
    cards
        .last()
        .map_or_else(String::new, |card| card.title.clone())
}

#[test]
fn a_label_is_typed_in_the_row_by_keys_alone_and_taken_back() {
    let mut harness = cohort_window();
    let before = subject(&harness, "N01").label.clone();
    key(&mut harness, Key::L);
    harness.get_by_label("Label of N01");
    type_text(&mut harness, "MINF");
    key(&mut harness, Key::Enter);
    assert_eq!(subject(&harness, "N01").label.as_deref(), Some("MINF"));
    assert!(harness.query_by_label("Label of N01").is_none());
    // The keys belong to the window again.
    key(&mut harness, Key::Space);
    assert!(harness.state().state().play.playing);
    key(&mut harness, Key::Space);
    undo(&mut harness);
    assert_eq!(subject(&harness, "N01").label, before);
    redo(&mut harness);
    assert_eq!(subject(&harness, "N01").label.as_deref(), Some("MINF"));
}

#[test]
fn a_label_that_exists_is_offered_and_escape_changes_nothing() {
    let mut harness = cohort_window();
    let other = subject(&harness, "P01").label.clone().unwrap();
    choose(&mut harness, "N02", &["Edit label…"]);
    type_text(&mut harness, &other[..2]);
    key(&mut harness, Key::ArrowDown);
    key(&mut harness, Key::Enter);
    assert_eq!(subject(&harness, "N02").label.as_ref(), Some(&other));
    undo(&mut harness);
    choose(&mut harness, "N02", &["Edit label…"]);
    harness
        .get_by_role_and_label(egui::accesskit::Role::ListBoxOption, &other)
        .click();
    harness.run_steps(3);
    assert_eq!(subject(&harness, "N02").label.as_ref(), Some(&other));
    choose(&mut harness, "N03", &["Edit label…"]);
    type_text(&mut harness, "nothing");
    let steps = harness.state().state().history.can_redo();
    key(&mut harness, Key::Escape);
    assert_ne!(subject(&harness, "N03").label.as_deref(), Some("nothing"));
    assert_eq!(harness.state().state().typing, None);
    assert!(!steps);
}

#[test]
fn all_subjects_that_the_filter_shows_get_a_label_in_one_step() {
    let mut harness = cohort_window();
    give(&mut harness, ViewCommand::SetSearch("N0".to_owned()).into());
    harness.run_steps(2);
    let shown = study(&harness)
        .subjects
        .iter()
        .filter(|s| s.id.starts_with("N0"))
        .count();
    choose(
        &mut harness,
        "N02",
        &[&format!("Edit label of the {shown} shown…")],
    );
    harness.get_by_label(&format!("Label of {shown} subjects"));
    type_text(&mut harness, "control");
    key(&mut harness, Key::Enter);
    let labelled = |harness: &Harness<'_, App>| {
        let subjects = study(harness).subjects.iter();
        subjects
            .filter(|subject| subject.label.as_deref() == Some("control"))
            .count()
    };
    assert_eq!(labelled(&harness), shown);
    undo(&mut harness);
    assert_eq!(labelled(&harness), 0);
}

#[test]
fn the_class_of_a_label_is_chosen_in_the_menu_of_a_row() {
    let mut harness = cohort_window();
    let label = subject(&harness, "P01").label.clone().unwrap();
    let class = |harness: &Harness<'_, App>| study(harness).class_of(subject(harness, "P01"));
    let before = class(&harness);
    assert_eq!(before, LabelClass::Abnormal);
    choose(
        &mut harness,
        "P01",
        &[&format!("Class of the label {label}"), "Normal"],
    );
    assert_eq!(class(&harness), LabelClass::Normal);
    undo(&mut harness);
    assert_eq!(class(&harness), before);
}

#[test]
fn a_name_that_is_taken_is_refused_while_it_is_typed_and_figures_have_the_new_one() {
    let mut harness = cohort_window();
    choose(&mut harness, "N01", &["Rename subject…"]);
    type_text(&mut harness, "N02");
    key(&mut harness, Key::Enter);
    harness.get_by_label("Another subject has the id N02");
    assert_eq!(ids(&harness)[0], "N01");
    assert!(
        harness.state().state().typing.is_some(),
        "it can be corrected"
    );
    type_text(&mut harness, "x");
    key(&mut harness, Key::Enter);
    assert_eq!(ids(&harness)[0], "N02x");
    let folder = tempfile::tempdir().unwrap();
    let tables = FileCommand::ExportTables(Some(folder.path().to_owned()));
    give(&mut harness, tables.into());
    wait(&mut harness, "the tables", |app| !app.busy());
    let text = std::fs::read_to_string(folder.path().join("subjects.csv")).unwrap();
    assert!(text.contains("N02x") && !text.contains("N01"), "{text}");
    undo(&mut harness);
    assert_eq!(ids(&harness)[0], "N01");
}

#[test]
fn a_deleted_subject_comes_back_with_its_row_selection_and_results() {
    let mut harness = mapped_window();
    give(&mut harness, SelectCommand::SelectSubject(4).into());
    harness.run_steps(2);
    let before = harness.state().state().document.clone();
    let ejection = harness.state().state().measures_of(4).unwrap().ef;
    key(&mut harness, Key::Delete);
    assert_eq!(study(&harness).subjects.len(), 22);
    // Until the next heart is ready, this one stays on screen with its name.
    wait(&mut harness, "the next heart", |app| !app.busy());
    harness.run_steps(2);
    assert!(
        harness
            .query_by_label(&before.selected().unwrap().id)
            .is_none()
    );
    wait(&mut harness, "measures", |app| {
        app.known(&MeasuresQuery).is_some_and(|all| all.len() == 22)
    });
    undo(&mut harness);
    assert_eq!(harness.state().state().document, before);
    wait(&mut harness, "the results", |app| {
        app.state().measures().is_some()
    });
    assert_eq!(harness.state().state().measures_of(4).unwrap().ef, ejection);
    redo(&mut harness);
    assert_eq!(study(&harness).subjects.len(), 22);
}

#[test]
fn the_menu_is_of_its_row_whoever_is_selected_meanwhile() {
    let mut harness = cohort_window();
    row(&harness, "N04").click_secondary();
    harness.run_steps(3);
    give(&mut harness, SelectCommand::SelectSubject(7).into());
    give(
        &mut harness,
        ViewCommand::SetSearch("N04".to_owned()).into(),
    );
    harness.run_steps(2);
    harness.get_by_label("Exclude from the cohort").click();
    harness.run_steps(3);
    assert!(!ids(&harness).contains(&"N04".to_owned()));
    assert_eq!(study(&harness).excluded[0].subject.id, "N04");
    // The keyboard opens the menu of the selected row.
    give(&mut harness, ViewCommand::SetSearch(String::new()).into());
    harness.run_steps(2);
    key(&mut harness, Key::Menu);
    harness.get_by_label("Rename subject…").click();
    harness.run_steps(3);
    let typing = harness.state().state().typing.clone().unwrap();
    let selected = harness.state().state().document.subject;
    assert_eq!((typing.field, typing.subject), (TypedField::Name, selected));
}

#[test]
fn the_unit_is_chosen_in_the_palette_and_volumes_follow() {
    let mut harness = cohort_window();
    let before = harness.state().state().measures_of(0).unwrap().clone();
    by_palette(&mut harness, "unit of all subjects: unknown");
    wait(&mut harness, "measures in file units", |app| {
        app.state()
            .measures_of(0)
            .is_some_and(|measures| measures.mass.is_none())
            && !app.busy()
    });
    by_palette(&mut harness, "unit: centimetres");
    assert_eq!(
        subject(&harness, "N01").coordinate_unit(),
        CoordinateUnit::Centimetre
    );
    assert_eq!(
        subject(&harness, "N02").coordinate_unit(),
        CoordinateUnit::Unknown
    );
    undo(&mut harness);
    undo(&mut harness);
    wait(&mut harness, "the old measures", |app| {
        app.state().measures_of(0) == Some(&before)
    });
}

#[test]
fn a_clicked_point_becomes_the_septum_and_the_segments_follow() {
    let mut harness = cohort_window();
    wait(&mut harness, "the wall", |app| {
        matches!(app.state().wall_of(0), Some((Ok(_), true)))
    });
    let known = subject(&harness, "N01").anatomy.unwrap();
    let segments = |harness: &Harness<'_, App>| {
        let wall = harness.state().state().wall_of(0).unwrap().0.clone();
        wall.unwrap().segments.clone()
    };
    let before = segments(&harness);
    let centre = harness.get_by_label("3D viewport").rect().center();
    click_at(&mut harness, centre);
    harness.run_steps(2);
    let picked = harness.state().state().picked.unwrap();
    assert_eq!(picked.subject, 0);
    let first = subject(&harness, "N01").sequence.pose(0).unwrap();
    let nearest = first
        .iter()
        .map(|p| (p - picked.at).norm())
        .fold(f64::MAX, f64::min);
    assert!(nearest < 0.01, "a vertex of the first frame: {nearest} mm");
    by_palette(&mut harness, "landmarks: septum at");
    let anatomy = subject(&harness, "N01").anatomy.unwrap();
    assert_ne!(anatomy.septal, known.septal);
    let across = picked.at - anatomy.base;
    assert!(across.dot(&anatomy.septal) > 0.0);
    wait(&mut harness, "the segments", |app| {
        matches!(app.state().wall_of(0), Some((Ok(_), true)))
    });
    assert_ne!(segments(&harness), before);
    undo(&mut harness);
    assert_eq!(subject(&harness, "N01").anatomy, Some(known));
    give(
        &mut harness,
        EditCommand::SetLandmark(Landmark::Apex).into(),
    );
    assert_eq!(
        subject(&harness, "N01").anatomy,
        Some(known),
        "nothing is clicked any more"
    );
}

#[test]
fn the_frame_on_screen_becomes_end_systole_unless_it_is_end_diastole() {
    let mut harness = cohort_window();
    let (end_diastole, end_systole) = harness.state().state().phases_of(0);
    let other = (0..8)
        .find(|f| Some(*f) != end_diastole && Some(*f) != end_systole)
        .unwrap();
    give(
        &mut harness,
        PlaybackCommand::SetPosition(other as f64).into(),
    );
    choose(
        &mut harness,
        "N01",
        &[&format!("Frame {other} is end-systole")],
    );
    assert_eq!(subject(&harness, "N01").end_systole, Some(other));
    choose(&mut harness, "N01", &["End-systole from the volume curve"]);
    assert_eq!(subject(&harness, "N01").end_systole, None);
    give(
        &mut harness,
        PlaybackCommand::SetPosition(end_diastole.unwrap() as f64).into(),
    );
    wait(&mut harness, "measures", |app| {
        app.state().measures().is_some()
    });
    by_palette(&mut harness, "end-systole: this frame");
    assert_eq!(subject(&harness, "N01").end_systole, None);
    assert!(
        card(&harness).ends_with("is not end-systole"),
        "{}",
        card(&harness)
    );
}

#[test]
fn a_row_that_is_typed_into_is_shown_whatever_pane_and_filter_hide_it() {
    let mut harness = cohort_window();
    give(&mut harness, WindowCommand::TogglePane(Pane::COHORT).into());
    give(&mut harness, ViewCommand::SetSearch("P".to_owned()).into());
    let typing = Typing {
        field: TypedField::Label,
        subject: 0,
        subjects: vec![0],
    };
    give(&mut harness, EditCommand::Type(typing).into());
    harness.run_steps(4);
    harness.get_by_label("Label of N01");
}
