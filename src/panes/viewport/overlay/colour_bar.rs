//! The colour bar: title, unit, ticks, the colours beyond the ends, and limits that can be set.

use std::sync::Arc;

use egui::text::{CCursor, CCursorRange};
use egui::{
    Align2, Button, Color32, Key, Popup, Rect, RichText, Role, Shape, Stroke, TextEdit, Ui,
    UiBuilder, WidgetInfo, pos2, vec2,
};

use crate::panes::commands::{Command, ViewCommand};
use crate::picture::Tick;
use crate::ui::marks::colour_strip;
use crate::ui::number_field::without_zeros;
use crate::ui::style::{note, note_font};
use crate::ui::text::note_at;
use crate::ui::theme::{colours, line, space};

/// What a colour bar shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourBarView<'a> {
    /// Name of the quantity: "Displacement from ED".
    pub title: &'a str,
    /// Its unit; empty for ratios.
    pub unit: &'a str,
    /// Colours from low to high, sRGB, evenly spaced.
    pub map: Arc<[[u8; 3]]>,
    /// Values at the ends.
    pub limits: [f64; 2],
    /// Whether the range is divided by ratios.
    pub logarithmic: bool,
    /// Marks between the limits.
    pub ticks: &'a [Tick],
    /// Colour of values below the range.
    pub below: [u8; 3],
    /// Colour of values above the range.
    pub above: [u8; 3],
    /// "fixed for all subjects"; shown as a badge where limits were typed.
    pub note: &'a str,
    /// Whether limits were typed by the user.
    pub typed: bool,
}

const HEIGHT: f32 = 10.0;
const CAP: f32 = 8.0;
/// Height of a bar with its numbers and its title.
pub const BAR_HEIGHT: f32 = 54.0;

/// Draws the bar in the lower left corner, with a title that ends at `end`, and returns where both end.
pub fn colour_bar_ui(
    ui: &mut Ui,
    inner: Rect,
    end: f32,
    view: &ColourBarView,
    commands: &mut Vec<Command>,
) -> f32 {
    let bar = plain_bar_ui(ui, inner, view);
    limits_ui(ui, bar, view, commands);
    title_ui(ui, inner, bar, end, view)
}

/// Draws a bar with fixed limits.
pub fn fixed_colour_bar_ui(ui: &mut Ui, inner: Rect, end: f32, view: &ColourBarView) {
    let bar = plain_bar_ui(ui, inner, view);
    for (index, x) in [(0, bar.left()), (1, bar.right())] {
        let at = pos2(x, bar.bottom() + 4.0);
        note_at(ui, at, Align2::CENTER_TOP, tick_text(view.limits[index]));
    }
    title_ui(ui, inner, bar, end, view);
}

fn plain_bar_ui(ui: &Ui, inner: Rect, view: &ColourBarView) -> Rect {
    let width = (inner.width() * 0.3).clamp(120.0, 230.0);
    let top = inner.bottom() - 46.0;
    let bar = Rect::from_min_size(
        pos2(inner.left() + CAP, top),
        vec2(width - 2.0 * CAP, HEIGHT),
    );
    draw_gradient(ui, bar, view);
    draw_ticks(ui, bar, view);
    bar
}

/// Title, unit and where the limits come from, below the bar, up to `end`; returns where they end.
fn title_ui(ui: &mut Ui, inner: Rect, bar: Rect, end: f32, view: &ColourBarView) -> f32 {
    let width = |text: &str| crate::ui::text::text_width(ui, text, note_font());
    let bar_width = bar.width() + 2.0 * CAP;
    let room = (end - inner.left()).max(bar_width);
    let source = match (view.typed, view.note) {
        (true, _) => "· limits set by the user".to_owned(),
        (false, "") => String::new(),
        (false, note) => format!("· {note}"),
    };
    let source_width = match source.is_empty() {
        true => 0.0,
        false => space::SMALL + width(&source),
    };
    // That limits were set by hand is said whatever the title loses; that they are the usual ones, where there is room.
    let for_title = room - if view.typed { source_width } else { 0.0 };
    let (whole, text) = title_with_unit(view.title, view.unit, |text| width(text) <= for_title);
    let title_width = width(&text);
    let said = view.typed || title_width + source_width <= room;
    let used = title_width + if said { source_width } else { 0.0 };
    let below = Rect::from_min_size(pos2(inner.left(), bar.bottom() + 18.0), vec2(room, 18.0));
    let mut line_ui = ui.new_child(UiBuilder::new().max_rect(below));
    line_ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        let title = ui.add(egui::Label::new(RichText::new(&text).small()).truncate());
        if text != whole {
            // Readers of the screen hear it whole, and so does who points at it.
            title.widget_info(|| WidgetInfo::labeled(Role::Label, true, &whole));
            title.on_hover_text(whole);
        }
        if view.typed {
            let accent = colours(ui).selection;
            ui.add(egui::Label::new(RichText::new(source).small().color(accent)).truncate());
        } else if said {
            ui.add(egui::Label::new(note(source)).truncate());
        }
    });
    inner.left() + used.clamp(bar_width, room) + space::LARGE
}

/// Name and unit of a quantity, whole and as they are shown. A number without its unit says nothing: where not all fits,
/// the name is cut.
fn title_with_unit(title: &str, unit: &str, fits: impl Fn(&str) -> bool) -> (String, String) {
    let unit = match unit {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    let letters: Vec<char> = title.chars().collect();
    let cut = |count: usize| {
        let kept: String = letters[..count].iter().collect();
        format!("{}…{unit}", kept.trim_end())
    };
    let whole = format!("{title}{unit}");
    let shown = match fits(&whole) {
        true => whole.clone(),
        false => {
            let count = (1..letters.len()).rev().find(|&count| fits(&cut(count)));
            cut(count.unwrap_or(0))
        }
    };
    (whole, shown)
}

fn rgb([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn draw_gradient(ui: &Ui, bar: Rect, view: &ColourBarView) {
    let last = view.map.len().saturating_sub(1).max(1) as f32;
    let painter = ui.painter();
    painter.add(colour_strip(view.map.iter().enumerate().map(
        |(index, colour)| {
            let x = egui::lerp(bar.x_range(), index as f32 / last);
            ([pos2(x, bar.top()), pos2(x, bar.bottom())], rgb(*colour))
        },
    )));
    for (edge, tip, colour) in [
        (bar.left(), bar.left() - CAP, view.below),
        (bar.right(), bar.right() + CAP, view.above),
    ] {
        let corners = vec![
            pos2(edge, bar.top()),
            pos2(tip, bar.center().y),
            pos2(edge, bar.bottom()),
        ];
        let outline = Stroke::new(0.5, colours(ui).line);
        painter.add(Shape::convex_polygon(corners, rgb(colour), outline));
    }
}

/// Three figures, without needless zeros: `0.71`, `1`, `12.5`.
fn tick_text(value: f64) -> String {
    let magnitude = value.abs();
    let digits: usize = match magnitude {
        m if m >= 100.0 => 0,
        m if m >= 10.0 => 1,
        m if m >= 1.0 => 2,
        m if m < 1e-12 => 0,
        _ => 3,
    };
    without_zeros(format!("{value:.digits$}"))
}

/// Marks with their numbers, as many as have room beside each other and beside the limits.
fn draw_ticks(ui: &Ui, bar: Rect, view: &ColourBarView) {
    const ROOM: f32 = 36.0;
    let colours = colours(ui);
    let mut free_from = bar.left() + ROOM;
    for tick in view.ticks {
        let x = egui::lerp(bar.x_range(), tick.position);
        let stroke = Stroke::new(line::THIN, colours.muted);
        ui.painter()
            .vline(x, bar.bottom()..=bar.bottom() + 3.0, stroke);
        if x >= free_from && x <= bar.right() - ROOM {
            let at = pos2(x, bar.bottom() + 4.0);
            note_at(ui, at, Align2::CENTER_TOP, &tick.text);
            free_from = x + ROOM;
        }
    }
}

/// The ends are buttons; either opens a small form with both limits.
fn limits_ui(ui: &mut Ui, bar: Rect, view: &ColourBarView, commands: &mut Vec<Command>) {
    for (index, name) in [(0, "Lower limit"), (1, "Upper limit")] {
        let text = tick_text(view.limits[index]);
        let x = if index == 0 { bar.left() } else { bar.right() };
        let rect = Rect::from_center_size(pos2(x, bar.bottom() + 11.0), vec2(34.0, 16.0));
        let mut child = ui.new_child(UiBuilder::new().max_rect(rect).layout(
            egui::Layout::centered_and_justified(egui::Direction::LeftToRight),
        ));
        child.spacing_mut().button_padding = vec2(0.0, 0.0);
        child.spacing_mut().interact_size = vec2(0.0, 0.0);
        let button = Button::new(RichText::new(text.clone()).small()).frame_when_inactive(false);
        let response = child.add(button);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{name}: {text}")));
        let unit = if view.unit.is_empty() {
            ""
        } else {
            &format!(" {}", view.unit)
        };
        let range = if view.logarithmic {
            "any number above 0"
        } else {
            "any number"
        };
        let hint = format!("{name}: {text}{unit}\n\nClick to type another one; range: {range}");
        let response = response.on_hover_text(hint);
        Popup::menu(&response)
            .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside)
            .show(|ui| limits_form_ui(ui, view, index, commands));
    }
}

/// What was typed into the form, in which pass last: a form that is opened again begins with the limits in force.
#[derive(Clone)]
struct TypedLimits {
    texts: [String; 2],
    pass: u64,
}

/// The form; the limit that was clicked has the keyboard when it opens.
fn limits_form_ui(ui: &mut Ui, view: &ColourBarView, clicked: usize, commands: &mut Vec<Command>) {
    let id = ui.scope_id().with(("typed limits", view.title));
    let pass = ui.ctx().cumulative_pass_nr();
    let kept: Option<TypedLimits> = ui.data(|data| data.get_temp(id));
    let kept = kept.filter(|kept| kept.pass + 1 >= pass);
    let opens = kept.is_none();
    let mut typed = kept.map_or_else(|| view.limits.map(tick_text), |kept| kept.texts);
    ui.set_width(180.0);
    ui.label(note(format!("Limits of {}", view.title.to_lowercase())));
    let mut done = false;
    for (index, (text, name)) in typed.iter_mut().zip(["From", "To"]).enumerate() {
        ui.horizontal(|ui| {
            ui.label(name);
            let length = text.chars().count();
            let edit = TextEdit::singleline(text).desired_width(90.0);
            let mut output = edit.show(ui);
            if opens && index == clicked {
                // What is typed takes the place of the limit.
                let all = CCursorRange::two(CCursor::new(0), CCursor::new(length));
                output.state.cursor.set_char_range(Some(all));
                output.state.store(ui.ctx(), output.response.id);
                output.response.request_focus();
            }
            let response = output
                .response
                .response
                .accessible_name(format!("{name} value"));
            done |= response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            ui.label(RichText::new(view.unit).weak());
        });
    }
    let limits = parse_limits(&typed, view.logarithmic);
    if let Err(why) = &limits {
        ui.colored_label(colours(ui).error, *why);
    }
    ui.horizontal(|ui| {
        done |= ui
            .add_enabled(limits.is_ok(), Button::new("Apply"))
            .clicked();
        if ui.button("Default range").clicked() {
            commands.push(ViewCommand::SetColourLimits(None).into());
            ui.close();
        }
    });
    let kept = TypedLimits { texts: typed, pass };
    ui.data_mut(|data| data.insert_temp(id, kept));
    if let (true, Ok(limits)) = (done, limits) {
        commands.push(ViewCommand::SetColourLimits(Some(limits)).into());
        ui.data_mut(|data| data.remove::<TypedLimits>(id));
        ui.close();
    }
}

/// Two numbers in order, both above zero where the bar divides by ratios.
fn parse_limits(typed: &[String; 2], logarithmic: bool) -> Result<[f64; 2], &'static str> {
    let number = |text: &str| {
        let value: f64 = (text.trim().replace(',', ".").parse()).unwrap_or(f64::NAN);
        Some(value)
            .filter(|value| value.is_finite())
            .ok_or("Not a number")
    };
    let (low, high) = (number(&typed[0])?, number(&typed[1])?);
    if low >= high {
        Err("The lower limit must be less than the upper")
    } else if logarithmic && low <= 0.0 {
        Err("Limits of a ratio must be positive")
    } else {
        Ok([low, high])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_stays_where_the_name_of_a_quantity_is_cut() {
        let fits = |most: usize| move |text: &str| text.chars().count() <= most;
        let shown = |most| title_with_unit("Difference from own motion", "mm", fits(most)).1;
        assert_eq!(shown(40), "Difference from own motion, mm");
        assert_eq!(shown(20), "Difference from…, mm");
        assert_eq!(shown(3), "…, mm");
        let (whole, cut) = title_with_unit("Area ratio", "", fits(5));
        assert_eq!((&*whole, &*cut), ("Area ratio", "Area…"));
    }

    #[test]
    fn typed_limits_must_be_numbers_in_order() {
        let typed = |low: &str, high: &str| [low.to_owned(), high.to_owned()];
        assert_eq!(parse_limits(&typed("0,5", "2"), true), Ok([0.5, 2.0]));
        assert!(parse_limits(&typed("2", "0.5"), false).is_err());
        assert!(parse_limits(&typed("-1", "1"), true).is_err());
        assert!(parse_limits(&typed("inf", "1"), false).is_err());
        assert!(parse_limits(&typed("", "1"), false).is_err());
    }

    #[test]
    fn ticks_have_three_figures_at_most() {
        for (value, text) in [
            (0.7123, "0.712"),
            (1.0, "1"),
            (12.5, "12.5"),
            (0.0, "0"),
            (104.2, "104"),
        ] {
            assert_eq!(tick_text(value), text);
        }
    }
}
