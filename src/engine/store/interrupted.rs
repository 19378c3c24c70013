//! Why there is no answer: it was stopped, or it failed; the two can never be mistaken for each other.

use std::error::Error;
use std::sync::Arc;

use crate::progress::Stopped;

/// An error of whichever analysis, with its source chain.
pub type SharedError = Arc<dyn Error + Send + Sync>;

/// Why a computation brought no answer. `E` says what went wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Interrupted<E> {
    /// Nobody wants the answer any more, or the user pressed Cancel. Not an error.
    Stopped,
    /// It went wrong.
    Failed(E),
}

impl<E> Interrupted<E> {
    /// The same with another error: what an analysis says of a question that it asked.
    pub fn map<F>(self, error: impl FnOnce(E) -> F) -> Interrupted<F> {
        match self {
            Self::Stopped => Interrupted::Stopped,
            Self::Failed(failure) => Interrupted::Failed(error(failure)),
        }
    }
}

impl<E> From<Stopped> for Interrupted<E> {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}

/// What went wrong with a question: its analysis says so, or the program has a bug.
#[derive(Debug, thiserror::Error)]
pub enum Failure<E: Error + 'static> {
    /// The analysis has no answer.
    #[error(transparent)]
    Analysis(Arc<E>),
    /// A bug of the program; other work goes on.
    #[error("internal error: {message}")]
    Panicked {
        /// What the panic said.
        message: String,
    },
    /// A bug of the program: the question asks, perhaps through others, for its own answer.
    #[error("internal error: “{title}” depends on itself")]
    AsksItself {
        /// The question.
        title: &'static str,
    },
}

// Written by hand, because `derive` would ask for `E: Clone`.
impl<E: Error + 'static> Clone for Failure<E> {
    fn clone(&self) -> Self {
        match self {
            Self::Analysis(error) => Self::Analysis(Arc::clone(error)),
            Self::Panicked { message } => Self::Panicked {
                message: message.clone(),
            },
            Self::AsksItself { title } => Self::AsksItself { title },
        }
    }
}

impl<E: Error + Send + Sync + 'static> Failure<E> {
    /// The error for a reader that takes those of all analyses: its type and sources can still be had.
    pub fn erased(self) -> SharedError {
        match self {
            Self::Analysis(error) => error,
            bug => Arc::new(bug),
        }
    }
}
