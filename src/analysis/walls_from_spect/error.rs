//! Why a gated SPECT image gives no wall.

use crate::image::{BlurError, FrameError, ImageError, ResampleError, VolumeEditError};
use crate::progress::Stopped;

use super::find::WALL_MM;
use crate::analysis::walls_from_masks::MaskError;

/// Why the walls of an image are not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SpectError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The image is too large for what is done with it.
    #[error(
        "{voxels} voxels at {instants} instants are more than the limit of {limit}; crop the image"
    )]
    TooLarge {
        /// Voxels of a volume.
        voxels: usize,
        /// Instants.
        instants: usize,
        /// Voxels in all that are possible.
        limit: usize,
    },
    /// There are no counts to follow.
    #[error("the image has the same counts everywhere, or none")]
    NoCounts,
    /// No place is enclosed by a wall.
    #[error(
        "no left ventricle is found: nowhere do counts rise to a wall in most directions {} to {} mm away (at best {score:.2}, at \
         least {needed:.2} is needed); mark apex and base, take away what is beside the heart, or check the spacing of the voxels",
        WALL_MM[0],
        WALL_MM[1]
    )]
    NoVentricle {
        /// How well the best place is enclosed, 0 to 1.
        score: f64,
        /// What it takes.
        needed: f64,
    },
    /// Marked points say no axis.
    #[error(
        "apex and base are marked in one place, or not with finite numbers: there is no long axis"
    )]
    NoAxis,
    /// Around the axis there is no wall.
    #[error(
        "around the long axis no wall is found at instant {instant}; are apex and base marked on the left ventricle?"
    )]
    NoWall {
        /// Which instant, from 0.
        instant: usize,
    },
    /// The blur cannot be done.
    #[error(transparent)]
    Blur(BlurError),
    /// An edit says no place.
    #[error(transparent)]
    Edit(#[from] VolumeEditError),
    /// A grid that is none.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// A volume that is none.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// Values cannot be read at positions.
    #[error(transparent)]
    Resample(#[from] ResampleError),
    /// Masks that are none.
    #[error(transparent)]
    Mask(#[from] MaskError),
}

impl From<BlurError> for SpectError {
    fn from(error: BlurError) -> Self {
        match error {
            BlurError::Stopped(stopped) => Self::Stopped(stopped),
            error => Self::Blur(error),
        }
    }
}
