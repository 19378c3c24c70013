//! How well a few typed letters fit a name.

/// A score for names that hold all letters of `typed` in order, the higher the better; `None` for
/// the others. Letters that follow each other, and letters that begin a word, count more.
pub fn fuzzy_score(name: &str, typed: &str) -> Option<i32> {
    let wanted: Vec<char> = typed
        .chars()
        .filter(|c| !c.is_whitespace())
        .flat_map(char::to_lowercase)
        .collect();
    let mut rest = wanted.iter().peekable();
    let mut score = 0;
    let mut run = 0;
    let mut before = ' ';
    for (index, letter) in name.chars().enumerate() {
        let letter = letter.to_lowercase().next().unwrap_or(letter);
        let Some(next) = rest.peek() else { break };
        if letter == **next {
            let begins_word = !before.is_alphanumeric();
            run += 1;
            score += 1 + 2 * run + if begins_word { 6 } else { 0 };
            if index == 0 {
                score += 4;
            }
            rest.next();
        } else {
            run = 0;
        }
        before = letter;
    }
    // Of two names that fit alike the shorter is meant.
    rest.peek()
        .is_none()
        .then(|| 4 * score - name.chars().count() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_letters_must_occur_in_order() {
        assert!(fuzzy_score("Go to end-systole", "gtes").is_some());
        assert!(fuzzy_score("Go to end-systole", "setg").is_none());
        assert!(fuzzy_score("Anything", "").is_some());
    }

    #[test]
    fn a_word_that_begins_so_comes_before_letters_strewn_about() {
        let names = [
            "Side by side",
            "End-systole from the volume curve",
            "Medial map",
        ];
        let best = names
            .iter()
            .max_by_key(|name| fuzzy_score(name, "sid"))
            .unwrap();
        assert_eq!(*best, "Side by side");
        assert!(fuzzy_score("Undo", "undo") > fuzzy_score("Undo everything so far", "undo"));
    }
}
