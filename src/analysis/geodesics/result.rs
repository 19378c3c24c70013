//! A path of poses with what was found out about it.

use crate::analysis::metrics::MetricError;
use crate::mesh::Point3;

/// Poses from one end to the other, both included, with their energy.
#[derive(Clone, Debug, PartialEq)]
pub struct GeodesicPath {
    /// Start, interpolated poses, end.
    pub poses: Vec<Vec<Point3>>,
    /// Energy of the straight line with as many interpolated poses.
    pub energy_linear: f64,
    /// Energy of this path, never above that of the straight line.
    pub energy: f64,
    /// Length of each step: √((⟨⟨X, X⟩⟩ at its start + at its end) / 2), in the units of the metric.
    pub step_lengths: Vec<f64>,
    /// Iterations of the minimisation, of all levels together.
    pub iterations: usize,
    /// Pairs of faces that cross each other, over all interpolated poses; the method cannot exclude them.
    pub self_intersections: usize,
    /// Whether the tolerance was met, so that the path is a geodesic to that tolerance.
    pub converged: bool,
    /// Whether what the search brought costs more than the straight line, or is no number: that line is then given, and
    /// not known to be a geodesic. A search that begins at the straight line and finds nothing cheaper has converged on
    /// it instead.
    pub fell_back: bool,
    /// Whether the computation was stopped; the path is then the best so far, and
    /// self-intersections may not all have been counted.
    pub stopped: bool,
}

/// Why there is no path.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GeodesicError {
    /// The ends do not correspond with the faces.
    #[error("ends of {start} and {end} points for faces over {expected} vertices")]
    VertexCounts {
        /// Points of the start.
        start: usize,
        /// Points of the end.
        end: usize,
        /// Vertices of the faces.
        expected: usize,
    },
    /// A coordinate is NaN or infinite, or overflows when squared.
    #[error(
        "vertex {vertex} of the {end} is at ({x}, {y}, {z}), which is not a finite number of moderate size"
    )]
    NotFinite {
        /// `start` or `end`.
        end: &'static str,
        /// The first such vertex.
        vertex: usize,
        /// Its coordinates.
        x: f64,
        /// Its coordinates.
        y: f64,
        /// Its coordinates.
        z: f64,
    },
    /// An end has no area, so that nothing is relative to it.
    #[error("the {end} has no area: {faces} faces over {vertices} vertices")]
    Degenerate {
        /// `start` or `end`.
        end: &'static str,
        /// Faces it has.
        faces: usize,
        /// Vertices it has.
        vertices: usize,
    },
    /// The energy of the straight line is not a number.
    #[error("the straight line between the ends has energy {energy}: a pose on it collapses")]
    Energy {
        /// What was computed.
        energy: f64,
    },
    /// The metric refuses an end.
    #[error(transparent)]
    Metric(#[from] MetricError),
}
