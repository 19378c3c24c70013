//! The whole way from a study to whole deformations: distances of poses, their map, curves, the plane.

use crate::analysis::deformations::{
    Comparison, DeformationDistances, DeformationMapParams, PartDistances, PartParams, PartWeights,
    deformation_distances, deformation_map, distances_at_equal_phases, part_distances,
};
use crate::analysis::embedding::{Embedding, MapMethod, embed};
use crate::analysis::metrics::{Corners, Form, MetricKind, MetricParams};
use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams, pose_distances};
use crate::analysis::transport::CohortTransportParams;
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
    /// What of two beats is compared.
    pub comparison: Comparison,
    /// Smoothing of poses of which deformations are compared.
    pub deformation_smoothing: f64,
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
    /// Takes a study through all of it with curves of poses, as in the text: `map` lays out poses, `plane` their curves.
    pub(super) fn curves_compared(
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

    /// Distances of whole deformations, without a map.
    pub(super) fn whole(
        &self,
        study: &Study,
        progress: &Progress,
    ) -> Result<DeformationDistances, ExperimentError> {
        if let Comparison::Parts(weights) = self.comparison {
            let parts = self.parts(study, progress)?;
            return Ok(DeformationDistances {
                distances: parts.weighted(weights),
                subjects: parts.subjects,
            });
        }
        Ok(distances_at_equal_phases(
            study,
            &self.distances.check()?,
            progress,
        )?)
    }

    /// Both parts, of which [`Method::whole`] takes what is compared.
    fn parts(&self, study: &Study, progress: &Progress) -> Result<PartDistances, ExperimentError> {
        let params = PartParams::like(&self.distances, self.deformation_smoothing);
        Ok(part_distances(study, &params.check()?, progress)?)
    }

    /// Curves of poses by these distances.
    pub fn of_poses(name: &'static str, distances: PoseDistanceParams) -> Self {
        Self {
            name,
            distances,
            comparison: Comparison::Poses,
            deformation_smoothing: DeformationMapParams::default().smoothing,
        }
    }

    /// Curves of poses by the metric that the program starts with.
    pub fn default_metric() -> Self {
        Self::of_poses("default", PoseDistanceParams::default())
    }

    /// Motion relative to the own end-diastole, by the default metric.
    pub fn deformation() -> Self {
        Self {
            name: "deformation",
            comparison: Comparison::Parts(PartWeights::DEFORMATION),
            ..Self::default_metric()
        }
    }

    /// The same with end-diastolic shape.
    pub fn deformation_and_shape() -> Self {
        Self {
            name: "deformation + shape",
            comparison: Comparison::Parts(PartWeights::BOTH),
            ..Self::default_metric()
        }
    }

    /// Displacement of vertices from end-diastole after rigid alignment of the end-diastolic poses, sizes normalised: what a
    /// comparison of motions without any metric or transport of its own would use. In the metric of displacement with all vertices of
    /// equal weight a transport along the straight line changes no displacement.
    pub fn displacement() -> Self {
        let rigid = Self::procrustes();
        Self {
            name: "displacement from end-diastole",
            distances: PoseDistanceParams {
                metric: MetricParams {
                    area_weights: false,
                    ..rigid.distances.metric
                },
                transport: Some(CohortTransportParams {
                    interpolated_poses: 0,
                    kind: Some(MetricKind::Displacement),
                    ..CohortTransportParams::default()
                }),
                ..rigid.distances
            },
            comparison: Comparison::Parts(PartWeights::DEFORMATION),
            deformation_smoothing: 0.0,
        }
    }

    /// Displacement after rigid alignment of each pair, nothing smoothed: what a comparison without
    /// any metric of its own would use.
    pub fn procrustes() -> Self {
        let displacement = MetricParams::of(MetricKind::Displacement);
        Self::of_poses("plain Procrustes", unsmoothed(displacement))
    }

    /// Equation 3.5 as printed: raw corners, absolute values, sums over faces, nothing smoothed.
    pub fn printed() -> Self {
        let printed = MetricParams {
            kind: MetricKind::QuasiConformal,
            form: Form::Printed,
            corners: Corners::Raw,
            area_weights: false,
            lambda: 0.0,
            ..MetricParams::default()
        };
        Self::of_poses("printed", unsmoothed(printed))
    }

    /// Change of angles and curvature with the default smoothing.
    pub fn quasi_conformal() -> Self {
        let poses = PoseDistanceParams {
            metric: MetricParams::of(MetricKind::QuasiConformal),
            ..PoseDistanceParams::default()
        };
        Self::of_poses("quasi-conformal", poses)
    }

    /// The same without smoothing: what smoothing brings.
    pub fn quasi_conformal_unsmoothed() -> Self {
        let metric = MetricParams::of(MetricKind::QuasiConformal);
        Self::of_poses("quasi-conformal, not smoothed", unsmoothed(metric))
    }
}

fn unsmoothed(metric: MetricParams) -> PoseDistanceParams {
    PoseDistanceParams {
        metric,
        transport: None,
        smoothing: 0.0,
    }
}
