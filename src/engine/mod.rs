//! Asks a study and keeps the answers; opens, exports. The only room that starts threads.

mod activity;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod engine;
mod export;
#[cfg(test)]
mod facade_tests;
mod job;
mod open;
mod queries;
mod store;
mod tables;
mod wall_tables;
mod workers;

pub use activity::{Activity, ActivityLog, ActivityState, Topic};
pub use engine::{Engine, ExportError};
pub use export::{ExportFile, FileBytes, PassingFile, write_files};
pub use job::{Ending, Job, JobError, JobWatch, Wake};
pub use open::{OpenSource, open};
pub use queries::{
    ClassesError, ClassesSettings, ComparedMethod, Contribution, ContributionError,
    DeformationMapSettings, DeformationsError, DistancesError, FrameThickness, FrameThicknessError,
    InBetweens, InBetweensError, Interval, LookedAt, Measures, MedialBeatError, MedialMapParams,
    MedialMapQueryError, MedialPaths, MedialSurfaces, MethodResult, NoSubject, PoseMap,
    PoseMapError, PoseMapParams, PoseThickness, StudyPaths, SubjectThickening,
    ThickeningQueryError, ThickeningSettings, ThicknessSettings, Transfer, TransferError,
    VerdictSettings, VerdictsError, WallThickening, distance_words, medial_words, metric_words,
    thickening_words,
};
pub use store::{
    Answered, Context, Dependencies, FailedWork, Failure, Interrupted, Memory, Query, SharedError,
    Showing, Store, StoreOptions, Urgency, configure_memory, default_budget,
};
pub use tables::{AnalysisTables, TableSettings};
pub use wall_tables::{TablesError, Unassessed};
pub use workers::configure_threads;
