//! Opens the study that a command works on.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::cli::outcome::CliError;
use crate::cli::print::say;
use crate::cli::work::run_work;
use crate::engine::{AnalysisOutcome, AnalysisRequest, Cache, OpenSource, open, run};
use crate::io::{Limits, Opened};
use crate::study::Study;

/// Opens paths, or the built-in cohort if there are none, and says what could not be read.
///
/// # Errors
/// If nothing could be read.
pub(super) fn opened_study(paths: &[PathBuf]) -> Result<Arc<Study>, CliError> {
    let opened = opened(paths)?;
    for error in &opened.errors {
        say(&format!("cardiomorph: {error}"));
    }
    if opened.study.subjects.is_empty() {
        return Err(CliError::Unusable(match opened.errors.len() {
            0 => "no meshes were found".to_owned(),
            _ => "nothing could be opened".to_owned(),
        }));
    }
    Ok(Arc::new(opened.study))
}

/// Opens paths, or the built-in cohort if there are none.
///
/// # Errors
/// If stopped.
pub(super) fn opened(paths: &[PathBuf]) -> Result<Opened, CliError> {
    let source = OpenSource::paths_or_built_in(paths.to_vec());
    run_work(move |progress| open(&source, &Limits::default(), progress))
}

/// Asks the engine, with a progress bar.
///
/// # Errors
/// If stopped, or the study cannot answer.
pub(super) fn answered(
    study: &Arc<Study>,
    request: AnalysisRequest,
    cache: &Arc<Cache>,
) -> Result<AnalysisOutcome, CliError> {
    let (study, cache) = (Arc::clone(study), Arc::clone(cache));
    run_work(move |progress| run(&study, &request, &cache, progress))
}

/// The measures of every subject.
///
/// # Errors
/// If stopped.
pub(super) fn measured(
    study: &Arc<Study>,
    cache: &Arc<Cache>,
) -> Result<Arc<Vec<SubjectMeasures>>, CliError> {
    let outcome = answered(study, AnalysisRequest::Measures, cache)?;
    match outcome.measures() {
        Some(measures) => Ok(Arc::clone(measures)),
        None => Err(CliError::Unusable("the measures are missing".to_owned())),
    }
}
