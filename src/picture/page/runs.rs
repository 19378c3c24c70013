//! Cuts text into pieces of one typeface each.

use unicode_normalization::char::is_combining_mark;

use crate::picture::page::faces::FurtherFace;

/// Pieces of a text, each with its face; `None` is the one that `own` knows.
///
/// A mark stays with its letter, in a face that has both. What stands between two words of a script that runs from right to
/// left stays with them, so that they keep their order.
pub(super) fn split(
    text: &str,
    own: impl Fn(char) -> bool,
    further: impl Fn(char) -> Option<FurtherFace>,
) -> Vec<(Option<FurtherFace>, String)> {
    let mut letters: Vec<(char, Option<FurtherFace>)> = Vec::new();
    for letter in text.chars().filter(|letter| !is_selector(*letter)) {
        let before = letters.last().copied();
        let mut face = if own(letter) { None } else { further(letter) };
        if let Some((base, base_face)) = before.filter(|_| is_combining_mark(letter)) {
            match (base_face, face) {
                (Some(same), _) if same.has(letter) => face = base_face,
                (_, Some(other)) if other.has(base) => {
                    if let Some(last) = letters.last_mut() {
                        last.1 = face;
                    }
                }
                _ => {}
            }
        }
        letters.push((letter, face));
    }
    keep_right_to_left_together(&mut letters);
    let mut pieces: Vec<(Option<FurtherFace>, String)> = Vec::new();
    for (letter, face) in letters {
        match pieces.last_mut() {
            Some((same, words)) if *same == face => words.push(letter),
            _ => pieces.push((face, letter.to_string())),
        }
    }
    pieces
}

fn keep_right_to_left_together(letters: &mut [(char, Option<FurtherFace>)]) {
    let mut from = None;
    for here in 0..letters.len() {
        let (letter, face) = letters[here];
        if runs_to_the_left(letter) {
            let gap = from.map(|from: usize| from + 1..here);
            if let Some((gap, face)) = gap.zip(face)
                && letters[gap.clone()]
                    .iter()
                    .all(|(between, _)| face.has(*between))
            {
                letters[gap]
                    .iter_mut()
                    .for_each(|between| between.1 = Some(face));
            }
            from = face.map(|_| here);
        } else if letter.is_alphanumeric() {
            from = None;
        }
    }
}

/// Says how the letter before it looks; every letter here looks one way.
fn is_selector(letter: char) -> bool {
    matches!(letter, '\u{fe0e}' | '\u{fe0f}')
}

/// Letters of scripts that are written from right to left.
fn runs_to_the_left(letter: char) -> bool {
    matches!(letter, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{fefc}' | '\u{10800}'..='\u{10fff}' | '\u{1e800}'..='\u{1efff}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::faces::further_face;

    fn pieces(text: &str) -> Vec<(bool, String)> {
        let pieces = split(text, |letter| letter.is_ascii(), further_face);
        (pieces.into_iter())
            .map(|(face, words)| (face.is_none(), words))
            .collect()
    }

    #[test]
    fn each_piece_has_one_face() {
        let expected = [
            (true, "a ".to_owned()),
            (false, "Жя".to_owned()),
            (true, " b".to_owned()),
        ];
        assert_eq!(pieces("a Жя b"), expected);
        assert_eq!(pieces(""), []);
    }

    #[test]
    fn what_says_how_a_letter_looks_is_not_drawn() {
        assert_eq!(pieces("Ж\u{fe0f}"), [(false, "Ж".to_owned())]);
    }

    #[test]
    fn words_that_run_to_the_left_keep_their_order() {
        let face = further_face('ש').unwrap();
        if face.coded {
            return;
        }
        assert_eq!(pieces("יוסי כהן"), [(false, "יוסי כהן".to_owned())]);
        assert_eq!(pieces("יוסי a").len(), 2);
    }
}
