//! Tables of the walls of all subjects, one subject after the other.

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
use std::thread;

use serde_json::{Value, json};

use crate::analysis::verdicts::{Examined, NotAssessed};
use crate::engine::export::{ExportFile, FileBytes, PartialFile};
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
    rows: WallRows,
    walls: AssessedWalls,
    subjects: usize,
}

/// The rows of the subjects that were assessed so far.
#[derive(Debug)]
struct WallRows {
    /// Too long for memory: every atom at every frame of every subject.
    atoms: PartialFile,
    patches: String,
    patch_segments: String,
    segments: String,
    /// What the summary says of each subject.
    summaries: Vec<Value>,
    unassessed: Vec<Unassessed>,
}

impl WallTables {
    /// Tables without rows yet.
    ///
    /// # Errors
    /// If `folder` cannot be written to.
    pub fn new(study: &Study, folder: &Path) -> Result<Self, WriteError> {
        let subjects = study.subjects.len();
        let mut atoms = PartialFile::create(folder.join("atoms.csv")).map_err(WriteError)?;
        atoms.write(csv_header::<AtomRow>()).map_err(WriteError)?;
        Ok(Self {
            rows: WallRows {
                atoms,
                patches: csv_header::<PatchRow>(),
                patch_segments: csv_header::<PatchSegmentRow>(),
                segments: csv_header::<SegmentRow>(),
                summaries: Vec::with_capacity(subjects),
                unassessed: Vec::new(),
            },
            walls: AssessedWalls {
                summary: Value::Null,
                unassessed: Vec::new(),
                examined: Vec::with_capacity(subjects),
                paths: StudyPaths::with_capacity(subjects),
            },
            subjects,
        })
    }

    /// Assesses one subject after the other; no more of them are in memory than the store keeps. Rows are written while the
    /// next subject is assessed.
    ///
    /// # Errors
    /// If stopped, or the folder cannot be written to: the rows of the subjects before stay. A subject that cannot be assessed
    /// is no error.
    pub fn assess(
        &mut self,
        store: &Store,
        study: &Arc<Study>,
        settings: &VerdictQuery,
        progress: &Progress,
    ) -> Result<(), Interrupted> {
        let VerdictQuery {
            thickening,
            verdicts,
            ..
        } = settings;
        let checked = verdicts.check()?;
        let count = study.subjects.len().max(1) as f32;
        let (rows, walls) = (&mut self.rows, &mut self.walls);
        thread::scope(|scope| {
            let (sender, answers) = sync_channel(1);
            let writer = thread::Builder::new().name("wall tables".to_owned());
            let writer = writer.spawn_scoped(scope, move || -> Result<(), Interrupted> {
                answers
                    .into_iter()
                    .enumerate()
                    .try_for_each(|(subject, answer)| rows.add(study, subject, answer))
            })?;
            let mut assess = |subject: usize| -> Result<bool, Interrupted> {
                let [from, to] = [subject, subject + 1].map(|done| done as f32 / count);
                let wall = WallThickeningQuery {
                    subject,
                    settings: *thickening,
                };
                let part = progress.part("assessing walls", from, to);
                let answer = store.answer(study, &wall, &part);
                walls.examined.push(examined(&answer, &checked)?);
                walls.paths.push(paths_of(&answer)?);
                // The writer is gone where it has failed, which it says itself.
                Ok(sender.send(answer).is_ok())
            };
            let assessed =
                (0..study.subjects.len()).try_for_each(|subject| match assess(subject) {
                    Ok(true) => Ok(()),
                    Ok(false) => Err(None),
                    Err(why) => Err(Some(why)),
                });
            drop(sender);
            let written = match writer.join() {
                Ok(written) => written,
                Err(panic) => std::panic::resume_unwind(panic),
            };
            match assessed {
                Err(Some(why)) => Err(why),
                _ => written,
            }
        })?;
        self.walls.unassessed = std::mem::take(&mut self.rows.unassessed);
        self.walls.summary = json!({
            "parameters": thickening_params_json(&thickening.medial, &thickening.patches),
            "subjects": std::mem::take(&mut self.rows.summaries),
        });
        Ok(())
    }

    /// The files, and what is left.
    pub fn files(self, folder: &Path) -> ([ExportFile; 4], AssessedWalls) {
        (self.rows.files(folder, ""), self.walls)
    }

    /// What there is of tables that were not finished, under names that say so; nothing where no subject was assessed.
    pub fn partial_files(self, folder: &Path) -> Vec<ExportFile> {
        let done = self.rows.summaries.len();
        if done == 0 {
            return Vec::new();
        }
        let ending = format!("_of_{done}_of_{}_subjects", self.subjects);
        self.rows.files(folder, &ending).into()
    }
}

impl WallRows {
    /// Adds the rows of one subject.
    fn add(
        &mut self,
        study: &Study,
        index: usize,
        answer: Answered<WallThickeningQuery>,
    ) -> Result<(), Interrupted> {
        let subject = &study.subjects[index];
        let answer = match answer {
            Ok(answer) => answer,
            Err(Interrupted::Stopped) => return Err(Interrupted::Stopped),
            Err(Interrupted::Failed(failure)) => {
                let reason = failure.to_string();
                self.summaries
                    .push(unassessed_wall_json(&subject.id, &reason));
                self.unassessed.push(Unassessed {
                    subject: index,
                    reason,
                });
                return Ok(());
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
            let rows = csv_rows(&AtomRow::of_frame(&wall, frame));
            self.atoms.write(rows).map_err(WriteError)?;
        }
        self.patches += &csv_rows(&PatchRow::of_wall(&wall));
        self.patch_segments += &csv_rows(&PatchSegmentRow::of_wall(&wall));
        self.segments += &csv_rows(&SegmentRow::of_wall(&wall));
        self.summaries.push(wall_json(&wall));
        Ok(())
    }

    /// The tables, with something behind their names.
    fn files(mut self, folder: &Path, ending: &str) -> [ExportFile; 4] {
        let name = |table: &str| format!("{table}{ending}.csv");
        let atoms = folder.join(name("atoms"));
        self.atoms.set_target(atoms.clone());
        [
            ExportFile {
                path: atoms,
                bytes: FileBytes::Written(self.atoms),
            },
            ExportFile::text(folder, &name("patches"), self.patches),
            ExportFile::text(folder, &name("patch_segments"), self.patch_segments),
            ExportFile::text(folder, &name("segments"), self.segments),
        ]
    }
}

#[cfg(test)]
mod tests;
