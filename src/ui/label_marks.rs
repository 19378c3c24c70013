//! Marks of the labels of a study on screen: the shapes of [`LabelMark`] in the colours of the theme.

use egui::{Color32, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};

pub use crate::picture::LabelMark;
use crate::picture::{MarkShape, label_colour_of};
use crate::ui::theme::{Colours, colours, line};

impl LabelMark {
    /// Its colour on screen.
    pub fn colour(self, colours: &Colours) -> Color32 {
        match self {
            Self::Normal => colours.normal,
            Self::Unlabelled => colours.unknown,
            Self::Label(place) => colours.labels[label_colour_of(place, colours.labels.len())],
        }
    }
}

/// The shape of a label, filled or open; lines are stronger or weaker instead.
pub fn label_shape(
    centre: Pos2,
    radius: f32,
    mark: LabelMark,
    colour: Color32,
    filled: bool,
) -> Shape {
    let stroke = Stroke::new(line::MARK, colour);
    let at = |[x, y]: [f32; 2]| centre + radius * vec2(x, y);
    match mark.shape() {
        MarkShape::Disc if filled => Shape::circle_filled(centre, radius, colour),
        MarkShape::Disc => Shape::circle_stroke(centre, radius - 0.5 * line::MARK, stroke),
        MarkShape::Square(side) => {
            let square = Rect::from_center_size(centre, Vec2::splat(2.0 * side * radius));
            if filled {
                Shape::rect_filled(square, 1.0, colour)
            } else {
                Shape::rect_stroke(square, 1.0, stroke, egui::StrokeKind::Inside)
            }
        }
        MarkShape::Arms(arms) => {
            let width = if filled { line::STRONG } else { line::MARK };
            let arm = |ends: &[[f32; 2]; 2]| {
                Shape::line_segment(ends.map(at), Stroke::new(width, colour))
            };
            Shape::Vec(arms.iter().map(arm).collect())
        }
        MarkShape::Polygons(polygons) => {
            let polygon = |corners: &Vec<[f32; 2]>| {
                let corners = corners.iter().map(|&corner| at(corner)).collect();
                if filled {
                    Shape::convex_polygon(corners, colour, Stroke::NONE)
                } else {
                    Shape::closed_line(corners, stroke)
                }
            };
            Shape::Vec(polygons.iter().map(polygon).collect())
        }
    }
}

/// Draws the mark of a label in its colour.
pub fn label_mark(ui: &Ui, centre: Pos2, radius: f32, mark: LabelMark, filled: bool) {
    let colour = mark.colour(colours(ui));
    ui.painter()
        .add(label_shape(centre, radius, mark, colour, filled));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::theme::{DARK, LIGHT};

    #[test]
    fn shapes_that_come_again_have_another_colour() {
        for colours in [DARK, LIGHT] {
            for place in 0..8 {
                let [first, again] = [place, place + 8].map(LabelMark::Label);
                assert_ne!(first.colour(&colours), again.colour(&colours));
            }
        }
    }

    /// Linear red, green and blue as they are seen without one kind of cone (Machado et al. 2009, severity 1).
    const SEEN: [[[f64; 3]; 3]; 3] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
    ];

    /// CIE L*a*b* of a colour as it is seen.
    fn lab(colour: Color32, seen: &[[f64; 3]; 3]) -> [f64; 3] {
        let linear = [colour.r(), colour.g(), colour.b()].map(|value| {
            let share = f64::from(value) / 255.0;
            if share <= 0.04045 {
                share / 12.92
            } else {
                ((share + 0.055) / 1.055).powf(2.4)
            }
        });
        let row = |row: &[f64; 3]| -> f64 { row.iter().zip(linear).map(|(a, b)| a * b).sum() };
        let [red, green, blue] = [0, 1, 2].map(|index| row(&seen[index]).clamp(0.0, 1.0));
        let part = |value: f64| {
            if value > 0.008856 {
                value.cbrt()
            } else {
                7.787 * value + 16.0 / 116.0
            }
        };
        let x = part((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.95047);
        let y = part(0.2126 * red + 0.7152 * green + 0.0722 * blue);
        let z = part((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    #[test]
    fn colours_of_labels_differ_for_colour_blind_readers_too() {
        for colours in [DARK, LIGHT] {
            let beside = [colours.normal, colours.unknown, colours.selection];
            for (index, a) in colours.labels.iter().enumerate() {
                for b in colours.labels[index + 1..].iter().chain(&beside) {
                    for seen in &SEEN {
                        let ends = lab(*a, seen).into_iter().zip(lab(*b, seen));
                        let apart = ends.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                        assert!(apart >= 11.0, "{a:?} and {b:?}: {apart}");
                    }
                }
            }
        }
    }
}
