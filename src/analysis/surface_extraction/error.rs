//! Why a volume or a mesh gives no surface.

use crate::mesh::MeshError;
use crate::progress::Stopped;

/// Why there is no surface.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// Values and a grid do not belong together.
    #[error("{values} values for {voxels} voxels")]
    Count {
        /// How many values there are.
        values: usize,
        /// How many there should be.
        voxels: usize,
    },
    /// The threshold is NaN or infinite.
    #[error("the threshold is not a finite number")]
    Threshold,
    /// All is padding.
    #[error("no voxel of the volume has a value")]
    NoValues,
    /// The volume has one value only.
    #[error("all voxels have the value {value}: there is no surface between them")]
    Constant {
        /// That value.
        value: f32,
    },
    /// Nothing lies above the threshold.
    #[error("no voxel lies above the threshold {threshold}: the greatest value is {greatest}")]
    NothingInside {
        /// The threshold.
        threshold: f64,
        /// The greatest value.
        greatest: f32,
    },
    /// Nothing lies below the threshold.
    #[error("all voxels lie above the threshold {threshold}: the smallest value is {smallest}")]
    NothingOutside {
        /// The threshold.
        threshold: f64,
        /// The smallest value.
        smallest: f32,
    },
    /// A mask has no voxel.
    #[error("the mask is empty")]
    EmptyMask,
    /// More vertices than a mesh may have.
    #[error("the surface has {vertices} vertices, more than {limit}: is the volume mostly noise?")]
    TooManyVertices {
        /// How many.
        vertices: u64,
        /// How many there may be.
        limit: u64,
    },
    /// Coordinates or faces are no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}
