//! Error cards, shown until they are dismissed.

use crate::document::ErrorCard;
use crate::engine::{FailedWork, Interrupted, Topic};
use crate::io::OpenError;
use crate::progress::Stopped;

/// Files that could not be opened have a card each up to this many; more are one card:
/// a folder of a thousand bad files is one mistake.
const MAX_CARDS: usize = 3;

/// Adds a card with a title and a reason.
pub fn push_card(cards: &mut Vec<ErrorCard>, title: impl Into<String>, message: impl Into<String>) {
    let card = ErrorCard {
        title: title.into(),
        message: message.into(),
        ..ErrorCard::default()
    };
    push(cards, card);
}

/// Why an export has no answer to write.
pub fn interruption(why: Interrupted) -> String {
    match why {
        Interrupted::Stopped => Stopped.to_string(),
        Interrupted::Failed(error) => error.to_string(),
    }
}

/// Adds a card, unless the same one is still shown.
fn push(cards: &mut Vec<ErrorCard>, card: ErrorCard) {
    if !cards.contains(&card) {
        cards.push(card);
    }
}

/// Adds a card for work that failed; its details list the causes.
pub fn push_failure(cards: &mut Vec<ErrorCard>, failure: &FailedWork) {
    let mut causes = Vec::new();
    let mut source = failure.error.source();
    while let Some(cause) = source {
        causes.push(format!("caused by: {cause}"));
        source = cause.source();
    }
    let card = ErrorCard {
        title: failure.title.to_owned(),
        message: failure.error.to_string(),
        details: causes.join("\n"),
        // An export asks for its place again.
        retry: (failure.topic != Topic::EXPORT).then_some(failure.topic),
    };
    push(cards, card);
}

/// Adds cards for the paths that could not be opened.
pub fn push_open_errors(cards: &mut Vec<ErrorCard>, errors: &[OpenError]) {
    if errors.len() <= MAX_CARDS {
        for error in errors {
            let subject = error.subject.iter().map(|subject| format!("{subject}: "));
            let subject: String = subject.collect();
            let card = ErrorCard {
                title: format!("{subject}{} could not be opened", file_name(error)),
                message: error.reason.clone(),
                details: error.path.display().to_string(),
                retry: None,
            };
            push(cards, card);
        }
        return;
    }
    let lines: Vec<String> = errors.iter().map(ToString::to_string).collect();
    cards.push(ErrorCard {
        title: format!("{} files could not be opened", errors.len()),
        message: format!("{}: {}", file_name(&errors[0]), errors[0].reason),
        details: lines.join("\n"),
        retry: None,
    });
}

/// The name of what could not be opened.
pub fn file_name(error: &OpenError) -> String {
    error.path.file_name().map_or_else(
        || error.path.display().to_string(),
        |name| name.to_string_lossy().into_owned(),
    )
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
        assert!(cards[0].message.starts_with("line 12"));
        push_open_errors(&mut cards, &[open_error("a.obj")]);
        assert_eq!(cards.len(), 1, "the same card is shown once");
    }

    #[test]
    fn a_failure_lists_its_causes_and_can_be_retried() {
        let number = u8::try_from(300).unwrap_err();
        let failure = FailedWork {
            topic: Topic::OPENING,
            title: "Opening failed",
            error: std::sync::Arc::new(Wrapped(number)),
        };
        let mut cards = Vec::new();
        push_failure(&mut cards, &failure);
        push_failure(&mut cards, &failure);
        assert_eq!(cards.len(), 1, "the same card is shown once");
        assert_eq!(cards[0].message, "no number");
        assert!(cards[0].details.starts_with("caused by: out of range"));
        assert_eq!(cards[0].retry, Some(Topic::OPENING));
        let export = FailedWork {
            topic: Topic::EXPORT,
            ..failure
        };
        push_failure(&mut cards, &export);
        assert_eq!(cards[1].retry, None, "an export asks for its place again");
    }

    #[derive(Debug, thiserror::Error)]
    #[error("no number")]
    struct Wrapped(#[source] std::num::TryFromIntError);

    #[test]
    fn many_errors_are_one_card_that_lists_them() {
        let errors: Vec<_> = (0..1000).map(|i| open_error(&format!("{i}.obj"))).collect();
        let mut cards = Vec::new();
        push_open_errors(&mut cards, &errors);
        assert_eq!(cards.len(), 1);
        assert!(cards[0].title.starts_with("1000 files"));
        assert_eq!(cards[0].details.lines().count(), 1000);
    }
}
