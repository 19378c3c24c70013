//! The name of the subject, what is shown of it, and the badge, at the upper edge of its picture.

use egui::text::LayoutJob;
use egui::{FontId, Label, Rect, RichText, Role, Ui, UiBuilder, WidgetInfo, vec2};

use super::caption::SubjectCaption;
use super::free_place::free_place;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::Command;
use crate::ui::label_marks::label_mark;
use crate::ui::style::{medium_font, note, note_font, title_font};
use crate::ui::text::{text_width, without_middle};
use crate::ui::theme::{colours, space};

/// Width of the mark of the label.
const MARK: f32 = 10.0;
/// Height of a line of a title, in its own and in the smaller face.
const LINES: [f32; 2] = [24.0, 18.0];

/// Draws them and returns where words stand now, from above.
pub fn title_ui(
    ui: &mut Ui,
    inner: Rect,
    caption: &SubjectCaption,
    commands: &mut Vec<Command>,
) -> Vec<Rect> {
    if caption.title.is_empty() {
        return Vec::new();
    }
    let strong = colours(ui).strong;
    let room = Rect::from_min_size(inner.min, vec2(inner.width(), 120.0));
    let mut corner = ui.new_child(UiBuilder::new().max_rect(room));
    corner.spacing_mut().item_spacing = vec2(space::MEDIUM, 0.0);
    let width = inner.width() - MARK - space::MEDIUM;
    let fits = |text: &str, font: FontId| text_width(ui, text, font) <= width;
    let (lines, font) = title_lines(&caption.title, &caption.title_end, fits);
    let whole = format!("{}{}", caption.title, caption.title_end);
    let height = LINES[usize::from(font != title_font())];
    let mut taken = Vec::new();
    for (place, line) in lines.iter().enumerate() {
        let row = corner.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = height;
            let (mark, _) = ui.allocate_exact_size(vec2(MARK, height), egui::Sense::hover());
            if place == 0 {
                label_mark(ui, mark.center(), 5.0, caption.mark, true);
            }
            let text = RichText::new(line).font(font.clone()).color(strong);
            let title = ui.add(Label::new(text).extend());
            if place == 0 && *line != whole {
                // Readers of the screen hear it whole, and so does who points at it.
                title.widget_info(|| WidgetInfo::labeled(Role::Label, true, &whole));
                title.on_hover_text(&whole);
            }
        });
        taken.push(row.response.rect);
    }
    if !caption.subtitle.is_empty() {
        taken.push(subtitle_ui(&mut corner, inner.width(), &caption.subtitle));
    }
    if let Some((words, command)) = &caption.leave {
        corner.add_space(space::SMALL);
        let above = corner.min_rect().bottom();
        command_button_ui(&mut corner, note(*words), command.clone(), commands);
        let width = text_width(ui, words, note_font()) + 2.0 * space::LARGE;
        let below = corner.min_rect().bottom();
        taken.push(Rect::from_x_y_ranges(
            inner.left()..=inner.left() + width,
            above..=below,
        ));
    }
    if let Some(badge) = &caption.badge {
        taken.extend(badge_ui(ui, inner, &taken, badge, caption));
    }
    taken
}

/// In one line where it fits, else in a smaller face, else with its end in a line of its own; what is still too long
/// loses its middle, for names differ at their end.
fn title_lines(
    title: &str,
    end: &str,
    fits: impl Fn(&str, FontId) -> bool,
) -> (Vec<String>, FontId) {
    let whole = format!("{title}{end}");
    let mut faces = [title_font(), medium_font()].into_iter();
    if let Some(face) = faces.find(|face| fits(&whole, face.clone())) {
        return (vec![whole], face);
    }
    let face = medium_font();
    let lines = [title, end.trim_start()].into_iter();
    let lines = lines.filter(|line| !line.is_empty());
    let cut = |line| without_middle(line, |shown| fits(shown, face.clone()));
    (lines.map(cut).collect(), face)
}

/// In two lines at most.
fn subtitle_ui(ui: &mut Ui, width: f32, text: &str) -> Rect {
    let muted = colours(ui).muted;
    let mut job = LayoutJob::simple(text.to_owned(), note_font(), muted, width);
    job.wrap.max_rows = 2;
    let galley = ui.painter().layout_job(job);
    let cut = galley.elided;
    let response = ui.add(Label::new(galley));
    let rect = response.rect;
    if cut {
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
        response.on_hover_text(text);
    }
    rect
}

/// Beside the title where there is room, below it where there is none.
fn badge_ui(
    ui: &mut Ui,
    inner: Rect,
    taken: &[Rect],
    badge: &str,
    caption: &SubjectCaption,
) -> Option<Rect> {
    let colours = colours(ui);
    let air = vec2(14.0, 6.0);
    // Where the whole has no room, its first part says what the pose is.
    let first = badge.split(" · ").next().unwrap_or(badge);
    let whole = text_width(ui, badge, note_font()) + air.x <= inner.width();
    let shown = if whole { badge } else { first };
    let galley = ui
        .painter()
        .layout_no_wrap(shown.to_owned(), note_font(), colours.muted);
    let size = galley.size() + air;
    let rect = free_place(taken, inner.right(), inner.top() + 6.0, size);
    if size.x > inner.width() {
        return None;
    }
    ui.painter().rect_filled(rect, 4.0, colours.control);
    ui.painter()
        .galley(rect.min + vec2(7.0, 3.0), galley, colours.muted);
    let response = ui.interact(rect, ui.scope_id().with("badge"), egui::Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, badge));
    let note = match (whole, caption.badge_note.as_str()) {
        (true, note) => note.to_owned(),
        (false, note) => format!("{badge}\n\n{note}"),
    };
    if !note.is_empty() {
        response.on_hover_text(note);
    }
    Some(rect)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_keeps_what_tells_subjects_apart() {
        // A letter takes a third of the size of its face.
        let fits = |width: f32| {
            move |text: &str, font: FontId| text.chars().count() as f32 * font.size / 3.0 <= width
        };
        let lines = |title: &str, end: &str, width| title_lines(title, end, fits(width));
        let (shown, face) = lines("Motion of P03", " on N05", 200.0);
        assert_eq!(
            (&*shown, face),
            (&["Motion of P03 on N05".to_owned()][..], title_font())
        );
        let (shown, face) = lines("Motion of P03", " on N05", 100.0);
        assert_eq!(
            (&*shown, face),
            (&["Motion of P03 on N05".to_owned()][..], medium_font())
        );
        assert_eq!(
            lines("Motion of P03", " on N05", 60.0).0,
            ["Motion of P03", "on N05"]
        );
        let names = ["Patient000151_rest", "Patient000151_stress"];
        let [rest, stress] = names.map(|name| lines(name, "", 70.0).0);
        assert_eq!(rest, ["Pat…t000151_rest"]);
        assert_eq!(stress, ["Pat…00151_stress"]);
    }
}
