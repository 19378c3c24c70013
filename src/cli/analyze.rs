//! `analyze`: measures, distances, maps, patches of the wall, a summary and figures, into one folder.

use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::embedding::MapMethod;
use crate::cli::analyze_pictures::Pictured;
use crate::cli::args::AnalyzeArgs;
use crate::cli::input::{in_unit, interrupted, opened_study, store};
use crate::cli::letters::say_missing_letters;
use crate::cli::measure::say_warnings;
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json, say};
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{
    AnalysisTables, ResultFolder, TableSettings, Unassessed, VerdictQuery, columns_file,
    read_classifier,
};
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
/// If nothing can be opened or written, or it was stopped: what is known by then stands in the folder, and the summary and a
/// line on standard error say what is missing. A figure that cannot be drawn is reported on standard error and left out, and
/// so is a deformation map that there are too few of.
pub(super) fn analyzed(args: &AnalyzeArgs) -> Result<Value, CliError> {
    let study = in_unit(opened_study(&args.study)?, args.unit);
    say_warnings(&study);
    let method = (args.maps.isomap).map_or_else(MapMethod::default, |neighbours| {
        MapMethod::Isomap { neighbours }
    });
    let rule =
        (args.rule.as_deref().map(read_classifier).transpose()).map_err(CliError::Unusable)?;
    let settings = TableSettings {
        deformations: args.maps.settings(&args.metric, method, &study)?,
        verdicts: VerdictQuery {
            thickening: args.patches.settings()?,
            rule: rule.map(Arc::new),
            ..VerdictQuery::default()
        },
        distances: args.distances.into(),
    };
    say_missing_letters(&study);
    let results = Arc::new(ResultFolder::new(args.out.clone()));
    let figures = args.figures == Switch::On;
    let outcome = analyzed_into(&results, &study, settings.clone(), figures);
    if let Err(error) = &outcome {
        let mut expected = settings.expected();
        expected.extend(figures.then(|| "figures".to_owned()));
        expected.extend(["report.pdf", "columns.md"].map(str::to_owned));
        // What cannot be written any more is what the error is about.
        if let Ok(Some(words)) = results.give_up(&expected, &error.to_string()) {
            say(&format!("cardiomorph: {words}"));
        }
    }
    outcome
}

fn analyzed_into(
    results: &Arc<ResultFolder>,
    study: &Arc<Study>,
    settings: TableSettings,
    figures: bool,
) -> Result<Value, CliError> {
    let store = store()?;
    let work = (Arc::clone(&store), Arc::clone(study), Arc::clone(results));
    let of = settings.clone();
    let tables = run_work(move |progress| {
        let (store, study, results) = &work;
        let mut deliver = |files| results.write(files);
        let folder = results.path();
        AnalysisTables::computed(store, study, &of, folder, &mut deliver, progress)
            .map_err(interrupted)
    })?;
    if let Some(reason) = &tables.without_deformations {
        say(&format!("cardiomorph: no deformation map: {reason}"));
    }
    say_unassessed(study, &tables.unassessed);
    let pictured = Pictured {
        study: Arc::clone(study),
        measures: Arc::clone(&tables.measures),
        verdicts: Arc::clone(&tables.verdicts),
        poses: Arc::clone(&tables.poses),
        shares: Arc::clone(&tables.shares),
        deformations: tables.deformations.clone(),
        classes: tables.classes.clone(),
        settings,
        results: Arc::clone(results),
    };
    let drawn = pictured.write(figures, &store)?;
    let columns = columns_file(results.path(), &results.written());
    results.write(vec![columns]).map_err(CliError::Unusable)?;
    let mut summary = tables.summary;
    if let Value::Object(object) = &mut summary {
        object.insert("figures".to_owned(), json!(drawn));
    }
    results.finish(summary).map_err(CliError::Unusable)
}

/// Says how many walls could not be assessed, and why the first of them: the summary has all reasons.
fn say_unassessed(study: &Study, unassessed: &[Unassessed]) {
    if let Some(first) = unassessed.first() {
        let id = (study.subjects.get(first.subject)).map_or("", |subject| &subject.id);
        say(&format!(
            "cardiomorph: {} of {} walls not assessed, such as {}: {}",
            unassessed.len(),
            study.subjects.len(),
            on_one_line(id),
            first.reason
        ));
    }
}
