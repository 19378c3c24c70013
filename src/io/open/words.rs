//! Words of file and folder names: surfaces of the left ventricle, other parts of the heart, phases and frames.

use super::frame_name::FrameName;
use crate::study::SurfaceKind;

/// What a word of a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// A surface of a ventricle.
    Surface(SurfaceKind),
    /// The left ventricle.
    Left,
    /// A part of the heart that is not the left ventricle; its name in a sentence.
    Other(&'static str),
    /// As [`Self::Other`], but only beside the word for a surface: two letters are often initials.
    OtherBesideSurface(&'static str),
    /// `left`: the left ventricle if the word for a surface or `ventricle` stands beside it.
    LeftBesideSurface,
    /// The inner or outer side, if the word for a wall follows.
    Side(SurfaceKind),
}

/// The right ventricle, in a sentence.
pub(super) const RIGHT: &str = "right ventricle";
/// An atrium, left or right, in a sentence.
pub(super) const ATRIUM: &str = "atrium";
const BOTH: &str = "both ventricles";

/// Whole words, in small letters.
fn meaning_of_entry(word: &str) -> Option<Meaning> {
    use Meaning::{Left, LeftBesideSurface, Other, OtherBesideSurface, Side, Surface};
    Some(match word {
        "endo" | "endocard" | "endocardium" | "endocardial" => Surface(SurfaceKind::Endocardium),
        "epi" | "epicard" | "epicardium" | "epicardial" => Surface(SurfaceKind::Epicardium),
        "wall" | "myo" | "myocard" | "myocardium" | "myocardial" => Surface(SurfaceKind::Wall),
        "cavity" | "blood" | "bloodpool" | "pool" | "bp" => Surface(SurfaceKind::Cavity),
        "lv" | "ventricle" | "ventricular" | "leftventricle" | "leftventricular" => Left,
        "left" => LeftBesideSurface,
        "rv" | "rightventricle" | "rightventricular" | "rvot" | "rvfw" => Other(RIGHT),
        "right" => OtherBesideSurface(RIGHT),
        "biventricular" | "biventricle" => Other(BOTH),
        "biv" | "bv" => OtherBesideSurface(BOTH),
        "leftatrium" | "leftatrial" => Other("left atrium"),
        "rightatrium" | "rightatrial" => Other("right atrium"),
        "atrium" | "atria" | "atrial" => Other(ATRIUM),
        "la" => OtherBesideSurface("left atrium"),
        "ra" => OtherBesideSurface("right atrium"),
        "mitral" => Other("mitral valve"),
        "aortic" => Other("aortic valve"),
        "tricuspid" => Other("tricuspid valve"),
        "pulmonary" | "pulmonic" => Other("pulmonary valve"),
        "valve" | "valves" => Other("valve"),
        "aorta" => Other("aorta"),
        "septum" => Other("septum"),
        "freewall" => Other("free wall"),
        "pericardium" | "pericardial" => Other("pericardium"),
        "papillary" | "papillaries" => Other("papillary muscles"),
        "thrombus" => Other("thrombus"),
        "scar" => Other("scar"),
        "thru" | "through" => OtherBesideSurface("surface through the wall"),
        "mid" => OtherBesideSurface("middle of the wall"),
        "midwall" | "midmyocardium" | "midmyocardial" => Other("middle of the wall"),
        "free" => OtherBesideSurface("free wall"),
        "inner" => Side(SurfaceKind::Endocardium),
        "outer" => Side(SurfaceKind::Epicardium),
        _ => return None,
    })
}

/// Beginnings of words that are written as one: `lvendo`, `RVFreeWall`, `leftEndo`.
const PREFIXES: [&str; 12] = [
    "leftventricular",
    "rightventricular",
    "leftventricle",
    "rightventricle",
    "right",
    "left",
    "biv",
    "lv",
    "rv",
    "bv",
    "la",
    "ra",
];

/// What a word means, with all its parts where several are written as one.
pub(super) fn meanings(word: &str) -> Vec<Meaning> {
    let lower = word.to_lowercase();
    if let Some(meaning) = meaning_of_entry(&lower) {
        return vec![meaning];
    }
    for prefix in PREFIXES {
        if let Some(rest) = lower.strip_prefix(prefix)
            && !rest.is_empty()
            && let (Some(side), Some(part)) = (meaning_of_entry(prefix), meaning_of_entry(rest))
            && matches!(part, Meaning::Surface(_) | Meaning::Other(_))
        {
            return vec![side, part];
        }
    }
    match lower.strip_suffix("valve").and_then(meaning_of_entry) {
        Some(valve @ Meaning::Other(_)) => vec![valve],
        _ => Vec::new(),
    }
}

/// The surface that a word means, if it is one of the left ventricle.
pub(super) fn surface_of_word(word: &str) -> Option<SurfaceKind> {
    match meanings(word).as_slice() {
        [Meaning::Surface(kind)] => Some(*kind),
        [
            Meaning::Left | Meaning::LeftBesideSurface,
            Meaning::Surface(kind),
        ] => Some(*kind),
        _ => None,
    }
}

/// The part of the heart beside the left ventricle that a word alone means, as the name of a folder.
pub(super) fn structure_of_word(word: &str) -> Option<&'static str> {
    meanings(word)
        .into_iter()
        .find_map(|meaning| match meaning {
            Meaning::Other(name) | Meaning::OtherBesideSurface(name) => Some(name),
            _ => None,
        })
}

/// The phase that a word means.
pub(super) fn phase_of_word(word: &str) -> Option<FrameName> {
    match word.to_lowercase().as_str() {
        "ed" | "enddiastole" | "enddiastolic" | "diastole" | "diastolic" | "diast" | "dias"
        | "dia" => Some(FrameName::EndDiastole),
        "es" | "endsystole" | "endsystolic" | "systole" | "systolic" | "syst" | "sys" => {
            Some(FrameName::EndSystole)
        }
        _ => None,
    }
}

/// Words that stand before a frame's number; nothing at all is none.
pub(super) fn is_frame_word(word: &str) -> bool {
    matches!(
        word.to_lowercase().as_str(),
        "g" | "t"
            | "f"
            | "fr"
            | "frame"
            | "phase"
            | "ph"
            | "gate"
            | "time"
            | "timestep"
            | "ts"
            | "step"
            | "pose"
            | "rr"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_those_of_the_left_ventricle() {
        for word in ["endo", "LVEndo", "lvendo", "LVENDOCARDIAL", "leftEndo"] {
            assert_eq!(
                surface_of_word(word),
                Some(SurfaceKind::Endocardium),
                "{word}"
            );
        }
        for word in [
            "rvendo",
            "RVEndo",
            "RVENDO",
            "rightendo",
            "BVEpi",
            "laWall",
            "Endora",
            "epic",
        ] {
            assert_eq!(surface_of_word(word), None, "{word}");
        }
    }

    #[test]
    fn other_parts_of_the_heart_have_names() {
        for (word, name) in [
            ("RV", "right ventricle"),
            ("RVEndo", "right ventricle"),
            ("rightventricle", "right ventricle"),
            ("MitralValve", "mitral valve"),
            ("LA", "left atrium"),
        ] {
            assert_eq!(structure_of_word(word), Some(name), "{word}");
        }
        for word in ["LV", "endo", "EDWARD", "Riva", "Lara", "rvx"] {
            assert_eq!(structure_of_word(word), None, "{word}");
        }
    }
}
