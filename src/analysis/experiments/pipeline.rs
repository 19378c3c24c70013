//! The whole way from a study to whole deformations: distances of poses, their map, curves, the plane.

use crate::analysis::deformations::{DeformationMapParams, deformation_distances, deformation_map};
use crate::analysis::embedding::{Embedding, MapMethod, embed};
use crate::analysis::metrics::{Corners, Form, MetricKind, MetricParams};
use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams, pose_distances};
use crate::progress::Progress;
use crate::study::Study;

use super::ExperimentError;

/// One way of measuring distances between poses, by name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// What tables call it.
    pub name: &'static str,
    /// How poses are compared.
    pub distances: PoseDistanceParams,
}

/// Whole deformations of a study.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Compared {
    /// What each row stands for: indices into the study's subjects.
    pub(super) subjects: Vec<usize>,
    /// Distances of whole deformations.
    pub(super) distances: DistanceMatrix,
    /// The LLE plane.
    pub(super) plane: Embedding,
}

const PLANE: usize = 2;

impl Method {
    /// Takes a study through all of it: `map` lays out poses, `plane` whole deformations.
    pub(super) fn compared(
        &self,
        study: &Study,
        map: MapMethod,
        plane: &DeformationMapParams,
        progress: &Progress,
    ) -> Result<Compared, ExperimentError> {
        let poses = pose_distances(study, &self.distances.check()?, progress)?;
        // Classifiers read these; the plane is for k-means and the eye.
        let whole = deformation_distances(study, &poses, progress)?;
        let map = embed(&poses.distances, map, PLANE, progress)?;
        let plane = deformation_map(study, &poses.poses, &map, &plane.check()?, progress)?;
        Ok(Compared {
            subjects: whole.subjects,
            distances: whole.distances,
            plane: plane.embedding,
        })
    }

    /// The settings that the program starts with.
    pub fn default_metric() -> Self {
        Self {
            name: "default",
            distances: PoseDistanceParams::default(),
        }
    }

    /// Displacement after rigid alignment of each pair, nothing smoothed: what a comparison without
    /// any metric of its own would use.
    pub fn procrustes() -> Self {
        let rigid = MetricParams {
            kind: MetricKind::Rigid,
            lambda: 0.0,
            ..MetricParams::default()
        };
        Self {
            name: "plain Procrustes",
            distances: unsmoothed(rigid),
        }
    }

    /// Equation 3.5 as printed: raw corners, absolute values, sums over faces, nothing smoothed.
    pub fn printed() -> Self {
        let printed = MetricParams {
            form: Form::Printed,
            corners: Corners::Raw,
            area_weights: false,
            lambda: 0.0,
            ..MetricParams::default()
        };
        Self {
            name: "printed",
            distances: unsmoothed(printed),
        }
    }

    /// The default metric without smoothing: what smoothing brings.
    pub fn default_unsmoothed() -> Self {
        Self {
            name: "default, not smoothed",
            distances: unsmoothed(MetricParams::default()),
        }
    }

    /// Plain Procrustes with the default smoothing: what the metric brings.
    pub fn procrustes_smoothed() -> Self {
        Self {
            name: "Procrustes, smoothed",
            distances: PoseDistanceParams {
                smoothing: PoseDistanceParams::default().smoothing,
                ..Self::procrustes().distances
            },
        }
    }
}

fn unsmoothed(metric: MetricParams) -> PoseDistanceParams {
    PoseDistanceParams {
        metric,
        transport: None,
        smoothing: 0.0,
    }
}
