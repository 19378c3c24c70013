//! Typefaces of the system, for letters that those of the program lack.

use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use fontdb::{Database, FaceInfo, ID, Style};
use rustybuzz::ttf_parser::{Face, OutlineBuilder};

/// A typeface that was found on this machine, held for the rest of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SystemFace {
    /// The file, which may hold several faces.
    pub bytes: &'static [u8],
    /// Which of them.
    pub index: u32,
}

/// What is known of the system's typefaces.
struct SystemFaces {
    database: Database,
    /// All faces, those before others that suit running text.
    order: Vec<ID>,
    /// Those in use: a word keeps one face.
    used: Vec<(ID, SystemFace)>,
    answers: HashMap<char, Option<SystemFace>>,
}

/// Files are read when the first letter is asked for that the program's own typefaces lack.
static FACES: LazyLock<Mutex<SystemFaces>> =
    LazyLock::new(|| Mutex::new(SystemFaces::of_machine()));

/// The typeface of this machine that has an outline for a letter; `None` where none has.
///
/// The same machine gives the same answer. The first call reads the lists of the system's font folders, so the window's
/// thread must not call this.
pub(super) fn system_face(letter: char) -> Option<SystemFace> {
    let mut faces = FACES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = faces.answers.get(&letter) {
        return *known;
    }
    let answer = faces.find(letter);
    faces.answers.insert(letter, answer);
    answer
}

impl SystemFaces {
    fn of_machine() -> Self {
        let mut database = Database::new();
        database.load_system_fonts();
        let mut faces: Vec<&FaceInfo> = database.faces().collect();
        faces.sort_by_cached_key(|face| preference(face));
        let order = faces.iter().map(|face| face.id).collect();
        Self {
            order,
            database,
            used: Vec::new(),
            answers: HashMap::new(),
        }
    }

    fn find(&mut self, letter: char) -> Option<SystemFace> {
        let used = self.used.iter();
        let mut ids = used.map(|(id, _)| id).chain(&self.order);
        let id = *ids.find(|id| {
            let drawn = |data: &[u8], index| draws(data, index, letter);
            self.database.with_face_data(**id, drawn).unwrap_or(false)
        })?;
        if let Some((_, face)) = self.used.iter().find(|(used, _)| *used == id) {
            return Some(*face);
        }
        // Held for the rest of the run: whoever draws text refers to it, and few faces are ever used.
        let held = |data: &[u8], index| SystemFace {
            bytes: Vec::leak(data.to_vec()),
            index,
        };
        let face = self.database.with_face_data(id, held)?;
        self.used.push((id, face));
        Some(face)
    }
}

/// Upright before slanted, regular before other weights, proportional before fixed width, without serifs before with; then
/// by name, so that the order does not depend on that of files on disk.
fn preference(face: &FaceInfo) -> (bool, u16, bool, bool, String, u32) {
    let serif = ["Serif", "Song", "Ming", "Mincho", "Batang", "Naskh"];
    (
        face.style != Style::Normal,
        face.weight.0.abs_diff(400),
        face.monospaced,
        serif
            .iter()
            .any(|word| face.post_script_name.contains(word)),
        face.post_script_name.clone(),
        face.index,
    )
}

/// Whether a face has an outline for a letter, not a picture of pixels alone.
fn draws(data: &[u8], index: u32, letter: char) -> bool {
    let Ok(face) = Face::parse(data, index) else {
        return false;
    };
    let glyph = face.glyph_index(letter);
    glyph.is_some_and(|glyph| face.outline_glyph(glyph, &mut Nowhere).is_some())
}

/// Takes an outline and forgets it.
struct Nowhere;

impl OutlineBuilder for Nowhere {
    fn move_to(&mut self, _: f32, _: f32) {}
    fn line_to(&mut self, _: f32, _: f32) {}
    fn quad_to(&mut self, _: f32, _: f32, _: f32, _: f32) {}
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {}
    fn close(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_that_no_script_has_is_in_no_typeface() {
        assert_eq!(system_face('\u{10fff1}'), None);
    }

    #[test]
    fn a_letter_is_found_in_the_same_face_again_and_that_face_draws_it() {
        // Hebrew: in the typefaces of most systems; where it is in none, nothing can be looked at.
        let Some(face) = system_face('ש') else {
            return;
        };
        assert!(draws(face.bytes, face.index, 'ש'));
        assert_eq!(system_face('ש'), Some(face));
        assert_eq!(system_face('ל').map(|other| other.bytes), Some(face.bytes));
    }
}
