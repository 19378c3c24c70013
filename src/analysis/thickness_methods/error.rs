//! Why a method of measuring thickness gives no result for a subject.

use crate::analysis::measures::UnknownVolume;
use crate::analysis::segments::SegmentError;
use crate::mesh::{MeshError, SheetError};
use crate::progress::Stopped;

/// Why thickness cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThicknessError {
    /// Settings out of range.
    #[error("{name} is {value}, but must be from {least} to {most}")]
    Setting {
        /// The setting.
        name: &'static str,
        /// What it is.
        value: f64,
        /// Lowest value.
        least: f64,
        /// Highest value.
        most: f64,
    },
    /// Thickness needs two sides.
    #[error("no wall: an inner and an outer side are needed, but the subject has no {missing} one")]
    NoSide {
        /// Which is missing.
        missing: &'static str,
    },
    /// A wall given as one surface has no inner side.
    #[error(transparent)]
    Unsplit(#[from] UnknownVolume),
    /// The long axis is not known.
    #[error(transparent)]
    Axis(#[from] SegmentError),
    /// A side has no inside.
    #[error("the {side} side: {reason}")]
    NoInside {
        /// Which side.
        side: &'static str,
        /// Why not.
        reason: SheetError,
    },
    /// Connectivity is broken.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sides touch, or are given the wrong way round.
    #[error("there is no wall between the sides: {voxels} voxels of {spacing} units lie in it")]
    NoWall {
        /// Voxels found.
        voxels: usize,
        /// Their side in coordinates.
        spacing: f64,
    },
    /// Too fine a grid.
    #[error("a grid of {voxels:.1e} voxels is needed, more than {most:.1e}")]
    TooManyVoxels {
        /// Voxels needed.
        voxels: f64,
        /// Voxels allowed.
        most: f64,
    },
    /// Labels do not fill the grid, or the spacing is no length.
    #[error("{labels} labels for a grid of {expected} voxels")]
    LabelCount {
        /// Labels given.
        labels: usize,
        /// Voxels of the grid.
        expected: usize,
    },
    /// The frame is past the last one.
    #[error("there is no frame {frame} in a sequence of {frames} frames")]
    NoFrame {
        /// The frame asked for.
        frame: usize,
        /// How many there are.
        frames: usize,
    },
    /// Asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
}
