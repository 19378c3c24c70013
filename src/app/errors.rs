//! Cards that say what went wrong, one for each thing, until they are dismissed.

use crate::io::OpenError;

/// One thing that went wrong; the rest goes on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ErrorCard {
    /// Stays the same while the card is shown.
    pub number: usize,
    /// What could not be done.
    pub title: String,
    /// Line or byte, reason, and what to do.
    pub detail: String,
    /// The work that failed, if it can be tried again.
    pub retry: Option<crate::ui::JobKind>,
}

/// Cards beyond this many are summed up in one: a folder of a thousand bad files is one mistake.
const MOST_CARDS: usize = 20;

/// Adds a card.
pub fn push_card(
    cards: &mut Vec<ErrorCard>,
    title: impl Into<String>,
    detail: impl Into<String>,
    retry: Option<crate::ui::JobKind>,
) {
    let number = cards.last().map_or(0, |card| card.number + 1);
    cards.push(ErrorCard {
        number,
        title: title.into(),
        detail: detail.into(),
        retry,
    });
}

/// Adds a card for each path that could not be opened.
pub fn push_open_errors(cards: &mut Vec<ErrorCard>, errors: &[OpenError]) {
    let shown = errors.len().min(MOST_CARDS);
    for error in &errors[..shown] {
        let file = error.path.file_name().map_or_else(
            || error.path.display().to_string(),
            |name| name.to_string_lossy().into_owned(),
        );
        let title = match &error.subject {
            Some(subject) => format!("{subject}: {file} could not be opened"),
            None => format!("{file} could not be opened"),
        };
        push_card(cards, title, error.reason.clone(), None);
    }
    if errors.len() > shown {
        let rest = errors.len() - shown;
        push_card(
            cards,
            format!("{rest} more files could not be opened"),
            "The load report lists them",
            None,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    fn open_error(name: &str) -> OpenError {
        OpenError {
            subject: None,
            path: PathBuf::from(format!("/study/{name}")),
            reason: "line 12: face refers to vertex 9, but only 4 are defined".to_owned(),
        }
    }

    #[test]
    fn a_card_names_the_file_and_the_reason() {
        let mut cards = Vec::new();
        push_open_errors(&mut cards, &[open_error("a.obj")]);
        assert_eq!(cards[0].title, "a.obj could not be opened");
        assert!(cards[0].detail.starts_with("line 12"));
    }

    #[test]
    fn many_errors_end_in_a_sum() {
        let errors: Vec<_> = (0..1000).map(|i| open_error(&format!("{i}.obj"))).collect();
        let mut cards = Vec::new();
        push_open_errors(&mut cards, &errors);
        assert_eq!(cards.len(), MOST_CARDS + 1);
        assert!(cards[MOST_CARDS].title.starts_with("980 more"));
        let numbers: Vec<_> = cards.iter().map(|card| card.number).collect();
        assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
