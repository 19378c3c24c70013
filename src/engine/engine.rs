//! The window's way to background work: the store that answers questions, and the jobs that open and export.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::engine::activity::{Activity, Topic};
use crate::engine::export::{ExportFile, write_files};
use crate::engine::job::{Ending, Job, JobError, Wake};
use crate::engine::open::{OpenSource, open, open_in_stages};
use crate::engine::reading_limits::reading_limits;
use crate::engine::stages::{Feed, Stage};
use crate::engine::store::{FailedWork, SharedError, Store, StoreOptions};
use crate::engine::workers::Workers;
use crate::io::{Limits, Opened};
use crate::progress::{Progress, Stopped};
use crate::study::{Revision, Study};

/// Why nothing was exported.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ExportError(String);

/// Threads for work that its owner polls: one for the dialog that may be open for minutes, one for what is read
/// meanwhile.
const ASIDE: usize = 2;

/// All background work of one window.
///
/// Calls return at once. Every frame: [`Self::poll`], then ask the [store](Self::store) for what is on screen. Dropping
/// the engine stops its work, then joins its threads.
pub struct Engine {
    // Jobs stand before their threads: they are dropped first, which stops what still runs.
    opening: Option<Opening>,
    opened: Option<Opened>,
    stages: Vec<Stage>,
    /// What is read to be added to a study.
    adding: Option<Job<Opened, Stopped>>,
    added: Option<Opened>,
    /// One is made after the other.
    exports: Vec<Job<Vec<PathBuf>, ExportError>>,
    exported: Option<Vec<PathBuf>>,
    last_opening: Option<OpenSource>,
    revisions: Arc<AtomicU64>,
    limits: Limits,
    wake: Wake,
    exporter: Workers,
    reader: Workers,
    aside: Workers,
    store: Arc<Store>,
}

/// Something that is being opened.
struct Opening {
    job: Job<Opened, Stopped>,
    feed: Arc<Feed>,
}

impl Engine {
    /// Starts the store, a thread that reads files, one that writes them, and those for work aside.
    ///
    /// # Errors
    /// If the operating system refuses a thread.
    pub fn start(options: StoreOptions) -> std::io::Result<Self> {
        Ok(Self {
            opening: None,
            opened: None,
            stages: Vec::new(),
            adding: None,
            added: None,
            exports: Vec::new(),
            exported: None,
            last_opening: None,
            revisions: Arc::new(AtomicU64::new(1)),
            limits: reading_limits(),
            wake: Arc::clone(&options.wake),
            exporter: Workers::start("export", 1)?,
            reader: Workers::start("reader", 1)?,
            aside: Workers::start("aside", ASIDE)?,
            store: Arc::new(Store::start(options)?),
        })
    }

    /// Answers questions to a study.
    pub fn store(&self) -> &Arc<Store> {
        &self.store
    }

    /// A revision that no study of this engine has yet; for whoever edits a study.
    pub fn next_revision(&self) -> Revision {
        next_revision(&self.revisions)
    }

    /// Opens something in place of what is being opened; the study in use is not touched.
    /// What comes of it is handed out once, by [`Self::take_opened`], or of a large study by [`Self::take_stages`].
    pub fn open(&mut self, source: OpenSource) {
        self.last_opening = Some(source.clone());
        let (name, words) = (source.name(), source.words());
        let (limits, revisions) = (self.limits, Arc::clone(&self.revisions));
        let wake = Arc::clone(&self.wake);
        self.give_up_opening();
        let feed = Arc::new(Feed::new(Arc::clone(&wake)));
        let listener = Arc::clone(&feed);
        let job = Job::spawn(&self.reader, wake, move |progress: &Progress| {
            let mut opened = open_in_stages(&source, &limits, progress, &*listener)?;
            opened.study.revision = next_revision(&revisions);
            Ok(opened)
        });
        (self.store).list_job(Topic::OPENING, name, words, Arc::clone(job.watch()));
        self.store.set_reading(Arc::clone(job.watch()));
        self.opened = None;
        self.opening = Some(Opening { job, feed });
    }

    /// Reads something that is to be added to a study. What comes of it is handed out once, by [`Self::take_added`].
    pub fn add(&mut self, source: OpenSource) {
        let (name, words) = (source.name(), source.words());
        let (limits, revisions) = (self.limits, Arc::clone(&self.revisions));
        let wake = Arc::clone(&self.wake);
        let job = Job::spawn(&self.reader, wake, move |progress: &Progress| {
            let mut opened = open(&source, &limits, progress)?;
            opened.study.revision = next_revision(&revisions);
            Ok(opened)
        });
        (self.store).list_job(Topic::OPENING, name, words, Arc::clone(job.watch()));
        self.added = None;
        self.adding = Some(job);
    }

    /// What was read to be added, once; `None` while nothing new is there.
    pub fn take_added(&mut self) -> Option<Opened> {
        self.added.take()
    }

    /// Lets go of what is being opened.
    pub fn give_up_opening(&mut self) {
        if self
            .opening
            .take()
            .is_some_and(|opening| opening.feed.begun())
        {
            self.stages.push(Stage::GivenUp);
        }
    }

    /// What came of a large study since the last call, in order.
    pub fn take_stages(&mut self) -> Vec<Stage> {
        std::mem::take(&mut self.stages)
    }

    /// Has a subject of the study that is being opened read before the others.
    pub fn read_first(&self, id: String) {
        if let Some(opening) = &self.opening {
            opening.feed.want(id);
        }
    }

    /// Opens the files that were opened last once more, with links that lead out of them.
    pub fn open_following_links(&mut self) {
        if let Some(OpenSource::Paths(paths)) = &self.last_opening {
            self.open(OpenSource::PathsAndLinks(paths.clone()));
        }
    }

    /// What was opened, once; `None` while nothing new is there.
    pub fn take_opened(&mut self) -> Option<Opened> {
        self.opened.take()
    }

    /// Whether something is being opened.
    pub fn opening(&self) -> bool {
        self.opening.is_some()
    }

    /// Makes files with `make` and writes them: all of them, or, if it fails or is stopped while
    /// making, none. What was written is handed out by [`Self::take_exported`].
    pub fn start_export(
        &mut self,
        name: impl Into<String>,
        parameters: impl Into<String>,
        make: impl FnOnce(&Progress) -> Result<Vec<ExportFile>, String> + Send + 'static,
    ) {
        self.start_writing(name, parameters, move |progress| {
            let files = make(progress)?;
            progress.check().map_err(|stopped| stopped.to_string())?;
            write_files(files)
        });
    }

    /// Writes files with `write`, which returns their paths; they are handed out by [`Self::take_exported`].
    pub fn start_writing(
        &mut self,
        name: impl Into<String>,
        parameters: impl Into<String>,
        write: impl FnOnce(&Progress) -> Result<Vec<PathBuf>, String> + Send + 'static,
    ) {
        let wake = Arc::clone(&self.wake);
        let job = Job::spawn(&self.exporter, wake, move |progress: &Progress| {
            write(progress).map_err(ExportError)
        });
        (self.store).list_job(Topic::EXPORT, name, parameters, Arc::clone(job.watch()));
        self.exports.push(job);
    }

    /// The files of a finished export, once.
    pub fn take_exported(&mut self) -> Option<Vec<PathBuf>> {
        self.exported.take()
    }

    /// Runs what is neither opened, exported nor asked of the store, such as a dialog of the operating system.
    ///
    /// It is not listed; whoever holds the job polls it, and must let go of it before the engine.
    pub fn spawn_aside<T, E>(
        &self,
        work: impl FnOnce(&Progress) -> Result<T, E> + Send + 'static,
    ) -> Job<T, E>
    where
        T: Send + 'static,
        E: std::fmt::Display + Send + 'static,
    {
        Job::spawn(&self.aside, Arc::clone(&self.wake), work)
    }

    /// Stops work of one kind; what was on screen stays, and nothing begins again until [`Self::retry`].
    pub fn cancel(&mut self, topic: Topic) {
        match topic {
            Topic::OPENING => {
                self.adding = None;
                match &self.opening {
                    // What was read of a large study stays: it is opened as if the rest were not there.
                    Some(opening) if opening.feed.begun() && opening.feed.stop_reading() => {
                        opening.job.watch().end(Ending::Stopped);
                    }
                    _ => self.give_up_opening(),
                }
            }
            Topic::EXPORT => self.exports.clear(),
            question => self.store.cancel(question),
        }
    }

    /// Begins work of one kind again that was stopped or has failed. A file to export to has to be chosen anew.
    pub fn retry(&mut self, topic: Topic) {
        match topic {
            Topic::OPENING => {
                if let Some(source) = self.last_opening.clone() {
                    self.open(source);
                }
            }
            Topic::EXPORT => {}
            question => self.store.retry(question),
        }
    }

    /// Takes in what jobs brought. Call once a frame.
    pub fn poll(&mut self) {
        self.poll_opening();
        if let Some(added) = finished(&mut self.adding) {
            match added {
                Ok(added) => self.added = Some(added),
                Err(error) => self.report(Topic::OPENING, "Adding failed", Arc::new(error)),
            }
        }
        for job in std::mem::take(&mut self.exports) {
            let mut job = Some(job);
            match finished(&mut job) {
                Some(Ok(files)) => self.exported.get_or_insert_default().extend(files),
                Some(Err(error)) => {
                    self.report(Topic::EXPORT, "Nothing was exported", Arc::new(error));
                }
                None => {}
            }
            self.exports.extend(job);
        }
    }

    fn poll_opening(&mut self) {
        let Some(opening) = &mut self.opening else {
            return;
        };
        let outcome = opening.job.poll();
        let stage = opening.feed.stage(outcome.is_some());
        let begun = opening.feed.begun();
        self.stages.extend(stage.map(|stage| match stage {
            Stage::Begun(study) => Stage::Begun(Study {
                revision: next_revision(&self.revisions),
                ..study
            }),
            other => other,
        }));
        let Some(outcome) = outcome else {
            return;
        };
        match outcome {
            Ok(opened) if begun => self.stages.push(Stage::Ended(opened)),
            Ok(opened) => self.opened = Some(opened),
            Err(error) => {
                if begun {
                    self.stages.push(Stage::GivenUp);
                }
                if !matches!(error, JobError::Failed(Stopped)) {
                    self.report(Topic::OPENING, "Opening failed", Arc::new(error));
                }
            }
        }
        self.opening = None;
    }

    /// What went wrong since the last call and needs a card.
    pub fn take_failures(&self) -> Vec<FailedWork> {
        self.store.take_failures()
    }

    /// Whether anything runs; while it does, its bar moves.
    pub fn busy(&self) -> bool {
        self.opening.is_some()
            || self.adding.is_some()
            || !self.exports.is_empty()
            || self.store.busy()
    }

    /// All work of this run, newest first.
    pub fn activities(&self) -> Vec<Activity> {
        self.store.activities()
    }

    /// The work that waits or runs, newest first.
    pub fn running(&self) -> Vec<Activity> {
        self.store.running()
    }

    fn report(&self, topic: Topic, title: &'static str, error: SharedError) {
        self.store.report(FailedWork {
            topic,
            title,
            error,
        });
    }
}

/// The outcome of a job that has ended; a stop is none.
fn finished<T, E>(job: &mut Option<Job<T, E>>) -> Option<Result<T, JobError<E>>>
where
    T: Send + 'static,
    E: std::fmt::Display + Send + 'static,
{
    let ended = job.as_mut()?;
    let outcome = ended.poll()?;
    let stopped = ended.watch().ending() == Some(&Ending::Stopped);
    *job = None;
    (!stopped).then_some(outcome)
}

fn next_revision(revisions: &AtomicU64) -> Revision {
    Revision(revisions.fetch_add(1, Ordering::Relaxed))
}
