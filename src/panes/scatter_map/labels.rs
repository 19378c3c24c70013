//! Labels beside points: inside the pane, without overlap, where they hide least.

use egui::{Color32, Painter, Pos2, Rect, vec2};

use crate::ui::style::medium_note_font;

/// Places labels; those given first choose first.
pub struct Labels<'a> {
    painter: &'a Painter,
    inside: Rect,
    behind: Color32,
    taken: Vec<Rect>,
}

impl<'a> Labels<'a> {
    /// Labels within `rect`, on ground of the colour `behind`.
    pub fn new(painter: &'a Painter, rect: Rect, behind: Color32) -> Self {
        Self {
            painter,
            inside: rect.shrink(4.0),
            behind: behind.gamma_multiply(0.7),
            taken: Vec::new(),
        }
    }

    /// Keeps labels away from a place.
    pub fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Writes beside a point where there is room, hiding as little of `path` as can be.
    /// `gap` keeps it clear of the mark.
    pub fn beside(&mut self, at: Pos2, gap: f32, text: String, colour: Color32, path: &[Pos2]) {
        let galley = self
            .painter
            .layout_no_wrap(text, medium_note_font(), colour);
        let size = galley.size();
        let middle = -0.5 * size.y;
        let left = -gap - size.x;
        let places = [
            vec2(gap, -size.y - 3.0),
            vec2(gap, 3.0),
            vec2(left, -size.y - 3.0),
            vec2(left, 3.0),
            vec2(gap, middle),
            vec2(left, middle),
            vec2(-0.5 * size.x, -size.y - gap),
            vec2(-0.5 * size.x, gap),
        ]
        .map(|offset| Rect::from_min_size(at + offset, size));
        let free = |rect: &Rect| {
            self.inside.contains_rect(*rect)
                && self.taken.iter().all(|other| !other.intersects(*rect))
        };
        let hidden = |rect: &Rect| hidden_length(path, *rect) as i32;
        let Some(rect) = places.into_iter().filter(free).min_by_key(hidden) else {
            return;
        };
        self.painter
            .rect_filled(rect.expand2(vec2(3.0, 0.0)), 3.0, self.behind);
        self.painter.galley(rect.min, galley, colour);
        self.taken.push(rect);
    }
}

/// How much of a path, in points, lies within a rectangle; the path is closed.
fn hidden_length(path: &[Pos2], rect: Rect) -> f32 {
    let mut hidden = 0.0;
    for (index, from) in path.iter().enumerate() {
        let to = path[(index + 1) % path.len()];
        let steps = ((to - *from).length() / 2.0).ceil().clamp(1.0, 400.0);
        let inside = (0..steps as usize)
            .filter(|step| rect.contains(from.lerp(to, *step as f32 / steps)))
            .count();
        hidden += 2.0 * inside as f32;
    }
    hidden
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Color32, pos2};

    #[test]
    fn labels_neither_overlap_nor_leave_the_pane_nor_hide_what_is_kept_free() {
        let ctx = egui::Context::default();
        crate::ui::style::apply(&ctx, true);
        let output = ctx.run_ui(egui::RawInput::default(), |ui| {
            let pane = Rect::from_min_size(pos2(10.0, 10.0), vec2(160.0, 90.0));
            let painter = ui.painter().clone();
            let mut labels = Labels::new(&painter, pane, Color32::BLACK);
            let point = pos2(90.0, 50.0);
            let free = Rect::from_center_size(point, vec2(14.0, 14.0));
            labels.keep_free(free);
            let mut write = |at: Pos2| {
                labels.beside(at, 9.0, "P05 ED".to_owned(), Color32::WHITE, &[]);
            };
            (0..12).for_each(|_| write(point));
            // Beside a point at the rim there is room on one side only.
            write(pos2(168.0, 95.0));
            assert_eq!(labels.taken[0], free);
            assert!(labels.taken.len() > 3, "{}", labels.taken.len());
            for (index, rect) in labels.taken.iter().enumerate() {
                assert!(pane.contains_rect(*rect), "{rect:?}");
                let others = &labels.taken[index + 1..];
                assert!(others.iter().all(|other| !other.intersects(*rect)));
            }
        });
        output.drop_without_applying_deltas();
    }
}
