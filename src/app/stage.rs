//! Which hearts the 3D view shows, at which place in their beat, and where on the view.

use egui::{Rect, pos2, vec2};

use crate::panes::ViewMode;

use super::document::{phase_of, position_at_phase};
use super::state::State;

/// Room between cells, in points.
const GAP: f32 = 1.0;

/// Width by height of a left ventricle in the first view, by which a grid chooses its columns.
const BEST_ASPECT: f32 = 0.68;

/// Room above a grid for the subject's name, and below for colour bar, scale and cube.
const GRID_MARGINS: [f32; 2] = [58.0, 84.0];

/// One heart on the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnStage {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place in its beat, counted in frames.
    pub position: f64,
    /// Whether it plays a carried beat, whose frames the position then counts.
    pub carried: bool,
}

/// The hearts on the view, first the selected one.
pub fn on_stage(state: &State) -> Vec<OnStage> {
    let document = &state.document;
    let Some(selected) = document.selected() else {
        return Vec::new();
    };
    let one = OnStage {
        subject: document.subject,
        position: document.position,
        carried: false,
    };
    match document.view_mode {
        ViewMode::Single => vec![one],
        ViewMode::SideBySide => {
            let other = document
                .compared()
                .and_then(|index| Some((index, state.subject(index)?)));
            let carried = state.carried_heart().is_some();
            let other = other.map(|(subject, heart)| OnStage {
                subject,
                // A carried beat has the frames of the heart that it came from. Otherwise linked
                // by phase: hearts with other frame counts beat in step.
                position: if carried {
                    document.position
                } else {
                    position_at_phase(heart, phase_of(selected, document.position))
                },
                carried,
            });
            [Some(one), other].into_iter().flatten().collect()
        }
        ViewMode::AllFrames => (0..selected.sequence.frame_count())
            .map(|frame| OnStage {
                subject: document.subject,
                position: frame as f64,
                carried: false,
            })
            .collect(),
    }
}

/// Places of `count` hearts on a view: beside each other, or in rows.
pub fn places(mode: ViewMode, area: Rect, count: usize) -> Vec<Rect> {
    match mode {
        _ if count <= 1 => vec![area; count],
        ViewMode::AllFrames => {
            let [above, below] = GRID_MARGINS.map(|margin| margin.min(0.2 * area.height()));
            let mut inner = area;
            inner.min.y += above;
            inner.max.y -= below;
            grid(inner, columns(inner, count), count)
        }
        _ => grid(area, count, count),
    }
}

/// The number of columns whose cells come nearest to the best aspect.
fn columns(area: Rect, count: usize) -> usize {
    let heart_size = |columns: usize| {
        let rows = count.div_ceil(columns);
        let width = area.width() / columns as f32;
        let height = area.height() / rows as f32;
        (width / BEST_ASPECT).min(height)
    };
    (1..=count.max(1))
        .max_by(|a, b| heart_size(*a).total_cmp(&heart_size(*b)))
        .unwrap_or(1)
}

/// Equal cells row by row.
fn grid(area: Rect, columns: usize, count: usize) -> Vec<Rect> {
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
        let hearts = on_stage(&state);
        assert_eq!(hearts.len(), 2);
        assert_eq!((hearts[1].subject, hearts[1].position), (1, 3.0));
        let rects = places(ViewMode::SideBySide, area(), 2);
        assert!(rects[0].right() < rects[1].left());
        assert_eq!(rects[1].right(), area().right());
    }

    #[test]
    fn all_phases_fill_the_view_without_overlap() {
        let mut state = state_of(vec![subject_with_frames("a", 25)]);
        state.document.view_mode = ViewMode::AllFrames;
        assert_eq!(on_stage(&state).len(), 25);
        let rects = places(ViewMode::AllFrames, area(), 25);
        assert_eq!(rects.len(), 25);
        for (i, a) in rects.iter().enumerate() {
            assert!(area().expand(0.01).contains_rect(*a));
            for b in &rects[i + 1..] {
                assert!(!a.shrink(0.01).intersects(b.shrink(0.01)));
            }
        }
    }

    #[test]
    fn a_lone_heart_has_nobody_beside_it() {
        let mut state = state_of(vec![subject_with_frames("a", 3)]);
        state.document.view_mode = ViewMode::SideBySide;
        assert_eq!(on_stage(&state).len(), 1);
        assert!(on_stage(&State::default()).is_empty());
        assert!(places(ViewMode::Single, area(), 0).is_empty());
    }
}
