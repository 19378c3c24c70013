//! The state of one question: not asked, under way, answered, failed or cancelled.

use std::error::Error;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use crate::engine::job::Ending;
use crate::engine::store::interrupted::{Failure, Interrupted};
use crate::engine::store::work::{Hold, Work, lock};

/// Longest time in which a waiter hears that it is stopped itself.
const LOOK_AROUND: Duration = Duration::from_millis(20);

/// Answer `A` or error `E` of one question, from not asked to known.
#[derive(Debug)]
pub(super) struct Cell<A, E: Error + 'static> {
    state: Mutex<State<A, E>>,
    changed: Condvar,
}

#[derive(Debug)]
enum State<A, E: Error + 'static> {
    Idle,
    Queued(Arc<Work>),
    Running(Arc<Work>),
    Done(Arc<A>),
    Failed(Failure<E>, Hold, bool),
    Cancelled(Hold),
}

/// What can be seen of a cell.
pub(super) enum Peek<A, E: Error + 'static> {
    /// Nobody works on it.
    Idle,
    /// Queued or running.
    UnderWay(Arc<Work>),
    Done(Arc<A>),
    /// With whether it has a card.
    Failed(Failure<E>, Hold, bool),
    Cancelled(Hold),
}

/// The outcome of asking to do the work.
pub(super) enum Claim<A, E: Error + 'static> {
    /// Whoever asked is to do it.
    Mine(Arc<Work>),
    /// It is done elsewhere.
    Elsewhere(Arc<Work>),
    Done(Arc<A>),
    Failed(Failure<E>, Hold, bool),
    Cancelled(Hold),
}

impl<A, E: Error + 'static> Default for Cell<A, E> {
    fn default() -> Self {
        Self {
            state: Mutex::new(State::Idle),
            changed: Condvar::new(),
        }
    }
}

impl<A, E: Error + 'static> State<A, E> {
    /// Stopped work, and what was released, is as if nobody had begun it.
    fn peek(&self) -> Peek<A, E> {
        match self {
            Self::Queued(work) | Self::Running(work) if !work.stopped() => {
                Peek::UnderWay(Arc::clone(work))
            }
            Self::Idle | Self::Queued(_) | Self::Running(_) => Peek::Idle,
            Self::Done(answer) => Peek::Done(Arc::clone(answer)),
            Self::Failed(failure, hold, reported) if hold.holds() => {
                Peek::Failed(failure.clone(), hold.clone(), *reported)
            }
            Self::Cancelled(hold) if hold.holds() => Peek::Cancelled(hold.clone()),
            Self::Failed(..) | Self::Cancelled(_) => Peek::Idle,
        }
    }

    fn is_run_of(&self, work: &Arc<Work>) -> bool {
        matches!(self, Self::Running(running) if Arc::ptr_eq(running, work))
    }
}

impl<A, E: Error + 'static> Cell<A, E> {
    pub fn peek(&self) -> Peek<A, E> {
        lock(&self.state).peek()
    }

    /// Takes in an answer that is known from elsewhere.
    pub fn set(&self, answer: Arc<A>) {
        *lock(&self.state) = State::Done(answer);
        self.changed.notify_all();
    }

    /// Says that `work` is queued for it, unless somebody was faster.
    pub fn queue(&self, work: &Arc<Work>) -> bool {
        let mut state = lock(&self.state);
        let free = matches!(state.peek(), Peek::Idle);
        if free {
            *state = State::Queued(Arc::clone(work));
        }
        free
    }

    /// Takes the work if nobody does it yet; queued work may be taken by whoever needs it first.
    pub fn claim(&self) -> Claim<A, E> {
        let mut state = lock(&self.state);
        let work = match state.peek() {
            Peek::Done(answer) => return Claim::Done(answer),
            Peek::Failed(failure, hold, reported) => return Claim::Failed(failure, hold, reported),
            Peek::Cancelled(hold) => return Claim::Cancelled(hold),
            Peek::UnderWay(work) if state.is_run_of(&work) => return Claim::Elsewhere(work),
            Peek::UnderWay(queued) => queued,
            Peek::Idle => Arc::default(),
        };
        *state = State::Running(Arc::clone(&work));
        Claim::Mine(work)
    }

    /// Takes queued work whose turn has come; `false` if somebody else took it meanwhile, or it was stopped.
    pub fn begin(&self, work: &Arc<Work>) -> bool {
        let mut state = lock(&self.state);
        let queued = matches!(&*state, State::Queued(queued) if Arc::ptr_eq(queued, work));
        if !queued || work.stopped() {
            return false;
        }
        *state = State::Running(Arc::clone(work));
        true
    }

    /// Keeps the result of `work`, and returns how it ended. `reports` is whether a failure gets a card; it gets none
    /// if a failure of what it asked for has one.
    pub fn finish(
        &self,
        work: &Arc<Work>,
        result: Result<A, Interrupted<Failure<E>>>,
        reports: bool,
    ) -> (Ending, Option<Failure<E>>) {
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
                    to_report = (reports && !reported).then(|| failure.clone());
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
        if let Peek::UnderWay(work) = state.peek() {
            *state = State::Cancelled(Hold::new());
            drop(state);
            work.stop();
            self.changed.notify_all();
        }
    }

    /// Lets what was cancelled or has failed begin again.
    pub fn retry(&self) {
        match self.peek() {
            Peek::Failed(_, hold, _) | Peek::Cancelled(hold) => hold.release(),
            Peek::Idle | Peek::UnderWay(_) | Peek::Done(_) => {}
        }
    }

    /// The failure, if it has no card yet; from now on it has one.
    pub fn report(&self) -> Option<Failure<E>> {
        match &mut *lock(&self.state) {
            State::Failed(failure, _, reported) if !*reported => {
                *reported = true;
                Some(failure.clone())
            }
            _ => None,
        }
    }

    /// Waits until `work` may have ended, or a moment has passed.
    pub fn wait_for(&self, work: &Arc<Work>) {
        let state = lock(&self.state);
        if matches!(state.peek(), Peek::UnderWay(now) if Arc::ptr_eq(&now, work)) {
            drop(self.changed.wait_timeout(state, LOOK_AROUND));
        }
    }
}
