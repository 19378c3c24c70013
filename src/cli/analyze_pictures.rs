//! What `analyze` draws: a figure of every subject, patch figures of those with a patch, the report.

use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::PoseMap;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::pose_distances::BeatShares;
use crate::analysis::verdicts::{Finding, SubjectThickening, Verdicts};
use crate::cli::figure::{Shot, Studio};
use crate::cli::input::interrupted;
use crate::cli::outcome::CliError;
use crate::cli::print::say;
use crate::cli::work::run_work;
use crate::engine::{
    ExportFile, ResultFolder, Store, TableSettings, WallThickeningQuery, distance_words,
    file_names, share_words,
};
use crate::picture::figure::Figure;
use crate::picture::page::{FigureFonts, Page, PageFormat, pdf_file};
use crate::picture::report::{REPORT_WIDTH_MM, ReportOrder, report_pages, report_settings};
use crate::picture::{MedialSettings, PictureTheme, Quantity, SceneSettings};
use crate::progress::Progress;
use crate::report::thickening_words;
use crate::study::Study;

/// Size of the figures of subjects: two side by side on a page at 300 dots per inch.
const FIGURE_SIZE: [u32; 2] = [1000, 750];
/// Size of patch figures: a page of the report at 200 dots per inch.
const PATCH_SIZE: [u32; 2] = [1600, 1200];
/// Patch figures in the report; beyond that a document is no longer read, and does not fit into memory.
const MAX_PAGES: usize = 100;

/// What is drawn, and of what.
#[derive(Clone)]
pub(super) struct Pictured {
    pub(super) study: Arc<Study>,
    pub(super) measures: Arc<Vec<SubjectMeasures>>,
    pub(super) verdicts: Arc<Verdicts>,
    pub(super) poses: Arc<PoseMap>,
    pub(super) shares: Arc<BeatShares>,
    pub(super) deformations: Option<Arc<DeformationMap>>,
    pub(super) classes: Option<Arc<Classes>>,
    pub(super) settings: TableSettings,
    pub(super) results: Arc<ResultFolder>,
}

/// What was drawn.
#[derive(Default)]
struct Drawn {
    /// Per subject its id and the names of its figures.
    files: Vec<Value>,
    /// Patch figures as pages.
    patches: Vec<Page>,
}

/// Why there are no figures, or not all.
enum NoFigures {
    /// They cannot be drawn, which the rest of an analysis does without; or it was stopped.
    Drawing(CliError),
    /// They cannot be written.
    Writing(CliError),
}

impl From<CliError> for NoFigures {
    fn from(error: CliError) -> Self {
        Self::Drawing(error)
    }
}

impl Pictured {
    /// Writes the figures, if they are wanted and can be drawn, and the report. Returns which files are of which subject.
    ///
    /// # Errors
    /// If stopped, or something cannot be written. Figures that cannot be drawn are reported on standard error.
    pub(super) fn write(&self, figures: bool, store: &Arc<Store>) -> Result<Vec<Value>, CliError> {
        let mut drawn = Drawn::default();
        if figures {
            let (task, store) = (self.clone(), Arc::clone(store));
            match run_work(move |progress| Ok::<_, CliError>(task.figures(&store, progress))) {
                Ok(Ok(figures)) => drawn = figures,
                Ok(Err(NoFigures::Drawing(CliError::Unusable(reason)))) => {
                    say(&format!("cardiomorph: no figures: {reason}"));
                }
                Ok(Err(NoFigures::Drawing(error) | NoFigures::Writing(error))) | Err(error) => {
                    return Err(error);
                }
            }
        }
        let task = self.clone();
        run_work(move |progress| task.report(&drawn.patches, progress).map(|()| drawn.files))
    }

    /// A figure of every subject at end-systole, coloured by displacement from end-diastole; and
    /// patch figures of subjects with an abnormal patch, as files and as pages. Each is written once it is drawn.
    fn figures(&self, store: &Store, progress: &Progress) -> Result<Drawn, NoFigures> {
        progress.begin_phase("drawing figures", 0.0, 1.0);
        progress.expect_steps(self.study.subjects.len());
        let mut studio = Studio::open(&self.study, &self.measures)?;
        let scene = SceneSettings {
            quantity: Quantity::Displacement,
            theme: PictureTheme::LIGHT,
            ..studio.settings()
        };
        let names = file_names(self.study.subjects.iter().map(|subject| &*subject.id));
        let mut drawn = Drawn::default();
        for ((index, subject), name) in self.study.subjects.iter().enumerate().zip(names) {
            let shot = Shot {
                index,
                frame: self.end_systole(index),
                view: None,
                size: FIGURE_SIZE,
                thickening: self.settings.verdicts.thickening,
            };
            let figure = studio.figure(&shot, scene, None)?;
            let file = self.picture(&studio, &figure, &format!("{name}.png"))?;
            let mut patch_file = None;
            if let Some(wall) = self.patched_wall(index, store, progress)? {
                let scene = SceneSettings {
                    quantity: Quantity::Tissue,
                    medial: MedialSettings::of_patch_figure(),
                    ..scene
                };
                let shot = Shot {
                    frame: wall.thickening.end_systole,
                    size: PATCH_SIZE,
                    ..shot
                };
                let figure = studio.patch_figure(&shot, scene, &wall, Some(&self.verdicts))?;
                let name = format!("{name}_patch.png");
                patch_file = Some(self.picture(&studio, &figure, &name)?);
                if drawn.patches.len() < MAX_PAGES {
                    drawn.patches.push(figure.page);
                }
            }
            drawn.files.push(json!({
                "subject": subject.id, "file": file, "patch_file": patch_file,
            }));
            progress.step().map_err(CliError::from)?;
        }
        Ok(drawn)
    }

    /// Writes a figure and returns its name in the folder.
    fn picture(
        &self,
        studio: &Studio<'_>,
        figure: &Figure,
        name: &str,
    ) -> Result<String, NoFigures> {
        let bytes = PageFormat::Png.file(&figure.page, &figure.settings, &studio.fonts);
        let file = ExportFile {
            path: self.results.path().join("figures").join(name),
            bytes: bytes.map_err(CliError::unusable)?.into(),
        };
        let written = self.results.write(vec![file]);
        written.map_err(|reason| NoFigures::Writing(CliError::Unusable(reason)))?;
        Ok(format!("figures/{name}"))
    }

    fn end_systole(&self, index: usize) -> usize {
        let subject = &self.study.subjects[index];
        let measured = self.measures.get(index).and_then(|row| row.end_systole);
        let last = subject.sequence.frame_count() - 1;
        measured.or(subject.end_systole).unwrap_or(last).min(last)
    }

    /// The wall of a subject whose verdict is a patch.
    fn patched_wall(
        &self,
        subject: usize,
        store: &Store,
        progress: &Progress,
    ) -> Result<Option<Arc<SubjectThickening>>, CliError> {
        let assessed = self.verdicts.subjects.get(subject);
        if !matches!(assessed, Some(Ok(verdict)) if verdict.finding == Finding::AbnormalPatch) {
            return Ok(None);
        }
        let query = WallThickeningQuery {
            subject,
            settings: self.settings.verdicts.thickening,
        };
        let quiet = progress.part("assessing walls", 0.0, 0.0);
        let wall = store.answer(&self.study, &query, &quiet);
        wall.map(Some).map_err(interrupted)
    }

    fn report(&self, patches: &[Page], progress: &Progress) -> Result<(), CliError> {
        progress.begin_phase("writing the report", 0.0, 1.0);
        let fonts = FigureFonts::load().map_err(CliError::unusable)?;
        let distances = &self.settings.deformations.poses.distances;
        let parameters = [
            format!("Distance between poses: {}.", distance_words(distances)),
            format!("{}.", share_words(&self.shares, distances.metric.kind)),
            format!(
                "Walls: medial surface {}.",
                thickening_words(&self.settings.verdicts.thickening)
            ),
        ];
        let order = ReportOrder {
            study: &self.study,
            measures: &self.measures,
            verdicts: &self.verdicts,
            poses: Some(&self.poses),
            deformations: self.deformations.as_deref(),
            classes: self.classes.as_deref(),
            parameters: &parameters,
        };
        let pages = report_pages(&order, patches, &fonts);
        progress.check()?;
        let bytes = pdf_file(&pages, REPORT_WIDTH_MM, &report_settings(&self.study));
        let file = ExportFile {
            path: self.results.path().join("report.pdf"),
            bytes: bytes.map_err(CliError::unusable)?.into(),
        };
        self.results.write(vec![file]).map_err(CliError::Unusable)
    }
}
