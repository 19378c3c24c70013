//! Shapes and colours of the labels of a study: each label has its own, so that colour is never alone.

use egui::{Color32, Pos2, Rect, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::study::LabelRole;
use crate::ui::theme::{Colours, colours, line};

/// How subjects of one label are marked in tables, maps and legends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LabelMark {
    /// Any label that counts as normal: a circle.
    Normal,
    /// Another label of the study, by its place among them.
    Label(u8),
    /// No label: a square.
    #[default]
    Unlabelled,
}

/// Shapes of labels other than normal, in the order of labels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LabelShape {
    Cross,
    TriangleUp,
    Plus,
    TriangleDown,
    Diamond,
    Asterisk,
    Pentagon,
    Hourglass,
}

const SHAPES: [LabelShape; 8] = [
    LabelShape::Cross,
    LabelShape::TriangleUp,
    LabelShape::Plus,
    LabelShape::TriangleDown,
    LabelShape::Diamond,
    LabelShape::Asterisk,
    LabelShape::Pentagon,
    LabelShape::Hourglass,
];

impl LabelMark {
    /// Marks of subjects by their label and its role. Labels other than normal are counted in alphabetical order
    /// whatever their case, so that the order of subjects changes no mark.
    pub fn of_study<'a>(labels: &[(Option<&'a str>, LabelRole)]) -> Vec<Self> {
        let other = |&(label, role): &(Option<&'a str>, LabelRole)| {
            label
                .filter(|_| role != LabelRole::Normal)
                .map(str::to_lowercase)
        };
        let mut known: Vec<String> = labels.iter().filter_map(other).collect();
        known.sort();
        known.dedup();
        let mark = |subject: &(Option<&'a str>, LabelRole)| match (subject.1, other(subject)) {
            (LabelRole::Normal, _) => Self::Normal,
            (_, Some(label)) => {
                let place = known.binary_search(&label).unwrap_or_default();
                Self::Label(u8::try_from(place).unwrap_or(u8::MAX))
            }
            (_, None) => Self::Unlabelled,
        };
        labels.iter().map(mark).collect()
    }

    /// Its colour. Past the eighth label the shapes come again, each in another colour.
    pub fn colour(self, colours: &Colours) -> Color32 {
        match self {
            Self::Normal => colours.normal,
            Self::Unlabelled => colours.unknown,
            Self::Label(place) => {
                let place = usize::from(place);
                let count = colours.labels.len();
                colours.labels[(place + place / count) % count]
            }
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
    match mark {
        LabelMark::Normal if filled => Shape::circle_filled(centre, radius, colour),
        LabelMark::Normal => Shape::circle_stroke(centre, radius - 0.5 * line::MARK, stroke),
        LabelMark::Unlabelled => {
            let square = Rect::from_center_size(centre, Vec2::splat(1.8 * radius));
            if filled {
                Shape::rect_filled(square, 1.0, colour)
            } else {
                Shape::rect_stroke(square, 1.0, stroke, egui::StrokeKind::Inside)
            }
        }
        LabelMark::Label(place) => {
            let shape = SHAPES[usize::from(place) % SHAPES.len()];
            other_shape(centre, radius, shape, colour, filled)
        }
    }
}

fn other_shape(
    centre: Pos2,
    radius: f32,
    shape: LabelShape,
    colour: Color32,
    filled: bool,
) -> Shape {
    let width = if filled { line::STRONG } else { line::MARK };
    let arms = |ends: &[Vec2]| {
        let arm = |end: &Vec2| {
            Shape::line_segment(
                [centre - radius * *end, centre + radius * *end],
                Stroke::new(width, colour),
            )
        };
        Shape::Vec(ends.iter().map(arm).collect())
    };
    let polygon = |corners: Vec<Pos2>| {
        if filled {
            Shape::convex_polygon(corners, colour, Stroke::NONE)
        } else {
            Shape::closed_line(corners, Stroke::new(line::MARK, colour))
        }
    };
    // Corners on a circle, the first one up.
    let regular = |count: usize, turn: f32, reach: f32| -> Vec<Pos2> {
        let corner = |index: usize| {
            let angle = std::f32::consts::TAU * (index as f32 / count as f32 + turn);
            centre + reach * radius * vec2(angle.sin(), -angle.cos())
        };
        (0..count).map(corner).collect()
    };
    match shape {
        LabelShape::Cross => arms(&[vec2(0.85, 0.85), vec2(0.85, -0.85)]),
        LabelShape::Plus => arms(&[vec2(1.1, 0.0), vec2(0.0, 1.1)]),
        LabelShape::Asterisk => {
            let arm = |turn: f32| vec2(turn.sin(), turn.cos()) * 1.1;
            let third = std::f32::consts::FRAC_PI_3;
            arms(&[arm(0.0), arm(third), arm(2.0 * third)])
        }
        LabelShape::TriangleUp => polygon(regular(3, 0.0, 1.25)),
        LabelShape::TriangleDown => polygon(regular(3, 0.5, 1.25)),
        LabelShape::Diamond => polygon(regular(4, 0.0, 1.2)),
        LabelShape::Pentagon => polygon(regular(5, 0.0, 1.1)),
        LabelShape::Hourglass => {
            let half = |side: f32| {
                polygon(vec![
                    centre,
                    pos2(centre.x - radius, centre.y + side * radius),
                    pos2(centre.x + radius, centre.y + side * radius),
                ])
            };
            Shape::Vec(vec![half(-1.0), half(1.0)])
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
    fn every_label_of_a_study_has_its_own_mark_whatever_the_order_of_subjects() {
        let study = [
            (Some("MINF"), LabelRole::Abnormal),
            (Some("DCM"), LabelRole::Abnormal),
            (Some("NOR"), LabelRole::Normal),
            (Some("RV"), LabelRole::Unknown),
            (Some("dcm"), LabelRole::Abnormal),
            (None, LabelRole::Unknown),
        ];
        let marks = LabelMark::of_study(&study);
        let [dcm, minf, rv] = [0, 1, 2].map(LabelMark::Label);
        let wanted = [minf, dcm, LabelMark::Normal, rv, dcm, LabelMark::Unlabelled];
        assert_eq!(marks, wanted);
        let turned: Vec<_> = study.into_iter().rev().collect();
        let mut again = LabelMark::of_study(&turned);
        again.reverse();
        assert_eq!(again, marks);
    }

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
