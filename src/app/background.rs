//! Everything that runs behind the window: asked for by the state, taken in when it is done.

use std::sync::Arc;

use crate::engine::{Engine, JobError, OpenSource, Showing, Wake, WorkKind};
use crate::io::Opened;
use crate::picture::reference_frame;
use crate::study::Study;
use crate::ui::JobKind;

use super::dialogs::Dialogs;
use super::document::OpeningReport;
use super::errors::{push_card, push_open_errors};
use super::map_orientation::oriented_like;
use super::pictures::Pictures;
use super::state::{Fresh, State};

/// Engine, pictures and dialogs of one window.
pub struct Background {
    /// Opens, analyses, exports.
    pub engine: Engine,
    /// Makes hearts ready for drawing.
    pub pictures: Pictures,
    /// Asks for files.
    pub dialogs: Dialogs,
    /// The failures that have a card already, so that each is told once.
    told: [Option<String>; 4],
}

impl Background {
    /// Starts all threads.
    ///
    /// # Errors
    /// If the operating system refuses one.
    pub fn start(wake: &Wake) -> std::io::Result<Self> {
        Ok(Self {
            engine: Engine::start(Arc::clone(wake))?,
            pictures: Pictures::start(Arc::clone(wake))?,
            dialogs: Dialogs::start(Arc::clone(wake))?,
            told: [const { None }; 4],
        })
    }

    /// Takes in what finished since the last frame.
    pub fn poll(&mut self, state: &mut State) {
        for problem in self.pictures.poll() {
            push_card(&mut state.errors, "A heart cannot be drawn", problem, None);
        }
        self.engine.poll();
        // Results first: they belong to the study that is on screen until now.
        self.take_results(state);
        if let Some(opened) = self.engine.take_opened() {
            take_opened(state, &opened);
        }
        if let Some(files) = self.engine.take_exported() {
            state.message = match files.as_slice() {
                [] => "Nothing was written".to_owned(),
                [file] => format!("Wrote {}", file.display()),
                [first, ..] => {
                    let folder = first.parent().unwrap_or(first);
                    format!("Wrote {} files into {}", files.len(), folder.display())
                }
            };
        }
        self.tell_failures(state);
    }

    /// Asks for what the state on screen needs; free if it is there or under way.
    pub fn request(&mut self, state: &State) {
        let study = state.document.study();
        if study.subjects.is_empty() {
            return;
        }
        self.engine.request_measures(study);
        self.engine.request_pose_map(study, state.document.map);
    }

    /// Begins stopped or failed work again.
    pub fn retry(&mut self, state: &State, kind: JobKind) {
        let study = state.document.study();
        match kind {
            JobKind::Open => self.engine.retry_open(),
            JobKind::Measures => self.engine.retry_measures(study),
            JobKind::PoseMap => self.engine.retry_pose_map(study, state.document.map),
            JobKind::Export => {}
        }
    }

    /// Reads or makes a study; the one on screen stays until the new one is there.
    pub fn open(&mut self, source: OpenSource) {
        self.engine.open(source);
    }

    /// Stops one kind of work.
    pub fn stop(&mut self, kind: JobKind) {
        self.engine.cancel(work_kind(kind));
    }

    /// Whether anything runs, so that bars must move.
    pub fn busy(&self) -> bool {
        self.engine.busy()
    }

    fn take_results(&mut self, state: &mut State) {
        let revision = state.document.study().revision;
        let opening = state.document.study.opening;
        if let Showing::Ready(outcome) = self.engine.measures()
            && let Some(value) = outcome.measures()
            && !is_same(state.results.measures.as_ref(), value)
        {
            state.results.measures = Some(Fresh {
                revision,
                opening,
                source: Arc::clone(value),
                value: Arc::clone(value),
            });
        }
        if let Showing::Ready(outcome) = self.engine.pose_map()
            && let Some(value) = outcome.pose_map()
            && !is_same(state.results.map.as_ref(), value)
        {
            let turned = match state.map() {
                Some(shown) => Arc::new(oriented_like((**value).clone(), shown)),
                None => Arc::clone(value),
            };
            state.results.map = Some(Fresh {
                revision,
                opening,
                source: Arc::clone(value),
                value: turned,
            });
        }
    }

    fn tell_failures(&mut self, state: &mut State) {
        let failures = [
            failure(&self.engine.opening()),
            failure(&self.engine.measures()),
            failure(&self.engine.pose_map()),
            failure(&self.engine.export()),
        ];
        let kinds = [
            (JobKind::Open, "Opening failed"),
            (JobKind::Measures, "Volumes could not be computed"),
            (JobKind::PoseMap, "The map could not be computed"),
            (JobKind::Export, "Nothing was exported"),
        ];
        for ((failure, told), (kind, title)) in failures.into_iter().zip(&mut self.told).zip(kinds)
        {
            if let Some(reason) = &failure
                && told.as_ref() != Some(reason)
            {
                let retry = (kind != JobKind::Export).then_some(kind);
                push_card(&mut state.errors, title, reason.clone(), retry);
            }
            *told = failure;
        }
    }
}

fn failure<T, E: std::fmt::Display>(showing: &Showing<'_, T, E>) -> Option<String>
where
    JobError<E>: std::fmt::Display,
{
    match showing {
        Showing::Failed { error, .. } => Some(error.to_string()),
        _ => None,
    }
}

/// Whether a result is the one that was taken in last.
fn is_same<T>(taken: Option<&Fresh<T>>, value: &Arc<T>) -> bool {
    taken.is_some_and(|fresh| Arc::ptr_eq(&fresh.source, value))
}

fn take_opened(state: &mut State, opened: &Opened) {
    push_open_errors(&mut state.errors, &opened.errors);
    let study = &opened.study;
    if study.subjects.is_empty() {
        if opened.errors.is_empty() {
            push_card(
                &mut state.errors,
                "Nothing to open",
                "no mesh files were found there",
                None,
            );
        }
        return;
    }
    state.message = match study.subjects.len() {
        1 => format!("Opened {}", study.subjects[0].id),
        count => format!("Opened {count} subjects"),
    };
    let report = OpeningReport {
        notices: opened.notices.clone(),
        errors: opened.errors.clone(),
    };
    state.show_study(Arc::new(Study::clone(study)), report);
}

/// The frame of each subject that motion is counted from.
pub fn reference_frames(state: &State) -> Vec<usize> {
    let study = state.document.study();
    (0..study.subjects.len())
        .map(|index| reference_frame(&study.subjects[index], state.measures_of(index)))
        .collect()
}

/// The engine's word for a kind of work.
pub fn work_kind(kind: JobKind) -> WorkKind {
    match kind {
        JobKind::Open => WorkKind::Open,
        JobKind::Measures => WorkKind::Measures,
        JobKind::PoseMap => WorkKind::PoseMap,
        JobKind::Export => WorkKind::Export,
    }
}

/// The window's word for a kind of work.
pub fn job_kind(kind: WorkKind) -> JobKind {
    match kind {
        WorkKind::Open => JobKind::Open,
        WorkKind::Measures => JobKind::Measures,
        WorkKind::PoseMap => JobKind::PoseMap,
        WorkKind::Export => JobKind::Export,
    }
}
