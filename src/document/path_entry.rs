//! A path that is typed where the system shows no file dialog.

/// What the sheet for a typed path shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PathEntry {
    /// What the path is for.
    pub title: String,
    /// What the button says: "Open", "Save".
    pub verb: &'static str,
    /// What the program put into the field: a proposal, or a completed path.
    pub text: String,
    /// Counts what the program put in, so that the same text can be put in twice.
    pub revision: u64,
    /// Names that go on as what was typed does.
    pub choices: Vec<String>,
    /// Why what was typed last was not taken.
    pub refused: Option<String>,
    /// The text at whose place something lies that would be replaced, and what that is.
    pub replaces: Option<(String, String)>,
}
