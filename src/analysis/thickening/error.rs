//! Why thickening cannot be determined.

use crate::numeric::SparseCholeskyError;
use crate::progress::Stopped;

/// Why there is no thickening.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThickeningError {
    /// Thickening is a change.
    #[error("{frames} {}; thickening needs at least two", if *frames == 1 { "pose" } else { "poses" })]
    TooFewPoses {
        /// Poses that there are.
        frames: usize,
    },
    /// Most of the medial surface ends, or is no wall.
    #[error("only {regular} of {atoms} atoms are regular; at least {least} are needed")]
    TooFewAtoms {
        /// Atoms that take part.
        regular: usize,
        /// All atoms.
        atoms: usize,
        /// The fewest that would do.
        least: usize,
    },
    /// Frames, normals or flags are not as many as atoms.
    #[error("pose {frame} has {found} atoms where {expected} are expected")]
    Count {
        /// The first such frame.
        frame: usize,
        /// Atoms it has.
        found: usize,
        /// Vertices of the medial mesh.
        expected: usize,
    },
    /// A regular atom whose radius has no logarithm.
    #[error("atom {atom} of pose {frame} has radius {radius}")]
    BadRadius {
        /// The atom.
        atom: usize,
        /// The pose.
        frame: usize,
        /// Its radius.
        radius: f64,
    },
    /// All regular atoms lie on a line or in a point.
    #[error("the regular part of the medial surface has no area")]
    NoArea,
    /// Nothing can be averaged over the medial surface.
    #[error(transparent)]
    Smoothing(#[from] SparseCholeskyError),
    /// Asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
}
