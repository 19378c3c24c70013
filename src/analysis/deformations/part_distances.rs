//! Distances of beats in two parts: how hearts deform, and how they are shaped at end-diastole.

use std::collections::HashMap;
use std::sync::Arc;

use crate::analysis::metrics::{CheckedMetricParams, Form, MetricParams};
use crate::analysis::pose_distances::{
    CheckedPoseDistanceParams, DistanceMatrix, LeftOut, PoseDistanceError, PoseDistanceParamError,
    PoseDistanceParams, pose_distances, smoothed_study,
};
use crate::analysis::transport::{
    CohortTransportParams, TransportAccount, TransportedCohort, transport_cohort,
};
use crate::mesh::Point3;
use crate::numeric::median;
use crate::progress::Progress;
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

use super::PartWeights;
use super::motions::motion_distances;

/// Share of the time that transporting motions takes.
const TRANSPORT_SHARE: f32 = 0.9;

/// Sizes of the heart from which on sums of squares would be no numbers.
const TOO_FAR: f64 = 1e100;

/// Distances of shapes of size 1 below this are round-off: no two subjects differ.
const ROUND_OFF: f64 = 1e-12;

/// Settings of both parts of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartParams {
    /// The metric of both.
    pub metric: MetricParams,
    /// Onto which shape motions are transported before they are compared.
    pub transport: CohortTransportParams,
    /// Radius below which poses are smoothed before motions are compared, as in [`PoseDistanceParams`].
    pub smoothing: f64,
    /// Radius below which poses are smoothed before end-diastolic shapes are compared.
    pub shape_smoothing: f64,
}

impl PartParams {
    /// With the metric, the reference and the smoothing of shapes by which poses are compared; without a reference
    /// motions are transported onto the mean.
    pub fn like(poses: &PoseDistanceParams, smoothing: f64) -> Self {
        Self {
            metric: poses.metric,
            transport: poses.transport.unwrap_or_default(),
            smoothing,
            shape_smoothing: poses.smoothing,
        }
    }

    /// As settings of distances of poses: smoothed alike, motions transported.
    pub fn of_motions(&self) -> PoseDistanceParams {
        PoseDistanceParams {
            metric: self.metric,
            transport: Some(self.transport),
            smoothing: self.smoothing,
        }
    }

    fn of_shapes(&self) -> PoseDistanceParams {
        PoseDistanceParams {
            metric: self.metric,
            transport: None,
            smoothing: self.shape_smoothing,
        }
    }

    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If those of the metric or of the transport are not, or a radius is out of range.
    pub fn check(self) -> Result<CheckedPartParams, PoseDistanceParamError> {
        self.of_motions().check()?;
        // Displacements are compared by an inner product, which transport needs as well.
        let additive = MetricParams {
            form: match self.metric.is_inner_product() {
                true => self.metric.form,
                false => Form::Additive,
            },
            ..self.metric
        };
        Ok(CheckedPartParams {
            params: self,
            metric: additive.check()?,
            shapes: self.of_shapes().check()?,
        })
    }
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedPartParams {
    params: PartParams,
    metric: CheckedMetricParams,
    shapes: CheckedPoseDistanceParams,
}

/// Both parts of the distances of beats, a row per subject.
#[derive(Clone, Debug, PartialEq)]
pub struct PartDistances {
    /// What each row stands for: indices into the study's subjects, ascending.
    pub subjects: Vec<usize>,
    /// Of motions relative to the own end-diastole.
    pub deformation: DistanceMatrix,
    /// Of end-diastolic poses.
    pub shape: DistanceMatrix,
    /// Subjects that take no part, in the order of the study.
    pub left_out: Vec<LeftOut>,
    /// How the motion of each row was transported.
    pub transports: Vec<TransportAccount>,
    /// Of deformations and of shapes, over all pairs.
    medians: [f64; 2],
}

impl PartDistances {
    /// From two matrices with a row per subject.
    pub(super) fn new(
        subjects: Vec<usize>,
        [deformation, shape]: [DistanceMatrix; 2],
        left_out: Vec<LeftOut>,
        transports: Vec<TransportAccount>,
    ) -> Self {
        Self {
            medians: [&deformation, &shape]
                .map(|matrix| median(matrix.upper().to_vec()).unwrap_or(0.0)),
            subjects,
            deformation,
            shape,
            left_out,
            transports,
        }
    }

    /// d² = w_d · d_deformation² / m_d² + w_s · d_shape² / m_s², where m are the medians over all pairs: so weights
    /// mean the same in every study and by every metric. A part in which no two subjects differ counts for nothing.
    pub fn weighted(&self, weights: PartWeights) -> DistanceMatrix {
        DistanceMatrix::of_pairs(self.subjects.len(), |i, j| {
            self.weighted_squares(weights, i, j)
                .iter()
                .sum::<f64>()
                .sqrt()
        })
        .unwrap_or_else(DistanceMatrix::empty)
    }

    /// Share of shape in the squared distance of two rows, both parts of equal weight; `None` where they do not differ.
    pub fn shape_share(&self, i: usize, j: usize) -> Option<f64> {
        share(self.weighted_squares(PartWeights::BOTH, i, j))
    }

    /// Median of [`Self::shape_share`] over all pairs that differ; `None` where none do.
    pub fn median_shape_share(&self) -> Option<f64> {
        let pairs = (0..self.subjects.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        median(pairs.filter_map(|(i, j)| self.shape_share(i, j)).collect())
    }

    fn weighted_squares(&self, weights: PartWeights, i: usize, j: usize) -> [f64; 2] {
        let square = |weight: f64, matrix: &DistanceMatrix, median: f64| match median > ROUND_OFF {
            true => weight * (matrix.get(i, j) / median).powi(2),
            false => 0.0,
        };
        [
            square(weights.deformation, &self.deformation, self.medians[0]),
            square(weights.shape, &self.shape, self.medians[1]),
        ]
    }
}

/// Both parts of the distances of all usable beats.
///
/// **Deformation.** Poses are smoothed, sizes normalised, and every beat is transported onto the reference
/// ([`transport_cohort`]), so that all motions begin at one shape; distances are those of `motions.rs::motion_distances`.
///
/// **Shape.** Distances of the end-diastolic poses alone, smoothed, sizes normalised, each pair aligned
/// ([`pose_distances`]).
///
/// # Errors
/// If stopped, or the reference of the transport is no usable subject.
pub fn part_distances(
    study: &Study,
    params: &CheckedPartParams,
    progress: &Progress,
) -> Result<PartDistances, PoseDistanceError> {
    let CheckedPartParams {
        params,
        metric,
        shapes,
    } = params;
    let transporting = progress.part("transporting all motions", 0.0, TRANSPORT_SHARE);
    let smooth = smoothed_study(study, params.smoothing, &transporting.within())?;
    let mut cohort = transport_cohort(&smooth, metric, &params.transport, &transporting)?;
    let comparing = progress.part("comparing motions", TRANSPORT_SHARE, 1.0);
    let shapes = pose_distances(&end_diastoles(study), shapes, &comparing.within())?;
    leave_out_overflowing(&mut cohort);
    let row_of: HashMap<usize, usize> = (shapes.poses.iter().enumerate())
        .map(|(row, pose)| (pose.subject, row))
        .collect();
    // A shape whose lengths overflow has no distances, whatever its motion.
    cohort
        .members
        .retain(|member| row_of.contains_key(&member.subject));
    let subjects: Vec<usize> = cohort.members.iter().map(|member| member.subject).collect();
    let mut left_out = shapes.left_out;
    left_out.append(&mut cohort.left_out);
    left_out.sort_by_key(|left| left.subject);
    left_out.dedup_by_key(|left| left.subject);
    let transports = (cohort.members.iter_mut())
        .map(|member| std::mem::take(&mut member.account))
        .collect();
    let deformation = motion_distances(&smooth, cohort, metric, &comparing)?;
    let rows: Vec<usize> = subjects.iter().map(|subject| row_of[subject]).collect();
    let shape = DistanceMatrix::of_pairs(rows.len(), |i, j| shapes.distances.get(rows[i], rows[j]));
    let parts = [deformation, shape.unwrap_or_else(DistanceMatrix::empty)];
    Ok(PartDistances::new(subjects, parts, left_out, transports))
}

/// A pose so far from the rest that squares overflow takes the whole subject out, since its motion would have a gap.
fn leave_out_overflowing(cohort: &mut TransportedCohort) {
    let beyond = |pose: &Vec<Point3>| {
        let mut numbers = pose.iter().flat_map(|point| point.coords.iter());
        numbers.any(|x| x.is_nan() || x.abs() >= TOO_FAR)
    };
    let left_out = &mut cohort.left_out;
    cohort.members.retain(|member| {
        let frame = member.poses.iter().position(beyond);
        left_out.extend(frame.map(|frame| LeftOut {
            subject: member.subject,
            reason: format!("lengths of frame {frame} overflow against its size at end-diastole"),
        }));
        frame.is_none()
    });
}

/// The study with the pose at the start frame of each subject alone.
fn end_diastoles(study: &Study) -> Study {
    let at_end_diastole = |subject: &Arc<Subject>| {
        let frame = subject.start_frame();
        let surfaces = subject.sequence.surfaces().iter().map(|surface| {
            let mesh = surface.frames().get(frame)?.clone();
            SurfaceSequence::new(surface.kind(), vec![mesh]).ok()
        });
        let sequence = MeshSequence::new(surfaces.collect::<Option<_>>()?).ok()?;
        Some(Arc::new(Subject {
            sequence,
            end_diastole: None,
            ..(**subject).clone()
        }))
    };
    Study {
        // A frame that makes no sequence of its own is refused where its motion is, with the reason.
        subjects: (study.subjects.iter())
            .map(|subject| at_end_diastole(subject).unwrap_or_else(|| Arc::clone(subject)))
            .collect(),
        ..study.clone()
    }
}

/// The second over the sum of both.
fn share([deformation, shape]: [f64; 2]) -> Option<f64> {
    let both = deformation + shape;
    (both > 0.0).then(|| shape / both)
}
