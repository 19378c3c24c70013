//! Runs requests on a study: jobs, slots, the cache of results. The only room that starts threads.

mod activity;
mod cache;
//TMPX #[expect(
//TMPX     clippy::module_inception,
//TMPX     reason = "the room's main type carries the room's name"
//TMPX )]
//TMP mod engine;
mod export;
mod job;
//TMP mod open;
mod request;
//TMP mod run;
mod slot;
mod workers;

pub use activity::{Activity, ActivityLog, ActivityState, WorkKind};
pub use cache::Cache;
//TMP pub use engine::Engine;
pub use export::{ExportFile, write_files};
pub use job::{Ending, Job, JobError, JobWatch, Wake};
//TMP pub use open::{OpenSource, open};
pub use request::{
    AnalysisError, AnalysisOutcome, AnalysisRequest, PoseMap, PoseMapParams, metric_words,
};
//TMP pub use run::run;
pub use slot::{Showing, Slot};
pub use workers::{Workers, configure_threads};
