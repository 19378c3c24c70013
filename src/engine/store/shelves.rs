//! All that a store holds, without the types of its questions: shelves, queue, budget, activity list, failures.

use std::any::{Any, TypeId};
use std::collections::{HashMap, HashSet};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use crate::engine::activity::{ActivityLog, Topic};
use crate::engine::job::Wake;
use crate::engine::store::interrupted::SharedError;
use crate::engine::store::memory::Memory;
use crate::engine::store::queue::Queue;
use crate::engine::store::work::lock;
use crate::study::Study;

/// What the store does to all shelves alike.
pub(super) trait AnyShelf: Send + Sync {
    fn as_any(self: Arc<Self>) -> Arc<dyn Any + Send + Sync>;
    fn topic(&self) -> Topic;
    /// Stops what no pane asked for in this frame, and forgets questions without answer that nobody asks.
    fn end_frame(&self, frame: u64);
    fn stop_all(&self);
    fn cancel(&self);
    fn retry(&self);
    /// Whether something is under way that a pane asks for.
    fn works(&self) -> bool;
    /// Has questions mean the same subjects in a state of the study that has them in other places.
    fn follow(&self, study: &Study);
    /// All answers that it holds.
    fn held(&self, into: &mut Vec<Held>);
    /// Forgets the answers with these numbers.
    fn forget(&self, numbers: &HashSet<u64>);
}

/// An answer that a shelf holds.
pub(super) struct Held {
    /// Names the answer within the store.
    pub number: u64,
    /// The frame in which a pane asked for it last.
    pub frame: u64,
    /// Greater for those used later.
    pub used: u64,
    pub memory: Memory,
}

/// Work that a pane asked for and that went wrong, for a card.
#[derive(Clone, Debug)]
pub struct FailedWork {
    /// By which it is retried.
    pub topic: Topic,
    /// What could not be done.
    pub title: &'static str,
    /// Why, with its sources.
    pub error: SharedError,
}

/// What all shelves share.
pub(super) struct Shelves {
    by_type: Mutex<HashMap<TypeId, Arc<dyn AnyShelf>>>,
    pub queue: Arc<Queue>,
    pub log: Mutex<ActivityLog>,
    pub failures: Mutex<Vec<FailedWork>>,
    pub wake: Wake,
    budget: usize,
    /// Bytes of the study on screen, which count, too.
    study_bytes: AtomicUsize,
    /// Whether answers came, or left the screen while there were too many.
    crowded: AtomicBool,
    frame: AtomicU64,
    clock: AtomicU64,
}

impl Shelves {
    pub fn new(queue: Arc<Queue>, wake: Wake, budget: usize) -> Self {
        Self {
            by_type: Mutex::default(),
            queue,
            log: Mutex::default(),
            failures: Mutex::default(),
            wake,
            budget,
            study_bytes: AtomicUsize::new(0),
            crowded: AtomicBool::new(false),
            // Later than "never asked by a pane", which is 0, by more than a frame.
            frame: AtomicU64::new(2),
            clock: AtomicU64::new(1),
        }
    }

    /// The frame that is being drawn.
    pub fn frame(&self) -> u64 {
        self.frame.load(Ordering::SeqCst)
    }

    /// A number that none had before.
    pub fn tick(&self) -> u64 {
        self.clock.fetch_add(1, Ordering::SeqCst)
    }

    /// The shelf of a type of question, made if need be.
    pub fn of_type<S: AnyShelf + Default + 'static>(&self, question: TypeId) -> Arc<S> {
        let mut shelves = lock(&self.by_type);
        let shelf = (shelves.entry(question)).or_insert_with(|| Arc::new(S::default()));
        // Each stands under its own type, so the cast succeeds.
        (Arc::clone(shelf).as_any().downcast()).unwrap_or_default()
    }

    /// All shelves; no lock is held while they are used.
    pub fn all(&self) -> Vec<Arc<dyn AnyShelf>> {
        lock(&self.by_type).values().cloned().collect()
    }

    /// Ends a frame.
    pub fn end_frame(&self) {
        let frame = self.frame();
        for shelf in self.all() {
            shelf.end_frame(frame);
        }
        self.frame.store(frame + 1, Ordering::SeqCst);
        if self.crowded.load(Ordering::SeqCst) {
            self.give_memory_back();
        }
    }

    /// The study on screen holds so much: at the end of the frame answers may have to go.
    pub fn hold_study(&self, bytes: usize) {
        self.study_bytes.store(bytes, Ordering::SeqCst);
        self.crowded.store(true, Ordering::SeqCst);
    }

    /// Forgets the answers used longest ago, as far as all together hold more than the budget. What is on screen
    /// stays: it was asked for in this frame or the one before.
    pub fn give_memory_back(&self) {
        let shelves = self.all();
        let mut held = Vec::new();
        for shelf in &shelves {
            shelf.held(&mut held);
        }
        let frame = self.frame();
        let on_screen = |answer: &Held| answer.frame + 1 >= frame;
        held.sort_by_key(|answer| std::cmp::Reverse((on_screen(answer), answer.used)));
        let study = self.study_bytes.load(Ordering::SeqCst);
        let (mut total, mut seen, mut gone) = (study, HashSet::new(), HashSet::new());
        for answer in &held {
            let parts = answer.memory.shared_parts().iter();
            let new_parts = parts.filter(|(address, _)| seen.insert(*address));
            let shared: usize = new_parts.map(|(_, bytes)| bytes).sum();
            total = total.saturating_add(answer.memory.own_bytes() + shared);
            if total > self.budget && !on_screen(answer) {
                gone.insert(answer.number);
            }
        }
        self.crowded.store(total > self.budget, Ordering::SeqCst);
        if !gone.is_empty() {
            for shelf in &shelves {
                shelf.forget(&gone);
            }
        }
    }
}
