//! `analyze`: measures, distances, maps, patches of the wall, a summary and figures, into one folder.

use std::path::Path;
use std::sync::Arc;

use serde_json::Value;

use crate::analysis::embedding::MapMethod;
use crate::analysis::measures::SubjectMeasures;
use crate::cli::args::AnalyzeArgs;
use crate::cli::figure::{Shot, Studio};
use crate::cli::input::opened_study;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json, say};
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{
    AnalysisTables, Cache, ExportFile, TableSettings, ThickeningSettings, Unassessed,
    VerdictSettings, write_files,
};
use crate::picture::page::PageFormat;
use crate::picture::{PictureTheme, Quantity, SceneSettings};
use crate::study::Study;

/// Size of the figures of a report: two side by side on a page at 300 dots per inch.
const FIGURE_SIZE: [u32; 2] = [1000, 750];

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
/// If nothing can be opened or written, or it was stopped. A figure that cannot be drawn is said
/// on standard error and left out, and so is a map of deformations that there are too few of.
pub(super) fn analyzed(args: &AnalyzeArgs) -> Result<Value, CliError> {
    let folder = args.out.as_path();
    let study = opened_study(&args.study)?;
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
    let tables = run_work(move |progress| {
        let cache = Cache::default();
        AnalysisTables::of(&work_study, &settings, &work_folder, &cache, progress)
    })?;
    if let Some(reason) = &tables.without_deformations {
        say(&format!("cardiomorph: no map of deformations: {reason}"));
    }
    say_unassessed(&study, tables.unassessed());
    let mut drawn = Vec::new();
    if args.figures == Switch::On {
        match figures(&study, &tables.measures, folder) {
            Ok(figures) => drawn = figures,
            Err(error @ CliError::Stopped(_)) => return Err(error),
            Err(error) => say(&format!("cardiomorph: no figures: {error}")),
        }
    }
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

/// One figure per subject: end-systole, coloured by the way that each place has come since
/// end-diastole.
fn figures(
    study: &Arc<Study>,
    measures: &Arc<Vec<SubjectMeasures>>,
    folder: &Path,
) -> Result<Vec<ExportFile>, CliError> {
    let (study, measures) = (Arc::clone(study), Arc::clone(measures));
    let folder = folder.join("figures");
    run_work(move |progress| -> Result<Vec<ExportFile>, CliError> {
        progress.begin_phase("drawing figures", 0.0, 1.0);
        progress.expect_steps(study.subjects.len());
        let mut studio = Studio::open(&study, &measures)?;
        let settings = SceneSettings {
            quantity: Quantity::Displacement,
            theme: PictureTheme::LIGHT,
            ..studio.settings()
        };
        let mut files = Vec::with_capacity(study.subjects.len());
        for (index, subject) in study.subjects.iter().enumerate() {
            let measured = measures
                .get(index)
                .and_then(|measures| measures.end_systole);
            let last = subject.sequence.frame_count() - 1;
            let systole = measured.or(subject.end_systole).unwrap_or(last).min(last);
            let shot = Shot {
                index,
                frame: systole,
                view: None,
                size: FIGURE_SIZE,
                thickening: ThickeningSettings::default(),
            };
            let figure = studio.figure(&shot, settings, None)?;
            files.push(ExportFile {
                path: folder.join(format!("{}.png", file_name(&subject.id))),
                bytes: (PageFormat::Png.file(&figure.page, &figure.settings, &studio.fonts))
                    .map_err(CliError::unusable)?
                    .into(),
            });
            progress.step()?;
        }
        Ok(files)
    })
}

/// An id as the name of a file: whatever could lead elsewhere becomes a dash.
fn file_name(id: &str) -> String {
    let plain = |letter: char| letter.is_alphanumeric() || "-_. ".contains(letter);
    let name: String = id.chars().map(|c| if plain(c) { c } else { '-' }).collect();
    name.trim_start_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_cannot_lead_out_of_the_folder() {
        assert_eq!(file_name("../../etc/passwd"), "-..-etc-passwd");
        assert_eq!(file_name("P-041"), "P-041");
    }
}
