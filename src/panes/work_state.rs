//! How the answer that a pane shows stands: one set of states for every pane with work of its own.

use crate::engine::{Interrupted, Showing};

/// How the answer that a pane shows stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WorkState {
    /// There is nothing to compute it for.
    #[default]
    Empty,
    /// It starts after the work that is on screen.
    Waiting,
    /// It is being computed; what is shown, if anything, is that of the settings before.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// What is being done now; may be empty.
        phase: String,
        /// Estimated seconds left, once they are known.
        seconds_left: Option<f64>,
    },
    /// The user stopped it.
    Stopped,
    /// It could not be computed, and why.
    Failed(String),
    /// There is none for this study or subject, and why; trying again would change nothing.
    Unanswerable(String),
    /// What is shown is that of the settings.
    Ready,
}

impl WorkState {
    /// How an answer stands; what is not asked for yet is about to be computed.
    pub fn of<T>(showing: Option<&Showing<T>>) -> Self {
        match showing {
            None => Self::computing(0.0),
            Some(Showing::Ready(_)) => Self::Ready,
            Some(Showing::Computing { watch, .. }) => Self::Computing {
                fraction: watch.fraction(),
                phase: watch.phase().to_owned(),
                seconds_left: watch.time_left().map(|left| left.as_secs_f64()),
            },
            Some(Showing::Interrupted { why, .. }) => match why {
                Interrupted::Stopped => Self::Stopped,
                Interrupted::Failed(error) => Self::Failed(error.to_string()),
            },
        }
    }

    /// So far, with nothing said of phase and time.
    pub fn computing(fraction: f32) -> Self {
        Self::Computing {
            fraction,
            phase: String::new(),
            seconds_left: None,
        }
    }
}
