//! The patches of the subject on screen in words, in the upper right corner.

use std::sync::Arc;

use egui::text::LayoutJob;
use egui::{Align, Galley, Pos2, Rect, Role, Sense, Ui, WidgetInfo, vec2};

use super::free_place::free_place;
use crate::ui::style::{medium_font, note_font};
use crate::ui::theme::{colours, radius, space};

/// The words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchNote {
    /// "1 patch · 31 % of the LV".
    pub heading: String,
    /// "patch 31 %", where the heading has no room.
    pub short: String,
    /// Segments, area, thickening.
    pub lines: Vec<String>,
    /// Whether there is a patch: the heading has the colour of its outline.
    pub found: bool,
}

/// Narrower pictures have the heading alone.
const WIDTH_OF_LINES: f32 = 380.0;

/// Draws the note where title and badge, which stand at `taken`, leave room. It is never left out, for silence would mean
/// that there is no patch; but its lines end where they would come over the subject, of which `subject` are points.
pub fn patch_note_ui(ui: &Ui, inner: Rect, taken: &[Rect], subject: &[Pos2], note: &PatchNote) {
    let colours = colours(ui);
    let colour = if note.found {
        colours.selection
    } else {
        colours.muted
    };
    let top = inner.top() + 6.0;
    let covers = |rect: Rect| subject.iter().any(|at| rect.expand(6.0).contains(*at));
    let placed = |text: &str| {
        let galley = (ui.painter()).layout_no_wrap(text.to_owned(), medium_font(), colour);
        let rect = free_place(taken, inner.right(), top, galley.size());
        (rect, galley)
    };
    let [long, short] = [&note.heading, &note.short].map(|text| placed(text));
    let long_fits = long.0.top() <= short.0.top() && long.0.left() >= inner.left();
    let heading = match note.short.is_empty() || (long_fits && !covers(long.0)) {
        true => long,
        false => short,
    };
    let mut area = heading.0;
    let draw = |(rect, galley): (Rect, Arc<Galley>), colour| {
        if covers(rect) {
            // A plate below the words keeps them readable over the surface.
            let ground = rect.expand2(vec2(space::SMALL, 1.0));
            let dim = colours.pane.gamma_multiply(0.8);
            ui.painter().rect_filled(ground, radius::CONTROL, dim);
        }
        // A galley that ends at the right is placed by its right end.
        let by_right = galley.job.halign == Align::RIGHT;
        let at = if by_right {
            rect.right_top()
        } else {
            rect.left_top()
        };
        ui.painter().galley(at, galley, colour);
    };
    draw(heading, colour);
    let lines = note.lines.iter();
    for line in lines.filter(|_| inner.width() > WIDTH_OF_LINES) {
        let room = (0.55 * inner.width()).min(320.0);
        let mut job = LayoutJob::simple(line.clone(), note_font(), colours.muted, room);
        // Lines end at the right edge, each by itself.
        job.halign = Align::RIGHT;
        let galley = ui.painter().layout_job(job);
        let top = area.bottom() + 1.0;
        let rect = free_place(taken, inner.right(), top, galley.size());
        if covers(rect) {
            break;
        }
        area = area.union(rect);
        draw((rect, galley), colours.muted);
    }
    let words = format!("{}. {}", note.heading, note.lines.join(". "));
    let response = ui.interact(area, ui.scope_id().with("patch note"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.clone()));
    let hint = [&note.heading].into_iter().chain(&note.lines);
    response.on_hover_text(hint.map(String::as_str).collect::<Vec<_>>().join("\n"));
}
