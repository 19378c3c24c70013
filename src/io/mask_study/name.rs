//! What the name of a file says about a mask: whose, which kind, and at which frame.

/// What a mask is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MaskRole {
    /// Labels of several tissues.
    Labels,
    /// Everything within the endocardium.
    Endo,
    /// Everything within the epicardium.
    Epi,
}

/// A name taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct MaskName {
    /// What is left: the subject.
    pub subject: String,
    pub role: MaskRole,
    /// The number of the frame, where the name has one.
    pub frame: Option<u32>,
}

/// Endings of files that may hold masks.
const EXTENSIONS: [&str; 7] = [
    ".nii.gz",
    ".nii",
    ".nrrd",
    ".nhdr",
    ".mha",
    ".mhd",
    ".seg.nrrd",
];
/// Last words of names, with what they say.
const ROLES: [(&str, MaskRole); 10] = [
    ("gt", MaskRole::Labels),
    ("seg", MaskRole::Labels),
    ("mask", MaskRole::Labels),
    ("label", MaskRole::Labels),
    ("labels", MaskRole::Labels),
    ("segmentation", MaskRole::Labels),
    ("endo", MaskRole::Endo),
    ("endocardium", MaskRole::Endo),
    ("epi", MaskRole::Epi),
    ("epicardium", MaskRole::Epi),
];
/// Words before a number that counts frames.
const FRAME_WORDS: [&str; 5] = ["frame", "phase", "gate", "time", "t"];

/// The name without the ending of a format of images; `None` with another ending.
pub(super) fn stem(name: &str) -> Option<&str> {
    let lower = name.to_ascii_lowercase();
    let ending = EXTENSIONS.iter().filter(|ending| lower.ends_with(*ending));
    let longest = ending.max_by_key(|ending| ending.len())?;
    name.get(..name.len() - longest.len())
        .filter(|stem| !stem.is_empty())
}

/// Takes a file's name apart; `None` where it does not say that it is a mask.
pub(super) fn mask_name(name: &str) -> Option<MaskName> {
    let (rest, word) = last_word(stem(name)?)?;
    let word = word.to_ascii_lowercase();
    let (_, role) = ROLES.iter().find(|(known, _)| *known == word)?;
    let numbered = last_word(rest).and_then(|(subject, word)| Some((subject, frame_number(word)?)));
    let (subject, frame) = match numbered {
        Some((subject, number)) => (subject, Some(number)),
        None => (rest, None),
    };
    Some(MaskName {
        subject: subject.to_owned(),
        role: *role,
        frame,
    })
}

/// Whether a file is one of masks by its name.
pub(in crate::io) fn is_mask_name(name: &str) -> bool {
    mask_name(name).is_some()
}

/// What stands before the last `_`, `-` or `.`, and the word after it.
fn last_word(text: &str) -> Option<(&str, &str)> {
    let at = text.rfind(['_', '-', '.'])?;
    let (rest, word) = (text.get(..at)?, text.get(at + 1..)?);
    (!rest.is_empty() && !word.is_empty()).then_some((rest, word))
}

/// `frame01`, `t3`: a word for frames and a number.
fn frame_number(word: &str) -> Option<u32> {
    let lower = word.to_ascii_lowercase();
    let digits = FRAME_WORDS
        .iter()
        .find_map(|known| lower.strip_prefix(known))?;
    digits.parse().ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    fn parts(name: &str) -> Option<(String, MaskRole, Option<u32>)> {
        mask_name(name).map(|found| (found.subject, found.role, found.frame))
    }

    #[test]
    fn names_say_subject_role_and_frame() {
        use MaskRole::{Endo, Epi, Labels};
        for (name, subject, role, frame) in [
            (
                "patient001_frame01_gt.nii.gz",
                "patient001",
                Labels,
                Some(1),
            ),
            (
                "Patient000151_rest_endo.nii.gz",
                "Patient000151_rest",
                Endo,
                None,
            ),
            ("a_t12_EPI.NII", "a", Epi, Some(12)),
            ("A0S9V9_sa_gt.nii.gz", "A0S9V9_sa", Labels, None),
            ("x-seg.nrrd", "x", Labels, None),
            ("case.mask.mha", "case", Labels, None),
        ] {
            assert_eq!(
                parts(name),
                Some((subject.to_owned(), role, frame)),
                "{name}"
            );
        }
    }

    #[test]
    fn names_of_images_are_no_masks() {
        for name in [
            "patient001_frame01.nii.gz",
            "a_image.nii.gz",
            "endo.nii",
            "_gt.nii.gz",
            "a_gt.csv",
            "",
        ] {
            assert_eq!(parts(name), None, "{name}");
        }
    }
}
