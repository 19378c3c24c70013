//! How a command ends: the exit codes that scripts rely on.

use std::process::ExitCode;

use crate::progress::Stopped;

/// Why a command did not do what it was asked to.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CliError {
    /// The input cannot be used, or the output not be written.
    #[error("{0}")]
    Unusable(String),
    /// The command was called wrongly.
    #[error("{0}")]
    Usage(String),
    /// Ctrl-C.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// Whoever read standard output went away: nothing is wrong.
    #[error("standard output was closed")]
    OutputClosed,
}

impl CliError {
    /// An error of any kind that makes the input unusable.
    pub(super) fn unusable(error: impl std::fmt::Display) -> Self {
        Self::Unusable(error.to_string())
    }

    /// 0 done, 1 the input is unusable, 2 wrong usage, 3 stopped.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::OutputClosed => 0,
            Self::Unusable(_) => 1,
            Self::Usage(_) => 2,
            Self::Stopped(_) => 3,
        })
    }
}
