//! Paths of poses and their map, as plain values.

use crate::analysis::embedding::{Embedding, EmbeddingError};
use crate::analysis::medial_space::PoseDescriptor;
use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::Stopped;

use super::placement::{Frame, Placement};

/// The part of a wall whose poses make a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AkineticPart {
    /// All that is akinetic in a step, M̂ of 4.4: what the method takes where there is no patch.
    Whole,
    /// One connected part that does not thicken over the beat (4.6.2), by its place in the list of patches.
    Patch(usize),
}

impl AkineticPart {
    /// Its place in the list of patches.
    pub fn patch(self) -> Option<usize> {
        match self {
            Self::Whole => None,
            Self::Patch(patch) => Some(patch),
        }
    }
}

/// One point of a path: a step of the beat with its descriptor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathStep {
    /// Pose t₁, at which positions and normals are taken.
    pub from: usize,
    /// Pose t₂.
    pub to: usize,
    /// (x̄, r̂, ρ, N̄) in the coordinates of the subject.
    pub descriptor: PoseDescriptor,
}

/// The path of one part over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct AkineticPath {
    /// Which part.
    pub part: AkineticPart,
    /// By rising [`PathStep::from`]; steps without descriptor are left out.
    pub steps: Vec<PathStep>,
}

/// What one subject adds to the map.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectPaths {
    /// One per patch, or that of M̂.
    pub paths: Vec<AkineticPath>,
    /// How the subject's coordinates become comparable, for each [`Frame`] that it has.
    pub placements: [Option<Placement>; Frame::COUNT],
}

/// Why a subject is not on the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotMapped {
    /// All of the wall changes in every step.
    #[error("no atom is akinetic in any of {steps} steps")]
    NothingAkinetic {
        /// Steps of the beat.
        steps: usize,
    },
    /// The subject has no extent.
    #[error("the medial surface has no extent")]
    NoSize,
}

/// What a point of the map is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MedialPose {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Which part of its wall.
    pub part: AkineticPart,
    /// Pose t₁ of the step.
    pub step_from: usize,
    /// Pose t₂.
    pub step_to: usize,
    /// (x̄, r̂, ρ, N̄) in the map's frame: positions from the middle of the subject's box, in its largest side.
    pub descriptor: PoseDescriptor,
}

/// How far the poses of one path lie from each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Which part of its wall.
    pub part: AkineticPart,
    /// Mean distance 4.5.1 of two poses of the path; `None` with one pose.
    pub mean_distance: Option<f64>,
}

/// The pose map of the medial shape space.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialMap {
    /// What each row is; paths follow each other, by subject, part and step.
    pub poses: Vec<MedialPose>,
    /// Distances 4.5.1 of all of them.
    pub distances: DistanceMatrix,
    /// Their places.
    pub embedding: Embedding,
    /// How steady each path is, in the order of paths.
    pub spreads: Vec<Spread>,
    /// In which axes positions and normals were compared.
    pub frame: Frame,
    /// Subjects that are not on the map, with the reason in words.
    pub left_out: Vec<(usize, String)>,
}

/// Why there is no map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MedialMapError {
    /// Two points make no map.
    #[error(
        "{poses} poses of {hearts} subjects whose wall can be assessed: a map needs at least three"
    )]
    TooFewPoses {
        /// Points there would be.
        poses: usize,
        /// Subjects that have any.
        hearts: usize,
    },
    /// A descriptor is not finite.
    #[error("a pose of subject {subject} has no finite distance from another")]
    NotFinite {
        /// Index into the study's subjects.
        subject: usize,
    },
    /// The method of mapping failed.
    #[error(transparent)]
    Embedding(EmbeddingError),
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
}
