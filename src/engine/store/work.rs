//! One computation under way: its progress, who wants it, and what it waits for itself.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::engine::job::{Ending, JobWatch};

/// A poisoned lock holds whole values: nothing panics while one is half changed.
pub(super) fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Holds a cancelled or failed question, and those that failed because of it, until it is retried.
#[derive(Clone, Debug)]
pub(super) struct Hold(Arc<AtomicBool>);

impl Hold {
    pub fn new() -> Self {
        Self(Arc::new(AtomicBool::new(true)))
    }

    /// Lets it and all that share it begin again.
    pub fn release(&self) {
        self.0.store(false, Ordering::SeqCst);
    }

    pub fn holds(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// One run of a question, from queued to ended. It goes on as long as anyone wants it.
#[derive(Debug, Default)]
pub(super) struct Work {
    pub watch: Arc<JobWatch>,
    /// A thread has taken it. Changed only under the lock of its slot.
    running: AtomicBool,
    /// A pane asked for it in the latest frame.
    asked: AtomicBool,
    /// Readers outside the store that wait for it.
    pins: AtomicUsize,
    /// Other work that waits for it.
    askers: Mutex<Vec<Arc<Work>>>,
    /// Other work that it waits for.
    awaited: Mutex<Vec<Arc<Work>>>,
    /// Of a question that it asked and that was cancelled or has failed, and whether a card says so.
    below: Mutex<Option<(Hold, bool)>>,
}

impl Work {
    pub fn set_running(&self) {
        self.running.store(true, Ordering::SeqCst);
    }

    pub fn runs(&self) -> bool {
        self.running.load(Ordering::SeqCst)
    }

    pub fn set_asked(&self, asked: bool) {
        self.asked.store(asked, Ordering::SeqCst);
    }

    pub fn is_asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }

    pub fn stopped(&self) -> bool {
        self.watch.progress().stop_requested()
    }

    /// Ends it whoever wants it, and what it waits for unless somebody else wants that.
    pub fn stop(&self) {
        self.watch.progress().stop();
        self.watch.end(Ending::Stopped);
        // Cloned, so that no lock is held while other work is looked at.
        let awaited = lock(&self.awaited).clone();
        for work in awaited {
            work.stop_if_unwanted();
        }
    }

    /// Ends it if nobody wants it any more.
    pub fn stop_if_unwanted(&self) {
        if !self.stopped() && !self.wanted() {
            self.stop();
        }
    }

    fn wanted(&self) -> bool {
        self.is_asked()
            || self.pins.load(Ordering::SeqCst) > 0
            || lock(&self.askers).iter().any(|work| !work.stopped())
    }

    /// What is known of the questions that it asked in vain.
    pub fn below(&self) -> Option<(Hold, bool)> {
        lock(&self.below).clone()
    }

    pub fn set_below(&self, hold: &Hold, reported: bool) {
        *lock(&self.below) = Some((hold.clone(), reported));
    }

    /// Whether it waits, perhaps through others, for `other`.
    fn waits_for(&self, other: &Arc<Self>) -> bool {
        let awaited = lock(&self.awaited).clone();
        awaited
            .iter()
            .any(|work| Arc::ptr_eq(work, other) || work.waits_for(other))
    }
}

/// Work waits for other work as long as this lives.
pub(super) struct Waiting<'a> {
    asker: &'a Arc<Work>,
    awaited: Arc<Work>,
}

impl<'a> Waiting<'a> {
    /// `None` if the two would wait for each other.
    pub fn begin(asker: &'a Arc<Work>, awaited: &Arc<Work>) -> Option<Self> {
        // Said before it is checked: of two threads that close a circle, at least one sees it.
        lock(&asker.awaited).push(Arc::clone(awaited));
        lock(&awaited.askers).push(Arc::clone(asker));
        let waiting = Self {
            asker,
            awaited: Arc::clone(awaited),
        };
        let circle = Arc::ptr_eq(asker, awaited) || awaited.waits_for(asker);
        (!circle).then_some(waiting)
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        remove_one(&self.asker.awaited, &self.awaited);
        remove_one(&self.awaited.askers, self.asker);
        // Whoever asked may have been stopped meanwhile, and nobody else may want it.
        if self.asker.stopped() {
            self.awaited.stop_if_unwanted();
        }
    }
}

fn remove_one(list: &Mutex<Vec<Arc<Work>>>, work: &Arc<Work>) {
    let mut list = lock(list);
    if let Some(place) = list.iter().position(|other| Arc::ptr_eq(other, work)) {
        list.swap_remove(place);
    }
}

/// A reader outside the store waits for work as long as this lives.
pub(super) struct Pin(Arc<Work>);

impl Pin {
    pub fn on(work: &Arc<Work>) -> Self {
        work.pins.fetch_add(1, Ordering::SeqCst);
        Self(Arc::clone(work))
    }

    pub fn work(&self) -> &Arc<Work> {
        &self.0
    }
}

impl Drop for Pin {
    fn drop(&mut self) {
        self.0.pins.fetch_sub(1, Ordering::SeqCst);
        if self.0.watch.ending().is_none() {
            self.0.stop_if_unwanted();
        }
    }
}
