//! Shapes that stand for verdicts, told apart without colour, and the few words beside them.

use egui::{Color32, Painter, Pos2, Shape, Stroke, vec2};

use crate::ui::theme::{Colours, line};

/// What was found in a heart, as tables and views mark it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum VerdictMark {
    /// Thickens as normal hearts do: a dot.
    #[default]
    Nothing,
    /// Unlike normal hearts, without a part that stands out: a hollow diamond.
    Elsewhere,
    /// The whole wall fails: a ring.
    Global,
    /// A part does not thicken: a filled diamond.
    Patch,
    /// Nothing can be said: a dash.
    NotAssessed,
}

impl VerdictMark {
    /// In a word or two, as a narrow column has room for.
    pub fn word(self) -> &'static str {
        match self {
            Self::Nothing => "no finding",
            Self::Elsewhere => "abnormal",
            Self::Global => "hypokinesia",
            Self::Patch => "patch",
            Self::NotAssessed => "not assessed",
        }
    }

    /// Its colour; never the only thing that tells it.
    pub fn colour(self, colours: &Colours) -> Color32 {
        match self {
            Self::Nothing => colours.muted,
            Self::Elsewhere | Self::Global => colours.abnormal,
            Self::Patch => colours.selection,
            Self::NotAssessed => colours.muted,
        }
    }
}

/// Draws a mark.
pub fn verdict_mark(
    painter: &Painter,
    centre: Pos2,
    radius: f32,
    mark: VerdictMark,
    colour: Color32,
) {
    let stroke = Stroke::new(line::MARK, colour);
    let diamond = |reach: f32| {
        [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]
            .map(|(x, y)| centre + reach * vec2(x, y))
            .to_vec()
    };
    match mark {
        VerdictMark::Nothing => {
            painter.circle_filled(centre, 0.45 * radius, colour);
        }
        VerdictMark::Elsewhere => {
            painter.add(Shape::closed_line(diamond(radius), stroke));
        }
        VerdictMark::Global => {
            painter.circle_stroke(centre, 0.9 * radius, Stroke::new(line::STRONG, colour));
        }
        VerdictMark::Patch => {
            let reach = 1.15 * radius;
            painter.add(Shape::convex_polygon(diamond(reach), colour, Stroke::NONE));
        }
        VerdictMark::NotAssessed => {
            let arm = vec2(0.8 * radius, 0.0);
            painter.line_segment([centre - arm, centre + arm], stroke);
        }
    }
}
