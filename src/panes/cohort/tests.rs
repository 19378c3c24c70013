//! What the table does under pointer and keys.

use super::columns::VerdictRoom;
use super::*;
use crate::panes::{FileCommand, SelectCommand, TransportCommand, ViewCommand};
use egui::Key;
use egui_kittest::{Harness, kittest::Queryable as _};

fn rows(count: usize) -> Vec<CohortRow> {
    (0..count)
        .map(|index| CohortRow {
            id: format!("S{index}"),
            ejection_fraction: Some(0.5),
            correspondence: usize::from(index == 4),
            verdict: (index == 3).then(|| CohortVerdict {
                mark: crate::panes::VerdictMark::Patch,
                share: Some(0.31),
                probability: Some(0.97),
                words: "Abnormal patch".to_owned(),
            }),
            ..CohortRow::default()
        })
        .collect()
}

fn harness(count: usize, selected: Option<usize>) -> Harness<'static, Vec<Command>> {
    let visible = (0..count).collect();
    harness_of(count, visible, "", selected)
}

/// A table of `count` subjects of which a search leaves some.
fn harness_of(
    count: usize,
    visible: Vec<usize>,
    search: &'static str,
    selected: Option<usize>,
) -> Harness<'static, Vec<Command>> {
    let rows = rows(count);
    Harness::builder()
        .with_size([280.0, 400.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = CohortView {
                    rows: &rows,
                    visible: &visible,
                    search,
                    sort: None,
                    selected,
                    compared: None,
                    measuring: false,
                    classifying: false,
                    ..CohortView::default()
                };
                cohort_table_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

#[test]
fn a_click_selects_a_row_and_a_heading_sorts() {
    let mut harness = harness(5, None);
    harness.run();
    harness.get_by_label("S3").click();
    harness.run();
    harness.get_by_label("Sort by EF %").click();
    harness.run();
    harness.get_by_label("Sort by Verdict").click();
    harness.run();
    assert_eq!(
        harness.into_state(),
        [
            Command::Select(SelectCommand::SelectSubject(3)),
            Command::View(ViewCommand::SortCohort(CohortColumn::EjectionFraction)),
            Command::View(ViewCommand::SortCohort(CohortColumn::Verdict))
        ]
    );
}

#[test]
fn columns_keep_apart_at_any_width_and_give_up_words_before_names() {
    for width in [150.0, 180.0, 220.0, 250.0, 280.0, 300.0, 340.0, 500.0] {
        for labelled in [true, false] {
            let columns = Columns::within(egui::Rangef::new(10.0, 10.0 + width), labelled, 200.0);
            let spans: Vec<[f32; 2]> = (rows::COLUMNS.iter())
                .map(|spec| columns.span(spec.column))
                .filter(|[left, right]| left < right)
                .collect();
            for pair in spans.windows(2) {
                assert!(pair[0][1] <= pair[1][0] + 0.01, "{width}: {pair:?}");
            }
            let [_, end] = columns.span(CohortColumn::Verdict);
            assert!(end <= 10.0 + width - space::LARGE + 0.01);
            let [left, right] = columns.span(CohortColumn::Subject);
            assert!(
                width < 200.0 || right - left > 40.0,
                "{width}: {left} {right}"
            );
        }
    }
    let room = |width: f32| Columns::within(egui::Rangef::new(0.0, width), true, 24.0).room;
    assert!(room(300.0) == VerdictRoom::Words && room(264.0) == VerdictRoom::Words);
    assert!(room(236.0) == VerdictRoom::Share && room(190.0) == VerdictRoom::Mark);
    // Labels take what short names leave.
    let label = |names: f32| {
        let columns = Columns::within(egui::Rangef::new(0.0, 300.0), true, names);
        let [left, right] = columns.span(CohortColumn::Label);
        right - left
    };
    assert!(label(24.0) > label(200.0) + 8.0 && label(24.0) == label(0.0));
}

#[test]
fn rows_can_be_reached_and_selected_by_keyboard() {
    let mut harness = harness(5, None);
    harness.run();
    harness.get_by_label("S1").focus();
    harness.run();
    harness.key_press(Key::Tab);
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(
        harness.into_state(),
        [Command::Select(SelectCommand::SelectSubject(2))]
    );
}

#[test]
fn of_thousands_of_rows_only_those_in_sight_are_drawn() {
    let mut harness = harness(5000, Some(4000));
    harness.run();
    let drawn = harness
        .query_all_by_role(Role::ListBoxOption)
        .filter(|row| row.rect().height() > 1.0)
        .count();
    assert!(drawn > 5 && drawn < 30, "{drawn}");
    // The selected row was scrolled into sight.
    harness.get_by_label("S4000");
}

#[test]
fn what_is_typed_becomes_the_filter() {
    let mut harness = harness(3, None);
    harness.run();
    harness.get_by_label("Filter subjects").focus();
    harness.run();
    harness.get_by_label("Filter subjects").type_text("minf");
    harness.run();
    assert_eq!(
        harness.state().last(),
        Some(&Command::View(ViewCommand::SetSearch("minf".to_owned())))
    );
}

#[test]
fn an_empty_cohort_offers_to_open_one() {
    let mut harness = harness(0, None);
    harness.run();
    harness.get_by_label("Open the built-in cohort").click();
    harness.run();
    assert_eq!(
        harness.into_state(),
        [Command::File(FileCommand::OpenBuiltIn)]
    );
}

fn drag(harness: &mut Harness<'static, Vec<Command>>, from: &str, onto: &str) {
    let [from, onto] = [from, onto].map(|id| harness.get_by_label(id).rect().center());
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    for step in 1..=4 {
        harness.hover_at(from.lerp(onto, step as f32 / 4.0));
        harness.step();
    }
    harness.drop_at(onto);
    harness.step();
}

#[test]
fn a_row_dropped_on_another_transports_its_motion() {
    let mut harness = harness(5, Some(2));
    harness.run();
    drag(&mut harness, "S1", "S3");
    let wanted = Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 3 });
    assert_eq!(harness.state().as_slice(), [wanted]);
    // Dropped where the drag began, it is neither a drop nor a click.
    drag(&mut harness, "S1", "S1");
    assert_eq!(harness.state().len(), 1);
    // Without correspondence the command is given all the same: the window says why it is refused.
    drag(&mut harness, "S1", "S4");
    let refused = Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 4 });
    assert_eq!(harness.state().last(), Some(&refused));
}

#[test]
fn a_drag_that_is_broken_off_does_nothing() {
    let mut harness = harness(5, None);
    harness.run();
    let [from, onto] = ["S1", "S3"].map(|id| harness.get_by_label(id).rect().center());
    harness.drag_at(from);
    harness.step();
    harness.hover_at(onto);
    harness.step();
    harness.key_press(Key::Escape);
    harness.step();
    harness.drop_at(onto);
    harness.step();
    assert_eq!(harness.into_state(), []);
}

#[test]
fn the_menu_of_a_row_offers_both_directions() {
    let mut harness = harness(5, Some(0));
    harness.run();
    harness.get_by_label("S2").click_secondary();
    harness.run();
    harness.get_by_label("Transport motion: S2 → S0").click();
    harness.run();
    assert_eq!(
        harness.into_state(),
        [Command::Transport(TransportCommand::TransportMotion {
            from: 2,
            onto: 0
        })]
    );
}

/// What the table asks for when Esc is pressed, in its filter box or elsewhere.
fn on_escape(search: &'static str, in_box: bool) -> Vec<Command> {
    let mut harness = harness_of(3, vec![1], search, None);
    harness.run();
    if in_box {
        harness.get_by_label("Filter subjects").focus();
        harness.run();
    }
    harness.key_press(Key::Escape);
    harness.run();
    harness.into_state()
}

#[test]
fn escape_clears_the_filter_from_its_box_and_from_anywhere() {
    let clear = Command::View(ViewCommand::SetSearch(String::new()));
    assert_eq!(on_escape("S1", true), std::slice::from_ref(&clear));
    assert_eq!(on_escape("S1", false), [clear]);
    assert_eq!(on_escape("", true), []);
}

#[test]
fn a_filter_says_how_many_of_all_subjects_it_shows() {
    assert_eq!(rows::count_text(6, 23), "6 of 23");
    assert_eq!(rows::count_text(23, 23), "23");
}
