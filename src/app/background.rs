//! The engine behind the window: what it brings goes into the state.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::preparation::Preparation;
use crate::engine::{Engine, OpenSource, Stage, StoreOptions, Wake};
use crate::io::{Opened, renew_cohort_notices};
use crate::panes::{Command, FileCommand};
use crate::picture::reference_frame;
use crate::study::{Notice, Revision, Study};
use crate::ui::text::counted;

use super::apply::{Moment, change};
use super::asks::Asks;
use super::errors::{push_card, push_failure, push_open_errors};
use super::imports::{add_walls, panes_of_images};
use crate::document::StudyExport;
use crate::document::document::OpeningReport;
use crate::document::state::State;

/// The engine of one window, and what is asked of its store.
pub struct Background {
    /// Opens, answers, exports.
    pub engine: Engine,
    asks: Asks,
    /// The state of the study that the store knows of.
    followed: Option<Revision>,
    /// Which opening of a study is added to.
    added_to: u64,
}

impl Background {
    /// Starts all threads.
    ///
    /// # Errors
    /// If the operating system refuses one.
    pub fn start(wake: &Wake) -> std::io::Result<Self> {
        Ok(Self {
            engine: Engine::start(StoreOptions {
                wake: Arc::clone(wake),
                ..StoreOptions::default()
            })?,
            asks: Asks::default(),
            followed: None,
            added_to: 0,
        })
    }

    /// Takes in what finished since the last frame; gives what is to be done after it.
    pub fn poll(&mut self, state: &mut State) -> Vec<Command> {
        let mut next = Vec::new();
        self.engine.poll();
        for stage in self.engine.take_stages() {
            let ended = matches!(stage, Stage::Ended(_));
            self.take_stage(state, stage);
            if ended {
                next.extend(panes_of_images(state));
            }
        }
        if let Some(opened) = self.engine.take_opened() {
            let before = state.document.study.opening;
            take_opened(state, opened);
            if state.document.study.opening != before {
                next.extend(panes_of_images(state));
            }
        }
        if let Some(added) = self.engine.take_added() {
            let moment = Moment {
                now_s: 0.0,
                pointer_held: false,
                fresh_revision: self.engine.next_revision(),
            };
            take_added(state, added, self.added_to, &moment);
        }
        if let Some(files) = self.engine.take_exported() {
            next.extend(take_exported(state, &files));
        }
        for failure in self.engine.take_failures() {
            push_failure(&mut state.errors, &failure);
        }
        next
    }

    /// Begins to read what is to be added to the study on screen.
    pub fn add(&mut self, state: &State, paths: Vec<PathBuf>) {
        self.added_to = state.document.study.opening;
        self.engine.add(OpenSource::Paths(paths));
    }

    /// Puts walls of images into the study on screen.
    pub fn add_walls(&mut self, state: &mut State, images: &[(usize, Arc<Preparation>)]) {
        let moment = Moment {
            now_s: 0.0,
            pointer_held: false,
            fresh_revision: self.engine.next_revision(),
        };
        add_walls(state, self.engine.store(), images, &moment);
    }

    /// Asks for what the state on screen needs, and has the state show what is known.
    pub fn ask(&mut self, state: &mut State, pointer_held: bool) {
        let study = state.document.study();
        if self.followed != Some(study.revision) {
            self.engine.store().follow(study);
            self.followed = Some(study.revision);
        }
        state.answers = self.asks.ask(state, self.engine.store(), pointer_held);
    }

    fn take_stage(&mut self, state: &mut State, stage: Stage) {
        let mut fresh = || self.engine.next_revision();
        match stage {
            Stage::Begun(study) => state.begin_reading(study),
            Stage::Read(read) => {
                if !state.add_read(&read, &mut fresh) {
                    self.engine.give_up_opening();
                }
            }
            Stage::Ended(opened) => {
                push_open_errors(&mut state.errors, &opened.errors);
                state.message = opened_words(&opened.study);
                state.end_reading(report_of(opened).1, &mut fresh);
            }
            Stage::GivenUp => {
                let stopped = Notice::warning("reading was stopped: not all subjects were read");
                let report = OpeningReport {
                    notices: vec![stopped],
                    ..OpeningReport::default()
                };
                state.end_reading(report, &mut fresh);
            }
        }
    }
}

/// Files that were written. A study among them is left if it was written for that, unless it was edited meanwhile: then
/// the person at the screen is asked again.
fn take_exported(state: &mut State, files: &[PathBuf]) -> Option<Command> {
    let written = |export: &mut StudyExport| files.contains(&export.manifest);
    let kept: Vec<StudyExport> = state.exports.extract_if(.., written).collect();
    state.message = written_words(files);
    state.kept.extend(kept.iter().map(|export| export.revision));
    state.leaving = Some(kept.into_iter().find_map(|export| export.then)?);
    (!state.is_edited()).then(|| FileCommand::Leave.into())
}

fn written_words(files: &[PathBuf]) -> String {
    match files {
        [] => "Nothing was written".to_owned(),
        [file] => format!("Wrote {}", file.display()),
        [first, ..] => {
            let folder = first.parent().unwrap_or(first);
            format!("Wrote {} files into {}", files.len(), folder.display())
        }
    }
}

fn take_opened(state: &mut State, opened: Opened) {
    push_open_errors(&mut state.errors, &opened.errors);
    if opened.study.subjects.is_empty() && opened.images.is_empty() {
        if opened.errors.is_empty() {
            push_card(&mut state.errors, "Nothing to open", "no mesh files found");
        }
        return;
    }
    state.message = opened_words(&opened.study);
    let (study, report) = report_of(opened);
    state.show_study(Arc::new(study), report);
}

fn opened_words(study: &Study) -> String {
    match study.subjects.as_slice() {
        [] => "Opened images".to_owned(),
        [one] => format!("Opened {}", one.id),
        all => format!("Opened {} subjects", all.len()),
    }
}

fn report_of(opened: Opened) -> (Study, OpeningReport) {
    let report = OpeningReport {
        notices: opened.notices,
        errors: opened.errors,
        images: Arc::new(opened.images),
    };
    (opened.study, report)
}

/// Adds what was read to the study that it was asked for, as one step of undo; the load report tells of both.
fn take_added(state: &mut State, added: Opened, added_to: u64, moment: &Moment) {
    let refused = if state.document.study.opening != added_to {
        Some("another study was opened meanwhile")
    } else if !state.document.study().unread.is_empty() {
        Some("the study on screen is still being read")
    } else if added.study.subjects.is_empty() && added.images.is_empty() {
        Some("no mesh files that can be read were found")
    } else {
        None
    };
    push_open_errors(&mut state.errors, &added.errors);
    if let Some(why) = refused {
        return push_card(&mut state.errors, "Nothing was added", why);
    }
    let study = (state.document.study()).adding(&added.study, moment.fresh_revision);
    let mut report = OpeningReport::clone(&state.document.study.report);
    renew_cohort_notices(&mut report.notices, [state.document.study(), &study]);
    report
        .notices
        .extend(added.notices.into_iter().map(|notice| Notice {
            text: format!("{}, added: {}", added.study.name, notice.text),
            ..notice
        }));
    report.errors.extend(added.errors);
    let before = report.images.iter().cloned();
    report.images = Arc::new(before.chain(added.images).collect());
    change(state, moment, None, |document| {
        document.show_relisted(study);
        document.study.report = Arc::new(report);
    });
    state.leave_listing();
    state.estimate_at = None;
    state.message = format!("Added {}", counted(added.study.count(), "subject"));
}

/// The frame of each subject that motion is counted from.
pub fn reference_frames(state: &State) -> Vec<usize> {
    let study = state.document.study();
    (study.all().enumerate())
        .map(|(index, subject)| reference_frame(subject, state.measures_of(index)))
        .collect()
}
