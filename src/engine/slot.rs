//! Where the window looks for a computed value: one slot per kind of result.

use std::fmt::Display;
use std::sync::Arc;

use crate::engine::job::{Job, JobError, JobWatch};

/// The latest result for the latest key, plus the one before it while a new one is computed.
#[derive(Debug)]
pub struct Slot<K, T, E> {
    wanted: Option<K>,
    job: Option<Job<T, E>>,
    last_good: Option<(K, Arc<T>)>,
    problem: Option<JobError<E>>,
}

impl<K, T, E> Default for Slot<K, T, E> {
    fn default() -> Self {
        Self {
            wanted: None,
            job: None,
            last_good: None,
            problem: None,
        }
    }
}

/// What a panel may draw for a slot.
#[derive(Debug)]
pub enum Showing<'a, T, E> {
    /// Nothing was asked for yet.
    Nothing,
    /// Work goes on; the last good result stays on screen.
    Computing {
        /// The result before, if there is one.
        previous: Option<&'a Arc<T>>,
        /// Fraction, phase and time left.
        watch: &'a JobWatch,
    },
    /// The result of the wanted key.
    Ready(&'a Arc<T>),
    /// The user stopped it; it can be asked for again.
    Stopped {
        /// The result before, if there is one.
        previous: Option<&'a Arc<T>>,
    },
    /// It went wrong.
    Failed {
        /// The result before, if there is one.
        previous: Option<&'a Arc<T>>,
        /// Why.
        error: &'a JobError<E>,
    },
}

impl<K, T, E> Slot<K, T, E>
where
    K: Clone + PartialEq,
    T: Send + 'static,
    E: Display + Send + 'static,
{
    /// Asks for the value of `key`. Cheap every frame: `start` runs only when `key` is new, and
    /// not if the result at hand is the one of `key`. What was stopped or failed is not begun
    /// again; [`Self::retry`] does that.
    pub fn request(&mut self, key: K, start: impl FnOnce() -> Job<T, E>) {
        if self.wanted.as_ref() == Some(&key) {
            return;
        }
        self.problem = None;
        self.job = None; // Stops the superseded computation.
        if !self.holds(&key) {
            self.job = Some(start());
        }
        self.wanted = Some(key);
    }

    /// Asks again for the value of `key` after a stop or a failure; free while it is computed
    /// or ready.
    pub fn retry(&mut self, key: K, start: impl FnOnce() -> Job<T, E>) {
        if self.wanted.as_ref() == Some(&key) && self.job.is_none() && !self.holds(&key) {
            self.wanted = None;
        }
        self.request(key, start);
    }

    /// Takes in a finished computation, if there is one, and says whether it did. Call once a
    /// frame, before drawing.
    pub fn poll(&mut self) -> bool {
        let Some(outcome) = self.job.as_mut().and_then(Job::poll) else {
            return false;
        };
        self.job = None;
        match (outcome, self.wanted.clone()) {
            (Ok(value), Some(key)) => self.last_good = Some((key, Arc::new(value))),
            (Ok(_), None) => {}
            (Err(error), _) => self.problem = Some(error),
        }
        true
    }

    /// The user pressed stop: ends the work and does not start it again for the same key.
    pub fn stop(&mut self) {
        self.job = None;
    }

    /// Forgets everything, as at the start; running work is stopped.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// What to draw now.
    pub fn showing(&self) -> Showing<'_, T, E> {
        let previous = self.last_good.as_ref().map(|(_, value)| value);
        if let Some(job) = &self.job {
            let watch = job.watch();
            return Showing::Computing { previous, watch };
        }
        if let Some(error) = &self.problem {
            return Showing::Failed { previous, error };
        }
        match (&self.wanted, previous) {
            (None, _) => Showing::Nothing,
            (Some(key), Some(value)) if self.holds(key) => Showing::Ready(value),
            (Some(_), previous) => Showing::Stopped { previous },
        }
    }

    /// The last good result, whatever is wanted now.
    pub fn latest(&self) -> Option<&Arc<T>> {
        self.last_good.as_ref().map(|(_, value)| value)
    }

    /// The result of the wanted key, if it is there.
    pub fn ready(&self) -> Option<&Arc<T>> {
        match self.showing() {
            Showing::Ready(value) => Some(value),
            _ => None,
        }
    }

    /// Whether work goes on.
    pub fn busy(&self) -> bool {
        self.job.is_some()
    }

    fn holds(&self, key: &K) -> bool {
        matches!(&self.last_good, Some((held, _)) if held == key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::workers::Workers;
    use crate::progress::{Progress, Stopped};
    use std::time::{Duration, Instant};

    type Numbers = Slot<u32, u32, Stopped>;

    fn pool() -> Workers {
        Workers::start("job", 2).unwrap()
    }

    fn answer(pool: &Workers, value: u32) -> Job<u32, Stopped> {
        Job::spawn(pool, Arc::new(|| ()), move |_| Ok(value))
    }

    fn endless(pool: &Workers) -> Job<u32, Stopped> {
        Job::spawn(pool, Arc::new(|| ()), |progress: &Progress| {
            loop {
                std::thread::sleep(Duration::from_millis(1));
                progress.step()?;
            }
        })
    }

    fn wait_for(slot: &mut Numbers, value: u32) {
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(5) {
            slot.poll();
            if slot.ready().is_some_and(|ready| **ready == value) {
                return;
            }
        }
        panic!("{value} never came: {:?}", slot.showing());
    }

    #[test]
    fn the_same_key_starts_work_once() {
        let pool = pool();
        let mut slot = Numbers::default();
        let mut starts = 0;
        for key in [1, 1, 1] {
            slot.request(key, || {
                starts += 1;
                answer(&pool, 10)
            });
        }
        assert_eq!(starts, 1);
        wait_for(&mut slot, 10);
    }

    #[test]
    fn the_newest_key_wins_and_the_old_picture_stays_meanwhile() {
        let pool = pool();
        let mut slot = Numbers::default();
        slot.request(1, || answer(&pool, 10));
        wait_for(&mut slot, 10);
        slot.request(2, || endless(&pool));
        let Showing::Computing { previous, .. } = slot.showing() else {
            panic!("{:?}", slot.showing());
        };
        assert_eq!(previous.map(|value| **value), Some(10));
        slot.request(3, || answer(&pool, 30));
        wait_for(&mut slot, 30);
    }

    #[test]
    fn going_back_to_the_key_at_hand_computes_nothing() {
        let pool = pool();
        let mut slot = Numbers::default();
        slot.request(1, || answer(&pool, 10));
        wait_for(&mut slot, 10);
        slot.request(2, || endless(&pool));
        slot.request(1, || panic!("its result is at hand"));
        assert!(matches!(slot.showing(), Showing::Ready(value) if **value == 10));
    }

    #[test]
    fn stopped_work_starts_again_only_when_asked_to() {
        let pool = pool();
        let mut slot = Numbers::default();
        slot.request(2, || endless(&pool));
        slot.stop();
        assert!(matches!(
            slot.showing(),
            Showing::Stopped { previous: None }
        ));
        slot.request(2, || panic!("a stopped key must not start again by itself"));
        slot.retry(2, || answer(&pool, 20));
        slot.retry(2, || panic!("it runs or is ready"));
        wait_for(&mut slot, 20);
        slot.retry(2, || panic!("it is ready"));
        assert!(slot.ready().is_some());
    }

    #[test]
    fn a_failure_is_shown_until_it_is_tried_again() {
        let pool = pool();
        let mut slot: Slot<u32, u32, String> = Slot::default();
        slot.request(1, || {
            Job::spawn(&pool, Arc::new(|| ()), |_| Err("no volume".to_owned()))
        });
        let begin = Instant::now();
        while !slot.poll() && begin.elapsed() < Duration::from_secs(5) {}
        let Showing::Failed { error, .. } = slot.showing() else {
            panic!("{:?}", slot.showing());
        };
        assert_eq!(*error, JobError::Failed("no volume".to_owned()));
        slot.retry(1, || Job::spawn(&pool, Arc::new(|| ()), |_| Ok(5)));
        assert!(slot.busy());
    }
}
