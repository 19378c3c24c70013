//! Opens the study that a command works on.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, say};
use crate::cli::words::UnitWord;
use crate::cli::work::run_work;
use crate::engine::{
    Interrupted, MeasuresQuery, OpenSource, Query, Store, StoreOptions, open, reading_limits,
};
use crate::io::{Opened, OpenedImages};
use crate::progress::Stopped;
use crate::study::{Severity, Study};
use crate::units::LengthUnit;

/// Opens paths, or the built-in cohort if there are none, and says what could not be read and what is odd about the study as
/// a whole.
///
/// # Errors
/// If nothing could be read.
pub(super) fn opened_study(paths: &[PathBuf]) -> Result<Arc<Study>, CliError> {
    let opened = opened(paths)?;
    for error in &opened.errors {
        say(&format!("cardiomorph: {error}"));
    }
    let odd = (opened.notices.iter()).filter(|notice| notice.severity == Severity::Warning);
    for notice in odd {
        say(&format!("cardiomorph: warning: {}", notice.text));
    }
    for images in without_walls(&opened) {
        for notice in &images.notices {
            say(&format!(
                "cardiomorph: {}: {}",
                on_one_line(&images.id),
                notice.text
            ));
        }
    }
    if opened.study.subjects.is_empty() {
        return Err(CliError::Unusable(match opened.errors.len() {
            0 => nothing_found(&opened).to_owned(),
            _ => "nothing could be opened".to_owned(),
        }));
    }
    Ok(Arc::new(opened.study))
}

/// Images that gave no walls; their notes say what they need.
pub(super) fn without_walls(opened: &Opened) -> impl Iterator<Item = &OpenedImages> {
    opened.images.iter().filter(|images| images.made.is_none())
}

/// What is said where nothing is wrong, and there is no subject.
pub(super) fn nothing_found(opened: &Opened) -> &'static str {
    match opened.images.is_empty() {
        true => "no meshes were found",
        false => "no walls could be made of the images",
    }
}

/// The study with the unit of length that the command line states, for all subjects.
pub(super) fn in_unit(study: Arc<Study>, unit: Option<UnitWord>) -> Arc<Study> {
    let unit = match unit {
        None => return study,
        Some(UnitWord::Mm) => LengthUnit::Millimetre,
        Some(UnitWord::File) => LengthUnit::FileUnit,
    };
    let mut stated = Study::clone(&study);
    let excluded = stated.excluded.iter_mut();
    let excluded = excluded.map(|excluded| &mut excluded.subject);
    for subject in stated.subjects.iter_mut().chain(excluded) {
        Arc::make_mut(subject).unit = unit;
    }
    Arc::new(stated)
}

/// Opens paths, or the built-in cohort if there are none.
///
/// # Errors
/// If stopped.
pub(super) fn opened(paths: &[PathBuf]) -> Result<Opened, CliError> {
    let source = OpenSource::paths_or_built_in(paths.to_vec());
    run_work(move |progress| open(&source, &reading_limits(), progress))
}

/// A store for one command.
///
/// # Errors
/// If the operating system refuses a thread.
pub(super) fn store() -> Result<Arc<Store>, CliError> {
    let store = Store::start(StoreOptions::default());
    Ok(Arc::new(store.map_err(CliError::unusable)?))
}

/// Asks the store, with a progress bar.
///
/// # Errors
/// If stopped, or the study cannot answer.
pub(super) fn answered<Q: Query>(
    store: &Arc<Store>,
    study: &Arc<Study>,
    query: &Q,
) -> Result<Arc<Q::Answer>, CliError> {
    let (store, study, query) = (Arc::clone(store), Arc::clone(study), query.clone());
    run_work(move |progress| store.answer(&study, &query, progress).map_err(interrupted))
}

/// Why a question has no answer, as a command says it.
pub(super) fn interrupted(why: Interrupted) -> CliError {
    match why {
        Interrupted::Stopped => CliError::Stopped(Stopped),
        Interrupted::Failed(error) => CliError::unusable(error),
    }
}

/// The measures of every subject.
///
/// # Errors
/// If stopped.
pub(super) fn measured(
    store: &Arc<Store>,
    study: &Arc<Study>,
) -> Result<Arc<Vec<SubjectMeasures>>, CliError> {
    answered(store, study, &MeasuresQuery)
}
