//! One line of the load report.

/// How much a note matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Something was assumed or found, and nothing is wrong with it.
    Info,
    /// Results can be affected.
    Warning,
}

/// Something found or assumed while a subject was read; nothing is reshaped without one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// How much it matters.
    pub severity: Severity,
    /// A sentence: which surface and frames, what, and how many.
    pub text: String,
}

impl Notice {
    /// A note.
    pub fn info(text: impl Into<String>) -> Self {
        Self {
            severity: Severity::Info,
            text: text.into(),
        }
    }

    /// A finding that can affect results.
    pub fn warning(text: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            text: text.into(),
        }
    }
}
