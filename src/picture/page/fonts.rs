//! Text of figures in Inter, and in further faces where Inter lacks a letter: widths, lines, outlines.

use ab_glyph::{Font, FontRef, PxScale, ScaleFont};
use unicode_normalization::UnicodeNormalization;

use crate::picture::page::faces::{FurtherFace, further_face};
use crate::picture::page::runs::split;
use crate::picture::page::weight::{Letter, Weight};

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

/// Words of one face.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    /// What is said.
    pub(super) words: String,
    /// `None` for Inter.
    pub(super) face: Option<FurtherFace>,
    /// From the start of the line in pixels.
    pub(super) x: f32,
    /// In pixels.
    pub(super) width: f32,
}

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
        if self.is_own(text, weight) {
            return self.own_width(text, weight, size);
        }
        let runs = self.runs(text, weight, size);
        runs.last().map_or(0.0, |run| run.x + run.width)
    }

    /// A line of text as pieces of one face each, from left to right.
    pub(super) fn runs(&self, text: &str, weight: Weight, size: f32) -> Vec<Run> {
        // An accent behind its letter and the letter with the accent are the same text; Inter has the latter.
        let composed: String = text.nfc().collect();
        let own = |letter| self.font(weight).glyph_id(letter).0 != 0;
        let mut x = 0.0;
        (split(&composed, own, further_face).into_iter())
            .map(|(face, words)| {
                let width = match face {
                    None => self.own_width(&words, weight, size),
                    Some(face) => face.outlines(&words, size).1,
                };
                x += width;
                Run {
                    words,
                    face,
                    x: x - width,
                    width,
                }
            })
            .collect()
    }

    /// Whether Inter has every letter of a text.
    fn is_own(&self, text: &str, weight: Weight) -> bool {
        let font = self.font(weight);
        text.chars().all(|letter| font.glyph_id(letter).0 != 0)
    }

    /// Width of text of which Inter has every letter.
    fn own_width(&self, text: &str, weight: Weight, size: f32) -> f32 {
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
        // By halving: a text of many thousand letters is cut as quickly as a short one.
        let ends: Vec<usize> = text.char_indices().map(|(end, _)| end).collect();
        let shown = |end: usize| format!("{}…", text[..end].trim_end());
        let fits = |end: &usize| self.width(&shown(*end), weight, size) <= most;
        let kept = ends.partition_point(fits).saturating_sub(1);
        ends.get(kept)
            .map_or_else(|| "…".to_owned(), |end| shown(*end))
    }

    /// Outlines of a line of text of which Inter has every letter; `size` is the em in pixels.
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
                    y: 0.0,
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

    #[test]
    fn a_letter_with_an_accent_behind_it_is_one_letter_of_inter() {
        let fonts = FigureFonts::load().unwrap();
        let runs = fonts.runs("Mu\u{308}ller", Weight::Regular, 20.0);
        assert_eq!(runs.len(), 1);
        assert_eq!((runs[0].face, &*runs[0].words), (None, "M\u{fc}ller"));
    }

    #[test]
    fn names_in_any_script_have_room_and_differ() {
        let fonts = FigureFonts::load().unwrap();
        let drawn = |text: &str| {
            let runs = fonts.runs(text, Weight::SemiBold, 20.0);
            let faces = runs.iter().filter_map(|run| Some((run.face?, &run.words)));
            let curves = faces.map(|(face, words)| {
                let (letters, width) = face.outlines(words, 20.0);
                assert!(width > 5.0, "{text}");
                letters
                    .iter()
                    .map(|l| format!("{:?}", l.curves))
                    .collect::<String>()
            });
            curves.collect::<String>()
        };
        let names = [
            "心脏",
            "患者",
            "Мария",
            "יוסי",
            "محمد",
            "สมชาย",
            "राम",
            "❤",
            "\u{1b}",
        ]
        .map(drawn);
        for (index, name) in names.iter().enumerate() {
            assert!(!name.is_empty(), "{index}");
            assert!(!names[..index].contains(name), "{index}");
        }
    }

    #[test]
    fn a_text_of_many_thousand_letters_is_cut_quickly() {
        let fonts = FigureFonts::load().unwrap();
        let long = "x".repeat(200_000);
        let cut = fonts.shortened(&long, Weight::Regular, 16.0, 100.0);
        assert!(
            cut.ends_with('…') && (8..20).contains(&cut.chars().count()),
            "{cut}"
        );
    }
}
