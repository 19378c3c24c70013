//! Tables of the walls of all subjects, one subject after the other.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::verdicts::{Examined, NotAssessed};
use crate::engine::export::{ExportFile, FileBytes, PassingFile};
use crate::engine::queries::{StudyPaths, VerdictQuery, WallThickeningQuery, examined, paths_of};
use crate::engine::store::{Answered, Interrupted, Store};
use crate::progress::Progress;
use crate::report::{
    AssessedWall, AtomRow, PatchRow, PatchSegmentRow, SegmentRow, csv_header, csv_rows,
    thickening_params_json, unassessed_wall_json, wall_json,
};
use crate::study::Study;

/// The folder of the tables cannot be written to.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub(super) struct WriteError(pub String);

/// A subject whose wall could not be assessed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unassessed {
    /// Its index.
    pub subject: usize,
    /// Why.
    pub reason: String,
}

/// What the tables of walls leave for what is asked next.
#[derive(Debug)]
pub(super) struct AssessedWalls {
    /// What the summary says of them.
    pub summary: Value,
    /// Those without rows.
    pub unassessed: Vec<Unassessed>,
    /// What a verdict needs of each subject.
    pub examined: Vec<Result<Examined, NotAssessed>>,
    /// What the medial map is made of.
    pub paths: StudyPaths,
}

/// Atoms, patches and segments of all subjects.
#[derive(Debug)]
pub(super) struct WallTables {
    /// Too long for memory: every atom at every frame of every subject.
    atoms: PassingFile,
    patches: String,
    patch_segments: String,
    segments: String,
    walls: AssessedWalls,
}

impl WallTables {
    /// Assesses one subject after the other; no more of them are in memory than the store keeps.
    ///
    /// # Errors
    /// If stopped, or `folder` cannot be written to. A subject that cannot be assessed is no error.
    pub fn of(
        store: &Store,
        study: &Arc<Study>,
        settings: &VerdictQuery,
        folder: &Path,
        progress: &Progress,
    ) -> Result<Self, Interrupted> {
        let VerdictQuery {
            thickening,
            verdicts,
        } = settings;
        let checked = verdicts.check()?;
        let mut tables = Self {
            atoms: PassingFile::create(folder.join("atoms.csv")).map_err(WriteError)?,
            patches: csv_header::<PatchRow>(),
            patch_segments: csv_header::<PatchSegmentRow>(),
            segments: csv_header::<SegmentRow>(),
            walls: AssessedWalls {
                summary: Value::Null,
                unassessed: Vec::new(),
                examined: Vec::with_capacity(study.subjects.len()),
                paths: StudyPaths::with_capacity(study.subjects.len()),
            },
        };
        tables.add_atoms(&csv_header::<AtomRow>())?;
        let count = study.subjects.len().max(1) as f32;
        let mut subjects = Vec::with_capacity(study.subjects.len());
        for subject in 0..study.subjects.len() {
            let [from, to] = [subject, subject + 1].map(|done| done as f32 / count);
            let part = progress.part("assessing walls", from, to);
            let wall = WallThickeningQuery {
                subject,
                settings: *thickening,
            };
            let answer = store.answer(study, &wall, &part);
            tables.walls.examined.push(examined(&answer, &checked)?);
            tables.walls.paths.push(paths_of(&answer)?);
            subjects.push(tables.add(study, subject, answer, &part)?);
        }
        tables.walls.summary = json!({
            "parameters": thickening_params_json(&thickening.medial, &thickening.patches),
            "subjects": subjects,
        });
        Ok(tables)
    }

    /// Adds the rows of one subject, and returns its part of the summary.
    fn add(
        &mut self,
        study: &Study,
        index: usize,
        answer: Answered<WallThickeningQuery>,
        progress: &Progress,
    ) -> Result<Value, Interrupted> {
        let subject = &study.subjects[index];
        let answer = match answer {
            Ok(answer) => answer,
            Err(Interrupted::Stopped) => return Err(Interrupted::Stopped),
            Err(Interrupted::Failed(failure)) => {
                let reason = failure.to_string();
                let json = unassessed_wall_json(&subject.id, &reason);
                self.walls.unassessed.push(Unassessed {
                    subject: index,
                    reason,
                });
                return Ok(json);
            }
        };
        let wall = AssessedWall {
            subject: &subject.id,
            unit: subject.unit,
            beat: &answer.beat,
            thickening: &answer.thickening,
            axis: answer.axis.as_ref(),
            segments: &answer.segments,
        };
        for frame in 0..answer.beat.frames.len() {
            progress.check()?;
            self.add_atoms(&csv_rows(&AtomRow::of_frame(&wall, frame)))?;
        }
        self.patches += &csv_rows(&PatchRow::of_wall(&wall));
        self.patch_segments += &csv_rows(&PatchSegmentRow::of_wall(&wall));
        self.segments += &csv_rows(&SegmentRow::of_wall(&wall));
        Ok(wall_json(&wall))
    }

    fn add_atoms(&mut self, text: &str) -> Result<(), WriteError> {
        self.atoms.write(text).map_err(WriteError)
    }

    /// The files, and what is left.
    pub fn files(self, folder: &Path) -> ([ExportFile; 4], AssessedWalls) {
        let files = [
            ExportFile {
                path: folder.join("atoms.csv"),
                bytes: FileBytes::Passing(self.atoms),
            },
            ExportFile::text(folder, "patches.csv", self.patches),
            ExportFile::text(folder, "patch_segments.csv", self.patch_segments),
            ExportFile::text(folder, "segments.csv", self.segments),
        ];
        (files, self.walls)
    }
}

#[cfg(test)]
mod tests;
