//! The state of one question: not asked, under way, answered, failed or cancelled.

use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use crate::engine::job::Ending;
use crate::engine::store::interrupted::{Interrupted, SharedError};
use crate::engine::store::work::{Hold, Work, lock};

/// Longest time in which a waiter hears that it is stopped itself.
const LOOK_AROUND: Duration = Duration::from_millis(20);

/// Answer `A` of one question, or its error, from not asked to known.
#[derive(Debug)]
pub(super) struct Slot<A> {
    state: Mutex<State<A>>,
    changed: Condvar,
}

/// Where a question stands. Stopped work, and what was released, is as if nobody had begun it.
#[derive(Debug)]
pub(super) enum State<A> {
    /// Nobody works on it.
    Idle,
    /// Queued or running.
    UnderWay(Arc<Work>),
    Done(Arc<A>),
    /// With whether it has a card.
    Failed(SharedError, Hold, bool),
    Cancelled(Hold),
}

impl<A> Default for Slot<A> {
    fn default() -> Self {
        Self {
            state: Mutex::new(State::Idle),
            changed: Condvar::new(),
        }
    }
}

impl<A> State<A> {
    fn seen(&self) -> Self {
        match self {
            Self::UnderWay(work) if !work.stopped() => Self::UnderWay(Arc::clone(work)),
            Self::Done(answer) => Self::Done(Arc::clone(answer)),
            Self::Failed(failure, hold, reported) if hold.holds() => {
                Self::Failed(Arc::clone(failure), hold.clone(), *reported)
            }
            Self::Cancelled(hold) if hold.holds() => Self::Cancelled(hold.clone()),
            Self::Idle | Self::UnderWay(_) | Self::Failed(..) | Self::Cancelled(_) => Self::Idle,
        }
    }

    fn is_run_of(&self, work: &Arc<Work>) -> bool {
        matches!(self, Self::UnderWay(now) if Arc::ptr_eq(now, work) && work.runs())
    }
}

impl<A> Slot<A> {
    pub fn peek(&self) -> State<A> {
        lock(&self.state).seen()
    }

    /// Takes in an answer that is known from elsewhere.
    pub fn set(&self, answer: Arc<A>) {
        *lock(&self.state) = State::Done(answer);
        self.changed.notify_all();
    }

    /// Says that `work` is queued for it, unless somebody was faster.
    pub fn queue(&self, work: &Arc<Work>) -> bool {
        let mut state = lock(&self.state);
        let free = matches!(state.seen(), State::Idle);
        if free {
            *state = State::UnderWay(Arc::clone(work));
        }
        free
    }

    /// Takes the work if nobody does it yet; queued work may be taken by whoever needs it first.
    ///
    /// # Errors
    /// Where the question stands otherwise; under way is elsewhere then.
    pub fn claim(&self) -> Result<Arc<Work>, State<A>> {
        let mut state = lock(&self.state);
        let work = match state.seen() {
            State::UnderWay(queued) if !queued.runs() => queued,
            State::Idle => Arc::default(),
            other => return Err(other),
        };
        work.set_running();
        *state = State::UnderWay(Arc::clone(&work));
        Ok(work)
    }

    /// Takes queued work whose turn has come; `false` if somebody else took it meanwhile, or it was stopped.
    pub fn begin(&self, work: &Arc<Work>) -> bool {
        let state = lock(&self.state);
        let queued = matches!(state.seen(), State::UnderWay(queued) if Arc::ptr_eq(&queued, work))
            && !work.runs();
        if queued {
            work.set_running();
        }
        queued
    }

    /// Keeps the result of `work`, and returns how it ended. `reports` is whether a failure gets a card; it gets none
    /// if a failure of what it asked for has one.
    pub fn finish(
        &self,
        work: &Arc<Work>,
        result: Result<A, Interrupted>,
        reports: bool,
    ) -> (Ending, Option<SharedError>) {
        let mut state = lock(&self.state);
        let below = work.below();
        let mut to_report = None;
        let ending = match result {
            // Cancelled while it ran: it stays cancelled.
            Ok(_) if matches!(&*state, State::Cancelled(hold) if hold.holds()) => Ending::Stopped,
            // An answer is true whoever computed it, and even if nobody waits for it any more.
            Ok(answer) => {
                *state = State::Done(Arc::new(answer));
                Ending::Done
            }
            // An error after "stop" is the stop itself, whatever the work calls it.
            Err(Interrupted::Failed(failure)) if !work.stopped() => {
                let ending = Ending::Failed(failure.to_string());
                if state.is_run_of(work) {
                    let (hold, reported) = below.unwrap_or_else(|| (Hold::new(), false));
                    to_report = (reports && !reported).then(|| Arc::clone(&failure));
                    *state = State::Failed(failure, hold, reported || reports);
                }
                ending
            }
            Err(_) => {
                if state.is_run_of(work) {
                    *state = match below {
                        // Held by what it asked for; without that it would be begun again and again.
                        Some((hold, _)) if !work.stopped() => State::Cancelled(hold),
                        _ => State::Idle,
                    };
                }
                Ending::Stopped
            }
        };
        drop(state);
        self.changed.notify_all();
        (ending, to_report)
    }

    /// The user pressed Cancel: what is under way ends, and is not begun again until it is retried.
    pub fn cancel(&self) {
        let mut state = lock(&self.state);
        if let State::UnderWay(work) = state.seen() {
            *state = State::Cancelled(Hold::new());
            drop(state);
            work.stop();
            self.changed.notify_all();
        }
    }

    /// Lets what was cancelled or has failed begin again.
    pub fn retry(&self) {
        match self.peek() {
            State::Failed(_, hold, _) | State::Cancelled(hold) => hold.release(),
            State::Idle | State::UnderWay(_) | State::Done(_) => {}
        }
    }

    /// The failure, if it has no card yet; from now on it has one.
    pub fn report(&self) -> Option<SharedError> {
        match &mut *lock(&self.state) {
            State::Failed(failure, _, reported) if !*reported => {
                *reported = true;
                Some(Arc::clone(failure))
            }
            _ => None,
        }
    }

    /// Waits until `work` may have ended, or a moment has passed.
    pub fn wait_for(&self, work: &Arc<Work>) {
        let state = lock(&self.state);
        if matches!(state.seen(), State::UnderWay(now) if Arc::ptr_eq(&now, work)) {
            drop(self.changed.wait_timeout(state, LOOK_AROUND));
        }
    }
}
