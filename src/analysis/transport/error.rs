//! Why a motion cannot be transported to another subject.

use crate::analysis::geodesics::GeodesicError;
use crate::analysis::metrics::MetricError;
use crate::progress::Stopped;
use crate::study::SequenceError;

use super::TransportParamError;

/// Why a motion cannot be transported to another subject.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TransportError {
    /// Not a failure: it was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// The settings cannot be used.
    #[error(transparent)]
    Params(#[from] TransportParamError),
    /// Vertices of two subjects do not correspond.
    #[error(
        "the vertices of {from} ({from_vertices} with {from_faces} faces) do not correspond with \
         those of {onto} ({onto_vertices} with {onto_faces} faces)"
    )]
    NoCorrespondence {
        /// Whose motion it is.
        from: String,
        /// Its vertices.
        from_vertices: usize,
        /// Its faces.
        from_faces: usize,
        /// Who was to move.
        onto: String,
        /// Its vertices.
        onto_vertices: usize,
        /// Its faces.
        onto_faces: usize,
    },
    /// A subject has no size that could be normalised.
    #[error("the size of {subject} at end-diastole (frame {frame}) is not measurable")]
    NoSize {
        /// Id of the subject concerned.
        subject: String,
        /// Its end-diastolic frame.
        frame: usize,
    },
    /// The subject that all motions were to be transported onto cannot take part.
    #[error("subject {index} of {subjects} cannot be used as the reference: {reason}")]
    Reference {
        /// The index named.
        index: usize,
        /// Subjects of the study.
        subjects: usize,
        /// Why, in a sentence.
        reason: String,
    },
    /// A path needs samples, a deformation poses.
    #[error("there are no poses to transport a motion along")]
    NoPoses,
    /// A field needs a displacement for each vertex.
    #[error("{displacements} displacements for poses of {vertices} vertices")]
    FieldLength {
        /// Displacements given.
        displacements: usize,
        /// Vertices of the poses.
        vertices: usize,
    },
    /// Products of this metric are not linear, so that no field can be fitted to them.
    #[error("transport needs a form of the metric that is an inner product")]
    NotAnInnerProduct,
    /// A displacement is NaN, infinite or too large to be squared.
    #[error("the displacement from pose {pose} has squared length {norm2}")]
    NotFinite {
        /// Index of the pose it starts at.
        pose: usize,
        /// What was computed.
        norm2: f64,
    },
    /// Nothing cheaper than the straight line was found, which is not known to be a geodesic.
    #[error(
        "no geodesic was found between the subjects: nothing cheaper than the straight line of energy {energy_linear}; \
         without interpolated poses the straight line itself is taken"
    )]
    NoGeodesic {
        /// Energy of the straight line.
        energy_linear: f64,
    },
    /// The metric refuses a pose.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// There is no path between the subjects.
    #[error(transparent)]
    Geodesic(#[from] GeodesicError),
    /// What was transported does not make a sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}
