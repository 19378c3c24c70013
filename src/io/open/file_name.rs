//! What a mesh file's name says: `{case}_{surface}_{frame}.ext` and the habits around it.

use super::frame_name::{FrameName, FrameNumber, NumberUnit};
use super::name_words::{Word, is_surface, words_of};
use super::words::{ATRIUM, Meaning, RIGHT, is_frame_word, meanings, phase_of_word};
use crate::study::SurfaceKind;

/// The parts of a file's name, without its ending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct MeshName {
    /// What is left beside the other parts; empty if nothing is.
    pub(super) case: String,
    /// The same with the words for another part of the heart.
    pub(super) case_with_structure: String,
    /// Which surface, if a word says so.
    pub(super) surface: Option<SurfaceKind>,
    /// Which frame, if there is a number or a word.
    pub(super) frame: Option<FrameName>,
    /// Whether a word says that this is a surface of a ventricle, and none that it is another part of the heart.
    pub(super) ventricle: bool,
    /// Whether a word says that it is the left ventricle.
    pub(super) left: bool,
    /// The part of the heart that it is, if that is not the left ventricle.
    pub(super) structure: Option<&'static str>,
}

/// A name in parts, before it is settled which of them is the frame.
#[derive(Clone, Debug)]
pub(super) struct NameParts {
    words: Vec<Word>,
    uses: Vec<Use>,
    surface: Option<SurfaceKind>,
    left: bool,
    structure: Option<&'static str>,
    /// The phase that a word says.
    pub(super) phase: Option<FrameName>,
    /// Numbers that may be the frame's, likeliest first.
    pub(super) numbers: Vec<Candidate>,
}

/// A number that may be the frame's.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) number: FrameNumber,
    /// Whether its place or a word says that it is the frame's; otherwise it may be a patient's.
    pub(super) sure: bool,
    /// Whether a word or a unit says that it is the frame's.
    pub(super) worded: bool,
    /// The words that it takes.
    places: Vec<usize>,
}

/// What stands for a word for a phase in [`NameParts::template`].
pub(super) const PHASE: &str = "@";

/// What a word is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    Case,
    Surface,
    Structure,
    Phase,
}

/// Which parts of a name are its frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Reading {
    /// What the word for a phase is for.
    pub(super) phase: PhaseUse,
    /// Which of the numbers is the frame's.
    pub(super) number: Option<usize>,
}

/// What the word for a phase is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum PhaseUse {
    /// It is the frame.
    #[default]
    Frame,
    /// It belongs to the name of the case.
    Case,
    /// It says nothing beside the number.
    Left,
}

/// Reads the parts of a name that stands alone, such as `lv_endo_003` or `subj0062_ED_endo`.
pub(super) fn mesh_name(stem: &str) -> MeshName {
    let parts = NameParts::of(stem);
    let reading = parts.usual_reading();
    parts.name(reading)
}

impl NameParts {
    /// Takes a name apart.
    pub(super) fn of(stem: &str) -> Self {
        let words = words_of(stem);
        let mut uses = vec![Use::Case; words.len()];
        let meant: Vec<Vec<Meaning>> = words.iter().map(meanings_of).collect();
        let place = (0..words.len()).rev().find(|&place| {
            let surface = |meaning: &Meaning| matches!(meaning, Meaning::Surface(_));
            meant[place].iter().any(surface)
        });
        let (surface, left, structure) = surface_and_structure(&meant, place, &mut uses);
        let phase = take_phase(&words, &mut uses);
        let numbers = candidates(&words, place);
        Self {
            words,
            uses,
            surface,
            left,
            structure,
            phase,
            numbers,
        }
    }

    /// The phase if there is one, else the likeliest number.
    pub(super) fn usual_reading(&self) -> Reading {
        Reading {
            phase: PhaseUse::Frame,
            number: (self.phase.is_none() && !self.numbers.is_empty()).then_some(0),
        }
    }

    /// What the name says if these parts of it are the frame.
    pub(super) fn name(&self, reading: Reading) -> MeshName {
        let candidate = reading.number.and_then(|index| self.numbers.get(index));
        let case = |with_structure: bool| {
            let parts: Vec<&str> = (self.words.iter().zip(&self.uses).enumerate())
                .filter_map(|(place, (word, used))| {
                    let of_frame = candidate.is_some_and(|c| c.places.contains(&place));
                    match used {
                        Use::Structure => with_structure.then_some(word.text.as_str()),
                        Use::Phase => {
                            (reading.phase == PhaseUse::Case).then_some(word.text.as_str())
                        }
                        // `horse07`: the letters before a number that is the frame are the case.
                        _ if of_frame => {
                            let letters = word.letters.as_str();
                            let said = letters.is_empty() || word.number.is_none();
                            let known = said || is_frame_word(letters) || is_surface(letters);
                            (!known).then_some(letters)
                        }
                        Use::Surface => None,
                        Use::Case => Some(word.text.as_str()),
                    }
                })
                .collect();
            parts.join("_")
        };
        let number = candidate.map(|c| FrameName::Number(c.number));
        MeshName {
            case: case(false),
            case_with_structure: case(true),
            surface: self.surface,
            frame: self
                .phase
                .filter(|_| reading.phase == PhaseUse::Frame)
                .or(number),
            ventricle: self.structure.is_none() && self.uses.contains(&Use::Surface),
            left: self.left,
            structure: self.structure,
        }
    }

    /// The name with its numbers and phase blanked: equal for names that differ in nothing else.
    pub(super) fn template(&self) -> Vec<String> {
        (self.words.iter().zip(&self.uses).enumerate())
            .filter(|(_, (_, used))| **used != Use::Surface)
            .map(|(place, (word, used))| {
                let numbered = self.numbers.iter().any(|c| c.places.contains(&place));
                match used {
                    Use::Phase => PHASE.to_owned(),
                    _ if numbered && word.number.is_some() => format!("{}#", word.letters),
                    _ => word.text.clone(),
                }
            })
            .collect()
    }
}

/// A number glued to a word leaves the word its meaning only where that is a surface: `RV1` is a patient's name.
fn meanings_of(word: &Word) -> Vec<Meaning> {
    if word.number.is_some() && !is_surface(&word.letters) {
        return Vec::new();
    }
    meanings(&word.letters)
}

/// Which surface a name is of, and which part of the heart if not of the left ventricle.
///
/// What stands beside the word for the surface decides (`RV_x_LV_endo` is a left ventricle's); without any, a word for
/// the right ventricle or an atrium elsewhere does. Names of valves and walls elsewhere may be diagnoses.
fn surface_and_structure(
    meant: &[Vec<Meaning>],
    place: Option<usize>,
    uses: &mut [Use],
) -> (Option<SurfaceKind>, bool, Option<&'static str>) {
    let mut surface = None;
    let mut left = false;
    let mut structure = None;
    if let Some(place) = place {
        uses[place] = Use::Surface;
        let beside = [
            place.checked_sub(1),
            Some(place + 1).filter(|&next| next < meant.len()),
        ];
        for at in std::iter::once(place).chain(beside.into_iter().flatten()) {
            for meaning in &meant[at] {
                match meaning {
                    Meaning::Surface(kind) if at == place => surface = Some(*kind),
                    Meaning::Side(kind) if surface == Some(SurfaceKind::Wall) => {
                        surface = Some(*kind);
                        uses[at] = Use::Surface;
                    }
                    Meaning::Left | Meaning::LeftBesideSurface if structure.is_none() => {
                        left = true;
                    }
                    Meaning::Other(name) | Meaning::OtherBesideSurface(name) if !left => {
                        structure = structure.or(Some(*name));
                        uses[at] = Use::Structure;
                    }
                    _ => {}
                }
            }
        }
    }
    for (at, meanings) in meant.iter().enumerate() {
        let follows = |wanted: &dyn Fn(&Meaning) -> bool| {
            meant
                .get(at + 1)
                .is_some_and(|next| next.iter().any(wanted))
        };
        match meanings.as_slice() {
            // `right_ventricle`, `left atrium`
            [Meaning::OtherBesideSurface(RIGHT)] if follows(&|next| *next == Meaning::Left) => {
                structure = Some(RIGHT);
                left = false;
                uses[at] = Use::Structure;
            }
            [side @ (Meaning::OtherBesideSurface(RIGHT) | Meaning::LeftBesideSurface)]
                if follows(&|next| *next == Meaning::Other(ATRIUM)) =>
            {
                let right = *side != Meaning::LeftBesideSurface;
                structure = Some(if right { "right atrium" } else { "left atrium" });
                left = false;
                uses[at] = Use::Structure;
            }
            [Meaning::LeftBesideSurface] if left || follows(&|next| *next == Meaning::Left) => {
                left = true;
                uses[at] = Use::Surface;
            }
            [Meaning::Left] => {
                left = left || structure.is_none();
                uses[at] = Use::Surface;
            }
            _ => {}
        }
    }
    if left {
        return (surface, true, None);
    }
    for (at, meanings) in meant.iter().enumerate() {
        for meaning in meanings {
            if let Meaning::Other(name) = meaning {
                let chamber = name.contains("ventricle") || name.contains("atri");
                if surface.is_none() || chamber || structure.is_some() {
                    structure = structure.or(Some(*name));
                    uses[at] = Use::Structure;
                }
            }
        }
    }
    (surface, false, structure)
}

/// The last word for a phase; `end_diastole` is one word in two.
fn take_phase(words: &[Word], uses: &mut [Use]) -> Option<FrameName> {
    let place = (0..words.len())
        .rev()
        .find(|&place| uses[place] == Use::Case && phase_of_word(&words[place].text).is_some())?;
    uses[place] = Use::Phase;
    if let Some(before) = place.checked_sub(1)
        && words[before].text.eq_ignore_ascii_case("end")
    {
        uses[before] = Use::Phase;
    }
    phase_of_word(&words[place].text)
}

/// Numbers that may be the frame's, the last first: those behind the surface or a word for "frame", with a unit or
/// decimals; then those that stand alone or, where no surface is named, at the end of the name.
fn candidates(words: &[Word], surface: Option<usize>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let is_total = |place: usize| {
        let of = |before: usize| words[before].text.eq_ignore_ascii_case("of");
        place.checked_sub(1).is_some_and(of)
    };
    let last = (0..words.len())
        .rev()
        .find(|&place| words[place].number.is_some() && !is_total(place));
    for (place, word) in words.iter().enumerate().rev() {
        let Some(mut number) = word.number.filter(|_| !is_total(place)) else {
            continue;
        };
        let mut places = vec![place];
        let next = words.get(place + 1);
        if let Some(with_unit) = next.and_then(|next| next.as_unit_of(number)) {
            number = with_unit;
            places.push(place + 1);
        }
        if next.is_some_and(|next| next.text.eq_ignore_ascii_case("of"))
            && words
                .get(place + 2)
                .is_some_and(|total| total.number.is_some())
        {
            places.extend([place + 1, place + 2]);
        }
        let counted = word.of_total || places.len() > 2;
        let mut worded = is_frame_word(&word.letters);
        // `frame_007`: the word before the number goes with it.
        if word.letters.is_empty()
            && let Some(before) = place.checked_sub(1)
            && is_frame_word(&words[before].text)
        {
            places.push(before);
            worded = true;
        }
        let ends_name =
            surface.is_none() && last == Some(place) && places.contains(&(words.len() - 1));
        let sure = surface.is_some_and(|surface| place > surface)
            || worded
            || counted
            || is_surface(&word.letters)
            || number.unit() != NumberUnit::None;
        if sure || ends_name || word.letters.is_empty() {
            found.push(Candidate {
                number,
                sure,
                worded: worded || counted || number.unit() != NumberUnit::None,
                places,
            });
        }
    }
    found
}

#[cfg(test)]
mod tests;
