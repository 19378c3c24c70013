//! Runs requests on a study: jobs, slots, the cache of results. The only room that starts threads.

mod job;
mod request;
mod slot;
mod workers;

pub use job::{Job, JobError, Wake};
pub use request::{AnalysisError, AnalysisOutcome, AnalysisRequest, PoseMap, PoseMapParams};
pub use slot::{Showing, Slot};
pub use workers::Workers;
