//! The typeface of figures, Inter, in its weights; and the outline of a letter.

use ab_glyph::{OutlineCurve, Point};

/// Thickness of letters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Weight {
    /// Running text.
    #[default]
    Regular,
    /// Names and numbers that matter.
    SemiBold,
}

/// One letter of a line: its outline in the typeface's units, y up.
pub(super) struct Letter {
    /// From the start of the line in pixels.
    pub(super) x: f32,
    /// Above the base line in pixels: accents of scripts that stack them.
    pub(super) y: f32,
    /// Pixels for each unit of the typeface.
    pub(super) scale: f32,
    /// One closed curve after the other.
    pub(super) curves: Vec<OutlineCurve>,
}

impl Letter {
    /// Where a point of the outline stands on a page whose base line begins at `start`.
    pub(super) fn place(&self, start: [f32; 2], point: Point) -> [f32; 2] {
        let x = start[0] + self.x + point.x * self.scale;
        [x, start[1] - self.y - point.y * self.scale]
    }
}

impl Weight {
    /// The typeface as a file.
    pub(super) fn file(self) -> &'static [u8] {
        match self {
            Self::Regular => REGULAR,
            Self::SemiBold => SEMI_BOLD,
        }
    }

    /// The number that style sheets give it.
    pub(super) fn number(self) -> u16 {
        match self {
            Self::Regular => 400,
            Self::SemiBold => 600,
        }
    }
}

const REGULAR: &[u8] = include_bytes!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/assets/fonts/Inter-Regular.otf"
));
const SEMI_BOLD: &[u8] = include_bytes!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/assets/fonts/Inter-SemiBold.otf"
));
