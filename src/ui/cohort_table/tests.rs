//! What the table does under pointer and keys.

use super::*;
use egui_kittest::{Harness, kittest::Queryable as _};

fn rows(count: usize) -> Vec<CohortRow> {
    (0..count)
        .map(|index| CohortRow {
            id: format!("S{index}"),
            ejection_fraction: Some(0.5),
            ..CohortRow::default()
        })
        .collect()
}

fn harness(count: usize, selected: Option<usize>) -> Harness<'static, Vec<Command>> {
    let rows = rows(count);
    let visible: Vec<usize> = (0..count).collect();
    Harness::builder()
        .with_size([280.0, 400.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = CohortView {
                    rows: &rows,
                    visible: &visible,
                    search: "",
                    sort: None,
                    selected,
                    compared: None,
                    measuring: false,
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
    assert_eq!(
        harness.into_state(),
        [Command::SelectSubject(3), Command::SortCohort(3)]
    );
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
    assert_eq!(harness.into_state(), [Command::SelectSubject(2)]);
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
        Some(&Command::SetSearch("minf".to_owned()))
    );
}

#[test]
fn an_empty_cohort_offers_to_open_one() {
    let mut harness = harness(0, None);
    harness.run();
    harness.get_by_label("Open the built-in cohort").click();
    harness.run();
    assert_eq!(harness.into_state(), [Command::OpenBuiltIn]);
}
