//! Why there are no distances.

use crate::analysis::transport::TransportError;
use crate::progress::Stopped;

/// Why there are no distances.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PoseDistanceError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// Motions cannot be transported onto the subject that was chosen.
    #[error(transparent)]
    Transport(TransportError),
}

impl From<TransportError> for PoseDistanceError {
    fn from(error: TransportError) -> Self {
        match error {
            TransportError::Stopped(stopped) => Self::Stopped(stopped),
            other => Self::Transport(other),
        }
    }
}
