//! Runs requests on a study: jobs, slots, the cache of results. The only room that starts threads.

mod activity;
mod cache;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod engine;
mod export;
#[cfg(test)]
mod facade_tests;
mod job;
mod medial_map;
mod open;
mod outcome;
mod request;
mod run;
mod run_pairs;
mod settings;
mod slot;
mod tables;
mod thickening;
mod thickness;
mod verdicts;
mod wall_tables;
mod workers;

pub use activity::{Activity, ActivityLog, ActivityState, WorkKind};
pub use cache::Cache;
pub use engine::Engine;
pub use export::{ExportFile, FileBytes, PassingFile, write_files};
pub use job::{Ending, Job, JobError, JobWatch, Wake};
pub use medial_map::{MedialMapParams, StudyPaths};
pub use open::{OpenSource, open};
pub use outcome::AnalysisOutcome;
pub use request::{
    AnalysisError, AnalysisRequest, PoseMap, distance_words, medial_words, metric_words,
    thickening_words,
};
pub use run::run;
pub use settings::{ClassesSettings, DeformationMapSettings, PoseMapParams};
pub use slot::{Showing, Slot};
pub use tables::{AnalysisTables, TableSettings};
pub use thickening::{SubjectThickening, ThickeningSettings};
pub use thickness::{FrameThickness, ThicknessSettings, ThicknessWay, WayAnswer};
pub use verdicts::VerdictSettings;
pub use wall_tables::Unassessed;
pub use workers::{Workers, configure_threads};
