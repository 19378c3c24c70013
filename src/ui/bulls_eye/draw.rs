//! Draws the disc: fill, rings and sectors, labels, and the selection on top.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use egui::{Align2, Color32, Mesh, Painter, Pos2, Shape, Stroke, Ui, vec2};

use crate::analysis::segments::{FlatMap, Level, RING_RADII, Segment, ring};
use crate::ui::bulls_eye::{BullsEyeFill, BullsEyePick, BullsEyeView, Plot};
use crate::ui::style::{medium_note_font, note_font};
use crate::ui::theme::{Colours, colours, line, space};

/// Straight pieces of a full circle.
const PIECES: usize = 120;

/// A disc of fewer points across has no room for numbers in its segments.
const LEAST_FOR_NUMBERS: f32 = 90.0;

/// A disc of fewer points across has no room for values under the numbers.
const LEAST_FOR_VALUES: f32 = 220.0;

/// Draws everything; `hovered` is what lies under the pointer.
pub fn draw(ui: &Ui, view: &BullsEyeView, plot: &Plot, hovered: Option<BullsEyePick>) {
    let painter = ui.painter_at(plot.rect);
    let canvas = Canvas {
        painter: &painter,
        plot,
        colours: colours(ui),
    };
    painter.circle_filled(plot.centre, plot.radius, canvas.colours.control);
    match view.fill {
        BullsEyeFill::Segments(fills) => {
            for segment in Segment::all() {
                canvas.fill(
                    segment.level(),
                    segment.sector_rad(),
                    fills[segment.index()],
                );
            }
        }
        BullsEyeFill::Levels(fills) => {
            for level in Level::ALL {
                canvas.fill(level, [0.0, PI], fills[level.index()]);
            }
        }
        BullsEyeFill::Continuous { map, colours } => canvas.surface(map, colours),
    }
    canvas.borders(view.oriented);
    for &segment in view.outlined {
        canvas.outline(segment, Stroke::new(line::STRONG, canvas.colours.strong));
    }
    if let Some(segment) = hovered.and_then(|pick| pick.segment) {
        canvas.outline(segment, Stroke::new(line::MARK, canvas.colours.text));
    }
    if let Some(segment) = view.selected.filter(|_| view.oriented) {
        canvas.outline(segment, Stroke::new(line::STRONG, canvas.colours.selection));
    }
    if view.oriented {
        canvas.numbers(view);
    }
    canvas.directions(view.oriented);
}

struct Canvas<'a> {
    painter: &'a Painter,
    plot: &'a Plot,
    colours: &'static Colours,
}

impl Canvas<'_> {
    /// Fills a sector, given by middle and half width, of a ring.
    fn fill(&self, level: Level, [middle, half]: [f64; 2], colour: Option<Color32>) {
        let Some(colour) = colour else { return };
        let [inner, outer] = ring(level);
        let steps = ((PIECES as f64 * 2.0 * half / TAU).ceil() as usize).max(1);
        let mut mesh = Mesh::default();
        for step in 0..=steps {
            let angle = middle - half + 2.0 * half * step as f64 / steps as f64;
            mesh.colored_vertex(self.plot.at(inner, angle), colour);
            mesh.colored_vertex(self.plot.at(outer, angle), colour);
            if step > 0 {
                let last = 2 * step as u32;
                mesh.add_triangle(last - 2, last - 1, last);
                mesh.add_triangle(last - 1, last + 1, last);
            }
        }
        self.painter.add(Shape::mesh(mesh));
    }

    /// A surface laid flat, its colours blended over its faces.
    fn surface(&self, map: &FlatMap, colours: &[Color32]) {
        let mut mesh = Mesh::default();
        for (vertex, &point) in map.points.iter().enumerate() {
            let colour = colours.get(vertex).copied().unwrap_or_default();
            mesh.colored_vertex(self.plot.on_screen(point), colour);
        }
        for &[a, b, c] in &map.faces {
            mesh.add_triangle(a, b, c);
        }
        self.painter.add(Shape::mesh(mesh));
    }

    /// Rings of levels and, where they mean something, borders of segments.
    fn borders(&self, oriented: bool) {
        let stroke = Stroke::new(line::THIN, self.colours.pane);
        for radius in RING_RADII {
            let radius = self.plot.radius * radius as f32;
            self.painter.circle_stroke(self.plot.centre, radius, stroke);
        }
        for segment in Segment::all().filter(|s| oriented && s.level() != Level::Apex) {
            let [inner, outer] = ring(segment.level());
            let [middle, half] = segment.sector_rad();
            let ends = [inner, outer].map(|radius| self.plot.at(radius, middle - half));
            self.painter.line_segment(ends, stroke);
        }
    }

    fn outline(&self, segment: Segment, stroke: Stroke) {
        let [inner, outer] = ring(segment.level());
        let [middle, half] = segment.sector_rad();
        let arc = |radius: f64| -> Vec<Pos2> {
            let steps = ((PIECES as f64 * half / PI).ceil() as usize).max(1);
            let angle = |step| middle - half + 2.0 * half * step as f64 / steps as f64;
            (0..=steps)
                .map(|step| self.plot.at(radius, angle(step)))
                .collect()
        };
        let mut points = arc(outer);
        if segment.level() != Level::Apex {
            points.extend(arc(inner).into_iter().rev());
        }
        self.painter.add(Shape::closed_line(points, stroke));
    }

    /// Number of each segment, and its value where there is room.
    fn numbers(&self, view: &BullsEyeView) {
        let across = 2.0 * self.plot.radius;
        if across < LEAST_FOR_NUMBERS {
            return;
        }
        for segment in Segment::all() {
            let [inner, outer] = ring(segment.level());
            let [middle, _] = segment.sector_rad();
            let radius = if segment.level() == Level::Apex {
                0.0
            } else {
                0.5 * (inner + outer)
            };
            let at = self.plot.at(radius, middle);
            let value = &view.values[segment.index()];
            let two_lines = across >= LEAST_FOR_VALUES && !value.is_empty();
            let shift = vec2(0.0, if two_lines { 7.0 } else { 0.0 });
            self.label(at - shift, segment.number().to_string(), medium_note_font());
            if two_lines {
                self.label(at + shift, value.clone(), note_font());
            }
        }
    }

    /// A line of text that is read on any colour: on a plate of the pane's.
    fn label(&self, at: Pos2, text: String, font: egui::FontId) {
        let text = (self.painter).layout_no_wrap(text, font, self.colours.strong);
        let rect = Align2::CENTER_CENTER.anchor_size(at, text.size());
        let plate = self.colours.pane.gamma_multiply(0.55);
        self.painter
            .rect_filled(rect.expand2(vec2(3.0, 0.0)), 3.0, plate);
        self.painter.galley(rect.min, text, self.colours.strong);
    }

    /// The words around the disc; where they are not known, that they are not.
    fn directions(&self, oriented: bool) {
        let colour = self.colours.muted;
        if !oriented {
            self.painter.text(
                self.plot.rect.center_bottom() - vec2(0.0, space::SMALL),
                Align2::CENTER_BOTTOM,
                "Orientation not stated: levels only",
                note_font(),
                colour,
            );
            return;
        }
        for (word, angle, anchor) in [
            ("anterior", FRAC_PI_2, Align2::CENTER_BOTTOM),
            ("inferior", -FRAC_PI_2, Align2::CENTER_TOP),
        ] {
            let at = self.plot.at(1.0, angle);
            let away = vec2(0.0, -(angle.sin() as f32) * space::SMALL);
            (self.painter).text(at + away, anchor, word, note_font(), colour);
        }
        // Beside the disc words stand upright, so that a narrow pane has room for them.
        for (word, angle, turn) in [("septal", PI, -1.0), ("lateral", 0.0, 1.0)] {
            let text = (self.painter).layout_no_wrap(word.to_owned(), note_font(), colour);
            let size = text.size();
            let side = angle.cos() as f32;
            let middle = self.plot.at(1.0, angle) + vec2(side * (space::SMALL + 0.5 * size.y), 0.0);
            let corner = middle + vec2(turn * 0.5 * size.y, -turn * 0.5 * size.x);
            let shape = egui::epaint::TextShape::new(corner, text, colour)
                .with_angle(turn * std::f32::consts::FRAC_PI_2);
            self.painter.add(shape);
        }
    }
}
