//! Why there is no answer: it was stopped, or it failed; the two can never be mistaken for each other.

use std::error::Error;
use std::sync::Arc;

use crate::progress::Stopped;
use crate::study::Study;

/// An error of whichever analysis; its type and its source chain can still be had.
pub type SharedError = Arc<dyn Error + Send + Sync>;

/// Why a computation brought no answer.
#[derive(Clone, Debug)]
pub enum Interrupted {
    /// Nobody wants the answer any more, or the user pressed Cancel. Not an error.
    Stopped,
    /// It went wrong.
    Failed(SharedError),
}

/// Errors of analyses become this by `?`. They wrap a stop as their source, however deep: it is a stop here again.
impl<E: Error + Send + Sync + 'static> From<E> for Interrupted {
    fn from(error: E) -> Self {
        let mut cause: Option<&(dyn Error + 'static)> = Some(&error);
        while let Some(error) = cause {
            if error.is::<Stopped>() {
                return Self::Stopped;
            }
            cause = error.source();
        }
        Self::Failed(Arc::new(error))
    }
}

/// What is asked of the whole cohort waits until it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{unread} of {count} subjects are still to be read")]
pub(super) struct StillUnread {
    unread: usize,
    count: usize,
}

impl StillUnread {
    pub fn of(study: &Study) -> Self {
        let unread = study.unread.len();
        Self {
            unread,
            count: unread + study.subjects.len(),
        }
    }
}

/// What went wrong although no analysis says so; other work goes on.
#[derive(Debug, thiserror::Error)]
pub(super) enum Bug {
    #[error("internal error: {message}")]
    Panicked { message: String },
    /// The question asks, perhaps through others, for its own answer.
    #[error("internal error: “{title}” depends on itself")]
    AsksItself { title: &'static str },
}
