//! Where the subjects of the 3D view lie on the screen, and the labels of a grid.

use egui::{Rect, Stroke, Ui, pos2, vec2};

use crate::document::ViewMode;
use crate::document::state::State;
use crate::panes::viewport::shown_subject::Tile;
use crate::ui::theme::{colours, line, radius, type_size};

/// Room between cells, in points.
const GAP: f32 = 1.0;

/// Width by height of a left ventricle in the first view, by which a grid chooses its columns.
const BEST_ASPECT: f32 = 0.68;

/// Room above a grid for the subject's name, and below for colour bar, scale and cube.
const GRID_MARGINS: [f32; 2] = [58.0, 84.0];

/// Places of `count` subjects on a view: beside each other, or in rows.
pub fn places(mode: ViewMode, area: Rect, count: usize) -> Vec<Rect> {
    match mode {
        _ if count <= 1 => vec![area; count],
        ViewMode::AllFrames => {
            let [above, below] = GRID_MARGINS.map(|margin| margin.min(0.2 * area.height()));
            let mut inner = area;
            inner.min.y += above;
            inner.max.y -= below;
            let mut cells = grid(inner, columns(inner, count), count);
            for cell in &mut cells {
                cell.min.y += label_strip(cell.height());
            }
            cells
        }
        _ => grid(area, count, count),
    }
}

/// Height of the strip above a subject of a grid where its frame stands.
const LABEL_STRIP: f32 = 17.0;

/// The same in a cell of this height: there is always more room for the subject.
fn label_strip(cell_height: f32) -> f32 {
    LABEL_STRIP.min(0.4 * cell_height)
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

/// The number of a frame above its subject in the grid of all phases; the one that the time bar
/// stands on is marked.
pub fn frame_label(ui: &Ui, state: &State, tile: &Tile) {
    let frame = tile.shown.position as usize;
    let phase = state.phase_name(tile.shown.index, frame);
    let text = match phase {
        Some(phase) => format!("{frame} · {phase}"),
        None => frame.to_string(),
    };
    let colours = colours(ui);
    let here = state.document.subject == tile.shown.index && state.document.frame() == frame;
    let colour = if here {
        colours.selection
    } else {
        colours.muted
    };
    let mut cell = tile.rect;
    cell.min.y -= LABEL_STRIP;
    let at = cell.left_top() + vec2(10.0, 2.0);
    let font = egui::FontId::proportional(type_size::NOTE);
    ui.painter()
        .text(at, egui::Align2::LEFT_TOP, text, font, colour);
    if here {
        let rect = cell.shrink(1.0);
        let stroke = Stroke::new(line::THIN, colours.selection);
        let radius = f32::from(radius::CONTROL);
        ui.painter()
            .rect_stroke(rect, radius, stroke, egui::StrokeKind::Inside);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area() -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(900.0, 700.0))
    }

    #[test]
    fn two_subjects_share_the_width() {
        let rects = places(ViewMode::SideBySide, area(), 2);
        assert!(rects[0].right() < rects[1].left());
        assert_eq!(rects[1].right(), area().right());
        assert!(places(ViewMode::Single, area(), 0).is_empty());
    }

    #[test]
    fn all_frames_fill_the_view_without_overlap() {
        let rects = places(ViewMode::AllFrames, area(), 25);
        assert_eq!(rects.len(), 25);
        for (i, a) in rects.iter().enumerate() {
            assert!(area().expand(0.01).contains_rect(*a));
            for b in &rects[i + 1..] {
                assert!(!a.shrink(0.01).intersects(b.shrink(0.01)));
                // Nor does the strip with the number of a frame lie over another subject.
                let strip = Rect::from_min_max(b.min - vec2(0.0, LABEL_STRIP), b.right_top());
                assert!(!a.shrink(0.01).intersects(strip.shrink(0.01)));
            }
        }
    }
}
