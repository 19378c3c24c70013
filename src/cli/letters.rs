//! Says which letters of a study no typeface of this machine has, where they are drawn.

use crate::cli::print::say;
use crate::picture::page::{faces_for, letter_code};
use crate::study::Study;

/// Letters that are named in one line.
const MAX_NAMED: usize = 5;

/// Says on standard error which letters of ids, labels and the study's name are drawn as codes.
pub(super) fn say_missing_letters(study: &Study) {
    let subjects = study.subjects.iter();
    let texts = subjects.flat_map(|subject| [Some(&*subject.id), subject.label.as_deref()]);
    let name = std::iter::once(&*study.name);
    let without = faces_for(name.chain(texts.flatten())).without;
    if let Some(words) = missing_words(&without) {
        say(&format!("cardiomorph: {words}"));
    }
}

fn missing_words(without: &[char]) -> Option<String> {
    let named: Vec<String> = (without.iter().take(MAX_NAMED))
        .map(|letter| {
            let code = letter_code(*letter);
            if letter.is_control() {
                code
            } else {
                format!("{letter} ({code})")
            }
        })
        .collect();
    let more = without.len().saturating_sub(MAX_NAMED);
    let more = if more > 0 {
        format!(" and {more} more")
    } else {
        String::new()
    };
    (!named.is_empty()).then(|| {
        format!(
            "no typeface on this machine has {}{more}: their codes are drawn; a font package for the script adds them",
            named.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_without_a_face_are_named_up_to_five() {
        assert_eq!(missing_words(&[]), None);
        let words = missing_words(&['心', '\u{1b}']).unwrap();
        assert!(words.contains("心 (U+5FC3), U+001B:"), "{words}");
        let words = missing_words(&['a'; 8]).unwrap();
        assert!(words.contains(" and 3 more:"), "{words}");
    }
}
