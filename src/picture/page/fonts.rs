//! The typeface of figures: Inter, its widths and its outlines.

use ab_glyph::{Font, FontRef, OutlineCurve, PxScale, ScaleFont};

/// Thickness of letters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Weight {
    /// Running text.
    #[default]
    Regular,
    /// Names and numbers that matter.
    SemiBold,
}

/// A typeface inside the program is damaged: a fault of the build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the built-in font cannot be read")]
pub struct FontError;

/// The typefaces of figures.
#[derive(Clone, Debug)]
pub struct FigureFonts {
    regular: FontRef<'static>,
    semi_bold: FontRef<'static>,
}

/// One letter of a line: its outline in the typeface's units, y up.
pub(super) struct Letter {
    /// From the start of the line in pixels.
    pub(super) x: f32,
    /// Pixels for each unit of the typeface.
    pub(super) scale: f32,
    /// One closed curve after the other.
    pub(super) curves: Vec<OutlineCurve>,
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

impl FigureFonts {
    /// Reads the typefaces that ship inside.
    ///
    /// # Errors
    /// If one is damaged.
    pub fn load() -> Result<Self, FontError> {
        let read = |weight: Weight| FontRef::try_from_slice(weight.file()).map_err(|_| FontError);
        Ok(Self {
            regular: read(Weight::Regular)?,
            semi_bold: read(Weight::SemiBold)?,
        })
    }

    /// Width of a line of text in pixels; `size` is the em in pixels.
    pub fn width(&self, text: &str, weight: Weight, size: f32) -> f32 {
        let font = self.font(weight);
        let scaled = font.as_scaled(scale(font, size));
        let mut width = 0.0;
        let mut before = None;
        for id in text.chars().map(|letter| font.glyph_id(letter)) {
            width += before.map_or(0.0, |before| scaled.kern(before, id)) + scaled.h_advance(id);
            before = Some(id);
        }
        width
    }

    /// Breaks text at spaces so that no line is wider than `most`, unless a single word is.
    pub fn wrapped(&self, text: &str, weight: Weight, size: f32, most: f32) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            if let Some(line) = lines.last_mut() {
                let longer = format!("{line} {word}");
                if self.width(&longer, weight, size) <= most {
                    *line = longer;
                    continue;
                }
            }
            lines.push(word.to_owned());
        }
        lines
    }

    /// Text cut to a width, with `…` where something was left out.
    pub fn shortened(&self, text: &str, weight: Weight, size: f32, most: f32) -> String {
        if self.width(text, weight, size) <= most {
            return text.to_owned();
        }
        let mut kept: String = text.to_owned();
        while kept.pop().is_some() {
            let shown = format!("{}…", kept.trim_end());
            if self.width(&shown, weight, size) <= most {
                return shown;
            }
        }
        "…".to_owned()
    }

    /// Outlines of a line of text, letter by letter; `size` is the em in pixels.
    pub(super) fn outlines(&self, text: &str, weight: Weight, size: f32) -> Vec<Letter> {
        let font = self.font(weight);
        let scaled = font.as_scaled(scale(font, size));
        let mut x = 0.0;
        let mut before = None;
        let mut letters = Vec::with_capacity(text.len());
        for id in text.chars().map(|letter| font.glyph_id(letter)) {
            x += before.map_or(0.0, |before| scaled.kern(before, id));
            if let Some(outline) = font.outline(id) {
                letters.push(Letter {
                    x,
                    scale: size / font.units_per_em().unwrap_or(1000.0),
                    curves: outline.curves,
                });
            }
            x += scaled.h_advance(id);
            before = Some(id);
        }
        letters
    }

    fn font(&self, weight: Weight) -> &FontRef<'static> {
        match weight {
            Weight::Regular => &self.regular,
            Weight::SemiBold => &self.semi_bold,
        }
    }
}

/// ab_glyph scales by ascent less descent; type sizes are the em.
fn scale(font: &FontRef<'_>, size: f32) -> PxScale {
    let em = font.units_per_em().unwrap_or(1000.0);
    PxScale::from(size * font.height_unscaled() / em)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_tabular() {
        let fonts = FigureFonts::load().unwrap();
        let width = |text| fonts.width(text, Weight::Regular, 20.0);
        assert!((width("1111") - width("8888")).abs() < 1e-3);
        assert!(width("ml") > 10.0);
    }

    #[test]
    fn every_letter_that_figures_use_is_in_the_typeface() {
        let fonts = FigureFonts::load().unwrap();
        for letter in "AZaz09·–−×²³°%…(),µ".chars() {
            for font in [&fonts.regular, &fonts.semi_bold] {
                assert_ne!(font.glyph_id(letter).0, 0, "{letter}");
            }
        }
    }

    #[test]
    fn a_line_is_broken_where_it_grows_too_wide() {
        let fonts = FigureFonts::load().unwrap();
        let lines = fonts.wrapped(
            "one range for the whole cohort",
            Weight::Regular,
            16.0,
            100.0,
        );
        assert!(lines.len() > 1);
        assert!(
            lines
                .iter()
                .all(|l| fonts.width(l, Weight::Regular, 16.0) <= 100.0)
        );
        assert_eq!(lines.join(" "), "one range for the whole cohort");
        let short = fonts.shortened("one range for the cohort", Weight::Regular, 16.0, 100.0);
        assert!(short.ends_with('…') && fonts.width(&short, Weight::Regular, 16.0) <= 100.0);
    }
}
