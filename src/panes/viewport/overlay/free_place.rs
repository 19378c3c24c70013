//! Where words at the right edge of a picture keep clear of others.

use egui::{Align2, Rect, Vec2, pos2, vec2};

use crate::ui::theme::space;

/// The highest place at the right edge, from `top` down, where words of this size keep clear of what stands there.
pub fn free_place(taken: &[Rect], right: f32, top: f32, size: Vec2) -> Rect {
    let mut rect = Align2::RIGHT_TOP.anchor_size(pos2(right, top), size);
    let clear = |rect: Rect| rect.expand2(vec2(space::LARGE, 0.0));
    while let Some(other) = taken.iter().find(|other| other.intersects(clear(rect))) {
        rect = rect.translate(vec2(0.0, other.bottom() + 2.0 - rect.top()));
    }
    rect
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_at_the_right_keep_clear_of_those_at_the_left() {
        let taken = [[0.0, 0.0, 100.0, 24.0], [0.0, 24.0, 190.0, 39.0]];
        let taken = taken.map(|[x, y, to, below]| Rect::from_min_max(pos2(x, y), pos2(to, below)));
        let top = |width| free_place(&taken, 228.0, 6.0, vec2(width, 17.0)).top();
        assert_eq!((top(60.0), top(110.0), top(130.0)), (6.0, 6.0, 41.0));
        // A higher badge reaches down to the line below.
        assert_eq!(free_place(&taken, 228.0, 6.0, vec2(80.0, 21.0)).top(), 41.0);
    }
}
