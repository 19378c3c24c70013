//! Volumes over the cardiac cycle, with end-diastole, end-systole and the present position.

mod figure;
pub(crate) mod spec;
mod view;

use egui::{
    Align2, Color32, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use crate::panes::commands::{Command, PlaybackCommand};
use crate::panes::cycle_axis::CycleAxis;
use crate::picture::{nice_ticks, share_unit, share_words};
use crate::ui::controls::empty_pane_ui;
use crate::ui::style::{medium_note_font, note_font};
use crate::ui::text::{note_at, text_width};
use crate::ui::theme::{Colours, colours, line, space};

/// Which surface a curve belongs to; sets its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// The blood pool: what the ejection fraction comes from.
    Endocardium,
    /// Cavity and myocardium.
    Epicardium,
}

/// One number per frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Which surface.
    pub kind: CurveKind,
    /// One value per frame; NaN where it is not known.
    pub values: Vec<f64>,
}

/// What the volume pane shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurvesView<'a> {
    /// The selected subject's curves; empty without a volume.
    pub curves: Vec<Curve>,
    /// `ml`, or `units³`.
    pub unit: &'a str,
    /// Times of the frames within the cycle.
    pub axis: CycleAxis,
    /// Length of the cycle, where the study states it.
    pub cycle_ms: Option<f64>,
    /// Position in frames.
    pub position: f64,
    /// Frame of end-diastole.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole.
    pub end_systole: Option<usize>,
    /// Whether volumes are being computed.
    pub computing: bool,
}

/// Draws the plot; a click or drag moves through the cycle.
pub fn curves_ui(ui: &mut Ui, view: &CurvesView, commands: &mut Vec<Command>) {
    let Some((low, high)) = range(&view.curves) else {
        let what = if view.computing {
            "Volumes are being computed"
        } else {
            "The volume curve is shown for subjects with a closed or capped surface"
        };
        empty_pane_ui(ui, "No volumes", what, |_| {});
        return;
    };
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(vec2(80.0, 60.0)),
        Sense::click_and_drag(),
    );
    response
        .widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Volume over the cardiac cycle"));
    let plot = Plot::new(rect, numbers_width(ui, low, high), low, high);
    draw_axes(ui, view, &plot);
    draw_phases(ui, view, &plot);
    for curve in &view.curves {
        draw_curve(ui, &view.axis, curve, &plot);
    }
    draw_now(ui, view, &plot);
    if let Some(pointer) = response.interact_pointer_pos()
        && (response.clicked() || response.dragged())
    {
        let position = plot.position_at(pointer, &view.axis);
        commands.push(PlaybackCommand::SetPosition(position).into());
    }
    if let Some(pointer) = response.hover_pos() {
        let text = hover_text(view, plot.position_at(pointer, &view.axis));
        response.on_hover_text_at_pointer(text);
    }
}

/// Lowest and highest value with a little air, on round numbers.
fn range(curves: &[Curve]) -> Option<(f64, f64)> {
    let values = || {
        curves
            .iter()
            .flat_map(|curve| curve.values.iter().copied())
            .filter(|value| value.is_finite())
    };
    let low = values().reduce(f64::min)?;
    let high = values().reduce(f64::max)?;
    let air = 0.12 * (high - low).max(0.1 * high.abs()).max(1e-6);
    Some(((low - air).max(0.0), high + air))
}

/// Where values lie on screen.
struct Plot {
    area: Rect,
    low: f64,
    high: f64,
}

impl Plot {
    /// `numbers_width` is left free beside the numbers' margin.
    fn new(rect: Rect, numbers_width: f32, low: f64, high: f64) -> Self {
        let left = (numbers_width + space::LARGE + 8.0).max(44.0);
        let area = Rect::from_min_max(
            rect.min + vec2(left, space::LARGE + 18.0),
            rect.max - vec2(space::LARGE + 4.0, 24.0),
        );
        Self { area, low, high }
    }

    fn x(&self, share: f64) -> f32 {
        egui::lerp(self.area.x_range(), share as f32)
    }

    fn y(&self, value: f64) -> f32 {
        let share = (value - self.low) / (self.high - self.low);
        egui::lerp(self.area.bottom()..=self.area.top(), share as f32)
    }

    fn position_at(&self, pointer: Pos2, axis: &CycleAxis) -> f64 {
        let share = egui::remap_clamp(pointer.x, self.area.x_range(), 0.0..=1.0);
        axis.position_within(f64::from(share))
    }
}

/// How wide the longest number beside the axis is.
fn numbers_width(ui: &Ui, low: f64, high: f64) -> f32 {
    text_width(ui, &tick_text(high, low, high), note_font())
}

/// Whole numbers, one decimal place where the axis is short.
fn tick_text(tick: f64, low: f64, high: f64) -> String {
    let digits = usize::from(high - low < 5.0);
    format!("{tick:.digits$}")
}

fn draw_axes(ui: &Ui, view: &CurvesView, plot: &Plot) {
    let colours = colours(ui);
    let painter = ui.painter();
    let grid = Stroke::new(line::THIN, colours.grid);
    let rows = ((plot.area.height() / 34.0) as usize).clamp(2, 10);
    for tick in nice_ticks(plot.low, plot.high, rows) {
        let y = plot.y(tick);
        painter.hline(plot.area.x_range(), y, grid);
        let (at, text) = (
            pos2(plot.area.left() - 6.0, y),
            tick_text(tick, plot.low, plot.high),
        );
        note_at(ui, at, Align2::RIGHT_CENTER, text);
    }
    let top = pos2(plot.area.left() - 32.0, plot.area.top() - 13.0);
    note_at(
        ui,
        top,
        Align2::LEFT_CENTER,
        format!("Volume, {}", view.unit),
    );
    let y = plot.area.bottom() + 6.0;
    let (end, unit) = match view.cycle_ms {
        Some(beat) => (beat, "ms"),
        None => (100.0, share_unit(false)),
    };
    let unit_width = text_width(ui, unit, note_font());
    let columns = ((plot.area.width() / 80.0) as usize).clamp(2, 6);
    for tick in nice_ticks(0.0, end, columns) {
        let x = plot.x(tick / end);
        if x < plot.area.right() - unit_width - 16.0 {
            note_at(ui, pos2(x, y), Align2::CENTER_TOP, format!("{tick:.0}"));
        }
    }
    note_at(ui, pos2(plot.area.right(), y), Align2::RIGHT_TOP, unit);
}

fn draw_phases(ui: &Ui, view: &CurvesView, plot: &Plot) {
    let colours = colours(ui);
    for (frame, name) in [(view.end_diastole, "ED"), (view.end_systole, "ES")] {
        let Some(frame) = frame else { continue };
        let x = plot.x(view.axis.share_at(frame as f64));
        let ends = [pos2(x, plot.area.top()), pos2(x, plot.area.bottom())];
        let stroke = Stroke::new(line::THIN, colours.muted);
        ui.painter()
            .extend(Shape::dashed_line(&ends, stroke, 3.0, 3.0));
        note_at(ui, pos2(x + 4.0, plot.area.top()), Align2::LEFT_TOP, name);
    }
}

fn kind_colour(kind: CurveKind, colours: &Colours) -> Color32 {
    match kind {
        CurveKind::Endocardium => colours.text,
        CurveKind::Epicardium => colours.epicardium,
    }
}

fn kind_name(kind: CurveKind) -> &'static str {
    match kind {
        CurveKind::Endocardium => "endo",
        CurveKind::Epicardium => "epi",
    }
}

/// Straight from frame to frame, as positions between frames are interpolated; the last runs
/// into the first.
fn draw_curve(ui: &Ui, axis: &CycleAxis, curve: &Curve, plot: &Plot) {
    let colours = colours(ui);
    let colour = kind_colour(curve.kind, colours);
    let count = curve.values.len();
    let at = |frame: usize| {
        let value = curve
            .values
            .get(frame % count.max(1))
            .copied()
            .unwrap_or(f64::NAN);
        value
            .is_finite()
            .then(|| pos2(plot.x(axis.share_at(frame as f64)), plot.y(value)))
    };
    let stroke = Stroke::new(line::MARK, colour);
    let painter = ui.painter();
    for frame in 0..count {
        if let (Some(from), Some(to)) = (at(frame), at(frame + 1)) {
            painter.line_segment([from, to], stroke);
        }
    }
    for frame in 0..count {
        if let Some(point) = at(frame) {
            painter.circle_filled(point, 2.0, colour);
        }
    }
    if let Some(end) = at(count) {
        let name = kind_name(curve.kind);
        let place = end - vec2(2.0, 5.0);
        painter.text(place, Align2::RIGHT_BOTTOM, name, note_font(), colour);
    }
}

/// Value between frames, as straight lines have it.
fn value_at(curve: &Curve, position: f64) -> f64 {
    let count = curve.values.len();
    if count == 0 {
        return f64::NAN;
    }
    let frame = position.floor() as usize;
    let part = position - frame as f64;
    let (here, next) = (
        curve.values[frame % count],
        curve.values[(frame + 1) % count],
    );
    if part > 0.0 {
        here + part * (next - here)
    } else {
        here
    }
}

fn draw_now(ui: &Ui, view: &CurvesView, plot: &Plot) {
    let colours = colours(ui);
    let painter: &Painter = ui.painter();
    let x = plot.x(view.axis.share_at(view.position));
    let stroke = Stroke::new(line::THIN, colours.selection);
    painter.vline(x, plot.area.y_range(), stroke);
    for curve in &view.curves {
        let value = value_at(curve, view.position);
        if value.is_finite() {
            let point = pos2(x, plot.y(value));
            painter.circle_filled(point, 5.0, colours.pane);
            painter.circle_filled(point, 4.0, colours.selection);
        }
    }
    let value = view
        .curves
        .first()
        .map_or(f64::NAN, |curve| value_at(curve, view.position));
    if value.is_finite() {
        let right = x > plot.area.right() - 70.0;
        let (anchor, gap) = if right {
            (Align2::RIGHT_BOTTOM, -7.0)
        } else {
            (Align2::LEFT_BOTTOM, 7.0)
        };
        let at = pos2(x + gap, plot.y(value) - 3.0);
        let text = format!("{value:.0} {}", view.unit);
        let galley = painter.layout_no_wrap(text, medium_note_font(), colours.selection);
        let rect = anchor.anchor_size(at, galley.size());
        painter.rect_filled(
            rect.expand2(vec2(2.0, 0.0)),
            3.0,
            colours.pane.gamma_multiply(0.8),
        );
        painter.galley(rect.min, galley, colours.selection);
    }
}

fn hover_text(view: &CurvesView, position: f64) -> String {
    let share = view.axis.share_at(position);
    let mut text = share_words(share, view.cycle_ms.is_some());
    if let Some(cycle) = view.cycle_ms {
        text = format!("{:.0} ms · {text}", share * cycle);
    }
    for curve in &view.curves {
        let value = value_at(curve, position);
        if value.is_finite() {
            text += &format!("\n{} {value:.1} {}", kind_name(curve.kind), view.unit);
        }
    }
    text
}

#[cfg(test)]
mod tests;
