//! Answers questions about a study in the background and keeps the answers; opens and exports. The only room that
//! starts threads.
//!
//! Begin with the trait [`Query`] and one file of `queries/`, such as `queries/measures.rs`: a query is an analysis with
//! its settings. [`Store`] runs queries and keeps their answers. [`Engine`] is the store of a window with its jobs that
//! read and write files. [`AnalysisTables`] asks for everything that `analyze` writes.

mod activity;
mod classifier_file;
mod distance_table;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod engine;
mod export;
#[cfg(test)]
mod facade_tests;
mod file_names;
mod image_walls;
mod job;
mod mask_walls;
mod open;
mod preparation_file;
mod private_file;
mod queries;
mod reading_limits;
mod registered_walls;
mod result_folder;
mod stages;
mod store;
mod tables;
mod thread_priority;
mod typed_path;
mod wall_tables;
mod workers;

pub use crate::io::mesh_format_names;
pub use activity::{Activity, ActivityLog, ActivityState, Topic};
pub use classifier_file::{classifier_file, read_classifier};
pub use distance_table::DistanceTable;
pub use engine::{Engine, ExportError};
pub use export::{ExportFile, FileBytes, PartialFile, write_files};
pub use file_names::{file_name, file_names};
pub use image_walls::{ImageWallSettings, ImageWalls, image_walls, prepared_subject, series_facts};
pub use job::{Ending, Job, JobError, JobWatch, Wake};
pub use mask_walls::{MaskWallSettings, MaskWalls, mask_walls};
pub use open::{OpenSource, open};
pub use preparation_file::{preparation_file, read_preparations};
pub use private_file::make_private;
pub use queries::*;
pub use reading_limits::{configure_limits, reading_limits};
pub use registered_walls::{
    RegisterSettings, RegisteredWalls, TemplateError, TemplateSource, read_template,
    registered_walls,
};
pub use result_folder::{ResultFolder, replace_results};
pub use stages::Stage;
pub use store::{
    Answered, Context, Dependencies, FailedWork, Interrupted, Memory, Query, SharedError, Showing,
    Store, StoreOptions, Urgency, configure_memory, default_budget,
};
pub use tables::{AnalysisTables, TableSettings, columns_file, tables_of_study};
pub use thread_priority::compute_behind_window;
pub use typed_path::{CompletedPath, completed_path, typed_path};
pub use wall_tables::Unassessed;
pub use workers::configure_threads;
