//! What can be asked of a study, and what comes back.

use std::sync::Arc;

use crate::analysis::embedding::{Embedding, MapMethod};
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::metrics::{Corners, Form, MetricKind, MetricParams};
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances};
use crate::engine::activity::WorkKind;
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

impl AnalysisRequest {
    /// The kind of work that it is.
    pub fn kind(&self) -> WorkKind {
        match self {
            Self::Measures => WorkKind::Measures,
            Self::PoseDistances(_) | Self::PoseMap(_) => WorkKind::PoseMap,
        }
    }

    /// What the activity list calls it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Measures => "Volumes and ejection fraction",
            Self::PoseDistances(_) => "Pose distances",
            Self::PoseMap(_) => "Pose map",
        }
    }

    /// Its settings in words; empty where it has none.
    pub fn parameters(&self) -> String {
        match self {
            Self::Measures => String::new(),
            Self::PoseDistances(params) => metric_words(&params.metric),
            Self::PoseMap(params) => {
                let method = match params.method {
                    MapMethod::ClassicalMds => "classical MDS".to_owned(),
                    MapMethod::Smacof => "SMACOF".to_owned(),
                    MapMethod::Isomap { neighbours } => {
                        format!("Isomap of {neighbours} neighbours")
                    }
                };
                format!("{}, {method}", metric_words(&params.distances.metric))
            }
        }
    }
}

/// A metric with the settings that matter to it, as the activity list and figures say it.
pub fn metric_words(metric: &MetricParams) -> String {
    let kind = match metric.kind {
        MetricKind::Isometric => return "isometric".to_owned(),
        MetricKind::Rigid => return "rigid".to_owned(),
        MetricKind::AnglePreserving => "angle-preserving",
        MetricKind::QuasiConformal => "quasi-conformal",
    };
    let form = match metric.form {
        Form::Printed => "printed form".to_owned(),
        Form::Bilinear => "bilinear form".to_owned(),
        Form::Frozen => "frozen form".to_owned(),
        Form::Additive if metric.kind == MetricKind::QuasiConformal => {
            format!("additive form, μ = {}", metric.mu)
        }
        Form::Additive => "additive form".to_owned(),
    };
    let corners = match metric.corners {
        Corners::Raw => "raw corners",
        Corners::ScaleFree => "scale-free corners",
    };
    format!("{kind}, {form}, {corners}, λ = {}", metric.lambda)
}

impl AnalysisOutcome {
    /// Memory that it holds, near enough to bound a cache by it.
    pub fn bytes(&self) -> usize {
        let matrix = |distances: &PoseDistances| {
            size_of_val(distances.distances.upper()) + size_of_val(&*distances.poses)
        };
        match self {
            Self::Measures(subjects) => subjects
                .iter()
                .map(|subject| size_of_val(subject) + size_of_val(&*subject.frames))
                .sum(),
            Self::PoseDistances(distances) => matrix(distances),
            // Its distances are usually kept under their own key too; counting them twice
            // only makes the bound stricter.
            Self::PoseMap(map) => matrix(&map.distances) + size_of_val(&*map.embedding.coordinates),
        }
    }

    /// The measures, if that is what it is.
    pub fn measures(&self) -> Option<&Arc<Vec<SubjectMeasures>>> {
        match self {
            Self::Measures(measures) => Some(measures),
            _ => None,
        }
    }

    /// The distances, if that is what it is.
    pub fn pose_distances(&self) -> Option<&Arc<PoseDistances>> {
        match self {
            Self::PoseDistances(distances) => Some(distances),
            _ => None,
        }
    }

    /// The map, if that is what it is.
    pub fn pose_map(&self) -> Option<&Arc<PoseMap>> {
        match self {
            Self::PoseMap(map) => Some(map),
            _ => None,
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_read_as_a_person_would_say_them() {
        let request = AnalysisRequest::PoseMap(PoseMapParams::default());
        assert_eq!(
            request.parameters(),
            "quasi-conformal, additive form, μ = 0.001, scale-free corners, λ = 3, SMACOF"
        );
        let mut metric = MetricParams {
            kind: MetricKind::Rigid,
            ..MetricParams::default()
        };
        assert_eq!(metric_words(&metric), "rigid");
        metric.kind = MetricKind::AnglePreserving;
        assert!(!metric_words(&metric).contains('μ'));
    }
}
