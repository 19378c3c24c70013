//! All tables of a whole analysis with their summary; the window's export and the command line write these.

use std::path::Path;
use std::sync::Arc;

use serde_json::Value;

use crate::analysis::classification::{Classes, ClassesParams};
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::{MapMethod, PoseMap};
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial_map::medial_map;
use crate::analysis::pose_distances::BeatShares;
use crate::analysis::verdicts::{Verdicts, verdicts};
use crate::engine::distance_table::{DistanceTable, distance_files};
use crate::engine::export::ExportFile;
use crate::engine::queries::{
    BeatSharesQuery, ClassesBy, ClassesQuery, DeformationMapQuery, MeasuresQuery, PoseMapQuery,
    VerdictQuery, deformation_words, distance_words,
};
use crate::engine::result_folder::{complete, name_in};
use crate::engine::store::{Interrupted, Store};
use crate::engine::wall_tables::{AssessedWalls, Unassessed, WallTables, WriteError};
use crate::progress::Progress;
use crate::report::{
    AnalysisReport, DeformationRow, FrameRow, MedialPoseRow, PoseRow, Row, SubjectRow, VerdictRow,
    columns_md, csv, named_csv, pretty_json,
};
use crate::study::Study;

/// Share of the work that is done when poses are mapped.
const POSES_SHARE: f32 = 0.75;
/// Share of the work that is done when motions are classified.
const CLASSES_SHARE: f32 = 0.8;
/// Share of the work that is done when walls are assessed; the rest classifies subjects.
const WALLS_SHARE: f32 = 0.99;

/// Settings of an analysis of a whole study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableSettings {
    /// How poses and deformations are compared and mapped.
    pub deformations: DeformationMapQuery,
    /// How walls are assessed, and what a verdict is and by which classifier.
    pub verdicts: VerdictQuery,
    /// How distances of poses are written.
    pub distances: DistanceTable,
}

impl TableSettings {
    /// Names of all tables of an analysis with these settings.
    pub fn expected(&self) -> Vec<String> {
        let methods = methods(self.deformations.poses.method);
        let maps = methods.iter().map(|(word, _)| format!("poses_{word}.csv"));
        let before = ["frames.csv", "subjects.csv", "measures.csv"].into_iter();
        let distances = self.distances.file().map(|file| [file, "distances.json"]);
        let behind = [
            "deformations_lle.csv",
            "atoms.csv",
            "patches.csv",
            "patch_segments.csv",
            "segments.csv",
            "verdicts.csv",
            "medial_mds.csv",
        ];
        (before.chain(distances.into_iter().flatten()))
            .map(str::to_owned)
            .chain(maps)
            .chain(behind.map(str::to_owned))
            .collect()
    }
}

/// Results of the analysis of a whole study, whose tables are delivered already.
#[derive(Debug)]
pub struct AnalysisTables {
    /// The measures, for figures.
    pub measures: Arc<Vec<SubjectMeasures>>,
    /// The verdicts, for the report.
    pub verdicts: Arc<Verdicts>,
    /// The pose map by classical scaling.
    pub poses: Arc<PoseMap>,
    /// What distances within beats are made of.
    pub shares: Arc<BeatShares>,
    /// The deformation map.
    pub deformations: Option<Arc<DeformationMap>>,
    /// How well the labels are classified on it.
    pub classes: Option<Arc<Classes>>,
    /// The subjects whose wall could not be assessed, and why.
    pub unassessed: Vec<Unassessed>,
    /// What `summary.json` says, without the list of files.
    pub summary: Value,
    /// Why there is no deformation map, where there is none.
    pub without_deformations: Option<String>,
}

/// Takes the files of one part of an analysis; the words of an error name the file.
pub type Deliver<'a> = dyn FnMut(Vec<ExportFile>) -> Result<(), String> + 'a;

impl AnalysisTables {
    /// Does the whole analysis for `folder` and delivers each table as soon as it is known. Poses are mapped by classical
    /// scaling, by stress majorisation and by the method of the settings. The tables of atoms and of distances grow beside
    /// their place, since those of a large cohort do not fit into memory.
    ///
    /// # Errors
    /// If stopped, the study has no answer, or the folder cannot be written to; what was delivered stays. Too few subjects
    /// for a deformation map are no error, and neither are subjects whose wall cannot be assessed.
    pub fn computed(
        store: &Store,
        study: &Arc<Study>,
        settings: &TableSettings,
        folder: &Path,
        deliver: &mut Deliver<'_>,
        progress: &Progress,
    ) -> Result<Self, Interrupted> {
        let mut run = Run {
            store,
            study,
            settings,
            folder,
            deliver,
        };
        let measures = store.answer(study, &MeasuresQuery, progress)?;
        run.hand_over(measure_files(study, &measures, folder))?;
        let deformations = &settings.deformations;
        let maps = run.pose_maps(&progress.part("comparing poses", 0.0, POSES_SHARE))?;
        let part = progress.part("classifying motions", POSES_SHARE, CLASSES_SHARE);
        let classes = or_why(classified(store, study, deformations, &part))?;
        if let Ok(found) = &classes {
            let rows = DeformationRow::of_map(study, &found.map);
            run.hand_over(tables_of(&rows, folder))?;
        }
        let walls = run.walls(&progress.part("assessing walls", CLASSES_SHARE, WALLS_SHARE))?;
        let part = progress.part("training the classifier", WALLS_SHARE, 1.0);
        let checked = settings.verdicts.verdicts.check()?;
        let classifier = settings.verdicts.rule.as_deref();
        let verdicts = verdicts(study, &walls.examined, &checked, classifier, &part)?;
        let medial = medial_map(&walls.paths, MapMethod::ClassicalMds, &part);
        let medial = or_why(medial.map_err(Interrupted::from))?;
        let rows = VerdictRow::of_study(study, &verdicts);
        let rows = VerdictRow::with_measures(rows, &measures);
        run.hand_over(tables_of(&rows, folder))?;
        let places = MedialPoseRow::of_map(study, medial.as_ref().ok());
        run.hand_over(tables_of(&places, folder))?;
        let distances = &deformations.poses.distances;
        let shares = store.answer(study, &BeatSharesQuery(*distances), &part)?;
        let without_deformations = classes.as_ref().err().cloned();
        let classes = classes.ok();
        let report = AnalysisReport {
            study,
            measures: &measures,
            distances: &maps[0].1.distances,
            metric: &distance_words(distances),
            shares: (&*shares, distances.metric.kind),
            comparison: &deformation_words(deformations),
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
        let summary = report.summary();
        Ok(Self {
            measures,
            verdicts: Arc::new(verdicts),
            poses: Arc::clone(&maps[0].1),
            shares,
            classes: classes.as_ref().map(|found| Arc::clone(&found.classes)),
            deformations: classes.map(|found| found.map),
            unassessed: walls.unassessed,
            summary,
            without_deformations,
        })
    }
}

/// An analysis under way, and where its tables go.
struct Run<'a, 'd> {
    store: &'a Store,
    study: &'a Arc<Study>,
    settings: &'a TableSettings,
    folder: &'a Path,
    deliver: &'a mut Deliver<'d>,
}

impl Run<'_, '_> {
    fn hand_over(&mut self, files: Vec<ExportFile>) -> Result<(), WriteError> {
        (self.deliver)(files).map_err(WriteError)
    }

    /// The map of poses by each method with its word, classical scaling first, and their distances.
    fn pose_maps(
        &mut self,
        part: &Progress,
    ) -> Result<Vec<(&'static str, Arc<PoseMap>)>, Interrupted> {
        let poses = self.settings.deformations.poses;
        let mut maps = Vec::new();
        for (word, method) in methods(poses.method) {
            let query = PoseMapQuery { method, ..poses };
            let map = self.store.answer(self.study, &query, part)?;
            if maps.is_empty() {
                let (table, params) = (self.settings.distances, &poses.distances);
                let files = distance_files(self.study, &map, table, params, self.folder, part)?;
                self.hand_over(files)?;
            }
            let rows = PoseRow::of_map(self.study, &map.distances.poses, &map.embedding);
            let name = format!("poses_{word}.csv");
            self.hand_over(vec![ExportFile::text(self.folder, &name, csv(&rows))])?;
            maps.push((word, map));
        }
        Ok(maps)
    }

    /// The walls of all subjects, one after the other.
    fn walls(&mut self, part: &Progress) -> Result<AssessedWalls, Interrupted> {
        let mut walls = WallTables::new(self.study, self.folder)?;
        if let Err(why) = walls.assess(self.store, self.study, &self.settings.verdicts, part) {
            // What is known of the subjects before stays, under names that say how many they are.
            self.hand_over(walls.partial_files(self.folder))?;
            return Err(why);
        }
        let (files, walls) = walls.files(self.folder);
        self.hand_over(files.into())?;
        Ok(walls)
    }
}

/// An answer, or why there is none; who was stopped has neither.
fn or_why<T>(answer: Result<T, Interrupted>) -> Result<Result<T, String>, Interrupted> {
    match answer {
        Ok(answer) => Ok(Ok(answer)),
        Err(Interrupted::Failed(error)) => Ok(Err(error.to_string())),
        Err(Interrupted::Stopped) => Err(Interrupted::Stopped),
    }
}

/// The dictionary of the columns of tables with these names, as a file.
pub fn columns_file(folder: &Path, names: &[String]) -> ExportFile {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    ExportFile::text(folder, "columns.md", columns_md(&names))
}

/// All tables of a study with their summary, to be put into the folder at once by [`replace_results`](crate::engine::replace_results).
///
/// # Errors
/// As [`AnalysisTables::computed()`].
pub fn tables_of_study(
    store: &Store,
    study: &Arc<Study>,
    settings: &TableSettings,
    folder: &Path,
    progress: &Progress,
) -> Result<Vec<ExportFile>, Interrupted> {
    let mut files = Vec::new();
    let mut keep = |more: Vec<ExportFile>| {
        files.extend(more);
        Ok(())
    };
    let tables = AnalysisTables::computed(store, study, settings, folder, &mut keep, progress)?;
    let names = |files: &[ExportFile]| -> Vec<String> {
        let names = files.iter();
        names
            .filter_map(|file| name_in(folder, &file.path))
            .collect()
    };
    files.push(columns_file(folder, &names(&files)));
    let mut summary = tables.summary;
    complete(&mut summary, &names(&files));
    files.push(ExportFile::text(
        folder,
        "summary.json",
        pretty_json(&summary)?,
    ));
    Ok(files)
}

/// `frames.csv`, `subjects.csv` and its older name.
fn measure_files(study: &Study, measures: &[SubjectMeasures], folder: &Path) -> Vec<ExportFile> {
    let mut files = tables_of(&FrameRow::of_frames(study, measures), folder);
    files.extend(tables_of(&SubjectRow::of_study(study, measures), folder));
    files
}

fn tables_of<R: Row>(rows: &[R], folder: &Path) -> Vec<ExportFile> {
    named_csv(rows)
        .map(|(name, text)| ExportFile::text(folder, &name, text))
        .collect()
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
    settings: &DeformationMapQuery,
    progress: &Progress,
) -> Result<Classified, Interrupted> {
    let by = |by: ClassesBy| ClassesQuery {
        deformations: *settings,
        classes: ClassesParams::default(),
        by,
    };
    let classes = store.answer(study, &by(ClassesBy::Label), progress)?;
    // Several labels may count as abnormal: both questions are asked where the study says which.
    let by_role = (study.has_both_classes())
        .then(|| store.answer(study, &by(ClassesBy::Class), progress))
        .transpose()?;
    // The classification has asked for the map, so it is known by now.
    Ok(Classified {
        map: store.answer(study, settings, progress)?,
        classes,
        by_role,
    })
}
