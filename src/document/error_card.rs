//! What went wrong, as a card says it.

use crate::engine::Topic;

/// One thing that went wrong.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorCard {
    /// What could not be done: "2 files could not be read".
    pub title: String,
    /// Why, in one sentence with file, line or byte.
    pub message: String,
    /// The whole story, one line each; folded until asked for.
    pub details: String,
    /// Work that can be tried again.
    pub retry: Option<Topic>,
}
