//! What `analyze` draws: a figure of every subject, patch figures of those with a patch, the report.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::deformations::DeformationMap;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::{Finding, Verdicts};
use crate::cli::figure::{Shot, Studio};
use crate::cli::input::interrupted;
use crate::cli::outcome::CliError;
use crate::cli::print::say;
use crate::cli::work::run_work;
use crate::engine::{
    ExportFile, PoseMap, Store, SubjectThickening, TableSettings, WallThickening, distance_words,
    thickening_words,
};
use crate::picture::page::{FigureFonts, Page, PageFormat, pdf_file};
use crate::picture::report::{REPORT_WIDTH_MM, ReportOrder, report_pages, report_settings};
use crate::picture::{MedialSettings, PictureTheme, Quantity, SceneSettings};
use crate::progress::Progress;
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
    pub(super) deformations: Option<Arc<DeformationMap>>,
    pub(super) settings: TableSettings,
    pub(super) folder: PathBuf,
}

impl Pictured {
    /// The figures, if they are wanted and can be drawn, and the report.
    ///
    /// # Errors
    /// If stopped, or the report cannot be written. Figures that cannot be drawn are reported on standard error.
    pub(super) fn files(
        &self,
        figures: bool,
        store: &Arc<Store>,
    ) -> Result<Vec<ExportFile>, CliError> {
        let (mut files, mut patches) = (Vec::new(), Vec::new());
        if figures {
            let (task, store) = (self.clone(), Arc::clone(store));
            match run_work(move |progress| task.figures(&store, progress)) {
                Ok((drawn, pages)) => (files, patches) = (drawn, pages),
                Err(error @ CliError::Stopped(_)) => return Err(error),
                Err(error) => say(&format!("cardiomorph: no figures: {error}")),
            }
        }
        let task = self.clone();
        files.push(run_work(move |progress| task.report(patches, progress))?);
        Ok(files)
    }

    /// A figure of every subject at end-systole, coloured by displacement from end-diastole; and
    /// patch figures of subjects with an abnormal patch, as files and as pages.
    fn figures(
        &self,
        store: &Store,
        progress: &Progress,
    ) -> Result<(Vec<ExportFile>, Vec<Page>), CliError> {
        progress.begin_phase("drawing figures", 0.0, 1.0);
        progress.expect_steps(self.study.subjects.len());
        let mut studio = Studio::open(&self.study, &self.measures)?;
        let scene = SceneSettings {
            quantity: Quantity::Displacement,
            theme: PictureTheme::LIGHT,
            ..studio.settings()
        };
        let folder = self.folder.join("figures");
        let (mut files, mut pages) = (Vec::new(), Vec::new());
        for (index, subject) in self.study.subjects.iter().enumerate() {
            let name = file_name(&subject.id);
            let shot = Shot {
                index,
                frame: self.end_systole(index),
                view: None,
                size: FIGURE_SIZE,
                thickening: self.settings.verdicts.thickening,
            };
            let figure = studio.figure(&shot, scene, None)?;
            let bytes = PageFormat::Png.file(&figure.page, &figure.settings, &studio.fonts);
            files.push(ExportFile {
                path: folder.join(format!("{name}.png")),
                bytes: bytes.map_err(CliError::unusable)?.into(),
            });
            if let Some(wall) = self.abnormal_wall(index, store, progress)? {
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
                let bytes = PageFormat::Png.file(&figure.page, &figure.settings, &studio.fonts);
                files.push(ExportFile {
                    path: folder.join(format!("{name}_patch.png")),
                    bytes: bytes.map_err(CliError::unusable)?.into(),
                });
                if pages.len() < MAX_PAGES {
                    pages.push(figure.page);
                }
            }
            progress.step()?;
        }
        Ok((files, pages))
    }

    fn end_systole(&self, index: usize) -> usize {
        let subject = &self.study.subjects[index];
        let measured = self.measures.get(index).and_then(|row| row.end_systole);
        let last = subject.sequence.frame_count() - 1;
        measured.or(subject.end_systole).unwrap_or(last).min(last)
    }

    /// The wall of a subject whose verdict is an abnormal patch.
    fn abnormal_wall(
        &self,
        subject: usize,
        store: &Store,
        progress: &Progress,
    ) -> Result<Option<Arc<SubjectThickening>>, CliError> {
        let assessed = self.verdicts.subjects.get(subject);
        if !matches!(assessed, Some(Ok(verdict)) if verdict.finding == Finding::Patch) {
            return Ok(None);
        }
        let query = WallThickening {
            subject,
            settings: self.settings.verdicts.thickening,
        };
        let quiet = progress.part("assessing walls", 0.0, 0.0);
        let wall = store.answer(&self.study, &query, &quiet);
        wall.map(Some).map_err(interrupted)
    }

    fn report(&self, patches: Vec<Page>, progress: &Progress) -> Result<ExportFile, CliError> {
        progress.begin_phase("writing the report", 0.0, 1.0);
        let fonts = FigureFonts::load().map_err(CliError::unusable)?;
        let parameters = [
            format!(
                "Distance between poses: {}.",
                distance_words(&self.settings.deformations.poses.distances)
            ),
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
            parameters: &parameters,
        };
        let mut pages = report_pages(&order, &fonts);
        pages.extend(patches);
        progress.check()?;
        let bytes = pdf_file(&pages, REPORT_WIDTH_MM, &report_settings(&self.study));
        Ok(ExportFile {
            path: self.folder.join("report.pdf"),
            bytes: bytes.map_err(CliError::unusable)?.into(),
        })
    }
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
