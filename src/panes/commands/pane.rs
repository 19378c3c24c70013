//! The name of a pane, as commands and saved layouts know it.

/// A pane of the window, known by the word that saved layouts have for it; the word never changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pane(&'static str);

impl Pane {
    /// The pane of this word. Each pane's folder names its own.
    pub const fn named(word: &'static str) -> Self {
        Self(word)
    }

    /// The word.
    pub fn word(self) -> &'static str {
        self.0
    }
}
