//! How finely the built-in cohort is sampled, and from which seed it is drawn.

use crate::mesh::MeshError;
use crate::study::SequenceError;

/// Frames of every built-in beat; frame 0 is end-diastole.
pub const FRAMES: usize = 8;

/// Most vertices a built-in subject can have, both surfaces together.
pub const MAX_VERTICES: usize = 40_000;

/// Fewest: below this the apex is a hexagon and the wall a prism.
const MIN_VERTICES: usize = 200;

/// Settings of the built-in cohort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BuiltInParams {
    /// Draws the variation between subjects; equal seeds give equal bits.
    pub seed: u64,
    /// Vertices per subject, both surfaces together, as an upper limit: the nearest regular
    /// pattern that does not exceed it is taken.
    pub vertices: usize,
}

impl Default for BuiltInParams {
    fn default() -> Self {
        Self {
            seed: 2009,
            vertices: 2_500,
        }
    }
}

impl BuiltInParams {
    /// Vertices of one of the two surfaces, at most.
    ///
    /// # Errors
    /// If fewer than 200 or more than [`MAX_VERTICES`] are asked for.
    pub(super) fn vertices_per_surface(&self) -> Result<usize, BuiltInError> {
        if (MIN_VERTICES..=MAX_VERTICES).contains(&self.vertices) {
            Ok(self.vertices / 2)
        } else {
            Err(BuiltInError::Vertices {
                asked: self.vertices,
                fewest: MIN_VERTICES,
                most: MAX_VERTICES,
            })
        }
    }
}

/// Why the cohort cannot be made as asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BuiltInError {
    /// Too coarse or too fine.
    #[error("{asked} vertices per subject; the built-in cohort has between {fewest} and {most}")]
    Vertices {
        /// What was asked for.
        asked: usize,
        /// The fewest that can be had.
        fewest: usize,
        /// The most that can be had.
        most: usize,
    },
    /// The surfaces do not make a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The frames do not make a sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}
