//! The pose that the map of all poses implies at a place where none lies.

use std::sync::Arc;

use crate::analysis::alignment::{AlignmentError, rigid_motion};
use crate::analysis::embedding::{InverseMapError, inverse_map};
use crate::analysis::pose_distances::PoseId;
use crate::analysis::transport::sequence_like;
use crate::engine::queries::pose_map::PoseMapQuery;
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::mesh::Point3;
use crate::study::{Study, Subject};

/// The pose at a place of the pose map, estimated from the poses around it.
///
/// 1. **Weights** by [`inverse_map`]: on the path of a subject those of the two poses around the place, elsewhere those of
///    the nearest poses, of one subject or of several.
/// 2. **Alignment**: each of them is laid onto the nearest by the rigid motion of least squares over vertices, for the
///    map knows neither places nor directions. Sizes stay.
/// 3. **Mean** of corresponding vertices with these weights.
///
/// At a pose of the map it is that pose, exactly; nothing is measured on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EstimatedPoseQuery {
    /// The map.
    pub map: PoseMapQuery,
    /// The place, in the coordinates of the map's embedding.
    pub at: [f64; 2],
}

/// A pose between those of the map.
#[derive(Clone, Debug)]
pub struct EstimatedPose {
    /// The place.
    pub at: [f64; 2],
    /// The subject of the nearest pose with two frames: the one at which its motion begins, which says how large it is,
    /// and the estimated pose.
    pub subject: Arc<Subject>,
    /// The poses that it is estimated from, with weights that sum to 1, greatest first.
    pub sources: Vec<(PoseId, f64)>,
}

/// Which frame of [`EstimatedPose::subject`] is the estimated pose.
pub const ESTIMATED_FRAME: usize = 1;

/// Why no pose is estimated at a place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoEstimate {
    /// There is nothing around it.
    #[error(transparent)]
    Place(#[from] InverseMapError),
    /// Points stand for poses that no subject has.
    #[error(
        "with transport, points of the map stand for motions on another subject; choose transport: off"
    )]
    Transported,
    /// Poses of different subjects, of which one may be larger only by its unit.
    #[error("the poses around this place have different units of length")]
    Units,
    /// Vertices do not correspond.
    #[error("the surfaces around this place do not correspond: {0}")]
    Correspondence(#[from] AlignmentError),
}

impl Query for EstimatedPoseQuery {
    type Answer = Result<EstimatedPose, NoEstimate>;
    const TITLE: &'static str = "Estimated pose";
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::all_shapes(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<Self::Answer, Interrupted> {
        if self.map.distances.transport.is_some() {
            return Ok(Err(NoEstimate::Transported));
        }
        let map = cx.get(&self.map)?;
        let rows = map.embedding.len().min(map.distances.poses.len());
        let place = |row| {
            let point = map.embedding.point(row);
            [0, 1].map(|axis| point.get(axis).copied().unwrap_or(f64::NAN))
        };
        let places: Vec<[f64; 2]> = (0..rows).map(place).collect();
        let weights = match inverse_map(&places, &beats(&map.distances.poses), self.at) {
            Ok(weights) => weights,
            Err(why) => return Ok(Err(why.into())),
        };
        let sources: Vec<(PoseId, f64)> = (weights.into_iter())
            .map(|(row, weight)| (map.distances.poses[row], weight))
            .collect();
        let Some(&(nearest, _)) = sources.first() else {
            return Ok(Err(InverseMapError::NoPoints.into()));
        };
        let base = subject_of(cx.study(), nearest.subject)?;
        let mut poses = Vec::with_capacity(sources.len());
        for (source, weight) in &sources {
            let subject = subject_of(cx.study(), source.subject)?;
            if subject.unit != base.unit {
                return Ok(Err(NoEstimate::Units));
            }
            let pose = subject.sequence.pose(source.frame);
            poses.push((pose.unwrap_or_default(), *weight));
        }
        let pose = match weighted_mean(&poses) {
            Ok(pose) => pose,
            Err(why) => return Ok(Err(why.into())),
        };
        let first = base.sequence.pose(base.start_frame()).unwrap_or_default();
        let sequence = sequence_like(&base.sequence, &[first, pose])?;
        let subject = Subject {
            anatomy: base.anatomy,
            ..Subject::new("Estimated pose", sequence, base.unit)
        };
        Ok(Ok(EstimatedPose {
            at: self.at,
            subject: Arc::new(subject),
            sources,
        }))
    }

    fn memory(answer: &Self::Answer, memory: &mut Memory) {
        if let Ok(pose) = answer {
            let sequence = &pose.subject.sequence;
            memory.own(sequence.frame_count() * sequence.vertex_count() * size_of::<Point3>());
        }
    }

    fn replaces(&self, other: &Self) -> bool {
        self.map == other.map
    }

    fn lets_finish(&self, _: &Self) -> bool {
        true
    }
}

/// Rows of poses that follow each other in a beat; after the last comes the first.
fn beats(poses: &[PoseId]) -> Vec<[usize; 2]> {
    let mut first = 0;
    let mut links = Vec::with_capacity(poses.len());
    for beat in poses.chunk_by(|a, b| a.subject == b.subject) {
        let last = first + beat.len() - 1;
        links.extend((first..last).map(|row| [row, row + 1]));
        if beat.len() > 2 {
            links.push([last, first]);
        }
        first = last + 1;
    }
    links
}

/// The mean of corresponding vertices, each pose laid onto the first; weights sum to 1.
fn weighted_mean(poses: &[(Vec<Point3>, f64)]) -> Result<Vec<Point3>, AlignmentError> {
    let [(first, _), others @ ..] = poses else {
        return Err(AlignmentError::NoPoints);
    };
    // As offsets from the first, so that where it has all the weight it stays as it is, bit by bit.
    let mut mean = first.clone();
    for (pose, weight) in others {
        let motion = rigid_motion(pose, first)?;
        for ((mean, point), start) in mean.iter_mut().zip(pose).zip(first) {
            *mean += *weight * (motion.apply(point) - start);
        }
    }
    Ok(mean)
}
