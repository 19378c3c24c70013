//! Axes around a plot: a frame, round numbers on a grid, what is counted and in which unit.

use crate::picture::figure::Pen;
use crate::picture::page::Anchor;
use crate::picture::ticks::{nice_ticks, tick_text};

/// One axis of a plot.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlotAxis {
    /// What is counted, with its unit.
    pub(super) title: String,
    /// Value at the left or lower end.
    pub(super) low: f64,
    /// Value at the right or upper end.
    pub(super) high: f64,
}

impl PlotAxis {
    /// About `wanted` round values with their numbers.
    fn ticks(&self, wanted: usize) -> Vec<(f64, String)> {
        let ticks = nice_ticks(self.low, self.high, wanted);
        let step = match &ticks[..] {
            [first, second, ..] => second - first,
            _ => 1.0,
        };
        ticks
            .into_iter()
            .map(|tick| (tick, tick_text(tick, step)))
            .collect()
    }

    fn share(&self, value: f64) -> f32 {
        ((value - self.low) / (self.high - self.low)) as f32
    }
}

/// Upper left and lower right corner of the plot within a rectangle that has room for numbers `widest` wide and titles.
pub(super) fn plot_area(pen: &Pen<'_>, [low, high]: [[f32; 2]; 2], widest: f32) -> [[f32; 2]; 2] {
    let line = pen.line_height();
    let left = low[0] + widest + 0.6 * pen.text;
    let upper = low[1] + 1.2 * line;
    [
        [left, upper],
        [
            high[0].max(left + 1.0),
            (high[1] - 2.2 * line).max(upper + 1.0),
        ],
    ]
}

/// Width of the widest number of an axis that is `length` pixels long.
pub(super) fn widest_number(pen: &Pen<'_>, axis: &PlotAxis, length: f32) -> f32 {
    let set = pen.regular(pen.theme.muted);
    let ticks = axis.ticks(wanted(length, 3.0 * pen.text));
    let widths = ticks
        .iter()
        .map(|(_, text)| pen.fonts.width(text, set.weight, set.size));
    widths.fold(0.0, f32::max)
}

/// How many numbers an axis has room for, each with so many pixels.
fn wanted(length: f32, each: f32) -> usize {
    ((length / each) as usize).clamp(2, 10)
}

/// Draws frame, grid, numbers and titles around the plot in `area`.
pub(super) fn draw_axes(
    pen: &mut Pen<'_>,
    [low, high]: [[f32; 2]; 2],
    [across, up]: [&PlotAxis; 2],
) {
    let (text, line) = (pen.text, pen.line_height());
    let (theme, set) = (pen.theme, pen.regular(pen.theme.muted));
    let thin = (text / 15.0).max(1.0);
    let grid = [0, 1, 2]
        .map(|part| theme.background[part] + 0.3 * (theme.line[part] - theme.background[part]));
    let [width, height] = [high[0] - low[0], high[1] - low[1]];
    let mut free_from = f32::NEG_INFINITY;
    for (tick, number) in across.ticks(wanted(width, 5.0 * text)) {
        let x = low[0] + across.share(tick) * width;
        pen.page
            .line(&[[x, low[1]], [x, high[1]]], false, thin, grid);
        let wide = pen.fonts.width(&number, set.weight, set.size);
        if x - 0.5 * wide >= free_from {
            pen.write(&number, set, Anchor::Middle, [x, high[1] + 0.95 * line]);
            free_from = x + 0.5 * wide + 0.5 * text;
        }
    }
    for (tick, number) in up.ticks(wanted(height, 3.0 * text)) {
        let y = high[1] - up.share(tick) * height;
        pen.page
            .line(&[[low[0], y], [high[0], y]], false, thin, grid);
        let at = [low[0] - 0.5 * text, y + 0.35 * text];
        pen.write(&number, set, Anchor::End, at);
    }
    let frame = [low, [high[0], low[1]], high, [low[0], high[1]]];
    pen.page.line(&frame, true, thin, theme.line);
    let below = [0.5 * (low[0] + high[0]), high[1] + 1.95 * line];
    pen.write_within(&across.title, set, Anchor::Middle, below, width);
    let above = [low[0], low[1] - 0.4 * line];
    pen.write_within(&up.title, set, Anchor::Start, above, width);
}
