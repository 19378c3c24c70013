//! The store of one window or one command: what is asked is answered once, and kept while there is room.

use std::sync::{Arc, Mutex, OnceLock};

use crate::engine::activity::{Activity, Topic};
use crate::engine::job::{JobWatch, Wake};
use crate::engine::store::ask::{Answered, compute, known, report, shelf};
use crate::engine::store::interrupted::{Interrupted, SharedError, StillUnread};
use crate::engine::store::memory::default_budget;
use crate::engine::store::query::Query;
use crate::engine::store::queue::{Queue, Urgency};
use crate::engine::store::shelf::SlotOf;
use crate::engine::store::shelves::{FailedWork, Shelves};
use crate::engine::store::slot::State;
use crate::engine::store::work::{Pin, Work, lock};
use crate::progress::Progress;
use crate::study::Study;

/// Longer than any chain of questions.
const MAX_RELEASES: usize = 16;

/// What a pane may draw for a question.
#[derive(Clone, Debug)]
pub enum Showing<A> {
    /// The answer.
    Ready(Arc<A>),
    /// On its way, or not begun yet.
    Computing {
        /// The last good answer, which stays on screen.
        previous: Option<Arc<A>>,
        /// Fraction, phase and time left.
        watch: Arc<JobWatch>,
    },
    /// Cancelled by the user, or failed; a retry begins it again.
    Interrupted {
        /// Which of the two.
        why: Interrupted,
        /// The last good answer, which stays on screen.
        previous: Option<Arc<A>>,
    },
}

impl<A> Showing<A> {
    /// The answer to what was asked, if it is there.
    pub fn ready(&self) -> Option<&Arc<A>> {
        match self {
            Self::Ready(answer) => Some(answer),
            Self::Computing { .. } | Self::Interrupted { .. } => None,
        }
    }

    /// The answer, else the last good one.
    pub fn latest(&self) -> Option<&Arc<A>> {
        match self {
            Self::Ready(answer) => Some(answer),
            Self::Computing { previous, .. } | Self::Interrupted { previous, .. } => {
                previous.as_ref()
            }
        }
    }

    /// Whether it is on its way.
    pub fn computing(&self) -> bool {
        matches!(self, Self::Computing { .. })
    }

    /// Why it failed, if it did.
    pub fn failure(&self) -> Option<&SharedError> {
        match self {
            Self::Interrupted {
                why: Interrupted::Failed(error),
                ..
            } => Some(error),
            _ => None,
        }
    }

    /// Whether the user cancelled it.
    pub fn stopped(&self) -> bool {
        matches!(
            self,
            Self::Interrupted {
                why: Interrupted::Stopped,
                ..
            }
        )
    }
}

/// How a store is set up.
#[derive(Clone)]
pub struct StoreOptions {
    /// Bytes that all answers together may hold; what is on screen stays even if it is more.
    pub budget: usize,
    /// Called whenever work that a pane asked for ends.
    pub wake: Wake,
}

impl Default for StoreOptions {
    fn default() -> Self {
        Self {
            budget: default_budget(),
            wake: Arc::new(|| ()),
        }
    }
}

/// Asks, answers and keeps. Dropping it stops its work, then joins its threads.
pub struct Store {
    shelves: Arc<Shelves>,
    /// What is shown of a question that is not begun.
    not_begun: OnceLock<Arc<JobWatch>>,
    /// The work that reads the study last opened: what is asked of all subjects waits for it.
    reading: Mutex<Option<Arc<JobWatch>>>,
}

impl Store {
    /// Starts the threads.
    ///
    /// # Errors
    /// If the operating system refuses one.
    pub fn start(options: StoreOptions) -> std::io::Result<Self> {
        let shelves = Shelves::new(Queue::start()?, options.wake, options.budget);
        Ok(Self {
            shelves: Arc::new(shelves),
            not_begun: OnceLock::new(),
            reading: Mutex::default(),
        })
    }

    /// What a pane draws for a question now; begins the work if need be. Cheap every frame: what no pane asks for in a
    /// frame is stopped at its [end](Self::end_frame).
    pub fn ask<Q: Query>(&self, study: &Arc<Study>, query: &Q) -> Showing<Q::Answer> {
        self.show(study, query, true)
    }

    /// The same, without beginning anything: for what can wait while the pointer is down.
    pub fn watch<Q: Query>(&self, study: &Arc<Study>, query: &Q) -> Showing<Q::Answer> {
        self.show(study, query, false)
    }

    /// The answer to a question if it is known. Asks for nothing.
    pub fn known<Q: Query>(&self, study: &Study, query: &Q) -> Option<Arc<Q::Answer>> {
        known(&self.shelves, study, query)
    }

    /// Takes in an answer that is known from elsewhere.
    pub fn put<Q: Query>(&self, study: &Study, query: &Q, answer: Arc<Q::Answer>) {
        let (depends_on, now) = (query.depends_on(study), self.shelves.tick());
        let shelf = shelf::<Q>(&self.shelves);
        shelf.entries().of(query, &depends_on, now).slot.set(answer);
        self.shelves.give_memory_back();
    }

    /// The answer, however long it takes: for commands and exports. Computed by the store's threads, so that it goes on
    /// for a pane that wants it too when `progress` is stopped.
    ///
    /// # Errors
    /// What interrupted it.
    pub fn answer<Q: Query>(
        &self,
        study: &Arc<Study>,
        query: &Q,
        progress: &Progress,
    ) -> Answered<Q> {
        let (depends_on, now) = (query.depends_on(study), self.shelves.tick());
        if depends_on.waits_for(study) {
            return Err(StillUnread::of(study).into());
        }
        let shelf = shelf::<Q>(&self.shelves);
        let slot = Arc::clone(&shelf.entries().of(query, &depends_on, now).slot);
        // Whoever asks so may well want what a pane was denied; each step below it may be held too.
        let mut releases = MAX_RELEASES;
        loop {
            let under_way = match slot.peek() {
                State::Done(answer) => {
                    progress.followed();
                    return Ok(answer);
                }
                State::Failed(failure, ..) => return Err(Interrupted::Failed(failure)),
                State::Cancelled(hold) if releases > 0 => {
                    releases -= 1;
                    hold.release();
                    None
                }
                State::Cancelled(_) => return Err(Interrupted::Stopped),
                State::UnderWay(work) => Some(Pin::on(&work)),
                State::Idle => None,
            };
            progress.check()?;
            let pin = under_way.unwrap_or_else(|| {
                let pin = Pin::on(&Arc::<Work>::default());
                // Nobody watches for a place that statistics of a cohort may take, so they go with the rest.
                self.enqueue(
                    study,
                    query,
                    &slot,
                    pin.work(),
                    Q::URGENCY.max(Urgency::Visible),
                );
                pin
            });
            progress.follow(pin.work().watch.progress());
            while progress.check().is_ok()
                && matches!(slot.peek(), State::UnderWay(now) if Arc::ptr_eq(&now, pin.work()))
            {
                slot.wait_for(pin.work());
            }
        }
    }

    /// The user pressed Cancel: what panes ask for of this kind stops, and is not begun again until it is retried.
    pub fn cancel(&self, topic: Topic) {
        for shelf in self.shelves.all() {
            if shelf.topic() == topic {
                shelf.cancel();
            }
        }
    }

    /// Lets what was cancelled or has failed of this kind begin again at the next [`Self::ask`].
    pub fn retry(&self, topic: Topic) {
        for shelf in self.shelves.all() {
            if shelf.topic() == topic {
                shelf.retry();
            }
        }
    }

    /// The work that reads the study which is shown next.
    pub fn set_reading(&self, watch: Arc<JobWatch>) {
        *lock(&self.reading) = Some(watch);
    }

    /// Another state of the study is on screen, which may have subjects in other places: what is known of each stays
    /// known. Its surfaces count to the memory.
    pub fn follow(&self, study: &Study) {
        for shelf in self.shelves.all() {
            shelf.follow(study);
        }
        self.shelves.hold_study(study.bytes());
    }

    /// Ends a frame: what no pane asked for in it is stopped, and memory past the budget is given back.
    pub fn end_frame(&self) {
        self.shelves.end_frame();
    }

    /// What went wrong since the last call and needs a card.
    pub fn take_failures(&self) -> Vec<FailedWork> {
        std::mem::take(&mut lock(&self.shelves.failures))
    }

    /// Has a card say that a job went wrong.
    pub fn report(&self, failure: FailedWork) {
        lock(&self.shelves.failures).push(failure);
    }

    /// Shows a job in the activity list, among what panes asked for.
    pub fn list_job(
        &self,
        topic: Topic,
        name: impl Into<String>,
        parameters: impl Into<String>,
        watch: Arc<JobWatch>,
    ) {
        lock(&self.shelves.log).record(topic, name, parameters, watch);
    }

    /// All work of this run that panes asked for, and jobs, newest first.
    pub fn activities(&self) -> Vec<Activity> {
        lock(&self.shelves.log).list()
    }

    /// The work that waits or runs, newest first.
    pub fn running(&self) -> Vec<Activity> {
        lock(&self.shelves.log).running()
    }

    /// Whether something of this kind is under way that a pane asks for.
    pub fn works_on(&self, topic: Topic) -> bool {
        (self.shelves.all().iter()).any(|shelf| shelf.topic() == topic && shelf.works())
    }

    /// Whether any thread works, or work waits for one.
    pub fn busy(&self) -> bool {
        self.shelves.queue.busy()
    }

    /// How many answers to this type of question are kept.
    pub fn answers<Q: Query>(&self) -> usize {
        shelf::<Q>(&self.shelves).entries().answers()
    }

    fn show<Q: Query>(&self, study: &Arc<Study>, query: &Q, begin: bool) -> Showing<Q::Answer> {
        let (frame, now) = (self.shelves.frame(), self.shelves.tick());
        let depends_on = query.depends_on(study);
        if depends_on.waits_for(study) {
            let watch = lock(&self.reading).clone();
            return Showing::Computing {
                previous: None,
                watch: watch.unwrap_or_else(|| self.not_begun()),
            };
        }
        let shelf = shelf::<Q>(&self.shelves);
        let mut entries = shelf.entries();
        let entry = entries.of(query, &depends_on, now);
        entry.touch(frame, now);
        let slot = Arc::clone(&entry.slot);
        let seen = slot.peek();
        if let State::Done(answer) = seen {
            entry.show(now);
            return Showing::Ready(answer);
        }
        let first = match seen {
            State::Idle => entries.finished_first(query, frame, now),
            _ => None,
        };
        let previous = entries.previous(query, &depends_on, frame);
        drop(entries);
        let watch = match seen {
            State::Failed(failure, ..) => {
                if Q::FAILURE.is_some() {
                    report::<Q>(slot.report(), &self.shelves);
                }
                let why = Interrupted::Failed(failure);
                return Showing::Interrupted { why, previous };
            }
            State::Cancelled(_) => {
                let why = Interrupted::Stopped;
                return Showing::Interrupted { why, previous };
            }
            State::UnderWay(work) => Some(Arc::clone(&work.watch)),
            State::Idle if begin && first.is_none() => Some(self.begin(study, query, &slot)),
            State::Idle | State::Done(_) => first,
        };
        let watch = watch.unwrap_or_else(|| self.not_begun());
        Showing::Computing { previous, watch }
    }

    fn not_begun(&self) -> Arc<JobWatch> {
        Arc::clone(self.not_begun.get_or_init(Arc::default))
    }

    fn begin<Q: Query>(&self, study: &Arc<Study>, query: &Q, slot: &SlotOf<Q>) -> Arc<JobWatch> {
        let work = Arc::<Work>::default();
        work.set_asked(true);
        if Q::LISTED {
            let (topic, watch) = (Topic::of::<Q>(), Arc::clone(&work.watch));
            lock(&self.shelves.log).record(topic, Q::TITLE, query.parameters(), watch);
        }
        self.enqueue(study, query, slot, &work, Q::URGENCY);
        Arc::clone(&work.watch)
    }

    fn enqueue<Q: Query>(
        &self,
        study: &Arc<Study>,
        query: &Q,
        slot: &SlotOf<Q>,
        work: &Arc<Work>,
        urgency: Urgency,
    ) {
        if !slot.queue(work) {
            return;
        }
        let (study, query, slot) = (Arc::clone(study), query.clone(), Arc::clone(slot));
        // The queue must not keep alive the shelves that keep the queue.
        let shelves = Arc::downgrade(&self.shelves);
        let begun = Arc::clone(work);
        let run = Box::new(move || {
            if let Some(shelves) = shelves.upgrade()
                && slot.begin(&begun)
            {
                compute(&slot, &begun, &query, &study, urgency, &shelves);
            }
        });
        self.shelves.queue.push(urgency, work, run);
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        for shelf in self.shelves.all() {
            shelf.stop_all();
        }
        self.shelves.queue.close();
    }
}
