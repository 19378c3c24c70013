//! Typefaces beside Inter: those that come with the window, those of the system, and codes for letters that none of them has.

use std::collections::{BTreeSet, HashMap};
use std::sync::{LazyLock, Mutex, PoisonError};

use ab_glyph::{Font, FontRef, GlyphId};
use rustybuzz::{UnicodeBuffer, shape};

use crate::picture::page::code_face::code_face;
use crate::picture::page::system_faces::system_face;
use crate::picture::page::weight::{Letter, Weight};

/// A typeface for letters that Inter lacks, held for the rest of the run.
#[derive(Clone, Copy, Debug)]
pub struct FurtherFace {
    /// The file, which may hold several faces.
    pub bytes: &'static [u8],
    /// Which of them.
    pub index: u32,
    /// Whether it shows codes in place of letters.
    pub coded: bool,
    number: usize,
}

impl PartialEq for FurtherFace {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl FurtherFace {
    /// Names it in this run.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Whether it has a letter.
    pub(super) fn has(&self, letter: char) -> bool {
        has(self.bytes, self.index, letter)
    }

    /// Outlines of a line of text and its width in pixels; `size` is the em in pixels. Letters are joined and ordered as
    /// their script asks.
    pub(super) fn outlines(&self, text: &str, size: f32) -> (Vec<Letter>, f32) {
        let (Some(shaper), Ok(font)) = (
            rustybuzz::Face::from_slice(self.bytes, self.index),
            FontRef::try_from_slice_and_index(self.bytes, self.index),
        ) else {
            return (Vec::new(), 0.0);
        };
        let scale = size / shaper.units_per_em() as f32;
        let mut buffer = UnicodeBuffer::new();
        buffer.push_str(text);
        buffer.guess_segment_properties();
        let shaped = shape(&shaper, &[], buffer);
        let mut x = 0.0;
        let mut letters = Vec::with_capacity(shaped.len());
        for (glyph, place) in shaped.glyph_infos().iter().zip(shaped.glyph_positions()) {
            // Faces of OpenType hold at most 65,535 glyphs.
            let id = GlyphId(u16::try_from(glyph.glyph_id).unwrap_or_default());
            if let Some(outline) = font.outline(id) {
                letters.push(Letter {
                    x: x + scale * place.x_offset as f32,
                    y: scale * place.y_offset as f32,
                    scale,
                    curves: outline.curves,
                });
            }
            x += scale * place.x_advance as f32;
        }
        (letters, x)
    }
}

/// Faces that are found by their letters.
#[derive(Default)]
struct Known {
    faces: Vec<FurtherFace>,
    of_letter: HashMap<char, Option<usize>>,
}

static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);

/// The face that comes with the window beside Inter: Ubuntu Light, with Cyrillic, more Latin and Greek.
///
/// A static, not a constant: it is recognised by its address.
static WITH_WINDOW: &[u8] = epaint_default_fonts::UBUNTU_LIGHT;

/// The face for a letter that Inter lacks. `None` for what is part of the letter before it, and if the program is damaged.
pub(super) fn further_face(letter: char) -> Option<FurtherFace> {
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let number = match known.of_letter.get(&letter) {
        Some(number) => *number,
        None => {
            let number = known.find(letter);
            known.of_letter.insert(letter, number);
            number
        }
    };
    known.faces.get(number?).copied()
}

impl Known {
    fn find(&mut self, letter: char) -> Option<usize> {
        if !is_unseen(letter) {
            if has(WITH_WINDOW, 0, letter) {
                return Some(self.number_of(WITH_WINDOW, 0, false));
            }
            if let Some(face) = system_face(letter) {
                return Some(self.number_of(face.bytes, face.index, false));
            }
        }
        let bytes = code_face(&[letter])?;
        Some(self.number_of(Vec::leak(bytes), 0, true))
    }

    fn number_of(&mut self, bytes: &'static [u8], index: u32, coded: bool) -> usize {
        let mut faces = self.faces.iter();
        let same = |face: &FurtherFace| std::ptr::eq(face.bytes, bytes) && face.index == index;
        faces.position(same).unwrap_or_else(|| {
            let number = self.faces.len();
            self.faces.push(FurtherFace {
                bytes,
                index,
                coded,
                number,
            });
            number
        })
    }
}

/// Characters that no face may swallow: controls, and those that turn or join text without being seen.
fn is_unseen(letter: char) -> bool {
    letter.is_control()
        || matches!(letter, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// Whether Inter has a letter.
fn is_own(letter: char) -> bool {
    static INTER: LazyLock<Option<FontRef<'static>>> =
        LazyLock::new(|| FontRef::try_from_slice(Weight::Regular.file()).ok());
    (INTER.as_ref()).is_some_and(|inter| inter.glyph_id(letter).0 != 0)
}

fn has(file: &[u8], index: u32, letter: char) -> bool {
    rustybuzz::ttf_parser::Face::parse(file, index)
        .is_ok_and(|face| face.glyph_index(letter).is_some())
}

/// What a window needs for texts beside its own faces.
#[derive(Clone, Debug, Default)]
pub struct FacesFor {
    /// Faces of the system: file and number of the face in it.
    pub faces: Vec<(&'static [u8], u32)>,
    /// Letters that no face has.
    pub without: Vec<char>,
    /// A face that shows the codes of those.
    pub codes: Option<Vec<u8>>,
}

/// The faces for all letters of some texts that neither Inter nor the faces of the window have.
///
/// Reads files where a letter is in none of the program's own faces.
pub fn faces_for<'a>(texts: impl IntoIterator<Item = &'a str>) -> FacesFor {
    let letters: BTreeSet<char> = texts.into_iter().flat_map(str::chars).collect();
    let mut found = FacesFor::default();
    for letter in letters.into_iter().filter(|letter| !is_own(*letter)) {
        let Some(face) = further_face(letter) else {
            continue;
        };
        if face.coded {
            found.without.push(letter);
        } else if !std::ptr::eq(WITH_WINDOW, face.bytes)
            && !found.faces.contains(&(face.bytes, face.index))
        {
            found.faces.push((face.bytes, face.index));
        }
    }
    if !found.without.is_empty() {
        found.codes = code_face(&found.without);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cyrillic_comes_with_the_program() {
        for letter in "Жя".chars() {
            let face = further_face(letter).unwrap();
            assert!(!face.coded && face.has(letter), "{letter}");
            let (letters, width) = face.outlines(&letter.to_string(), 20.0);
            assert_eq!(letters.len(), 1);
            assert!(width > 5.0);
        }
        assert!(faces_for(["Жя Jürgen"]).faces.is_empty());
    }

    #[test]
    fn what_nobody_sees_is_shown_by_its_code() {
        for letter in ['\u{1b}', '\u{202e}', '\u{200b}', '\u{10fff1}'] {
            assert!(further_face(letter).unwrap().coded, "{letter:?}");
        }
        let found = faces_for(["a\u{1b}b", "c\u{202e}"]);
        assert_eq!(found.without, ['\u{1b}', '\u{202e}']);
        assert!(found.codes.is_some());
    }
}
