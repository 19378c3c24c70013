//! A typeface made when it is needed, for letters that no face has: each shows its code, such as U+5FC3.
//!
//! Two names in letters that a machine cannot draw stay apart, and whoever copies them from a PDF or the window has the
//! letters themselves.

use ab_glyph::{Font, FontRef};
use kurbo::{BezPath, CubicBez, Point, Shape};
use write_fonts::FontBuilder;
use write_fonts::tables::cmap::Cmap;
use write_fonts::tables::glyf::{GlyfLocaBuilder, Glyph, SimpleGlyph};
use write_fonts::tables::head::Head;
use write_fonts::tables::hhea::Hhea;
use write_fonts::tables::hmtx::{Hmtx, LongMetric};
use write_fonts::tables::maxp::Maxp;
use write_fonts::types::GlyphId;

use crate::picture::page::outline::{OutlineSink, trace};
use crate::picture::page::weight::Weight;

/// Size of a code relative to the text that it stands in.
const SIZE: f64 = 0.75;
/// Room before and behind a code, as a share of the em.
const MARGIN: f64 = 0.06;
/// How far a quadratic curve may lie from the cubic one that it stands for, in units of the face: a thousandth of the em
/// is far below a pixel.
const ACCURACY: f64 = 2.0;
/// A face holds no more glyphs.
const MAX_LETTERS: usize = 60_000;

/// How a letter is written that no face has.
pub fn letter_code(letter: char) -> String {
    format!("U+{:04X}", u32::from(letter))
}

/// The file of a typeface with a glyph per letter that shows the letter's code, drawn with the letters of Inter. `None` if
/// the typeface inside the program is damaged.
pub(super) fn code_face(letters: &[char]) -> Option<Vec<u8>> {
    let inter = FontRef::try_from_slice(Weight::Regular.file()).ok()?;
    let em = f64::from(inter.units_per_em()?);
    let mut outlines = GlyfLocaBuilder::new();
    outlines.add_glyph(&Glyph::Empty).ok()?;
    let mut metrics = vec![LongMetric::new(0, 0)];
    let mut codes = Vec::new();
    let mut widest = 0;
    for &letter in letters.iter().take(MAX_LETTERS) {
        let (path, advance) = code_outline(&inter, em, &letter_code(letter))?;
        let glyph = SimpleGlyph::from_bezpath(&path).ok()?;
        codes.push((letter, GlyphId::new(u32::try_from(metrics.len()).ok()?)));
        metrics.push(LongMetric::new(advance, path.bounding_box().x0 as i16));
        widest = widest.max(advance);
        outlines.add_glyph(&glyph).ok()?;
    }
    let count = u16::try_from(metrics.len()).ok()?;
    let (glyf, loca, form) = outlines.build();
    let head = Head {
        units_per_em: em as u16,
        x_max: i16::try_from(widest).unwrap_or(i16::MAX),
        y_max: inter.ascent_unscaled() as i16,
        y_min: inter.descent_unscaled() as i16,
        index_to_loc_format: form as i16,
        ..Head::default()
    };
    let hhea = Hhea {
        ascender: (inter.ascent_unscaled() as i16).into(),
        descender: (inter.descent_unscaled() as i16).into(),
        advance_width_max: widest.into(),
        caret_slope_rise: 1,
        number_of_h_metrics: count,
        ..Hhea::default()
    };
    let mut builder = FontBuilder::new();
    builder.add_table(&head).ok()?;
    builder.add_table(&hhea).ok()?;
    builder.add_table(&limits(count)).ok()?;
    builder.add_table(&Hmtx::new(metrics, Vec::new())).ok()?;
    builder.add_table(&Cmap::from_mappings(codes).ok()?).ok()?;
    builder.add_table(&loca).ok()?;
    builder.add_table(&glyf).ok()?;
    Some(builder.build())
}

/// The table of limits that faces with quadratic outlines have; no program reads more of it than the number of glyphs.
fn limits(glyphs: u16) -> Maxp {
    Maxp {
        num_glyphs: glyphs,
        max_points: Some(u16::MAX),
        max_contours: Some(64),
        max_composite_points: Some(0),
        max_composite_contours: Some(0),
        max_zones: Some(2),
        max_twilight_points: Some(0),
        max_storage: Some(0),
        max_function_defs: Some(0),
        max_instruction_defs: Some(0),
        max_stack_elements: Some(0),
        max_size_of_instructions: Some(0),
        max_component_elements: Some(0),
        max_component_depth: Some(0),
    }
}

/// The outline of a code and its advance, in units of the face.
fn code_outline(inter: &FontRef<'_>, em: f64, code: &str) -> Option<(BezPath, u16)> {
    let mut path = BezPath::new();
    let mut x = MARGIN * em;
    for letter in code.chars() {
        let id = inter.glyph_id(letter);
        if let Some(outline) = inter.outline(id) {
            trace(&outline.curves, &mut CodePath { path: &mut path, x });
        }
        x += SIZE * f64::from(inter.h_advance_unscaled(id));
    }
    // Seven letters of a face with at most 2048 units an em.
    let advance = (x + MARGIN * em).round();
    (advance < f64::from(u16::MAX)).then_some((path, advance as u16))
}

/// A letter of a code on its way into the outline of a face, `x` units to the right.
struct CodePath<'a> {
    path: &'a mut BezPath,
    x: f64,
}

impl CodePath<'_> {
    fn place(&self, point: ab_glyph::Point) -> Point {
        Point::new(
            self.x + SIZE * f64::from(point.x),
            SIZE * f64::from(point.y),
        )
    }
}

impl OutlineSink for CodePath<'_> {
    fn move_to(&mut self, to: ab_glyph::Point) {
        self.path.move_to(self.place(to));
    }

    fn line_to(&mut self, to: ab_glyph::Point) {
        self.path.line_to(self.place(to));
    }

    fn quad_to(&mut self, by: ab_glyph::Point, to: ab_glyph::Point) {
        self.path.quad_to(self.place(by), self.place(to));
    }

    fn cubic_to(
        &mut self,
        from: ab_glyph::Point,
        [first, second]: [ab_glyph::Point; 2],
        to: ab_glyph::Point,
    ) {
        let [from, first, second, to] = [from, first, second, to].map(|point| self.place(point));
        // A face of this format has quadratic curves alone.
        for (_, _, quad) in CubicBez::new(from, first, second, to).to_quads(ACCURACY) {
            self.path.quad_to(quad.p1, quad.p2);
        }
    }

    fn close(&mut self) {
        self.path.close_path();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_without_a_face_show_their_codes_and_differ() {
        let bytes = code_face(&['心', '患', '\u{1b}', '🫀']).unwrap();
        let face = FontRef::try_from_slice(&bytes).unwrap();
        let curves = |letter| {
            let id = face.glyph_id(letter);
            assert_ne!(id.0, 0, "{letter}");
            face.outline(id).unwrap().curves.len()
        };
        assert!(curves('心') > 40, "six letters have many curves");
        assert_ne!(curves('心'), curves('患'));
        assert!(curves('\u{1b}') > 30 && curves('🫀') > 40);
        assert_eq!(face.glyph_id('x').0, 0, "no other letter is there");
        let em = face.units_per_em().unwrap();
        let advance = face.h_advance_unscaled(face.glyph_id('心')) / em;
        assert!((2.0..4.5).contains(&advance), "{advance}");
        assert!(rustybuzz::Face::from_slice(&bytes, 0).is_some());
    }

    #[test]
    fn codes_have_at_least_four_digits() {
        assert_eq!(letter_code('\u{1b}'), "U+001B");
        assert_eq!(letter_code('心'), "U+5FC3");
        assert_eq!(letter_code('🫀'), "U+1FAC0");
    }
}
