//! All tables of a whole analysis with their summary; the window's export and the command line write these.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::classification::{Classes, ClassesParams};
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::MapMethod;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial_map::medial_map;
use crate::analysis::verdicts::{Verdicts, verdicts};
use crate::engine::export::ExportFile;
use crate::engine::queries::{
    ClassesBy, ClassesSettings, DeformationMapSettings, Measures, PoseMap, PoseMapParams,
    VerdictSettings, distance_words,
};
use crate::engine::store::{Interrupted, Store};
use crate::engine::wall_tables::{Unassessed, WallTables};
use crate::progress::Progress;
use crate::report::{AnalysisReport, columns_md, pretty_json};
use crate::study::{LabelRole, Study};

/// Share of the work until poses are mapped; the rest classifies motions …
const POSES_SHARE: f32 = 0.75;
/// … until here, and then assesses walls.
const CLASSES_SHARE: f32 = 0.8;

/// … until here, and then classifies subjects.
const WALLS_SHARE: f32 = 0.99;

/// Settings of an analysis of a whole study.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TableSettings {
    /// How poses and deformations are compared and mapped.
    pub deformations: DeformationMapSettings,
    /// How walls are assessed, and what a verdict is.
    pub verdicts: VerdictSettings,
}

/// Results of the analysis of a whole study.
#[derive(Debug)]
pub struct AnalysisTables {
    /// The measures, for figures.
    pub measures: Arc<Vec<SubjectMeasures>>,
    /// The verdicts, for the report.
    pub verdicts: Arc<Verdicts>,
    /// The pose map by classical scaling.
    pub poses: Arc<PoseMap>,
    /// The deformation map.
    pub deformations: Option<Arc<DeformationMap>>,
    /// Name of each file and what it holds, without those of walls.
    pub tables: Vec<(String, String)>,
    /// Atoms, patches and segments.
    walls: WallTables,
    folder: PathBuf,
    /// What `summary.json` says, without the list of files.
    pub summary: Value,
    /// Why there is no deformation map, where there is none.
    pub without_deformations: Option<String>,
}

impl AnalysisTables {
    /// Does the whole analysis for `folder`. Poses are mapped by classical scaling, by stress majorisation
    /// and by the method of the settings. The table of atoms grows beside its place meanwhile,
    /// since that of a large cohort does not fit into memory.
    ///
    /// # Errors
    /// If stopped, the study has no answer, or the folder cannot be written to. Too few subjects for a
    /// deformation map are no error, and neither are subjects whose wall cannot be assessed.
    pub fn of(
        store: &Store,
        study: &Arc<Study>,
        settings: &TableSettings,
        folder: &Path,
        progress: &Progress,
    ) -> Result<Self, Interrupted> {
        let measures = store.answer(study, &Measures, progress)?;
        let (deformations, folder) = (&settings.deformations, folder.to_owned());
        let part = progress.part("comparing poses", 0.0, POSES_SHARE);
        let maps = (methods(deformations.poses.method).into_iter())
            .map(|(word, method)| {
                let query = PoseMapParams {
                    method,
                    ..deformations.poses
                };
                Ok((word, store.answer(study, &query, &part)?))
            })
            .collect::<Result<Vec<_>, Interrupted>>()?;
        let part = progress.part("classifying motions", POSES_SHARE, CLASSES_SHARE);
        let (classes, without_deformations) = match classified(store, study, deformations, &part) {
            Ok(classes) => (Some(classes), None),
            Err(Interrupted::Stopped) => return Err(Interrupted::Stopped),
            Err(Interrupted::Failed(failure)) => (None, Some(failure.to_string())),
        };
        let part = progress.part("assessing walls", CLASSES_SHARE, WALLS_SHARE);
        let walls = WallTables::of(store, study, &settings.verdicts, &folder, &part)?;
        let part = progress.part("training the classifier", WALLS_SHARE, 1.0);
        let checked = settings.verdicts.verdicts.check()?;
        let verdicts = verdicts(study, &walls.examined, &checked, &part)?;
        let medial = medial_map(&walls.paths, MapMethod::ClassicalMds, &part);
        let medial = match medial.map_err(Interrupted::from) {
            Ok(map) => Ok(map),
            Err(Interrupted::Stopped) => return Err(Interrupted::Stopped),
            Err(Interrupted::Failed(error)) => Err(error.to_string()),
        };
        let report = AnalysisReport {
            study,
            measures: &measures,
            distances: &maps[0].1.distances,
            distance_params: &deformations.poses.distances,
            metric: &distance_words(&deformations.poses.distances),
            maps: (maps.iter())
                .map(|(word, map)| (*word, &map.embedding))
                .collect(),
            deformations: (classes.as_ref()).map(|found| (&*found.map, &*found.classes)),
            classes_by_role: classes.as_ref().and_then(|found| found.by_role.as_deref()),
            verdicts: &verdicts,
            verdict_params: &checked,
            medial_map: medial.as_ref().map_err(String::as_str),
            thickening: &walls.summary,
        };
        let tables = report.tables()?;
        let summary = report.summary();
        Ok(Self {
            measures,
            verdicts: Arc::new(verdicts),
            poses: Arc::clone(&maps[0].1),
            deformations: classes.map(|found| found.map),
            tables,
            walls,
            folder,
            summary,
            without_deformations,
        })
    }

    /// The subjects whose wall could not be assessed, and why.
    pub fn unassessed(&self) -> &[Unassessed] {
        &self.walls.unassessed
    }

    /// All files for the folder: the tables, `more`, and a summary that lists them.
    ///
    /// # Errors
    /// If the summary cannot be written as JSON.
    pub fn files(mut self, more: Vec<ExportFile>) -> Result<(Vec<ExportFile>, Value), String> {
        let folder = &self.folder;
        let mut files: Vec<ExportFile> = (self.tables.into_iter())
            .map(|(name, text)| ExportFile::text(folder, &name, text))
            .collect();
        files.extend(self.walls.files(folder));
        files.extend(more);
        let names_of = |files: &[ExportFile]| -> Vec<String> {
            (files.iter())
                .filter_map(|file| file.path.strip_prefix(folder).ok())
                .map(|name| name.display().to_string())
                .collect()
        };
        let tables = names_of(&files);
        let columns = columns_md(&tables.iter().map(String::as_str).collect::<Vec<_>>());
        files.push(ExportFile::text(folder, "columns.md", columns));
        let names = names_of(&files);
        if let Value::Object(object) = &mut self.summary {
            object.insert("files".to_owned(), json!(names));
        }
        let text = pretty_json(&self.summary).map_err(|error| error.to_string())?;
        files.push(ExportFile::text(folder, "summary.json", text));
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

/// The map of whole deformations, and the classification by it.
struct Classified {
    map: Arc<DeformationMap>,
    classes: Arc<Classes>,
    /// Of normal and abnormal subjects, where the study says which labels are which.
    by_role: Option<Arc<Classes>>,
}

/// Maps the deformations and classifies by them.
fn classified(
    store: &Store,
    study: &Arc<Study>,
    settings: &DeformationMapSettings,
    progress: &Progress,
) -> Result<Classified, Interrupted> {
    let by = |by: ClassesBy| ClassesSettings {
        deformations: *settings,
        classes: ClassesParams::default(),
        by,
    };
    let classes = store.answer(study, &by(ClassesBy::Label), progress)?;
    let with = |role| (study.subjects.iter()).any(|subject| study.role(subject) == role);
    // Several labels may count as abnormal: both questions are asked where the study says which.
    let by_role = (with(LabelRole::Normal) && with(LabelRole::Abnormal))
        .then(|| store.answer(study, &by(ClassesBy::Role), progress))
        .transpose()?;
    // The classification has asked for the map, so it is known by now.
    Ok(Classified {
        map: store.answer(study, settings, progress)?,
        classes,
        by_role,
    })
}
