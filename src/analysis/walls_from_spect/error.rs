//! Why a gated SPECT image gives no wall.

use crate::image::{BlurError, FrameError, VolumeEditError};
use crate::progress::Stopped;

use super::super::walls_from_masks::MaskError;

/// Why the walls of an image are not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SpectError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}
