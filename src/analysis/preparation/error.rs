//! Why an image gives no walls.

use super::{Asked, SettingsError};
use crate::analysis::surface_extraction::SurfaceError;
use crate::analysis::walls_from_cine::CineError;
use crate::analysis::walls_from_contours::ContourError;
use crate::analysis::walls_from_masks::{MaskError, WallError};
use crate::analysis::walls_from_spect::SpectError;
use crate::image::{BlurError, ImageError, VolumeEditError};
use crate::mesh::MeshError;
use crate::progress::Stopped;
use crate::study::SequenceError;

/// Why there are no walls, or no preview of them.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PreparationError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// Somebody must say more.
    #[error("{} must be said", asked_for(.0))]
    Asked(Vec<Asked>),
    /// The image with what was typed is none.
    #[error("with the distances and times that were typed: {0}")]
    Typed(ImageError),
    /// A volume that the image does not have.
    #[error("there is no volume {instant}: the image has {instants}")]
    Instant {
        /// Which, from 0.
        instant: usize,
        /// How many there are.
        instants: usize,
    },
    /// The volume has no value above 0, of which the threshold could be a share.
    #[error("volume {0} has no value above 0, so that a threshold says nothing")]
    Dark(usize),
    /// The values are not the labels of a ventricle.
    #[error(transparent)]
    Masks(MaskError),
    /// The counts of SPECT show no ventricle.
    #[error(transparent)]
    Spect(SpectError),
    /// No outlines are found in cine MR.
    #[error(transparent)]
    Cine(CineError),
    /// The outlines give no tissues.
    #[error(transparent)]
    Contours(#[from] ContourError),
    /// The tissues give no walls.
    #[error(transparent)]
    Walls(WallError),
    /// No surface for the preview.
    #[error(transparent)]
    Surface(SurfaceError),
    /// The blur.
    #[error(transparent)]
    Blur(BlurError),
    /// An edit.
    #[error(transparent)]
    Edit(#[from] VolumeEditError),
    /// The lids at the base make no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The surfaces with lids make no sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}

fn asked_for(asked: &[Asked]) -> String {
    let words: Vec<&str> = asked.iter().map(|asked| asked.words()).collect();
    words.join(", ")
}

/// An error with "stopped" among its reasons, which is no failure.
macro_rules! stoppable {
    ($($error:ty => $variant:ident, $stopped:path);+ $(;)?) => {
        $(impl From<$error> for PreparationError {
            fn from(error: $error) -> Self {
                match error {
                    $stopped(stopped) => Self::Stopped(stopped),
                    other => Self::$variant(other),
                }
            }
        })+
    };
}

stoppable! {
    WallError => Walls, WallError::Stopped;
    SurfaceError => Surface, SurfaceError::Stopped;
    SpectError => Spect, SpectError::Stopped;
    CineError => Cine, CineError::Stopped;
    BlurError => Blur, BlurError::Stopped;
}

impl From<MaskError> for PreparationError {
    fn from(error: MaskError) -> Self {
        Self::Masks(error)
    }
}
