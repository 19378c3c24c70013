//! One method: its name and difference, and below it a box strip for each pose.

use egui::{Align2, Color32, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use crate::panes::thickness::{Difference, ThicknessPanelView, ThicknessRow, ThicknessStrip};
use crate::picture::nice_ticks;
use crate::ui::style::{medium_font, note, note_font};
use crate::ui::text::note_at;
use crate::ui::theme::{Colours, colours, line, space};

/// Height of the line with the name.
const LINE: f32 = 20.0;
/// Height of a strip.
const STRIP: f32 = 16.0;
/// Width of the names of poses.
const MOMENT: f32 = 48.0;
/// Width of the numbers, with and without their range.
const NUMBERS: [f32; 2] = [96.0, 30.0];
/// Width below which numbers lose their range.
const NARROW: f32 = 210.0;

/// Where names, strips and numbers lie.
struct Columns {
    left: f32,
    axis: [f32; 2],
    right: f32,
    wide: bool,
    max: f64,
}

impl Columns {
    fn of(area: Rect, max: f64) -> Self {
        let wide = area.width() >= NARROW;
        let numbers = if wide { NUMBERS[0] } else { NUMBERS[1] };
        let from = area.left() + MOMENT;
        let to = (area.right() - numbers - space::MEDIUM).max(from + 20.0);
        Self {
            left: area.left(),
            axis: [from, to],
            right: area.right(),
            wide,
            max: if max > 0.0 { max } else { 1.0 },
        }
    }

    fn x(&self, value: f64) -> f32 {
        let share = (value / self.max).clamp(0.0, 1.0) as f32;
        self.axis[0] + share * (self.axis[1] - self.axis[0])
    }

    fn ticks(&self) -> Vec<f64> {
        let wanted = ((self.axis[1] - self.axis[0]) / 34.0).max(1.0) as usize;
        nice_ticks(0.0, self.max, wanted)
    }
}

/// The axis that all strips share, with its unit.
pub(super) fn axis_ui(ui: &mut Ui, view: &ThicknessPanelView) {
    let (area, _) = ui.allocate_exact_size(vec2(ui.available_width(), STRIP), Sense::hover());
    let columns = Columns::of(area, view.max);
    for tick in columns.ticks() {
        let at = pos2(columns.x(tick), area.center().y);
        note_at(ui, at, Align2::CENTER_CENTER, tick);
    }
    let at = pos2(columns.right, area.center().y);
    note_at(ui, at, Align2::RIGHT_CENTER, view.unit);
}

/// One method.
pub(super) fn row_ui(ui: &mut Ui, view: &ThicknessPanelView, row: &ThicknessRow) {
    title_ui(ui, view, row);
    for strip in &row.strips {
        strip_ui(ui, view, row, strip);
    }
    if let Some(reason) = &row.reason {
        ui.add(egui::Label::new(note(format!("Not applicable: {reason}"))).wrap());
    }
    ui.add_space(space::SMALL);
}

fn title_ui(ui: &mut Ui, view: &ThicknessPanelView, row: &ThicknessRow) {
    let (area, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::hover());
    let colours = colours(ui);
    let difference = difference_text(row);
    let words = row_words(view, row);
    response.widget_info(|| WidgetInfo::labeled(Role::Row, true, &words));
    let at = |x: f32| pos2(x, area.center().y);
    let painter = ui.painter();
    let right = painter.layout_no_wrap(difference, note_font(), colours.text);
    let left = area.right() - right.size().x;
    let place = Align2::RIGHT_CENTER.anchor_size(at(area.right()), right.size());
    painter.galley(place.min, right, colours.text);
    let clip = Rect::from_x_y_ranges(area.left()..=(left - space::SMALL), area.y_range());
    let painter = painter.with_clip_rect(clip.intersect(ui.clip_rect()));
    let name = painter.text(
        at(area.left()),
        Align2::LEFT_CENTER,
        &row.name,
        medium_font(),
        colours.strong,
    );
    if let Some(seconds) = row.seconds {
        let text = painter.layout_no_wrap(seconds_text(seconds), note_font(), colours.muted);
        let beside = at(name.right() + space::MEDIUM);
        let place = Align2::LEFT_CENTER.anchor_size(beside, text.size());
        // Without room it is shown on hover only.
        if place.right() + space::MEDIUM <= left {
            painter.galley(place.min, text, colours.muted);
        }
    }
    response.on_hover_text(format!("{words}. {}", row.hint));
}

/// "+0.31 ± 0.62 mm" without the unit; the method that others are compared with is marked "reference".
fn difference_text(row: &ThicknessRow) -> String {
    match (row.reference, row.difference) {
        (true, _) => "reference".to_owned(),
        (false, Some(difference)) => signed(&difference),
        (false, None) => "–".to_owned(),
    }
}

fn signed(difference: &Difference) -> String {
    let bias = format!("{:+.2}", difference.bias).replace('-', "−");
    format!("{bias} ± {:.2}", difference.deviation)
}

fn seconds_text(seconds: f64) -> String {
    if seconds < 0.0095 {
        format!("{:.0} ms", (1000.0 * seconds).max(1.0))
    } else {
        format!("{seconds:.2} s")
    }
}

/// The whole row in words.
fn row_words(view: &ThicknessPanelView, row: &ThicknessRow) -> String {
    let mut words = row.name.clone();
    for strip in &row.strips {
        words += &format!(", {} {} {}", strip.moment, range_text(strip), view.unit);
    }
    if let Some(difference) = &row.difference {
        words += &format!(
            ", {} {} from medial spheres at {} over {} vertices",
            signed(difference),
            view.unit,
            view.moment,
            difference.pairs
        );
    }
    if let Some(seconds) = row.seconds {
        words += &format!(", {} per pose", seconds_text(seconds));
    }
    words
}

/// "9.1 (6.2–12.4)".
fn range_text(strip: &ThicknessStrip) -> String {
    let [low, _, median, _, high] = strip.quantiles;
    format!("{median:.1} ({low:.1}–{high:.1})")
}

fn strip_ui(ui: &mut Ui, view: &ThicknessPanelView, row: &ThicknessRow, strip: &ThicknessStrip) {
    let (area, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), STRIP), Sense::hover());
    let (columns, colours) = (Columns::of(area, view.max), colours(ui));
    let text = if strip.on_screen {
        colours.selection
    } else {
        colours.muted
    };
    let painter = ui.painter();
    let middle = area.center().y;
    let (at, name) = (pos2(columns.left, middle), &strip.moment);
    painter.text(at, Align2::LEFT_CENTER, name, note_font(), text);
    for tick in columns.ticks() {
        let stroke = Stroke::new(line::THIN, colours.grid);
        painter.vline(columns.x(tick), area.y_range(), stroke);
    }
    box_strip(ui, &columns, strip, middle, fill(colours, row, strip));
    let number = if columns.wide {
        range_text(strip)
    } else {
        format!("{:.1}", strip.quantiles[2])
    };
    let at = pos2(columns.right, middle);
    painter.text(at, Align2::RIGHT_CENTER, number, note_font(), colours.text);
    response.on_hover_text(format!(
        "{} at {}: interquartile range {:.1} to {:.1} {}",
        row.name, strip.moment, strip.quantiles[1], strip.quantiles[3], view.unit
    ));
}

/// The pose on screen in the colour of the selection, the reference stronger than what is compared with it.
fn fill(colours: &Colours, row: &ThicknessRow, strip: &ThicknessStrip) -> Color32 {
    match (strip.on_screen, row.reference) {
        (true, _) => colours.selection,
        (false, true) => colours.text,
        (false, false) => colours.muted,
    }
}

/// A line from 5 to 95 %, a box from 25 to 75 %, and a mark at the median.
fn box_strip(ui: &Ui, columns: &Columns, strip: &ThicknessStrip, y: f32, colour: Color32) {
    let painter = ui.painter();
    let [low, quarter, median, three_quarters, high] = strip.quantiles.map(|q| columns.x(q));
    let stroke = Stroke::new(line::THIN, colour);
    painter.hline(low..=high, y, stroke);
    let half = 4.0;
    let inner = Rect::from_x_y_ranges(
        quarter..=three_quarters.max(quarter + 1.0),
        (y - half)..=(y + half),
    );
    painter.rect_filled(inner, 1.0, colour.gamma_multiply(0.45));
    let stroke = Stroke::new(line::STRONG, colour);
    painter.vline(median, (y - half - 1.0)..=(y + half + 1.0), stroke);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_minus_sign_and_times_few_digits() {
        let difference = Difference {
            bias: -0.416,
            deviation: 0.52,
            pairs: 10,
        };
        assert_eq!(signed(&difference), "−0.42 ± 0.52");
        assert_eq!(seconds_text(0.0004), "1 ms");
        assert_eq!(seconds_text(0.0076), "8 ms");
        assert_eq!(seconds_text(1.234), "1.23 s");
    }

    #[test]
    fn strips_share_one_axis_from_zero() {
        let area = Rect::from_min_size(pos2(10.0, 0.0), vec2(300.0, 16.0));
        let columns = Columns::of(area, 20.0);
        assert_eq!(columns.x(0.0), columns.axis[0]);
        assert_eq!(columns.x(20.0), columns.axis[1]);
        assert_eq!(columns.x(99.0), columns.axis[1]);
        assert!(columns.wide && !Columns::of(area.with_max_x(150.0), 20.0).wide);
    }
}
