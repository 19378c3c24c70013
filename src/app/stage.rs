//! Which hearts the 3D view shows, at which place in their beat, and where on the view.

use egui::{Rect, pos2, vec2};

use crate::ui::ViewMode;

use super::document::{phase_of, position_at_phase};
use super::state::State;

/// Room between cells, in points.
const GAP: f32 = 1.0;

/// The width by height that a heart fills best: cells of a grid come as near to it as they can.
const BEST_ASPECT: f32 = 0.95;

/// One heart on the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place in its beat, counted in frames.
    pub position: f64,
    /// Where on the view.
    pub rect: Rect,
}

/// The hearts on a view of this size, first the selected one.
pub fn cells(state: &State, area: Rect) -> Vec<Cell> {
    let document = &state.document;
    let Some(selected) = document.selected() else {
        return Vec::new();
    };
    let one = Cell {
        subject: document.subject,
        position: document.position,
        rect: area,
    };
    match document.view_mode {
        ViewMode::Single => vec![one],
        ViewMode::SideBySide => {
            let Some((index, other)) = document
                .compared()
                .and_then(|index| Some((index, state.subject(index)?)))
            else {
                return vec![one];
            };
            // Linked by phase: hearts with other frame counts beat in step.
            let position = position_at_phase(other, phase_of(selected, document.position));
            let halves = grid(area, 2, 1);
            vec![
                Cell {
                    rect: halves[0],
                    ..one
                },
                Cell {
                    subject: index,
                    position,
                    rect: halves[1],
                },
            ]
        }
        ViewMode::AllPhases => {
            let count = selected.sequence.frame_count();
            grid(area, columns(area, count), count.max(1))
                .into_iter()
                .take(count)
                .enumerate()
                .map(|(frame, rect)| Cell {
                    subject: document.subject,
                    position: frame as f64,
                    rect,
                })
                .collect()
        }
    }
}

/// The number of columns whose cells come nearest to the best aspect.
fn columns(area: Rect, count: usize) -> usize {
    let misfit = |columns: usize| {
        let rows = count.div_ceil(columns);
        let width = area.width() / columns as f32;
        let height = area.height() / rows as f32;
        // Size of a heart in such a cell: the greater, the better.
        -(width / BEST_ASPECT).min(height)
    };
    (1..=count.max(1))
        .min_by(|a, b| misfit(*a).total_cmp(&misfit(*b)))
        .unwrap_or(1)
}

/// Equal cells row by row: with `count` 1, as many as there are columns.
fn grid(area: Rect, columns: usize, count: usize) -> Vec<Rect> {
    let count = count.max(columns);
    let rows = count.div_ceil(columns);
    let size = vec2(
        (area.width() - GAP * (columns - 1) as f32) / columns as f32,
        (area.height() - GAP * (rows - 1) as f32) / rows as f32,
    )
    .max(vec2(1.0, 1.0));
    (0..count)
        .map(|index| {
            let (row, column) = (index / columns, index % columns);
            let corner = pos2(
                area.left() + column as f32 * (size.x + GAP),
                area.top() + row as f32 * (size.y + GAP),
            );
            Rect::from_min_size(corner, size)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::{state_of, subject_with_frames};

    fn area() -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(900.0, 700.0))
    }

    #[test]
    fn two_hearts_beat_in_step() {
        let mut state = state_of(vec![
            subject_with_frames("a", 8),
            subject_with_frames("b", 4),
        ]);
        state.document.view_mode = ViewMode::SideBySide;
        state.document.position = 6.0;
        let cells = cells(&state, area());
        assert_eq!(cells.len(), 2);
        assert_eq!((cells[1].subject, cells[1].position), (1, 3.0));
        assert!(cells[0].rect.right() < cells[1].rect.left());
        assert_eq!(cells[1].rect.right(), area().right());
    }

    #[test]
    fn all_phases_fill_the_view_without_overlap() {
        let mut state = state_of(vec![subject_with_frames("a", 25)]);
        state.document.view_mode = ViewMode::AllPhases;
        let cells = cells(&state, area());
        assert_eq!(cells.len(), 25);
        for (i, a) in cells.iter().enumerate() {
            assert!(area().expand(0.01).contains_rect(a.rect));
            assert_eq!(a.position, i as f64);
            for b in &cells[i + 1..] {
                assert!(!a.rect.shrink(0.01).intersects(b.rect.shrink(0.01)));
            }
        }
    }

    #[test]
    fn a_lone_heart_has_nobody_beside_it() {
        let mut state = state_of(vec![subject_with_frames("a", 3)]);
        state.document.view_mode = ViewMode::SideBySide;
        assert_eq!(cells(&state, area()).len(), 1);
        assert!(super::cells(&State::default(), area()).is_empty());
    }
}
