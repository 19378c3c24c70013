//! Why an experiment cannot be run.

use crate::analysis::classification::{ClassesParamError, ClassifyError};
use crate::analysis::deformations::{DeformationMapError, DeformationParamError};
use crate::analysis::embedding::EmbeddingError;
use crate::analysis::pose_distances::{PoseDistanceError, PoseDistanceParamError};
use crate::analysis::thickening::{ThickeningError, ThickeningParamError};
use crate::mesh::MeshError;
use crate::progress::Stopped;
use crate::study::SequenceError;

/// Why an experiment brought no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExperimentError {
    /// It was asked to stop; no error to show.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// A number is too small.
    #[error("{name}: at least {least} are needed, not {value}")]
    TooFew {
        /// What there must be more of.
        name: &'static str,
        /// How many were asked for.
        value: usize,
        /// The least that works.
        least: usize,
    },
    /// Objects are closed or have one or two holes.
    #[error("objects have at most 2 boundaries, not {boundaries}")]
    Boundaries {
        /// What was asked for.
        boundaries: u8,
    },
    /// Jitter is a share.
    #[error("{name} must be at least 0 and less than 0.9, not {value}")]
    Jitter {
        /// Name of the setting that is refused.
        name: &'static str,
        /// What was asked for.
        value: f64,
    },
    /// A patch is a part of the sheet.
    #[error("the share of a patch must be above 0 and below 0.9, not {share}")]
    PatchShare {
        /// What was asked for.
        share: f64,
    },
    /// Nobody's other sequence can be nearer.
    #[error(
        "none of the {sequences} sequences that correspond has a partner: ids of one patient must agree \
         up to their last `_`, as P7_rest and P7_stress do"
    )]
    NoPartners {
        /// How many were looked at.
        sequences: usize,
    },
    /// There is nobody else to be nearer than.
    #[error(
        "all {sequences} sequences that correspond are of one patient, {patient}: the rank of a partner \
         needs sequences of other patients"
    )]
    OnePatient {
        /// How many were looked at.
        sequences: usize,
        /// What their ids have in common.
        patient: String,
    },
    /// A noise level is not a share of a variance.
    #[error("a noise level must be zero or positive and finite, not {percent} %")]
    Level {
        /// What was asked for.
        percent: f64,
    },
    /// Coordinates left the range of numbers.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Poses do not make a sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// Settings of distances.
    #[error(transparent)]
    Distances(#[from] PoseDistanceParamError),
    /// Settings of the deformation map.
    #[error(transparent)]
    Deformations(#[from] DeformationParamError),
    /// Settings of the classifiers.
    #[error(transparent)]
    Classes(#[from] ClassesParamError),
    /// Settings of the search for patches.
    #[error(transparent)]
    Thickening(#[from] ThickeningParamError),
    /// A step of the method failed.
    #[error("{step}: {reason}")]
    Step {
        /// Name of the step that failed.
        step: &'static str,
        /// What it said.
        reason: String,
    },
}

impl From<PoseDistanceError> for ExperimentError {
    fn from(error: PoseDistanceError) -> Self {
        match error {
            PoseDistanceError::Stopped(stopped) => stopped.into(),
            other => step("comparing poses", &other),
        }
    }
}

impl From<EmbeddingError> for ExperimentError {
    fn from(error: EmbeddingError) -> Self {
        match error {
            EmbeddingError::Stopped(stopped) => stopped.into(),
            other => step("embedding poses", &other),
        }
    }
}

impl From<ThickeningError> for ExperimentError {
    fn from(error: ThickeningError) -> Self {
        match error {
            ThickeningError::Stopped(stopped) => stopped.into(),
            other => step("detecting patches", &other),
        }
    }
}

impl From<DeformationMapError> for ExperimentError {
    fn from(error: DeformationMapError) -> Self {
        match error {
            DeformationMapError::Stopped(stopped) => stopped.into(),
            other => step("embedding deformations", &other),
        }
    }
}

impl From<ClassifyError> for ExperimentError {
    fn from(error: ClassifyError) -> Self {
        match error {
            ClassifyError::Stopped(stopped) => stopped.into(),
            other => step("classifying", &other),
        }
    }
}

pub(super) fn step(step: &'static str, error: &dyn std::error::Error) -> ExperimentError {
    ExperimentError::Step {
        step,
        reason: error.to_string(),
    }
}
