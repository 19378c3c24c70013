//! How well classes can be told apart: every accuracy beside what chance reaches.

use egui::{Align2, Color32, FontId, Rect, Role, Sense, Ui, Vec2, WidgetInfo, pos2, vec2};

use crate::ui::style::{medium_note_font, note_font};
use crate::ui::theme::{colours, line, space};

/// One rule, tried on hearts that it had not seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RuleView {
    /// "Nearest neighbour".
    pub name: &'static str,
    /// What it does, for the hover.
    pub what: &'static str,
    /// How many hearts it put into their class.
    pub correct: usize,
    /// How many it was tried on.
    pub of: usize,
    /// How many it puts right on average where labels are shuffled.
    pub chance: f64,
    /// How often shuffled labels do as well.
    pub p_value: f64,
}

/// How the classes stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ClassesView<'a> {
    /// Not asked for, or the map is not there yet.
    #[default]
    Absent,
    /// Being tried.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
    },
    /// Rules cannot be tried, and why: "not enough labels".
    Unanswerable(&'a str),
    /// What was found.
    Ready(&'a [RuleView]),
}

const ROW: f32 = 20.0;
const HEAD: f32 = 24.0;

/// The height that the card takes of a pane; none where the map would be left without room.
pub fn height(pane: Vec2, view: &ClassesView) -> f32 {
    let wanted = match view {
        ClassesView::Absent => 0.0,
        ClassesView::Computing { .. } | ClassesView::Unanswerable(_) => HEAD + 4.0,
        ClassesView::Ready(rules) => HEAD + ROW * rules.len() as f32 + space::MEDIUM,
    };
    if pane.y - wanted < 150.0 { 0.0 } else { wanted }
}

/// Draws the card in the height that [`height`] says.
pub fn classes_ui(ui: &mut Ui, view: &ClassesView, height: f32) {
    let (card, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let colours = colours(ui);
    ui.painter()
        .hline(card.x_range(), card.top(), (line::THIN, colours.line));
    let inner = card.shrink2(vec2(space::LARGE, 0.0));
    let head = Rect::from_min_size(inner.min, vec2(inner.width(), HEAD));
    match view {
        ClassesView::Absent => {}
        ClassesView::Computing { fraction } => {
            let text = format!("Trying rules on the labels, {:.0} %", 100.0 * fraction);
            line_ui(ui, head, &text, "");
        }
        ClassesView::Unanswerable(why) => {
            line_ui(ui, head, &format!("Classes: {why}"), why);
        }
        ClassesView::Ready(rules) => {
            let columns = Columns::within(inner);
            columns.head_ui(ui, head);
            for (index, rule) in rules.iter().enumerate() {
                let top = head.bottom() + ROW * index as f32;
                let row = Rect::from_min_size(pos2(inner.left(), top), vec2(inner.width(), ROW));
                rule_ui(ui, row, rule, &columns);
            }
        }
    }
}

fn line_ui(ui: &mut Ui, head: Rect, text: &str, hover: &str) {
    let mut child = ui.new_child(
        egui::UiBuilder::new()
            .max_rect(head)
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    let label = egui::Label::new(crate::ui::style::note(text)).truncate();
    let response = child.add(label);
    if !hover.is_empty() {
        response.on_hover_text(hover);
    }
}

/// Where columns end; those without room are left out, from the right.
struct Columns {
    name: f32,
    correct: Option<f32>,
    share: Option<f32>,
    chance: Option<f32>,
    p_value: Option<f32>,
}

const NAME: f32 = 112.0;
const SHARE: f32 = 46.0;
const CORRECT: f32 = 66.0;
const CHANCE: f32 = 56.0;
const P_VALUE: f32 = 56.0;

impl Columns {
    fn within(inner: Rect) -> Self {
        let mut free = inner.width() - NAME;
        let mut take = |width: f32| {
            let fits = free >= width;
            free -= width;
            fits
        };
        let shown = [take(CORRECT), take(CHANCE), take(SHARE), take(P_VALUE)];
        let mut right = inner.right();
        let mut place = |shown: bool, width: f32| {
            shown.then(|| {
                let at = right;
                right -= width;
                at
            })
        };
        let p_value = place(shown[3], P_VALUE);
        let chance = place(shown[1], CHANCE);
        let share = place(shown[2], SHARE);
        let correct = place(shown[0], CORRECT);
        Self {
            name: inner.left(),
            correct,
            share,
            chance,
            p_value,
        }
    }

    fn head_ui(&self, ui: &Ui, head: Rect) {
        let muted = colours(ui).muted;
        let y = head.center().y;
        write(ui, self.name, y, "Told apart by", note_font(), muted, false);
        for (at, text) in [
            (self.correct.or(self.share), "right"),
            (self.chance, "chance"),
            (self.p_value, "p"),
        ] {
            if let Some(x) = at
                && self.correct.is_some()
            {
                write(ui, x, y, text, note_font(), muted, true);
            }
        }
    }
}

fn write(ui: &Ui, x: f32, y: f32, text: &str, font: FontId, colour: Color32, right: bool) {
    let anchor = if right {
        Align2::RIGHT_CENTER
    } else {
        Align2::LEFT_CENTER
    };
    ui.painter().text(pos2(x, y), anchor, text, font, colour);
}

fn rule_ui(ui: &mut Ui, row: Rect, rule: &RuleView, columns: &Columns) {
    let id = ui.scope_id().with(("rule", rule.name));
    let response = ui.interact(row, id, Sense::hover());
    let said = said(rule);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
    let colours = colours(ui);
    let y = row.center().y;
    write(
        ui,
        columns.name,
        y,
        rule.name,
        note_font(),
        colours.text,
        false,
    );
    let share = 100.0 * rule.correct as f64 / rule.of.max(1) as f64;
    let cells = [
        (
            columns.correct,
            format!("{} of {}", rule.correct, rule.of),
            colours.strong,
        ),
        (columns.share, format!("{share:.0} %"), colours.strong),
        (columns.chance, format!("{:.1}", rule.chance), colours.muted),
        (columns.p_value, p_text(rule.p_value), colours.muted),
    ];
    for (at, text, colour) in cells {
        if let Some(x) = at {
            let font = if colour == colours.strong {
                medium_note_font()
            } else {
                note_font()
            };
            write(ui, x, y, &text, font, colour, true);
        }
    }
    response.on_hover_text(format!("{said}.\n\n{}", rule.what));
}

/// "Nearest neighbour: 20 of 23 right, chance 12.4, p 0.001".
fn said(rule: &RuleView) -> String {
    format!(
        "{}: {} of {} · chance {:.1} · p {}",
        rule.name,
        rule.correct,
        rule.of,
        rule.chance,
        p_text(rule.p_value)
    )
}

fn p_text(p: f64) -> String {
    if p < 0.001 {
        "< 0.001".to_owned()
    } else if p < 0.1 {
        format!("{p:.3}")
    } else {
        format!("{p:.2}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_is_told_with_its_chance() {
        let rule = RuleView {
            name: "Nearest neighbour",
            correct: 20,
            of: 23,
            chance: 12.43,
            p_value: 0.002,
            ..RuleView::default()
        };
        assert_eq!(
            said(&rule),
            "Nearest neighbour: 20 of 23 · chance 12.4 · p 0.002"
        );
        assert_eq!(p_text(0.0004), "< 0.001");
        assert_eq!(p_text(0.34), "0.34");
    }

    #[test]
    fn the_map_keeps_its_room_in_a_low_pane() {
        let rules = vec![RuleView::default(); 4];
        let ready = ClassesView::Ready(&rules);
        assert_eq!(height(vec2(300.0, 200.0), &ready), 0.0);
        assert!(height(vec2(300.0, 420.0), &ready) > 80.0);
    }
}
