//! How a running question asks another one: from the store, from the thread that computes it now, or computed here.

use std::any::TypeId;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::engine::activity::Topic;
use crate::engine::job::{Ending, panic_message};
use crate::engine::store::dependencies::Dependencies;
use crate::engine::store::interrupted::{Bug, Interrupted, SharedError, StillUnread};
use crate::engine::store::query::{Context, Query};
use crate::engine::store::queue::Urgency;
use crate::engine::store::shelf::{Shelf, SlotOf};
use crate::engine::store::shelves::{FailedWork, Shelves};
use crate::engine::store::slot::State;
use crate::engine::store::work::{Waiting, Work, lock};
use crate::study::Study;

/// What a question brings.
pub type Answered<Q> = Result<Arc<<Q as Query>::Answer>, Interrupted>;

impl Context<'_> {
    /// The answer to another question. Its progress is shown as that of this part, whichever thread computes it. If this
    /// question is stopped, the other one goes on as long as somebody else wants it.
    ///
    /// # Errors
    /// What interrupted it.
    pub fn get<Q: Query>(&self, query: &Q) -> Answered<Q> {
        if query.depends_on(self.study).waits_for(self.study) {
            return Err(StillUnread::of(self.study).into());
        }
        let slot = self.slot(query);
        loop {
            if self.work.stopped() {
                return Err(Interrupted::Stopped);
            }
            match slot.claim() {
                Err(State::Done(answer)) => {
                    self.progress.followed();
                    return Ok(answer);
                }
                Err(State::Failed(failure, hold, reported)) => {
                    self.work.set_below(&hold, reported);
                    return Err(Interrupted::Failed(failure));
                }
                Err(State::Cancelled(hold)) => {
                    self.work.set_below(&hold, true);
                    return Err(Interrupted::Stopped);
                }
                Ok(work) => {
                    // Work that nobody else knows waits for nothing, so this closes no circle.
                    let _waiting = Waiting::begin(self.work, &work);
                    self.progress.follow(work.watch.progress());
                    compute(&slot, &work, query, self.study, self.place, self.shelves);
                    let ended_by_itself = work.watch.ending() == Some(&Ending::Stopped)
                        && !work.stopped()
                        && work.below().is_none();
                    // It would do so again, and again.
                    if ended_by_itself {
                        return Err(Interrupted::Stopped);
                    }
                }
                Err(State::UnderWay(work)) => {
                    let Some(_waiting) = Waiting::begin(self.work, &work) else {
                        return Err(Bug::AsksItself { title: Q::TITLE }.into());
                    };
                    self.progress.follow(work.watch.progress());
                    let _aside = self.shelves.queue.wait_aside(self.place);
                    while !self.work.stopped()
                        && matches!(slot.peek(), State::UnderWay(now) if Arc::ptr_eq(&now, &work))
                    {
                        slot.wait_for(&work);
                    }
                }
                // What is idle is taken.
                Err(State::Idle) => {}
            }
        }
    }

    /// The answer to another question as the first part of the work, with where the rest of it begins: at `share`, or at
    /// once if the answer is known.
    ///
    /// # Errors
    /// What interrupted it.
    pub fn first<Q: Query>(
        &self,
        name: &'static str,
        query: &Q,
        share: f32,
    ) -> Result<(Arc<Q::Answer>, f32), Interrupted> {
        let share = if self.known(query).is_some() {
            0.0
        } else {
            share
        };
        Ok((self.part(name, 0.0, share).get(query)?, share))
    }

    /// The answer to another question if it is known. Computes nothing.
    pub fn known<Q: Query>(&self, query: &Q) -> Option<Arc<Q::Answer>> {
        known(self.shelves, self.study, query)
    }

    /// The newest answer to the same question about another state of a study, with what it depends on: for whoever can
    /// use a part of it.
    pub fn similar<Q: Query>(&self, query: &Q) -> Option<(Dependencies, Arc<Q::Answer>)> {
        shelf::<Q>(self.shelves).entries().similar(query)
    }

    fn slot<Q: Query>(&self, query: &Q) -> SlotOf<Q> {
        let depends_on = query.depends_on(self.study);
        let now = self.shelves.tick();
        let shelf = shelf::<Q>(self.shelves);
        let mut entries = shelf.entries();
        Arc::clone(&entries.of(query, &depends_on, now).slot)
    }
}

/// The answer to a question if it is known; it counts as used.
pub(super) fn known<Q: Query>(
    shelves: &Shelves,
    study: &Study,
    query: &Q,
) -> Option<Arc<Q::Answer>> {
    let depends_on = query.depends_on(study);
    let shelf = shelf::<Q>(shelves);
    let mut entries = shelf.entries();
    let entry = entries.find(query, &depends_on)?;
    match entry.slot.peek() {
        State::Done(answer) => {
            entry.used(shelves.tick());
            Some(answer)
        }
        _ => None,
    }
}

pub(super) fn shelf<Q: Query>(shelves: &Shelves) -> Arc<Shelf<Q>> {
    shelves.of_type(TypeId::of::<Q>())
}

/// Computes what was claimed, on this thread.
pub(super) fn compute<Q: Query>(
    slot: &SlotOf<Q>,
    work: &Arc<Work>,
    query: &Q,
    study: &Arc<Study>,
    place: Urgency,
    shelves: &Arc<Shelves>,
) {
    work.watch.start();
    let cx = Context {
        study,
        progress: work.watch.progress().clone(),
        work,
        place,
        shelves,
    };
    // A panic leaves nothing half done that another question could see: answers are set in one step, below.
    let result = catch_unwind(AssertUnwindSafe(|| query.run(&cx))).unwrap_or_else(|payload| {
        let message = panic_message(&*payload);
        Err(Bug::Panicked { message }.into())
    });
    let reports = Q::FAILURE.is_some() && work.is_asked();
    let (ending, failure) = slot.finish(work, result, reports);
    report::<Q>(failure, shelves);
    let done = ending == Ending::Done;
    work.watch.end(ending);
    if done {
        shelves.give_memory_back();
    }
    if work.is_asked() {
        (shelves.wake)();
    }
}

/// Has a card say what went wrong, if anything did.
pub(super) fn report<Q: Query>(failure: Option<SharedError>, shelves: &Shelves) {
    if let (Some(title), Some(error)) = (Q::FAILURE, failure) {
        lock(&shelves.failures).push(FailedWork {
            topic: Topic::of::<Q>(),
            title,
            error,
        });
    }
}
