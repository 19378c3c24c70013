//! All tables of a whole analysis with their summary; the window's export and the command line write these.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::classification::{Classes, ClassesParams};
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::MapMethod;
use crate::analysis::measures::SubjectMeasures;
use crate::engine::cache::Cache;
use crate::engine::export::ExportFile;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{
    AnalysisError, AnalysisRequest, ClassesSettings, DeformationMapSettings, PoseMap,
    PoseMapParams, distance_words,
};
use crate::engine::run::run;
use crate::io::{
    deformations_csv, distances_csv, frames_csv, poses_csv, subjects_csv, summary_json,
};
use crate::progress::Progress;
use crate::study::Study;

/// Share of the work until poses are mapped; the rest tells deformations apart.
const POSES_SHARE: f32 = 0.9;

/// What an analysis of a whole study found.
#[derive(Clone, Debug)]
pub struct AnalysisTables {
    /// The measures, for figures.
    pub measures: Arc<Vec<SubjectMeasures>>,
    /// Name of each file and what it holds.
    pub tables: Vec<(String, String)>,
    /// What `summary.json` says, without the list of files.
    pub summary: Value,
    /// Why there is no map of deformations, where there is none.
    pub without_deformations: Option<String>,
}

impl AnalysisTables {
    /// Does the whole analysis. Poses are mapped by classical scaling, by stress majorisation and by
    /// the method of the settings.
    ///
    /// # Errors
    /// If stopped, or the study has no answer. Too few hearts for a map of deformations are
    /// no error.
    pub fn of(
        study: &Study,
        settings: &DeformationMapSettings,
        cache: &Cache,
        progress: &Progress,
    ) -> Result<Self, AnalysisError> {
        let measures = answered(
            study,
            AnalysisRequest::Measures,
            cache,
            progress,
            |outcome| outcome.measures().cloned(),
        )?;
        let part = progress.part("comparing poses", 0.0, POSES_SHARE);
        let maps = (methods(settings.poses.method).into_iter())
            .map(|(word, method)| {
                let request = AnalysisRequest::PoseMap(PoseMapParams {
                    method,
                    ..settings.poses
                });
                let map = answered(study, request, cache, &part, |outcome| {
                    outcome.pose_map().cloned()
                });
                map.map(|map| (word, map))
            })
            .collect::<Result<Vec<_>, _>>()?;
        let part = progress.part("telling classes apart", POSES_SHARE, 1.0);
        let (told, without_deformations) = match told_apart(study, settings, cache, &part) {
            Ok(told) => (Some(told), None),
            Err(AnalysisError::Stopped(stopped)) => return Err(stopped.into()),
            Err(AnalysisError::Unanswerable(reason)) => (None, Some(reason)),
        };
        let tables = tables(study, &measures, &maps, told.as_ref());
        let embeddings: Vec<_> = maps
            .iter()
            .map(|(word, map)| (*word, &map.embedding))
            .collect();
        let summary = summary_json(
            study,
            &measures,
            &maps[0].1.distances,
            &distance_words(&settings.poses.distances),
            &embeddings,
            told.as_ref().map(|(map, classes)| (&**map, &**classes)),
        );
        Ok(Self {
            measures,
            tables,
            summary,
            without_deformations,
        })
    }

    /// All files for a folder: the tables, `more`, and a summary that lists them.
    ///
    /// # Errors
    /// If the summary cannot be written as JSON.
    pub fn files(
        mut self,
        folder: &Path,
        more: Vec<ExportFile>,
    ) -> Result<(Vec<ExportFile>, Value), String> {
        let mut files: Vec<ExportFile> = (self.tables.into_iter())
            .map(|(name, text)| ExportFile {
                path: folder.join(name),
                bytes: text.into_bytes(),
            })
            .collect();
        files.extend(more);
        let names: Vec<String> = (files.iter())
            .filter_map(|file| file.path.strip_prefix(folder).ok())
            .map(|name| name.display().to_string())
            .collect();
        if let Value::Object(object) = &mut self.summary {
            object.insert("files".to_owned(), json!(names));
        }
        let text =
            serde_json::to_string_pretty(&self.summary).map_err(|error| error.to_string())?;
        files.push(ExportFile {
            path: folder.join("summary.json"),
            bytes: (text + "\n").into_bytes(),
        });
        Ok((files, self.summary))
    }
}

/// Both kinds of scaling, and what the settings ask for beside them, with the word for each.
fn methods(chosen: MapMethod) -> Vec<(&'static str, MapMethod)> {
    let mut methods = vec![
        ("mds", MapMethod::ClassicalMds),
        ("smacof", MapMethod::Smacof),
    ];
    if let MapMethod::Isomap { .. } = chosen {
        methods.push(("isomap", chosen));
    }
    methods
}

/// The map of whole deformations, and what is said of classes by it.
fn told_apart(
    study: &Study,
    settings: &DeformationMapSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<(Arc<DeformationMap>, Arc<Classes>), AnalysisError> {
    let classes = AnalysisRequest::Classes(ClassesSettings {
        deformations: *settings,
        classes: ClassesParams::default(),
    });
    let classes = answered(study, classes, cache, progress, |outcome| {
        outcome.classes().cloned()
    })?;
    // Classes stand on the map, which the cache has by now.
    let map = AnalysisRequest::DeformationMap(*settings);
    let map = answered(study, map, cache, progress, |outcome| {
        outcome.deformation_map().cloned()
    })?;
    Ok((map, classes))
}

fn tables(
    study: &Study,
    measures: &[SubjectMeasures],
    maps: &[(&str, Arc<PoseMap>)],
    told: Option<&(Arc<DeformationMap>, Arc<Classes>)>,
) -> Vec<(String, String)> {
    let distances = &maps[0].1.distances;
    // `measures.csv` is what `subjects.csv` is to `measure`: one table, under the name that a whole
    // analysis promises beside it.
    let subjects = subjects_csv(study, measures);
    let mut tables = vec![
        ("frames.csv".to_owned(), frames_csv(study, measures)),
        ("subjects.csv".to_owned(), subjects.clone()),
        ("measures.csv".to_owned(), subjects),
        ("distances.csv".to_owned(), distances_csv(study, distances)),
    ];
    for (word, map) in maps {
        let table = poses_csv(study, &distances.poses, &map.embedding);
        tables.push((format!("poses_{word}.csv"), table));
    }
    if let Some((map, _)) = told {
        tables.push((
            "deformations_lle.csv".to_owned(),
            deformations_csv(study, map),
        ));
    }
    tables
}

fn answered<T>(
    study: &Study,
    request: AnalysisRequest,
    cache: &Cache,
    progress: &Progress,
    taken: impl Fn(&AnalysisOutcome) -> Option<Arc<T>>,
) -> Result<Arc<T>, AnalysisError> {
    let outcome = run(study, &request, cache, progress)?;
    taken(&outcome)
        .ok_or_else(|| AnalysisError::Unanswerable(format!("{}: no answer", request.name())))
}
