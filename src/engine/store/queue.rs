//! Work that waits for a thread, and the threads: the most urgent first, of equals the one asked for first.
//!
//! A thread whose work waits for other work gives its place away meanwhile, so that threads that wait for each other
//! hold nobody up.

use std::fmt::Debug;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::{Builder, JoinHandle};

use crate::engine::store::work::{Work, lock};
use crate::engine::thread_priority::take_place;

/// The order in which queued work begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Urgency {
    /// Everything else goes first: statistics of the whole cohort.
    Background,
    /// Fills a pane on screen.
    Visible,
    /// The user waits for it with the pointer down.
    Interactive,
}

/// Threads at the start: two for what is visible, and two that only interactive work may take, so that a slider never
/// waits for a map.
const THREADS: usize = 4;
/// Visible and background work that runs at a time; inner loops use all cores anyway.
const VISIBLE_AT_A_TIME: usize = 2;
/// Threads at most. Each step of a chain of questions may hold one that waits; chains have some five steps.
pub(super) const MAX_THREADS: usize = 16;

type Run = Box<dyn FnOnce() + Send>;

struct Item {
    urgency: Urgency,
    order: u64,
    work: Arc<Work>,
    run: Run,
}

#[derive(Default)]
struct Inner {
    waiting: Vec<Item>,
    /// Work that runs and does not wait, by urgency.
    active: [usize; 3],
    /// Work that a thread has begun and not ended.
    begun: usize,
    idle: usize,
    order: u64,
    closing: bool,
    threads: Vec<JoinHandle<()>>,
}

/// The queue with its threads.
#[derive(Default)]
pub(super) struct Queue {
    inner: Mutex<Inner>,
    news: Condvar,
}

impl Debug for Queue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Queue").finish_non_exhaustive()
    }
}

impl Queue {
    /// Starts the threads.
    ///
    /// # Errors
    /// If the operating system refuses one.
    pub fn start() -> std::io::Result<Arc<Self>> {
        let queue = Arc::new(Self::default());
        {
            let mut inner = lock(&queue.inner);
            for _ in 0..THREADS {
                queue.add_thread(&mut inner)?;
            }
        }
        Ok(queue)
    }

    /// Queues work; a free thread takes it. What the user waits for never waits for a thread that is held up.
    pub fn push(self: &Arc<Self>, urgency: Urgency, work: &Arc<Work>, run: Run) {
        let mut inner = lock(&self.inner);
        inner.order += 1;
        let order = inner.order;
        inner.waiting.push(Item {
            urgency,
            order,
            work: Arc::clone(work),
            run,
        });
        let held_up = urgency == Urgency::Interactive && inner.waiting.len() > inner.idle;
        if held_up && inner.threads.len() < MAX_THREADS {
            self.add_thread(&mut inner).ok();
        }
        drop(inner);
        // Which thread may take it depends on all that runs, so each looks.
        self.news.notify_all();
    }

    /// Whether anything runs or waits.
    pub fn busy(&self) -> bool {
        let inner = lock(&self.inner);
        inner.begun > 0 || inner.waiting.iter().any(|item| !item.work.stopped())
    }

    /// The work that this thread does now waits for other work, until the answer is dropped.
    pub fn wait_aside(self: &Arc<Self>, urgency: Urgency) -> Aside<'_> {
        let mut inner = lock(&self.inner);
        inner.active[urgency as usize] -= 1;
        // Whoever takes the free place needs a thread; where none can be had, it waits for one.
        if inner.idle == 0 && inner.threads.len() < MAX_THREADS {
            self.add_thread(&mut inner).ok();
        }
        drop(inner);
        self.news.notify_all();
        Aside {
            queue: self,
            urgency,
        }
    }

    /// Ends all threads once their work has seen that it is stopped.
    pub fn close(&self) {
        let (threads, waiting) = {
            let mut inner = lock(&self.inner);
            inner.closing = true;
            (
                std::mem::take(&mut inner.threads),
                std::mem::take(&mut inner.waiting),
            )
        };
        drop(waiting);
        self.news.notify_all();
        for thread in threads {
            thread.join().ok();
        }
    }

    fn add_thread(self: &Arc<Self>, inner: &mut Inner) -> std::io::Result<()> {
        let queue = Arc::clone(self);
        let name = format!("store-{}", inner.threads.len());
        let thread = Builder::new().name(name).spawn(move || {
            take_place();
            queue.serve();
        })?;
        inner.threads.push(thread);
        Ok(())
    }

    fn serve(&self) {
        let mut inner = lock(&self.inner);
        loop {
            if inner.closing {
                return;
            }
            let Some(item) = inner.next() else {
                inner.idle += 1;
                inner = (self.news.wait(inner)).unwrap_or_else(PoisonError::into_inner);
                inner.idle -= 1;
                continue;
            };
            inner.active[item.urgency as usize] += 1;
            inner.begun += 1;
            drop(inner);
            (item.run)();
            inner = lock(&self.inner);
            inner.active[item.urgency as usize] -= 1;
            inner.begun -= 1;
            // What had to wait for this place may begin.
            self.news.notify_all();
        }
    }
}

impl Inner {
    /// Takes the most urgent work that may begin now; what was stopped while it waited is dropped.
    fn next(&mut self) -> Option<Item> {
        self.waiting.retain(|item| !item.work.stopped());
        let place = (0..self.waiting.len())
            .filter(|&place| self.may_begin(self.waiting[place].urgency))
            .max_by_key(|&place| {
                let item = &self.waiting[place];
                (item.urgency, std::cmp::Reverse(item.order))
            })?;
        Some(self.waiting.swap_remove(place))
    }

    fn may_begin(&self, urgency: Urgency) -> bool {
        let [background, visible, interactive] = self.active;
        match urgency {
            Urgency::Interactive => true,
            Urgency::Visible => background + visible < VISIBLE_AT_A_TIME,
            Urgency::Background => background + visible + interactive == 0,
        }
    }
}

/// A thread's place is given away as long as this lives.
pub(super) struct Aside<'a> {
    queue: &'a Queue,
    urgency: Urgency,
}

impl Drop for Aside<'_> {
    fn drop(&mut self) {
        // The place is taken back without waiting: work that has begun is ended first.
        lock(&self.queue.inner).active[self.urgency as usize] += 1;
    }
}
