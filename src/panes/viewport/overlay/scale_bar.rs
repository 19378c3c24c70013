//! A bar of a round length.

use egui::{Align2, Rangef, Rect, Stroke, Ui, pos2};

use crate::picture::{nice_floor, tick_text};
use crate::ui::text::note_at;
use crate::ui::theme::{colours, line};

/// How long lengths are on screen, at the middle of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScaleBarView<'a> {
    /// Logical points for one unit of the coordinates.
    pub points_per_unit: f64,
    /// `mm`, or `units` where the files state none.
    pub unit: &'a str,
}

/// Longest bar in points.
const LONGEST: f64 = 110.0;

/// Draws the bar at the middle of the lower edge, or as near to it as `free`, the part of the edge
/// that nothing else takes, allows.
pub fn scale_bar_ui(ui: &Ui, inner: Rect, free: Rangef, view: &ScaleBarView) {
    let Some(points) = length(view).filter(|points| points + 8.0 < free.span()) else {
        return;
    };
    let length = nice_floor(LONGEST / view.points_per_unit);
    let colours = colours(ui);
    let stroke = Stroke::new(line::MARK, colours.muted);
    let y = inner.bottom() - 16.0;
    let reach = free.shrink(0.5 * points + 4.0);
    let x = inner.center().x.clamp(reach.min, reach.max);
    let (left, right) = (x - 0.5 * points, x + 0.5 * points);
    ui.painter().hline(left..=right, y, stroke);
    for end in [left, right] {
        ui.painter().vline(end, y - 6.0..=y, stroke);
    }
    let text = format!("{} {}", tick_text(length, length), view.unit);
    note_at(ui, pos2(x, y + 3.0), Align2::CENTER_TOP, text);
}

/// How long the bar is, in points; `None` where no length can be shown.
pub fn length(view: &ScaleBarView) -> Option<f32> {
    let length = nice_floor(LONGEST / view.points_per_unit);
    let points = (length * view.points_per_unit) as f32;
    (points.is_finite() && points > 8.0).then_some(points)
}
