//! `analyze`: measures, distances, the map of poses, a summary and figures, into one folder.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::classification::{Classes, ClassesParams};
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::MapMethod;
use crate::analysis::measures::SubjectMeasures;
use crate::cli::args::AnalyzeArgs;
use crate::cli::figure::Studio;
use crate::cli::input::{answered, measured, opened_study};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json, say};
use crate::cli::tables;
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{
    AnalysisRequest, Cache, ClassesSettings, DeformationMapSettings, ExportFile, PoseMap,
    PoseMapParams, metric_words, write_files,
};
use crate::io::summary_json;
use crate::picture::figure::encoded_png;
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
    let settings = |method| args.maps.settings(&args.metric, method, &study);
    let cache = Arc::new(Cache::default());
    let default = settings(MapMethod::default())?;
    let measures = measured(&study, &cache)?;
    let mut methods = vec![
        ("mds", MapMethod::ClassicalMds),
        ("smacof", MapMethod::Smacof),
    ];
    methods.extend(
        args.maps
            .isomap
            .map(|neighbours| ("isomap", MapMethod::Isomap { neighbours })),
    );
    let mut maps = Vec::new();
    for (word, method) in methods {
        maps.push((word, mapped(&study, settings(method)?.poses, &cache)?));
    }
    let distances = Arc::clone(&maps[0].1.distances);
    let deformations = told_apart(&study, default, &cache)?;
    let mut files = tables::measure_files(&study, &measures, folder);
    files.push(tables::measures_file(&study, &measures, folder));
    files.push(tables::distances_file(&study, &distances, folder));
    files.extend(
        maps.iter()
            .map(|(word, map)| tables::poses_file(&study, word, map, folder)),
    );
    if let Some((map, _)) = &deformations {
        files.push(tables::deformations_file(&study, map, folder));
    }
    let embeddings: Vec<_> = maps
        .iter()
        .map(|(word, map)| (*word, &map.embedding))
        .collect();
    let mut summary = summary_json(
        &study,
        &measures,
        &distances,
        &metric_words(&default.poses.distances.metric),
        &embeddings,
        deformations
            .as_ref()
            .map(|(map, classes)| (&**map, &**classes)),
    );
    if args.figures == Switch::On {
        match figures(&study, &measures, folder) {
            Ok(figures) => files.extend(figures),
            Err(error @ CliError::Stopped(_)) => return Err(error),
            Err(error) => say(&format!("cardiomorph: no figures: {error}")),
        }
    }
    let names: Vec<String> = files
        .iter()
        .filter_map(|file| file.path.strip_prefix(folder).ok())
        .map(|name| name.display().to_string())
        .collect();
    if let Value::Object(object) = &mut summary {
        object.insert("files".to_owned(), json!(names));
    }
    files.push(ExportFile {
        path: folder.join("summary.json"),
        bytes: pretty(&summary)?,
    });
    write_files(&files).map_err(CliError::Unusable)?;
    Ok(summary)
}

/// The map of all poses; the second one finds the distances of the first in the cache.
fn mapped(
    study: &Arc<Study>,
    params: PoseMapParams,
    cache: &Arc<Cache>,
) -> Result<Arc<PoseMap>, CliError> {
    let outcome = answered(study, AnalysisRequest::PoseMap(params), cache)?;
    let map = outcome.pose_map().cloned();
    map.ok_or_else(|| CliError::Unusable("the map of poses is missing".to_owned()))
}

/// The map of whole deformations with what is said of classes by it; `None`, with a word on standard
/// error, where there are too few.
fn told_apart(
    study: &Arc<Study>,
    settings: DeformationMapSettings,
    cache: &Arc<Cache>,
) -> Result<Option<(Arc<DeformationMap>, Arc<Classes>)>, CliError> {
    let classes = ClassesSettings {
        deformations: settings,
        classes: ClassesParams::default(),
    };
    // Classes stand on the map, so that the second answer comes from the cache.
    let told = answered(study, AnalysisRequest::Classes(classes), cache).and_then(|told| {
        Ok((
            told,
            answered(study, AnalysisRequest::DeformationMap(settings), cache)?,
        ))
    });
    match told {
        Ok((told, map)) => Ok(map.deformation_map().cloned().zip(told.classes().cloned())),
        Err(error @ CliError::Stopped(_)) => Err(error),
        Err(error) => {
            say(&format!("cardiomorph: no map of deformations: {error}"));
            Ok(None)
        }
    }
}

fn pretty(value: &Value) -> Result<Vec<u8>, CliError> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(CliError::unusable)?;
    bytes.push(b'\n');
    Ok(bytes)
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
            let figure = studio.figure(index, systole, settings, None, FIGURE_SIZE)?;
            files.push(ExportFile {
                path: folder.join(format!("{}.png", file_name(&subject.id))),
                bytes: encoded_png(&figure.canvas, &figure.settings).map_err(CliError::unusable)?,
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
