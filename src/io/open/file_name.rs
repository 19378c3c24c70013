//! What a mesh file's name says: `{case}_{surface}_{frame}.ext` and the habits around it.

use crate::study::SurfaceKind;

/// When within the beat a file is, in the order of a beat.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum FrameName {
    /// `ED`.
    EndDiastole,
    /// `ES`.
    EndSystole,
    /// `7`, `g7`, `frame_007`.
    Number(u64),
}

/// The parts of a file's name, without its ending.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct MeshName {
    /// What is left beside the other parts; empty if nothing is.
    pub(super) case: String,
    /// Which sheet, if a word says so.
    pub(super) surface: Option<SurfaceKind>,
    /// Which frame, if there is a number or a word.
    pub(super) frame: Option<FrameName>,
    /// Whether a word says that this is a left ventricle.
    pub(super) ventricle: bool,
}

/// The sheet that a word means.
pub(super) fn surface_of_word(word: &str) -> Option<SurfaceKind> {
    let word = word.to_ascii_lowercase();
    let word = word
        .strip_prefix("lv")
        .filter(|rest| !rest.is_empty())
        .unwrap_or(&word);
    Some(match word {
        "endo" | "endocard" | "endocardium" | "endocardial" => SurfaceKind::Endocardium,
        "epi" | "epicard" | "epicardium" | "epicardial" => SurfaceKind::Epicardium,
        "wall" | "myo" | "myocard" | "myocardium" | "myocardial" => SurfaceKind::Wall,
        "cavity" | "blood" | "bloodpool" | "pool" | "bp" => SurfaceKind::Cavity,
        _ => return None,
    })
}

/// Reads the parts of a name, such as `lv_endo_003` or `subj0062_ED_endo`.
pub(super) fn mesh_name(stem: &str) -> MeshName {
    let words: Vec<&str> = stem
        .split(['_', '-', ' ', '.'])
        .filter(|word| !word.is_empty())
        .collect();
    let mut used = vec![false; words.len()];
    let surface = take_surface(&words, &mut used);
    let frame = take_frame(&words, &mut used, surface.map(|(place, _)| place));
    let mut ventricle = surface.is_some();
    for (word, used) in words.iter().zip(&mut used) {
        if is_ventricle(word) {
            ventricle = true;
            *used = true;
        }
    }
    let mut case: Vec<&str> = words
        .iter()
        .zip(&used)
        .filter(|(_, used)| !**used)
        .map(|(word, _)| *word)
        .collect();
    // `horse07`: the letters before a number that is the frame are the case.
    let (glued, frame) = match frame {
        Some((rest, frame)) => (rest, Some(frame)),
        None => ("", None),
    };
    if !is_frame_word(glued) && surface_of_word(glued).is_none() && !glued.is_empty() {
        case.push(glued);
    }
    let surface = surface
        .map(|(_, kind)| kind)
        .or_else(|| surface_of_word(glued));
    MeshName {
        case: case.join("_"),
        surface,
        frame,
        ventricle: ventricle || surface.is_some() || is_ventricle(glued),
    }
}

fn take_surface(words: &[&str], used: &mut [bool]) -> Option<(usize, SurfaceKind)> {
    let found = words
        .iter()
        .enumerate()
        .rev()
        .find_map(|(place, word)| Some((place, surface_of_word(word)?)))?;
    used[found.0] = true;
    Some(found)
}

/// The frame with the letters that were glued to its number.
///
/// A word for a phase wins; then the last word that ends in a number, if it stands last or after the surface;
/// then the last word that is but a number, or a number behind a word for "frame".
fn take_frame<'w>(
    words: &[&'w str],
    used: &mut [bool],
    surface: Option<usize>,
) -> Option<(&'w str, FrameName)> {
    for (place, word) in words.iter().enumerate().rev() {
        if let Some(phase) = phase_of_word(word) {
            used[place] = true;
            return Some(("", phase));
        }
    }
    let numbered = |place: usize| -> Option<(&'w str, u64)> {
        let word = words[place];
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        Some((letters, word[letters.len()..].parse().ok()?))
    };
    let last = words.len().checked_sub(1)?;
    let place = (0..words.len()).rev().find(|&place| {
        numbered(place).is_some_and(|(letters, _)| {
            let after_surface = surface.is_some_and(|surface| place > surface);
            let last_without_surface = surface.is_none() && place == last;
            after_surface
                || last_without_surface
                || is_frame_word(letters)
                || surface_of_word(letters).is_some()
        })
    })?;
    let (letters, number) = numbered(place)?;
    used[place] = true;
    // `frame_007`: the word before the number goes with it.
    if letters.is_empty()
        && let Some(before) = place.checked_sub(1)
        && !words[before].is_empty()
        && is_frame_word(words[before])
    {
        used[before] = true;
    }
    Some((letters, FrameName::Number(number)))
}

fn phase_of_word(word: &str) -> Option<FrameName> {
    match word.to_ascii_lowercase().as_str() {
        "ed" | "enddiastole" | "enddiastolic" | "diastole" => Some(FrameName::EndDiastole),
        "es" | "endsystole" | "endsystolic" | "systole" => Some(FrameName::EndSystole),
        _ => None,
    }
}

/// Words that stand before a frame's number; nothing at all is one.
fn is_frame_word(word: &str) -> bool {
    matches!(
        word.to_ascii_lowercase().as_str(),
        "" | "g"
            | "t"
            | "f"
            | "fr"
            | "frame"
            | "phase"
            | "ph"
            | "gate"
            | "time"
            | "timestep"
            | "step"
            | "pose"
    )
}

fn is_ventricle(word: &str) -> bool {
    matches!(
        word.to_ascii_lowercase().as_str(),
        "lv" | "ventricle" | "leftventricle"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use FrameName::{EndDiastole, EndSystole, Number};
    use SurfaceKind::{Cavity, Endocardium, Epicardium, Wall};

    fn parts(stem: &str) -> (String, Option<SurfaceKind>, Option<FrameName>) {
        let name = mesh_name(stem);
        (name.case, name.surface, name.frame)
    }

    #[test]
    fn every_naming_scheme_is_understood() {
        for (stem, case, surface, frame) in [
            ("endo_g1", "", Some(Endocardium), Some(Number(1))),
            ("epi_10", "", Some(Epicardium), Some(Number(10))),
            ("lv_endo_007", "", Some(Endocardium), Some(Number(7))),
            ("N01_wall_3", "N01", Some(Wall), Some(Number(3))),
            (
                "p_12_cavity_frame-04",
                "p_12",
                Some(Cavity),
                Some(Number(4)),
            ),
            (
                "subj0062_ED_endo",
                "subj0062",
                Some(Endocardium),
                Some(EndDiastole),
            ),
            (
                "subj0062_ES_epi",
                "subj0062",
                Some(Epicardium),
                Some(EndSystole),
            ),
            ("p01_endo", "p01", Some(Endocardium), None),
            ("frame_03_epi", "", Some(Epicardium), Some(Number(3))),
            (
                "phantom_03_epi",
                "phantom",
                Some(Epicardium),
                Some(Number(3)),
            ),
            ("endo12", "", Some(Endocardium), Some(Number(12))),
            ("LVEndo_5", "", Some(Endocardium), Some(Number(5))),
            ("horse_04", "horse", None, Some(Number(4))),
            ("horse04", "horse", None, Some(Number(4))),
            ("0007", "", None, Some(Number(7))),
            ("LV_ED_mean", "mean", None, Some(EndDiastole)),
            ("torso", "torso", None, None),
        ] {
            assert_eq!(parts(stem), (case.to_owned(), surface, frame), "{stem}");
        }
    }

    #[test]
    fn a_word_for_the_ventricle_is_noticed() {
        assert!(mesh_name("LV_ED_mean").ventricle);
        assert!(mesh_name("endo_3").ventricle);
        assert!(!mesh_name("horse_04").ventricle);
    }

    #[test]
    fn end_diastole_comes_first() {
        assert!(EndDiastole < EndSystole && Number(2) < Number(10));
    }

    #[test]
    fn odd_names_are_no_trouble() {
        for (stem, case, surface, frame) in [
            ("", "", None, None),
            ("_", "", None, None),
            ("___", "", None, None),
            ("é_endo", "é", Some(Endocardium), None),
            // More digits than a frame number has: a name like any other.
            (
                "99999999999999999999999",
                "99999999999999999999999",
                None,
                None,
            ),
            ("-1", "", None, Some(Number(1))),
        ] {
            assert_eq!(parts(stem), (case.to_owned(), surface, frame), "{stem}");
        }
    }
}
