//! One file per analysis: its settings, which are its question, its answer, its error, and what it asks of others.

mod classes;
mod contribution;
mod deformation_map;
mod interpolated_poses;
mod measures;
mod medial_beat;
mod medial_map;
mod motion_transport;
mod pose_distances;
mod pose_map;
mod subject;
#[cfg(test)]
mod tests;
mod thickening;
mod thickness;
mod verdicts;

pub use classes::{ClassesBy, ClassesError, ClassesSettings};
pub use contribution::{Contribution, ContributionError};
pub use deformation_map::{DeformationMapSettings, DeformationsError};
pub use interpolated_poses::{InterpolatedPoses, InterpolatedPosesError, Interval, LookedAt};
pub use measures::Measures;
pub use medial_beat::{MedialBeatError, MedialSurfaces, medial_words};
pub use medial_map::{
    MedialMapParams, MedialMapQueryError, MedialPaths, StudyPaths, map_of, paths_of,
};
pub use motion_transport::{MotionTransport, MotionTransportError};
pub use pose_distances::{DistancesError, distance_words, metric_words};
pub use pose_map::{PoseMap, PoseMapError, PoseMapParams};
pub use subject::NoSubject;
pub use thickening::{
    SubjectThickening, ThickeningQueryError, ThickeningSettings, WallThickening, thickening_words,
};
pub use thickness::{
    ComparedMethod, FrameThickness, FrameThicknessError, MethodResult, PoseThickness,
    ThicknessSettings,
};
pub use verdicts::{VerdictSettings, VerdictsError, examined, verdicts_of};
