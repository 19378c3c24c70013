//! Names of files for subjects: whatever an id holds, each subject has a name of its own that every disk takes.

use std::collections::HashSet;

/// Bytes of a name: with an ending it stays below the 143 that encrypted home folders take.
const MAX_BYTES: usize = 100;
/// Bytes of a shortened name before the number that tells it from others.
const SHORT_BYTES: usize = 80;

/// What a name may be followed by: two subjects never share a name with any of these.
const ENDINGS: [&str; 2] = ["", "_patch"];

/// One name per id, in the same order, for files that are called by the name and by the name with `_patch` behind.
///
/// An id that is a good name keeps it. Path separators, control characters, characters that some system refuses and those
/// that nobody sees become dashes; dots and blanks at the ends fall off; names that Windows reserves and empty ones are
/// changed; long ones are shortened. Where that makes two names one, also on a disk that takes no notice of capitals, the
/// later one gets a number.
pub fn file_names<'a>(ids: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let ids: Vec<&str> = ids.into_iter().collect();
    let mut taken = HashSet::new();
    let mut names: Vec<Option<String>> = vec![None; ids.len()];
    // Those that need no change first: no changed name takes theirs.
    for changed in [false, true] {
        for (name, id) in names.iter_mut().zip(&ids) {
            let plain = plain_name(id);
            if name.is_some() || (plain != *id) != changed {
                continue;
            }
            let numbered = (2_usize..).map(|number| format!("{plain}-{number}"));
            let mut candidates = std::iter::once(plain.clone()).chain(numbered);
            *name = candidates.find(|candidate| is_free(&taken, candidate));
            taken.extend(name.iter().flat_map(|name| keys(name)));
        }
    }
    names.into_iter().map(Option::unwrap_or_default).collect()
}

/// One id as a name; without others that it could be taken for.
pub fn file_name(id: &str) -> String {
    plain_name(id)
}

fn is_free(taken: &HashSet<String>, name: &str) -> bool {
    keys(name).all(|key| !taken.contains(&key))
}

/// All that a name takes, as a disk compares names that knows no capitals and no difference between a letter with an accent
/// and the same in two characters.
fn keys(name: &str) -> impl Iterator<Item = String> {
    let folded = composed(name).to_lowercase();
    ENDINGS
        .map(|ending| format!("{folded}{ending}"))
        .into_iter()
}

/// With accents joined to their letters, as keyboards type them.
fn composed(text: &str) -> String {
    use unicode_normalization::UnicodeNormalization;
    text.nfc().collect()
}

fn plain_name(id: &str) -> String {
    let dashed: String = composed(id)
        .chars()
        .map(|letter| if is_plain(letter) { letter } else { '-' })
        .collect();
    let trimmed = dashed.trim_matches(|letter: char| letter == '.' || letter.is_whitespace());
    let mut name = trimmed.to_owned();
    if name.is_empty() {
        name.push_str("subject");
    }
    if is_reserved(&name) {
        name.insert(0, '_');
    }
    if name.len() > MAX_BYTES {
        let end = (0..=SHORT_BYTES).rfind(|&end| name.is_char_boundary(end));
        name.truncate(end.unwrap_or(0));
        name = format!("{}-{:08x}", name.trim_end(), fingerprint(id));
    }
    name
}

/// Whether every system takes it in a name and every reader sees it.
fn is_plain(letter: char) -> bool {
    let unseen = matches!(letter, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
    !letter.is_control() && !unseen && !"/\\:*?\"<>|".contains(letter)
}

/// Names of devices on Windows, whatever stands behind a dot.
fn is_reserved(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim_end();
    let stem = stem.to_uppercase();
    let numbered = ["COM", "LPT"].into_iter().any(|device| {
        let number = stem.strip_prefix(device).unwrap_or_default();
        number.chars().count() == 1
            && number.contains(|c: char| c.is_ascii_digit() || "¹²³".contains(c))
    });
    numbered || ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"].contains(&&*stem)
}

/// FNV-1a of the id, so that the same long id has the same short name in every run.
fn fingerprint(id: &str) -> u32 {
    id.bytes().fold(0x811c_9dc5, |hash: u32, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(ids: &[&str]) -> Vec<String> {
        file_names(ids.iter().copied())
    }

    #[test]
    fn an_id_cannot_lead_out_of_the_folder() {
        let odd = ["../../etc/passwd", "..", "C:\\x", "a/b", "", " . ", "P-041"];
        let expected = [
            "-..-etc-passwd",
            "subject",
            "C--x",
            "a-b",
            "subject-2",
            "subject-3",
            "P-041",
        ];
        assert_eq!(names(&odd), expected);
    }

    #[test]
    fn ids_that_would_make_one_name_have_one_each_and_a_good_id_keeps_its_own() {
        assert_eq!(
            names(&["ward/3", "ward-3", "ward:3"]),
            ["ward-3-2", "ward-3", "ward-3-3"]
        );
        assert_eq!(names(&["a/b", "a-b-2", "a-b"]), ["a-b-3", "a-b-2", "a-b"]);
        assert_eq!(names(&["ED", "ed"]), ["ED", "ed-2"]);
        // One letter, and a letter with an accent behind it.
        assert_eq!(
            names(&["M\u{fc}ller", "Mu\u{308}ller"]),
            ["M\u{fc}ller", "M\u{fc}ller-2"]
        );
        // The patch figure of the first would be the figure of the second.
        assert_eq!(names(&["P1", "P1_patch"]), ["P1", "P1_patch-2"]);
    }

    #[test]
    fn names_that_windows_reserves_or_trims_are_changed() {
        assert_eq!(
            names(&["CON", "nul.x", "COM1", "COMET", "a. "]),
            ["_CON", "_nul.x", "_COM1", "COMET", "a"]
        );
    }

    #[test]
    fn long_ids_are_shortened_and_stay_apart() {
        let [a, b] = ["x", "y"].map(|last| "心".repeat(120) + last);
        let short = names(&[&a, &b, &"x".repeat(300)]);
        assert!(
            short.iter().all(|name| name.len() <= MAX_BYTES),
            "{short:?}"
        );
        assert_ne!(short[0], short[1]);
        assert_eq!(names(&[&a])[0], short[0], "the same in every run");
    }

    #[test]
    fn what_nobody_sees_becomes_a_dash_and_other_scripts_stay() {
        assert_eq!(
            names(&["a\u{202e}b\nc\u{1b}d", "心脏", "שלום", "❤"]),
            ["a-b-c-d", "心脏", "שלום", "❤"]
        );
    }
}
