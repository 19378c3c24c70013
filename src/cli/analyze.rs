//! `analyze`: measures, distances, maps, patches of the wall, a summary and figures, into one folder.

use std::sync::Arc;

use serde_json::Value;

use crate::analysis::embedding::MapMethod;
use crate::cli::analyze_pictures::Pictured;
use crate::cli::args::AnalyzeArgs;
use crate::cli::input::{in_unit, interrupted, opened_study, store};
use crate::cli::measure::say_warnings;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json, say};
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{AnalysisTables, TableSettings, Unassessed, VerdictSettings, write_files};
use crate::study::Study;

pub(super) fn analyze(args: &AnalyzeArgs) -> Result<(), CliError> {
    let summary = analyzed(args)?;
    if args.json {
        return print_json(&summary);
    }
    print(&args.out.display().to_string())
}

/// Does the whole analysis into the folder and returns the summary that it wrote there.
///
/// # Errors
/// If nothing can be opened or written, or it was stopped. A figure that cannot be drawn is reported
/// on standard error and left out, and so is a deformation map that there are too few of.
pub(super) fn analyzed(args: &AnalyzeArgs) -> Result<Value, CliError> {
    let folder = args.out.as_path();
    let study = in_unit(opened_study(&args.study)?, args.unit);
    say_warnings(&study);
    let method = (args.maps.isomap).map_or_else(MapMethod::default, |neighbours| {
        MapMethod::Isomap { neighbours }
    });
    let settings = TableSettings {
        deformations: args.maps.settings(&args.metric, method, &study)?,
        verdicts: VerdictSettings {
            thickening: args.patches.settings()?,
            ..VerdictSettings::default()
        },
    };
    let (work_study, work_folder) = (Arc::clone(&study), folder.to_owned());
    let store = store()?;
    let work_store = Arc::clone(&store);
    let tables = run_work(move |progress| {
        AnalysisTables::of(&work_store, &work_study, &settings, &work_folder, progress)
            .map_err(interrupted)
    })?;
    if let Some(reason) = &tables.without_deformations {
        say(&format!("cardiomorph: no deformation map: {reason}"));
    }
    say_unassessed(&study, tables.unassessed());
    let pictured = Pictured {
        study: Arc::clone(&study),
        measures: Arc::clone(&tables.measures),
        verdicts: Arc::clone(&tables.verdicts),
        poses: Arc::clone(&tables.poses),
        deformations: tables.deformations.clone(),
        settings,
        folder: folder.to_owned(),
    };
    let drawn = pictured.files(args.figures == Switch::On, &store)?;
    let (files, summary) = tables.files(drawn).map_err(CliError::Unusable)?;
    write_files(files).map_err(CliError::Unusable)?;
    Ok(summary)
}

/// Says how many walls could not be assessed, and why the first of them: the summary has all reasons.
fn say_unassessed(study: &Study, unassessed: &[Unassessed]) {
    if let Some(first) = unassessed.first() {
        let id = (study.subjects.get(first.subject)).map_or("", |subject| &subject.id);
        say(&format!(
            "cardiomorph: {} of {} walls not assessed, such as {id}: {}",
            unassessed.len(),
            study.subjects.len(),
            first.reason
        ));
    }
}
