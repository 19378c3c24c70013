//! Text in figures: Inter, drawn with smooth edges at any size.

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};

use crate::picture::figure::canvas::Canvas;

/// Thickness of letters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// Running text.
    #[default]
    Regular,
    /// Names and numbers that matter.
    SemiBold,
}

/// A typeface inside the program is damaged: a fault of the build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the typeface inside the program cannot be read")]
pub struct FontError;

/// The typefaces of figures.
#[derive(Clone, Debug)]
pub struct FigureFonts {
    regular: FontRef<'static>,
    semi_bold: FontRef<'static>,
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
        let read = |bytes| FontRef::try_from_slice(bytes).map_err(|_| FontError);
        Ok(Self {
            regular: read(REGULAR)?,
            semi_bold: read(SEMI_BOLD)?,
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

    /// Draws a line of text whose base line starts at `at`, and returns its width in pixels.
    pub fn draw(
        &self,
        canvas: &mut Canvas,
        text: &str,
        weight: Weight,
        size: f32,
        at: [f32; 2],
        colour: [f32; 3],
    ) -> f32 {
        let font = self.font(weight);
        let scale = scale(font, size);
        let scaled = font.as_scaled(scale);
        let mut x = at[0];
        let mut before = None;
        for letter in text.chars() {
            let id = font.glyph_id(letter);
            x += before.map_or(0.0, |before| scaled.kern(before, id));
            let glyph: Glyph = id.with_scale_and_position(scale, point(x, at[1]));
            if let Some(outline) = font.outline_glyph(glyph) {
                let corner = outline.px_bounds().min;
                outline.draw(|dx, dy, covered| {
                    let place = (
                        corner.x as i64 + i64::from(dx),
                        corner.y as i64 + i64::from(dy),
                    );
                    canvas.cover(place.0, place.1, colour, covered);
                });
            }
            x += scaled.h_advance(id);
            before = Some(id);
        }
        x - at[0]
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

    #[test]
    fn text_is_as_dark_as_its_area() {
        let fonts = FigureFonts::load().unwrap();
        let mut canvas = Canvas::filled(60, 40, [1.0; 3], 1.0);
        fonts.draw(
            &mut canvas,
            "I",
            Weight::Regular,
            30.0,
            [20.0, 32.0],
            [0.0; 3],
        );
        let dark: f32 = canvas
            .pixels()
            .chunks(4)
            .map(|p| 1.0 - f32::from(p[0]) / 255.0)
            .sum();
        // An I is a bar of cap height (0.73 em) by its stem (0.09 em).
        assert!((dark - 30.0 * 0.73 * 30.0 * 0.09).abs() < 15.0, "{dark}");
    }
}
