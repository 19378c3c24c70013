//! Where the window looks for a computed value: one slot per kind of result.

use std::sync::Arc;

use crate::engine::job::{Job, JobError};

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
    Nothing,
    Computing {
        previous: Option<&'a T>,
        fraction: f32,
    },
    Ready(&'a T),
    Failed {
        previous: Option<&'a T>,
        error: &'a JobError<E>,
    },
}

impl<K, T, E> Slot<K, T, E>
where
    K: Clone + PartialEq,
    T: Send + 'static,
    E: Send + 'static,
{
    /// Asks for the value of `key`. Cheap every frame: `start` runs only when `key` is new.
    pub fn request(&mut self, key: K, start: impl FnOnce() -> Job<T, E>) {
        if self.wanted.as_ref() == Some(&key) {
            return;
        }
        self.problem = None;
        self.job = None; // Stops the superseded computation.
        self.job = Some(start());
        self.wanted = Some(key);
    }

    /// Takes in a finished computation, if there is one. Call once a frame, before drawing.
    pub fn poll(&mut self) {
        let Some(outcome) = self.job.as_mut().and_then(Job::poll) else {
            return;
        };
        self.job = None;
        match (outcome, self.wanted.clone()) {
            (Ok(value), Some(key)) => self.last_good = Some((key, Arc::new(value))),
            (Ok(_), None) => {}
            (Err(error), _) => self.problem = Some(error),
        }
    }

    /// The user pressed stop: ends the work and does not start it again for the same key.
    pub fn stop(&mut self) {
        self.job = None;
    }

    pub fn showing(&self) -> Showing<'_, T, E> {
        let previous = self.last_good.as_ref().map(|(_, value)| &**value);
        if let Some(job) = &self.job {
            return Showing::Computing {
                previous,
                fraction: job.fraction(),
            };
        }
        if let Some(error) = &self.problem {
            return Showing::Failed { previous, error };
        }
        previous.map_or(Showing::Nothing, Showing::Ready)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Stopped;
    use std::time::{Duration, Instant};

    #[test]
    fn a_new_key_supersedes_the_old_one_and_keeps_the_old_picture() {
        let pool = crate::engine::workers::Workers::start(2).unwrap();
        let mut slot: Slot<u32, u32, Stopped> = Slot::default();
        let mut starts = 0;
        for key in [1, 1, 1] {
            slot.request(key, || {
                starts += 1;
                Job::spawn(&pool, Arc::new(|| ()), |_| Ok(10))
            });
        }
        assert_eq!(starts, 1);
        let begin = Instant::now();
        while !matches!(slot.showing(), Showing::Ready(10))
            && begin.elapsed() < Duration::from_secs(5)
        {
            slot.poll();
        }
        assert!(matches!(slot.showing(), Showing::Ready(10)));
        slot.request(2, || {
            Job::spawn(&pool, Arc::new(|| ()), |progress| {
                loop {
                    std::thread::sleep(Duration::from_millis(1));
                    progress.step()?;
                }
            })
        });
        assert!(matches!(
            slot.showing(),
            Showing::Computing {
                previous: Some(10),
                ..
            }
        ));
        slot.stop();
        assert!(matches!(slot.showing(), Showing::Ready(10)));
        slot.request(2, || panic!("a stopped key must not start again"));
        slot.request(3, || Job::spawn(&pool, Arc::new(|| ()), |_| Ok(30)));
        let begin = Instant::now();
        while !matches!(slot.showing(), Showing::Ready(30))
            && begin.elapsed() < Duration::from_secs(5)
        {
            slot.poll();
        }
        assert!(matches!(slot.showing(), Showing::Ready(30)));
    }
}
