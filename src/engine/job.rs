//! One computation on the worker pool, owned by whoever wants its result.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};

use crate::engine::workers::Workers;
use crate::progress::Progress;

/// Called from a worker when a result is ready, so that the window draws again.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// Why a job brought no result.
#[derive(Debug, thiserror::Error)]
pub enum JobError<E> {
    #[error(transparent)]
    Failed(E),
    #[error("the computation hit a bug: {message}")]
    Panicked { message: String },
    #[error("the worker thread ended before the computation did")]
    Lost,
}

/// A running computation. Dropping it stops the work and discards the result.
#[derive(Debug)]
pub struct Job<T, E> {
    progress: Progress,
    outcome: Receiver<Result<T, JobError<E>>>,
}

impl<T, E> Job<T, E>
where
    T: Send + 'static,
    E: Send + 'static,
{
    /// Queues `work` on `workers`; `wake` is called once, after the outcome can be polled.
    pub fn spawn(
        workers: &Workers,
        wake: Wake,
        work: impl FnOnce(&Progress) -> Result<T, E> + Send + 'static,
    ) -> Self {
        let progress = Progress::default();
        let (sender, outcome) = sync_channel(1);
        let meter = progress.clone();
        workers.submit(move || {
            let result = match catch_unwind(AssertUnwindSafe(|| work(&meter))) {
                Ok(result) => result.map_err(JobError::Failed),
                Err(payload) => Err(JobError::Panicked {
                    message: panic_message(&*payload),
                }),
            };
            // The receiver is gone when nobody wants this result any more.
            sender.send(result).ok();
            wake();
        });
        Self { progress, outcome }
    }

    /// The outcome, once: `None` while the work still runs.
    pub fn poll(&mut self) -> Option<Result<T, JobError<E>>> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(JobError::Lost)),
        }
    }

    pub fn fraction(&self) -> f32 {
        self.progress.fraction()
    }
}

impl<T, E> Drop for Job<T, E> {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

fn panic_message(payload: &(dyn Any + Send)) -> String {
    payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Stopped;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::{Duration, Instant};

    fn pool() -> Workers {
        Workers::start(1).unwrap()
    }

    fn wait<T: Send + 'static, E: Send + 'static>(job: &mut Job<T, E>) -> Result<T, JobError<E>> {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(5) {
            if let Some(outcome) = job.poll() {
                return outcome;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        panic!("job did not finish");
    }

    #[test]
    fn a_finished_job_wakes_the_window_once() {
        let wakes = Arc::new(AtomicUsize::new(0));
        let counter = Arc::clone(&wakes);
        let pool = pool();
        let mut job: Job<u32, Stopped> = Job::spawn(
            &pool,
            Arc::new(move || {
                counter.fetch_add(1, Ordering::SeqCst);
            }),
            |_| Ok(7),
        );
        assert!(matches!(wait(&mut job), Ok(7)));
        drop(pool);
        assert_eq!(wakes.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn dropping_a_job_stops_its_work() {
        let pool = pool();
        let ended_by_stop = Arc::new(std::sync::Mutex::new(None));
        let seen = Arc::clone(&ended_by_stop);
        let job: Job<(), Stopped> = Job::spawn(&pool, Arc::new(|| ()), move |progress| {
            let result = loop {
                std::thread::sleep(Duration::from_millis(1));
                if let Err(stopped) = progress.step() {
                    break Err(stopped);
                }
            };
            *seen.lock().unwrap() = Some(result);
            result
        });
        drop(job);
        drop(pool);
        assert_eq!(*ended_by_stop.lock().unwrap(), Some(Err(Stopped)));
    }

    #[test]
    fn a_panic_becomes_an_error_card_not_an_endless_spinner() {
        let pool = pool();
        let mut job: Job<(), Stopped> =
            Job::spawn(&pool, Arc::new(|| ()), |_| panic!("index out of range"));
        let error = wait(&mut job).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the computation hit a bug: index out of range"
        );
    }
}
