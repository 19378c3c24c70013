//! All answers to one type of question.

use std::any::Any;
use std::collections::HashSet;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock};

use crate::engine::activity::Topic;
use crate::engine::job::JobWatch;
use crate::engine::store::dependencies::Dependencies;
use crate::engine::store::memory::Memory;
use crate::engine::store::query::Query;
use crate::engine::store::shelves::{AnyShelf, Held};
use crate::engine::store::slot::{Slot, State};
use crate::engine::store::work::lock;
use crate::study::Study;

/// The slot of a question.
pub(super) type SlotOf<Q> = Arc<Slot<<Q as Query>::Answer>>;

/// The questions of one type that were asked.
pub(super) struct Shelf<Q: Query>(Mutex<Entries<Q>>);

/// Settings hold numbers with fractions, so questions are compared one by one, not hashed.
pub(super) struct Entries<Q: Query>(Vec<Entry<Q>>);

/// One question about one state of a study.
pub(super) struct Entry<Q: Query> {
    query: Q,
    depends_on: Dependencies,
    pub slot: SlotOf<Q>,
    number: u64,
    /// The frame in which a pane asked last; 0 if none did.
    frame: u64,
    used: u64,
    /// When it was on screen as the answer to what was asked; 0 if never.
    shown: u64,
    memory: OnceLock<Memory>,
}

impl<Q: Query> Default for Shelf<Q> {
    fn default() -> Self {
        Self(Mutex::new(Entries(Vec::new())))
    }
}

impl<Q: Query> Shelf<Q> {
    pub fn entries(&self) -> MutexGuard<'_, Entries<Q>> {
        lock(&self.0)
    }
}

impl<Q: Query> Entry<Q> {
    /// A pane asks for it in `frame`.
    pub fn touch(&mut self, frame: u64, now: u64) {
        self.frame = frame;
        self.used = now;
        if let State::UnderWay(work) = self.slot.peek() {
            work.set_asked(true);
        }
    }

    /// Somebody uses it.
    pub fn used(&mut self, now: u64) {
        self.used = now;
    }

    /// It is on screen.
    pub fn show(&mut self, now: u64) {
        self.shown = now;
    }

    fn answer(&self) -> Option<Arc<Q::Answer>> {
        match self.slot.peek() {
            State::Done(answer) => Some(answer),
            _ => None,
        }
    }
}

impl<Q: Query> Entries<Q> {
    /// The entry of a question, if it was asked before.
    pub fn find(&mut self, query: &Q, depends_on: &Dependencies) -> Option<&mut Entry<Q>> {
        let mut entries = self.0.iter_mut();
        entries.find(|entry| entry.query == *query && entry.depends_on == *depends_on)
    }

    /// The entry of a question, made if need be.
    pub fn of(&mut self, query: &Q, depends_on: &Dependencies, now: u64) -> &mut Entry<Q> {
        let same = |entry: &Entry<Q>| entry.query == *query && entry.depends_on == *depends_on;
        let place = self.0.iter().position(same).unwrap_or_else(|| {
            self.0.push(Entry {
                query: query.clone(),
                depends_on: depends_on.clone(),
                slot: Arc::default(),
                number: now,
                frame: 0,
                used: 0,
                shown: 0,
                memory: OnceLock::new(),
            });
            self.0.len() - 1
        });
        let entry = &mut self.0[place];
        entry.used = now;
        entry
    }

    /// The answer that was on screen last and may stay there until this question is answered. It counts as asked for.
    pub fn previous(
        &mut self,
        query: &Q,
        depends_on: &Dependencies,
        frame: u64,
    ) -> Option<Arc<Q::Answer>> {
        let entries = self.0.iter_mut();
        let may_stay = entries.filter(|entry| {
            entry.shown > 0
                && query.replaces(&entry.query)
                && entry.depends_on.same_surfaces(depends_on)
                && entry.answer().is_some()
        });
        let last = may_stay.max_by_key(|entry| entry.shown)?;
        last.frame = frame;
        last.answer()
    }

    /// Work that a pane asked for and that this question lets finish first. It counts as asked for.
    pub fn finished_first(&mut self, query: &Q, frame: u64, now: u64) -> Option<Arc<JobWatch>> {
        self.0.iter_mut().find_map(|entry| {
            let State::UnderWay(work) = entry.slot.peek() else {
                return None;
            };
            if !work.is_asked() || !query.lets_finish(&entry.query) {
                return None;
            }
            entry.touch(frame, now);
            // What comes of it goes on screen before the answer to the newest question.
            entry.show(now);
            Some(Arc::clone(&work.watch))
        })
    }

    /// The newest answer to the same question about another state of a study, with what it depends on.
    pub fn similar(&self, query: &Q) -> Option<(Dependencies, Arc<Q::Answer>)> {
        let same = self.0.iter().filter(|entry| entry.query == *query);
        same.filter_map(|entry| Some((entry, entry.answer()?)))
            .max_by_key(|(entry, _)| entry.used)
            .map(|(entry, answer)| (entry.depends_on.clone(), answer))
    }

    pub fn answers(&self) -> usize {
        self.0
            .iter()
            .filter(|entry| entry.answer().is_some())
            .count()
    }
}

impl<Q: Query> AnyShelf for Shelf<Q> {
    fn as_any(self: Arc<Self>) -> Arc<dyn Any + Send + Sync> {
        self
    }

    fn topic(&self) -> Topic {
        Topic::of::<Q>()
    }

    fn end_frame(&self, frame: u64) {
        let mut entries = self.entries();
        for entry in entries.0.iter().filter(|entry| entry.frame < frame) {
            if let State::UnderWay(work) = entry.slot.peek() {
                work.set_asked(false);
                work.stop_if_unwanted();
            }
        }
        // A slot that somebody holds may be about to be computed.
        entries.0.retain(|entry| {
            entry.frame >= frame
                || Arc::strong_count(&entry.slot) > 1
                || !matches!(entry.slot.peek(), State::Idle)
        });
    }

    fn stop_all(&self) {
        for entry in &self.entries().0 {
            if let State::UnderWay(work) = entry.slot.peek() {
                work.stop();
            }
        }
    }

    fn cancel(&self) {
        for entry in &self.entries().0 {
            if matches!(entry.slot.peek(), State::UnderWay(work) if work.is_asked()) {
                entry.slot.cancel();
            }
        }
    }

    fn retry(&self) {
        for entry in &self.entries().0 {
            entry.slot.retry();
        }
    }

    fn works(&self) -> bool {
        let entries = self.entries();
        let mut slots = entries.0.iter().map(|entry| entry.slot.peek());
        slots.any(|seen| matches!(seen, State::UnderWay(work) if work.is_asked()))
    }

    fn follow(&self, study: &Study) {
        (self.entries().0).retain_mut(|entry| {
            let subjects = entry.query.subjects();
            if subjects.is_empty() {
                return true;
            }
            let places = entry.depends_on.places(study);
            if places.len() != subjects.len() {
                // It does not say which subject is which: a number of one could come to stand under another's name.
                return false;
            }
            for (index, place) in subjects.into_iter().zip(places) {
                *index = place.unwrap_or(*index);
            }
            true
        });
    }

    fn held(&self, into: &mut Vec<Held>) {
        for entry in &self.entries().0 {
            let Some(answer) = entry.answer() else {
                continue;
            };
            let memory = entry.memory.get_or_init(|| {
                let mut memory = Memory::default();
                memory.own(size_of::<Entry<Q>>() + size_of::<Q::Answer>());
                Q::memory(&answer, &mut memory);
                memory
            });
            into.push(Held {
                number: entry.number,
                frame: entry.frame,
                used: entry.used,
                memory: memory.clone(),
            });
        }
    }

    fn forget(&self, numbers: &HashSet<u64>) {
        (self.entries().0).retain(|entry| !numbers.contains(&entry.number));
    }
}
