//! What can be asked of a study, and what comes back.

use std::sync::Arc;

use crate::analysis::embedding::{Embedding, MapMethod};
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances};
use crate::progress::Stopped;

/// Settings of the map of all poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseMapParams {
    /// How poses are compared.
    pub distances: PoseDistanceParams,
    /// How distances become a map.
    pub method: MapMethod,
}

/// One question to a study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnalysisRequest {
    /// Clinical measures of every subject.
    Measures,
    /// Distances of all poses.
    PoseDistances(PoseDistanceParams),
    /// The map of all poses.
    PoseMap(PoseMapParams),
}

/// The map of all poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMap {
    /// What the map shows; rows correspond.
    pub distances: Arc<PoseDistances>,
    /// Two coordinates per pose.
    pub embedding: Embedding,
}

/// One answer; results are shared, never changed.
#[derive(Clone, Debug)]
pub enum AnalysisOutcome {
    /// One per subject of the study.
    Measures(Arc<Vec<SubjectMeasures>>),
    /// Distances of all poses.
    PoseDistances(Arc<PoseDistances>),
    /// The map of all poses.
    PoseMap(Arc<PoseMap>),
}

/// Why a request brought no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AnalysisError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The study cannot answer it.
    #[error("{0}")]
    Unanswerable(String),
}
