//! How well classifiers find the labels: every accuracy beside what shuffled labels reach.

use egui::{
    Align2, Color32, FontId, Rect, Role, Sense, Ui, UiBuilder, Vec2, WidgetInfo, pos2, vec2,
};

use crate::engine::ClassesBy;
use crate::panes::commands::{Command, MapCommand};
use crate::ui::controls::{choices_ui, chooser_ui};
use crate::ui::style::{medium_note_font, note, note_font};
use crate::ui::text::p_text;
use crate::ui::theme::{colours, line, space};

/// One classifier, tested on subjects that were not in its training set.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassifierView {
    /// "Nearest neighbour".
    pub name: &'static str,
    /// What it does, for the hover.
    pub what: &'static str,
    /// How many subjects it puts into their class.
    pub correct: usize,
    /// How many it was tested on.
    pub of: usize,
    /// How many it puts into their class on average where labels are permuted.
    pub permutation_mean: f64,
    /// Share of permutations that do as well.
    pub p_value: f64,
}

/// How the classification stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ClassesView<'a> {
    /// Not asked for, or the map is not there yet.
    #[default]
    Absent,
    /// Being computed.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
    },
    /// Classifiers cannot be trained, and why: "not enough labels".
    Unanswerable(&'a str),
    /// The classifiers with their accuracies.
    Ready(&'a [ClassifierView]),
}

const ROW: f32 = 20.0;
const HEAD: f32 = 24.0;

/// The height that the card takes of a pane; none where the map would be left without room.
pub fn height(pane: Vec2, view: &ClassesView) -> f32 {
    let wanted = match view {
        ClassesView::Absent => 0.0,
        ClassesView::Computing { .. } | ClassesView::Unanswerable(_) => HEAD + 4.0,
        ClassesView::Ready(rows) => HEAD + ROW * rows.len() as f32 + space::MEDIUM,
    };
    if pane.y - wanted < 150.0 { 0.0 } else { wanted }
}

/// Draws the card in the height that [`height`] says.
///
/// `by` is what subjects are classified by, where the study offers both.
pub fn classes_ui(
    ui: &mut Ui,
    view: &ClassesView,
    by: Option<ClassesBy>,
    height: f32,
    commands: &mut Vec<Command>,
) {
    let (card, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let thin = (line::THIN, colours(ui).line);
    ui.painter().hline(card.x_range(), card.top(), thin);
    let inner = card.shrink2(vec2(space::LARGE, 0.0));
    let head = Rect::from_min_size(inner.min, vec2(inner.width(), HEAD));
    let taken = by.map_or(0.0, |by| by_ui(ui, head, by, commands));
    let rest = head.with_min_x((head.left() + taken).min(head.right()));
    match view {
        ClassesView::Absent => {}
        ClassesView::Computing { fraction } => {
            let text = format!("Training classifiers, {:.0} %", 100.0 * fraction);
            line_ui(ui, rest, &text);
        }
        ClassesView::Unanswerable(why) => line_ui(ui, rest, &format!("Classifiers: {why}")),
        ClassesView::Ready(rows) => {
            head_ui(ui, head, by.is_none());
            for (index, row) in rows.iter().enumerate() {
                let top = head.bottom() + ROW * index as f32;
                let size = vec2(inner.width(), ROW);
                row_ui(ui, Rect::from_min_size(pos2(inner.left(), top), size), row);
            }
        }
    }
}

fn line_ui(ui: &mut Ui, head: Rect, text: &str) {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let mut child = ui.new_child(UiBuilder::new().max_rect(head).layout(layout));
    child
        .add(egui::Label::new(note(text)).truncate())
        .on_hover_text(text);
}

/// One column of numbers.
struct Column {
    heading: &'static str,
    width: f32,
    /// Where there is no room, the column with the greatest number goes first.
    order: usize,
    strong: bool,
    text: fn(&ClassifierView) -> String,
}

/// Width of the names.
const NAME: f32 = 158.0;

/// Columns from left to right, each aligned to its right end.
const COLUMNS: [Column; 4] = [
    Column {
        heading: "accuracy",
        width: 60.0,
        order: 0,
        strong: true,
        text: |row| format!("{} of {}", row.correct, row.of),
    },
    Column {
        heading: "",
        width: 42.0,
        order: 2,
        strong: true,
        text: |row| format!("{:.0} %", 100.0 * row.correct as f64 / row.of.max(1) as f64),
    },
    Column {
        heading: "perm. mean",
        width: 72.0,
        order: 1,
        strong: false,
        text: |row| format!("{:.1}", row.permutation_mean),
    },
    Column {
        heading: "p",
        width: 52.0,
        order: 3,
        strong: false,
        text: |row| p_text(row.p_value),
    },
];

/// The columns that have room in a line, each with where it ends.
fn columns(line: Rect) -> Vec<(f32, &'static Column)> {
    let up_to = |count: usize| COLUMNS.iter().filter(move |column| column.order < count);
    let width = |count: usize| up_to(count).map(|column| column.width).sum::<f32>();
    let fits = |count: &usize| NAME + width(*count) <= line.width();
    let count = (0..=COLUMNS.len()).rev().find(fits).unwrap_or_default();
    let mut end = line.right() - width(count);
    up_to(count)
        .map(|column| {
            end += column.width;
            (end, column)
        })
        .collect()
}

/// Chooses what subjects are classified by; the width that it takes.
fn by_ui(ui: &mut Ui, head: Rect, by: ClassesBy, commands: &mut Vec<Command>) -> f32 {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let place = head.with_max_x((head.left() + NAME).min(head.right()));
    let mut child = ui.new_child(UiBuilder::new().max_rect(place).layout(layout));
    let choices = [ClassesBy::Label, ClassesBy::Class].map(|by| (by, by.name()));
    let response = chooser_ui(&mut child, "Classes", by.name(), |ui| {
        let chosen = choices_ui(ui, choices, by);
        commands.extend(chosen.map(|by| Command::from(MapCommand::SetClassesBy(by))));
    });
    response.on_hover_text("The classes of the classifiers: the labels of the study, or what it calls normal and abnormal",);
    child.min_rect().width() + space::MEDIUM
}

/// `named` says what the rows are.
fn head_ui(ui: &mut Ui, head: Rect, named: bool) {
    let muted = colours(ui).muted;
    if named {
        let at = head.left_center();
        write(
            ui,
            at,
            Align2::LEFT_CENTER,
            "Classifier",
            note_font(),
            muted,
        );
    }
    for (end, column) in columns(head) {
        let at = pos2(end, head.center().y);
        write(
            ui,
            at,
            Align2::RIGHT_CENTER,
            column.heading,
            note_font(),
            muted,
        );
    }
    let id = ui.scope_id().with("classifiers");
    ui.interact(head, id, Sense::hover()).on_hover_text(
        "Leave-one-out: each subject in turn is classified by a classifier trained on all \
         others. Permutation mean: mean number of correct subjects over permuted labels; p: share of \
         permutations with at least that accuracy",
    );
}

fn row_ui(ui: &mut Ui, line: Rect, row: &ClassifierView) {
    let id = ui.scope_id().with(("classifier", row.name));
    let response = ui.interact(line, id, Sense::hover());
    let summary = summary(row);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &summary));
    let colours = colours(ui);
    write(
        ui,
        line.left_center(),
        Align2::LEFT_CENTER,
        row.name,
        note_font(),
        colours.text,
    );
    for (end, column) in columns(line) {
        let (font, colour) = if column.strong {
            (medium_note_font(), colours.strong)
        } else {
            (note_font(), colours.muted)
        };
        let (at, text) = (pos2(end, line.center().y), (column.text)(row));
        write(ui, at, Align2::RIGHT_CENTER, &text, font, colour);
    }
    response.on_hover_text(format!("{summary}.\n\n{}", row.what));
}

fn write(ui: &Ui, at: egui::Pos2, anchor: Align2, text: &str, font: FontId, colour: Color32) {
    ui.painter().text(at, anchor, text, font, colour);
}

/// "Nearest neighbour: 20 of 23 · permutation mean 12.4 · p 0.001".
fn summary(row: &ClassifierView) -> String {
    format!(
        "{}: {} of {} · permutation mean {:.1} · p {}",
        row.name,
        row.correct,
        row.of,
        row.permutation_mean,
        p_text(row.p_value)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_accuracy_is_reported_with_its_permutation_mean() {
        let row = ClassifierView {
            name: "Nearest neighbour",
            correct: 20,
            of: 23,
            permutation_mean: 12.43,
            p_value: 0.002,
            ..ClassifierView::default()
        };
        assert_eq!(
            summary(&row),
            "Nearest neighbour: 20 of 23 · permutation mean 12.4 · p 0.002"
        );
        assert_eq!(p_text(0.0004), "< 0.001");
        assert_eq!(p_text(0.34), "0.34");
    }

    #[test]
    fn the_map_keeps_its_room_in_a_low_pane_and_columns_go_from_the_least_important() {
        let rows = vec![ClassifierView::default(); 4];
        let ready = ClassesView::Ready(&rows);
        assert_eq!(height(vec2(300.0, 200.0), &ready), 0.0);
        assert!(height(vec2(300.0, 420.0), &ready) > 80.0);
        let shown = |width: f32| -> Vec<&str> {
            let line = Rect::from_min_size(pos2(0.0, 0.0), vec2(width, ROW));
            let columns = columns(line).into_iter();
            columns.map(|(_, column)| column.heading).collect()
        };
        assert_eq!(shown(400.0), ["accuracy", "", "perm. mean", "p"]);
        assert_eq!(shown(300.0), ["accuracy", "perm. mean"]);
        assert!(shown(160.0).is_empty());
    }
}
