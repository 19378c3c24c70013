//! Shapes of verdicts, which differ without colour, and the short words beside them.

use egui::{Color32, Painter, Pos2, Shape, Stroke, vec2};

use crate::ui::theme::{Colours, line};

/// A verdict, as tables and views mark it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum VerdictMark {
    /// No regional abnormality: a dot.
    #[default]
    NoAbnormality,
    /// Abnormal without a patch: a hollow diamond.
    AbnormalWithoutPatch,
    /// Global hypokinesia: a ring.
    GlobalHypokinesia,
    /// Abnormal patch: a filled diamond.
    Patch,
    /// Not assessed: a dash.
    NotAssessed,
}

impl VerdictMark {
    /// In a word or two, as a narrow column has room for; never "normal", which is a label of the study.
    pub fn word(self) -> &'static str {
        match self {
            Self::NoAbnormality => "no finding",
            Self::AbnormalWithoutPatch => "abnormal",
            Self::GlobalHypokinesia => "hypokinesia",
            Self::Patch => "patch",
            Self::NotAssessed => "not assessed",
        }
    }

    /// Its colour; the shape says the same.
    pub fn colour(self, colours: &Colours) -> Color32 {
        match self {
            Self::NoAbnormality => colours.muted,
            Self::AbnormalWithoutPatch | Self::GlobalHypokinesia => colours.abnormal,
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
        VerdictMark::NoAbnormality => {
            painter.circle_filled(centre, 0.45 * radius, colour);
        }
        VerdictMark::AbnormalWithoutPatch => {
            painter.add(Shape::closed_line(diamond(radius), stroke));
        }
        VerdictMark::GlobalHypokinesia => {
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
