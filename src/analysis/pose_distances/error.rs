//! Why there are no distances.

use crate::analysis::transport::TransportError;
use crate::progress::Stopped;

/// Why there are no distances.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PoseDistanceError {
    /// It was asked to stop.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// Motions cannot be carried onto the heart that was chosen.
    #[error(transparent)]
    Transfer(TransportError),
}

impl From<TransportError> for PoseDistanceError {
    fn from(error: TransportError) -> Self {
        match error {
            TransportError::Stopped(stopped) => Self::Stopped(stopped),
            other => Self::Transfer(other),
        }
    }
}
