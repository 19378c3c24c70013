//! A metric with its connectivity, and what it answers. Its methods stand in `pair.rs`, `fields.rs`, `contributions.rs` and `path_energy.rs`.

use crate::mesh::Faces;

use super::connectivity::Connectivity;
use super::params::CheckedMetricParams;

/// A metric on the poses of one connectivity.
#[derive(Clone, Debug)]
pub struct Metric {
    pub(super) mesh: Connectivity,
    pub(super) params: CheckedMetricParams,
}

/// Why a metric cannot answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MetricError {
    /// A pose has another number of vertices than the connectivity.
    #[error("{points} points for connectivity of {expected} vertices")]
    VertexCount {
        /// Points given.
        points: usize,
        /// Vertices of the connectivity.
        expected: usize,
    },
    /// Coordinates are not finite, or so large that squared lengths are not.
    #[error("lengths or areas of the pose overflow")]
    Overflow,
}

/// Squared norms of X = B − A at both poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairNorms {
    /// ⟨⟨X, X⟩⟩ at A.
    pub norm2_a: f64,
    /// ⟨⟨X, X⟩⟩ at B.
    pub norm2_b: f64,
}

impl PairNorms {
    /// Energy of the one-step path: the sum of both (section 3.2.3).
    pub fn energy(&self) -> f64 {
        self.norm2_a + self.norm2_b
    }

    /// √(energy / 2): the mean of both norms in the quadratic sense, a length.
    pub fn distance(&self) -> f64 {
        // Round-off of equal poses may fall below zero.
        (0.5 * self.energy()).max(0.0).sqrt()
    }
}

/// Memory that pairs reuse; make one per thread.
#[derive(Clone, Debug, Default)]
pub struct PairScratch {
    /// Relative rate of length of each edge at A and at B.
    pub(super) stretch: Vec<[f64; 2]>,
    /// K(B) − K(A) of each vertex.
    pub(super) curvature_change: Vec<f64>,
}

impl Metric {
    /// A metric with checked settings on poses with these faces.
    pub fn new(faces: &Faces, params: CheckedMetricParams) -> Self {
        Self {
            mesh: Connectivity::new(faces),
            params,
        }
    }

    /// Rings of neighbours over which curvature is averaged on this mesh.
    pub(super) fn rings(&self) -> u32 {
        self.params.curvature.rings(self.mesh.vertex_count)
    }

    /// The settings it was made with.
    pub fn params(&self) -> &CheckedMetricParams {
        &self.params
    }
}
