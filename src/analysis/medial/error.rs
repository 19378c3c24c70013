//! Why a subject has no medial surface.

use crate::analysis::measures::UnknownVolume;
use crate::mesh::MeshError;
use crate::progress::Stopped;

/// Why atoms cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MedialError {
    /// Thickness needs two sides.
    #[error(
        "no wall: endocardium and epicardium, or a closed wall, are needed, but there is only {found}"
    )]
    NoWall {
        /// Words for the surfaces that are there.
        found: String,
    },
    /// The wall's inner side cannot be determined.
    #[error(transparent)]
    InnerSide(#[from] UnknownVolume),
    /// A surface without a single face that has an area.
    #[error("frame {frame}: surface {surface} has {faces} faces, none of which has an area")]
    NoArea {
        /// The frame.
        frame: usize,
        /// Place of the surface, the template first.
        surface: usize,
        /// Its faces.
        faces: usize,
    },
    /// The sides lie the wrong way round, cross each other, or are too far apart to be a wall.
    #[error(
        "frame {frame}: {without} of {atoms} vertices have no inscribed sphere between the sides; \
         they cross, coincide or do not face each other"
    )]
    NoRoom {
        /// The frame.
        frame: usize,
        /// Vertices without a sphere.
        without: usize,
        /// Vertices of the template.
        atoms: usize,
    },
    /// Vertices are off by so much that most atoms are lost.
    #[error(
        "noise: vertices are off by {noise:.2}, which is not small against the wall's thickness of {thickness:.2} (in coordinates); \
         {lost} of {atoms} atoms are lost"
    )]
    Noise {
        /// Standard deviation of each coordinate, in coordinates.
        noise: f64,
        /// Typical thickness, in coordinates.
        thickness: f64,
        /// Atoms that are lost.
        lost: usize,
        /// All of them.
        atoms: usize,
    },
    /// Connectivity of the template is broken.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
}
