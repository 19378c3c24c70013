//! The patches of the subject on screen in words, in the upper right corner.

use egui::{Rect, Role, Sense, Shape, Ui, WidgetInfo, pos2, vec2};

use crate::ui::style::{medium_font, note_font};
use crate::ui::theme::{colours, radius, space};

/// The words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchNote {
    /// "1 patch · 31 % of the LV".
    pub heading: String,
    /// Segments, area, thickening.
    pub lines: Vec<String>,
    /// Whether there is a patch: the heading has the colour of its outline.
    pub found: bool,
}

/// Draws the note where the title leaves room; narrow pictures have the heading alone or nothing.
pub fn patch_note_ui(ui: &Ui, inner: Rect, down: f32, note: &PatchNote) {
    let room = 0.55 * inner.width();
    let colours = colours(ui);
    let heading_colour = if note.found {
        colours.selection
    } else {
        colours.muted
    };
    let painter = ui.painter();
    let heading = painter.layout_no_wrap(note.heading.clone(), medium_font(), heading_colour);
    if heading.size().x > room {
        return;
    }
    // A plate below the words keeps them readable over the surface.
    let plate = painter.add(Shape::Noop);
    let mut top = inner.top() + down;
    let mut area = Rect::NOTHING;
    let mut draw = |galley: std::sync::Arc<egui::Galley>, colour| {
        let size = galley.size();
        let at = pos2(inner.right() - size.x, top);
        // A galley that ends at the right is placed by its right end.
        let by_right = galley.job.halign == egui::Align::RIGHT;
        let anchor = if by_right { inner.right() } else { at.x };
        painter.galley(pos2(anchor, top), galley, colour);
        area = area.union(Rect::from_min_size(at, size));
        top += size.y + 1.0;
    };
    draw(heading, heading_colour);
    // In a low picture they would lie over the heart.
    if inner.width() > 380.0 && inner.height() > 460.0 {
        for line in &note.lines {
            let mut job = egui::text::LayoutJob::simple(
                line.clone(),
                note_font(),
                colours.muted,
                room.min(320.0),
            );
            // Lines end at the right edge, each by itself.
            job.halign = egui::Align::RIGHT;
            draw(painter.layout_job(job), colours.muted);
        }
    }
    let ground = area.expand2(vec2(space::MEDIUM, space::SMALL));
    let dim = colours.pane.gamma_multiply(0.8);
    painter.set(plate, Shape::rect_filled(ground, radius::CONTROL, dim));
    let words = format!("{}. {}", note.heading, note.lines.join(". "));
    let response = ui.interact(area, ui.scope_id().with("patch note"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.clone()));
    if !note.lines.is_empty() {
        response.on_hover_text(note.lines.join("\n"));
    }
}
