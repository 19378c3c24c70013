//! Everything that runs behind the window: asked for by the state, taken in when it is done.

use std::sync::Arc;

use crate::analysis::classification::ClassesParams;
use crate::engine::{
    AnalysisRequest, ClassesSettings, DeformationMapSettings, Engine, JobError, OpenSource,
    Showing, Wake, WorkKind,
};
use crate::io::Opened;
use crate::picture::reference_frame;
use crate::study::Study;

use super::background_beats::AskedBeats;
use super::background_medial::{self, Seen, wanted_map};
use super::background_thickness::AskedThickness;
use super::background_walls::{AskedVerdicts, AskedWalls};
use super::dialogs::{AskPaths, Dialogs};
use super::document::OpeningReport;
use super::errors::{push_card, push_open_errors};
use super::map_orientation::{deformations_like, oriented_like};
use super::pictures::Pictures;
use super::saved_views::SavedViews;
use super::state::{Fresh, State};
use super::views::enough_subjects;

/// What a card says of work that failed.
const FAILURES: [(WorkKind, &str); 10] = [
    (WorkKind::Open, "Opening failed"),
    (WorkKind::Measures, "Volumes could not be computed"),
    (WorkKind::PoseMap, "The map of poses could not be computed"),
    (
        WorkKind::DeformationMap,
        "The map of deformations could not be computed",
    ),
    (WorkKind::Classes, "Classes could not be told apart"),
    (WorkKind::InBetweens, "No poses between frames were found"),
    (WorkKind::Transfer, "The beat could not be transferred"),
    (
        WorkKind::Contribution,
        "The poses could not be compared by place",
    ),
    (WorkKind::Verdicts, "The hearts could not be judged"),
    (WorkKind::Export, "Nothing was exported"),
];

/// Engine, pictures and dialogs of one window.
pub struct Background {
    /// Opens, analyses, exports.
    pub engine: Engine,
    /// Makes hearts ready for drawing.
    pub pictures: Pictures,
    /// Asks for files.
    pub dialogs: Dialogs,
    /// Reads the views that pictures carry.
    pub saved_views: SavedViews,
    /// What the answers about beats belong to.
    beats: AskedBeats,
    /// What the answers about walls belong to.
    walls: AskedWalls,
    /// And what those about all hearts belong to.
    verdicts: AskedVerdicts,
    /// What the answers about thickness belong to.
    thickness: AskedThickness,
    /// The failures that have a card already, so that each is told once.
    told: [Option<String>; FAILURES.len()],
}

impl Background {
    /// Starts all threads.
    ///
    /// # Errors
    /// If the operating system refuses one.
    pub fn start(wake: &Wake, ask_paths: AskPaths) -> std::io::Result<Self> {
        Ok(Self {
            engine: Engine::start(Arc::clone(wake))?,
            pictures: Pictures::start(Arc::clone(wake))?,
            dialogs: Dialogs::start(Arc::clone(wake), ask_paths)?,
            saved_views: SavedViews::start(Arc::clone(wake))?,
            beats: AskedBeats::default(),
            walls: AskedWalls::default(),
            verdicts: AskedVerdicts::default(),
            thickness: AskedThickness::default(),
            told: [const { None }; FAILURES.len()],
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
        self.take_deformations(state);
        self.beats.take(state, &self.engine);
        self.walls.take(state, &self.engine);
        self.verdicts.take(state, &self.engine);
        background_medial::take(state, &self.engine);
        self.thickness.take(state, &self.engine);
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

    /// Asks for what the state on screen needs; free if it is there or under way. While the pointer is held, verdicts
    /// on all hearts wait: a threshold is dragged through many values.
    pub fn request(&mut self, state: &State, seen: &Seen) {
        let study = state.document.study();
        if study.subjects.is_empty() {
            return;
        }
        for kind in [WorkKind::Measures, WorkKind::PoseMap] {
            if let Some(request) = wanted(state, kind) {
                self.engine.request(study, request);
            }
        }
        self.beats.request(state, &mut self.engine);
        self.walls.request(state, &mut self.engine);
        self.request_deformations(state);
        background_medial::request(state, &mut self.engine, seen);
        self.thickness.request(state, &mut self.engine, seen);
        // Last, so that it sees what else has begun.
        let held = seen.pointer_held;
        self.verdicts.request(state, &mut self.engine, held);
    }

    /// Maps of deformations are made from the map of poses, and classes are told apart on them: each
    /// is asked for once the one before is there, so that nothing is computed twice.
    fn request_deformations(&mut self, state: &State) {
        let steps = [
            (WorkKind::PoseMap, WorkKind::DeformationMap),
            (WorkKind::DeformationMap, WorkKind::Classes),
        ];
        for (before, kind) in steps {
            let there = matches!(self.engine.showing(before), Showing::Ready(_));
            if !there || !enough_subjects(state) {
                return;
            }
            if let Some(request) = wanted(state, kind) {
                self.engine.request(state.document.study(), request);
            }
        }
    }

    /// Begins stopped or failed work again.
    pub fn retry(&mut self, state: &State, kind: WorkKind) {
        if kind == WorkKind::Open {
            self.engine.retry_open();
        } else if let Some(request) = match kind {
            WorkKind::Medial => self.walls.retry(state),
            WorkKind::Verdicts => Some(self.verdicts.retry(state)),
            WorkKind::Thickness => self.thickness.retry(state),
            _ => wanted(state, kind).or_else(|| self.beats.retry(state, kind)),
        } {
            self.engine.retry(state.document.study(), request);
        }
    }

    /// Reads or makes a study; the one on screen stays until the new one is there.
    pub fn open(&mut self, source: OpenSource) {
        self.engine.open(source);
    }

    /// Stops one kind of work.
    pub fn stop(&mut self, kind: WorkKind) {
        self.engine.cancel(kind);
    }

    /// The frame of the selected heart whose thickness was asked for last.
    pub fn thickness_frame(&self, state: &State) -> Option<usize> {
        self.thickness.frame(state)
    }

    /// Whether anything runs, so that bars must move.
    pub fn busy(&self) -> bool {
        self.engine.busy()
    }

    fn take_results(&mut self, state: &mut State) {
        let revision = state.document.study().revision;
        let opening = state.document.study.opening;
        if let Showing::Ready(outcome) = self.engine.showing(WorkKind::Measures)
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
        if let Showing::Ready(outcome) = self.engine.showing(WorkKind::PoseMap)
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

    fn take_deformations(&mut self, state: &mut State) {
        let revision = state.document.study().revision;
        let opening = state.document.study.opening;
        if let Showing::Ready(outcome) = self.engine.showing(WorkKind::DeformationMap)
            && let Some(value) = outcome.deformation_map()
            && !is_same(state.results.deformations.as_ref(), value)
        {
            let turned = match state.deformations() {
                Some(shown) => Arc::new(deformations_like((**value).clone(), shown)),
                None => Arc::clone(value),
            };
            state.results.deformations = Some(Fresh {
                revision,
                opening,
                source: Arc::clone(value),
                value: turned,
            });
        }
        if let Showing::Ready(outcome) = self.engine.showing(WorkKind::Classes)
            && let Some(value) = outcome.classes()
            && !is_same(state.results.classes.as_ref(), value)
        {
            state.results.classes = Some(Fresh {
                revision,
                opening,
                source: Arc::clone(value),
                value: Arc::clone(value),
            });
        }
    }

    fn tell_failures(&mut self, state: &mut State) {
        for ((kind, title), told) in FAILURES.into_iter().zip(&mut self.told) {
            let failure = match kind {
                WorkKind::Open => failure(&self.engine.opening()),
                WorkKind::Export => failure(&self.engine.export()),
                analysis => failure(&self.engine.showing(analysis)),
            };
            if let Some(reason) = &failure
                && told.as_ref() != Some(reason)
            {
                let retry = (kind != WorkKind::Export).then_some(kind);
                push_card(&mut state.errors, title, reason.clone(), retry);
            }
            *told = failure;
        }
    }
}

/// What the state on screen needs of one kind of analysis; `None` where it needs nothing.
fn wanted(state: &State, kind: WorkKind) -> Option<AnalysisRequest> {
    match kind {
        WorkKind::Measures => Some(AnalysisRequest::Measures),
        WorkKind::PoseMap => Some(AnalysisRequest::PoseMap(state.document.map)),
        WorkKind::DeformationMap => Some(AnalysisRequest::DeformationMap(deformations(state))),
        WorkKind::MedialMap => Some(wanted_map(state)),
        WorkKind::Classes => Some(AnalysisRequest::Classes(ClassesSettings {
            deformations: deformations(state),
            classes: ClassesParams::default(),
        })),
        _ => None,
    }
}

fn deformations(state: &State) -> DeformationMapSettings {
    DeformationMapSettings {
        poses: state.document.map,
        map: state.document.deformation_map,
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
