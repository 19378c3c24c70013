//! The window's way to background work: opens, analyses and exports, and keeps what came of it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::engine::activity::{Activity, ActivityLog, WorkKind};
use crate::engine::cache::Cache;
use crate::engine::export::{ExportFile, write_files};
use crate::engine::job::{Job, Wake};
use crate::engine::open::{OpenSource, open};
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::engine::slot::{Showing, Slot};
use crate::engine::workers::Workers;
use crate::io::{Limits, Opened};
use crate::progress::{Progress, Stopped};
use crate::study::{Revision, Study};

type AnalysisSlot = Slot<(Revision, AnalysisRequest), AnalysisOutcome, AnalysisError>;

/// Whether a request that was stopped or has failed begins anew.
#[derive(Clone, Copy)]
enum Asking {
    Once,
    Again,
}

/// All background work of one window.
///
/// Calls return at once. Every frame: [`Self::poll`], then request what the visible state needs;
/// the same request again costs nothing. Dropping the engine stops its work, then joins its threads.
pub struct Engine {
    // Slots stand before the workers: they are dropped first, which stops what still runs.
    opening: Slot<u64, Opened, Stopped>,
    analyses: BTreeMap<WorkKind, AnalysisSlot>,
    export: Slot<u64, Vec<PathBuf>, String>,
    log: ActivityLog,
    cache: Arc<Cache>,
    revisions: Arc<AtomicU64>,
    last_opening: Option<OpenSource>,
    tickets: u64,
    limits: Limits,
    wake: Wake,
    jobs: Workers,
    reader: Workers,
}

impl Engine {
    /// Starts two threads for computations and one that reads files. `wake` is called from them
    /// whenever [`Self::poll`] will find something new.
    ///
    /// # Errors
    /// If the operating system refuses a thread.
    pub fn start(wake: Wake) -> std::io::Result<Self> {
        Ok(Self {
            opening: Slot::default(),
            analyses: BTreeMap::new(),
            export: Slot::default(),
            log: ActivityLog::default(),
            cache: Arc::new(Cache::default()),
            revisions: Arc::new(AtomicU64::new(1)),
            last_opening: None,
            tickets: 0,
            limits: Limits::default(),
            wake,
            jobs: Workers::start("job", 2)?,
            reader: Workers::start("reader", 1)?,
        })
    }

    /// A revision that no study of this engine has yet; for whoever edits a study.
    pub fn next_revision(&self) -> Revision {
        next_revision(&self.revisions)
    }

    /// Opens something in place of what is being opened; the study in use is not touched.
    /// What comes of it is handed out once, by [`Self::take_opened`].
    pub fn open(&mut self, source: OpenSource) {
        let ticket = self.ticket();
        let (name, words) = (source.name(), source.words());
        let (limits, revisions) = (self.limits, Arc::clone(&self.revisions));
        self.last_opening = Some(source.clone());
        let (reader, wake) = (&self.reader, &self.wake);
        self.opening.request(ticket, || {
            let job = Job::spawn(reader, Arc::clone(wake), move |progress: &Progress| {
                let mut opened = open(&source, &limits, progress)?;
                opened.study.revision = next_revision(&revisions);
                Ok(opened)
            });
            self.log
                .record(WorkKind::Open, name, words, Arc::clone(job.watch()));
            job
        });
    }

    /// What was opened, once; `None` while nothing new is there.
    pub fn take_opened(&mut self) -> Option<Arc<Opened>> {
        let opened = self.opening.ready().cloned()?;
        self.opening.clear();
        Some(opened)
    }

    /// How opening stands. After a failure or a stop it says so until something else is opened.
    pub fn opening(&self) -> Showing<'_, Opened, Stopped> {
        self.opening.showing()
    }

    /// Asks for an analysis in place of the one of its kind that was asked for before; free if it
    /// is the same. What was stopped or failed is not begun again: that is [`Self::retry`].
    pub fn request(&mut self, study: &Arc<Study>, request: AnalysisRequest) {
        self.ask(study, request, Asking::Once);
    }

    /// Computes again what was stopped or failed; free if nothing was.
    pub fn retry(&mut self, study: &Arc<Study>, request: AnalysisRequest) {
        self.ask(study, request, Asking::Again);
    }

    /// Opens again what was stopped or failed; free if nothing was opened.
    pub fn retry_open(&mut self) {
        if let Some(source) = self.last_opening.clone() {
            self.open(source);
        }
    }

    /// How an analysis stands; nothing is said of [`WorkKind::Open`] and [`WorkKind::Export`].
    pub fn showing(&self, kind: WorkKind) -> Showing<'_, AnalysisOutcome, AnalysisError> {
        (self.analyses.get(&kind)).map_or(Showing::Nothing, Slot::showing)
    }

    /// The newest result of its kind at hand, of whichever revision and settings.
    pub fn latest(&self, kind: WorkKind) -> Option<&AnalysisOutcome> {
        self.analyses.get(&kind)?.latest().map(|outcome| &**outcome)
    }

    /// An answer that was computed before, asked for or as a step to another, if it is still kept.
    /// Starts nothing.
    pub fn known(&self, study: &Study, request: &AnalysisRequest) -> Option<AnalysisOutcome> {
        self.cache.get(study, request)
    }

    /// Poses between frames are found beginning with this interval, and from it on through the
    /// beat: the one on screen. Work under way turns to it after the interval that it is at.
    pub fn look_at_interval(&self, interval: usize) {
        self.cache.look_at_interval(interval);
    }

    /// Makes files with `make` and writes them: all of them, or, if it fails or is stopped while
    /// making, none. What was written is in [`Self::export`] afterwards.
    pub fn start_export(
        &mut self,
        name: impl Into<String>,
        parameters: impl Into<String>,
        make: impl FnOnce(&Progress) -> Result<Vec<ExportFile>, String> + Send + 'static,
    ) {
        let ticket = self.ticket();
        let (jobs, wake, log) = (&self.jobs, &self.wake, &mut self.log);
        self.export.request(ticket, || {
            let job = Job::spawn(jobs, Arc::clone(wake), move |progress: &Progress| {
                let files = make(progress)?;
                progress.check().map_err(|stopped| stopped.to_string())?;
                write_files(files)
            });
            log.record(WorkKind::Export, name, parameters, Arc::clone(job.watch()));
            job
        });
    }

    /// Whether one kind of analysis goes on.
    pub fn computes(&self, kind: WorkKind) -> bool {
        matches!(self.showing(kind), Showing::Computing { .. })
    }

    /// How the export stands.
    pub fn export(&self) -> Showing<'_, Vec<PathBuf>, String> {
        self.export.showing()
    }

    /// The files of a finished export, once.
    pub fn take_exported(&mut self) -> Option<Arc<Vec<PathBuf>>> {
        let files = self.export.ready().cloned()?;
        self.export.clear();
        Some(files)
    }

    /// Stops one kind of work; the last good result stays.
    pub fn cancel(&mut self, kind: WorkKind) {
        match kind {
            WorkKind::Open => self.opening.stop(),
            WorkKind::Export => self.export.stop(),
            analysis => {
                if let Some(slot) = self.analyses.get_mut(&analysis) {
                    slot.stop();
                }
            }
        }
    }

    /// Takes in what finished, and says whether something did. Call once a frame.
    pub fn poll(&mut self) -> bool {
        // Every slot is asked, so no short cut at the first that has news.
        let mut news = self.opening.poll();
        news |= self.export.poll();
        for slot in self.analyses.values_mut() {
            news |= slot.poll();
        }
        news
    }

    /// Whether anything runs; while it does, its bar moves.
    pub fn busy(&self) -> bool {
        let analysing = self.analyses.values().any(Slot::busy);
        self.opening.busy() || analysing || self.export.busy()
    }

    /// All work of this run, newest first.
    pub fn activities(&self) -> Vec<Activity> {
        self.log.list()
    }

    /// The work that waits or runs, newest first.
    pub fn running(&self) -> Vec<Activity> {
        self.log.running()
    }

    fn ask(&mut self, study: &Arc<Study>, request: AnalysisRequest, asking: Asking) {
        let kind = request.kind();
        let slot = self.analyses.entry(kind).or_default();
        let (jobs, wake, log) = (&self.jobs, &self.wake, &mut self.log);
        let (work_study, cache) = (Arc::clone(study), Arc::clone(&self.cache));
        // Called only where work really has to begin.
        let start = || {
            let job = Job::spawn(jobs, Arc::clone(wake), move |progress: &Progress| {
                run(&work_study, &request, &cache, progress)
            });
            let watch = Arc::clone(job.watch());
            log.record(kind, request.name(), request.parameters(), watch);
            job
        };
        let key = (study.revision, request);
        match asking {
            Asking::Once => slot.request(key, start),
            Asking::Again => slot.retry(key, start),
        }
    }

    fn ticket(&mut self) -> u64 {
        self.tickets += 1;
        self.tickets
    }
}

fn next_revision(revisions: &AtomicU64) -> Revision {
    Revision(revisions.fetch_add(1, Ordering::Relaxed))
}
