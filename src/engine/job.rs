//! One computation on the worker pool, owned by whoever wants its result.

use std::any::Any;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use crate::engine::workers::Workers;
use crate::progress::Progress;

/// Called from a worker when a result is ready, so that the window draws again.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// Why a job brought no result.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum JobError<E> {
    /// The computation says why.
    #[error(transparent)]
    Failed(E),
    /// A bug of the program; other jobs go on.
    #[error("internal error: {message}")]
    Panicked {
        /// What the panic said.
        message: String,
    },
    /// The program is closing, or the thread was killed.
    #[error("the worker thread ended before the computation did")]
    Lost,
}

/// How a job ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ending {
    /// With a result.
    Done,
    /// Because it was asked to, or because newer work took its place.
    Stopped,
    /// With an error, in words.
    Failed(String),
}

/// A job as seen from outside: shared with the activity list, read without waiting.
#[derive(Debug)]
pub struct JobWatch {
    progress: Progress,
    queued: Instant,
    started: OnceLock<Instant>,
    ended: OnceLock<(Instant, Ending)>,
}

impl Default for JobWatch {
    /// Of work that is queued now.
    fn default() -> Self {
        Self {
            progress: Progress::default(),
            queued: Instant::now(),
            started: OnceLock::new(),
            ended: OnceLock::new(),
        }
    }
}

impl JobWatch {
    /// Where the work reports its steps and hears "stop".
    pub(super) fn progress(&self) -> &Progress {
        &self.progress
    }

    /// Says that the work begins.
    pub(super) fn start(&self) {
        self.started.set(Instant::now()).ok();
    }

    /// Share of the work that is done, in `0.0..=1.0`.
    pub fn fraction(&self) -> f32 {
        self.progress.fraction()
    }

    /// What is being done now; empty if the work does not say.
    pub fn phase(&self) -> &'static str {
        self.progress.phase()
    }

    /// When it was asked for.
    pub fn queued(&self) -> Instant {
        self.queued
    }

    /// How long it has run, or ran; zero while it waits for a thread.
    pub fn elapsed(&self) -> Duration {
        let Some(started) = self.started.get() else {
            return Duration::ZERO;
        };
        let until = self.ended.get().map_or_else(Instant::now, |(end, _)| *end);
        until.saturating_duration_since(*started)
    }

    /// How it ended, if it has.
    pub fn ending(&self) -> Option<&Ending> {
        self.ended.get().map(|(_, ending)| ending)
    }

    /// Estimated time to the end, if what is done so far allows one.
    pub fn time_left(&self) -> Option<Duration> {
        if self.ended.get().is_some() {
            return None;
        }
        time_left(self.elapsed(), self.fraction())
    }

    /// Says how the work ended; the first word stands.
    pub(super) fn end(&self, ending: Ending) {
        self.ended.set((Instant::now(), ending)).ok();
    }
}

/// elapsed · (1 − f) / f: what is left takes as long per share as what is done.
///
/// `None` in the first half second, and in the first three below a share of 3 %, where one slow step would decide the
/// answer; of long work a rough answer is better than none.
fn time_left(elapsed: Duration, fraction: f32) -> Option<Duration> {
    let early =
        elapsed < Duration::from_millis(500) || fraction < 0.03 && elapsed < Duration::from_secs(3);
    if early || fraction <= 0.0 {
        return None;
    }
    let share = f64::from(fraction.min(1.0));
    Some(elapsed.mul_f64((1.0 - share) / share))
}

/// A running computation. Dropping it stops the work and discards the result.
#[derive(Debug)]
pub struct Job<T, E> {
    watch: Arc<JobWatch>,
    outcome: Receiver<Result<T, JobError<E>>>,
    /// The thread of a job that runs alone; joined on drop, after the job has been asked to stop.
    own_thread: Option<Workers>,
}

impl<T, E> Job<T, E>
where
    T: Send + 'static,
    E: Display + Send + 'static,
{
    /// Runs `work` on a thread of its own called `job-0`; `wake` is called once, after the outcome can be polled.
    ///
    /// # Errors
    /// If the operating system refuses the thread.
    pub fn alone(
        wake: Wake,
        work: impl FnOnce(&Progress) -> Result<T, E> + Send + 'static,
    ) -> std::io::Result<Self> {
        let thread = Workers::start("job", 1)?;
        let mut job = Self::spawn(&thread, wake, work);
        job.own_thread = Some(thread);
        Ok(job)
    }

    /// Queues `work` on `workers`; `wake` is called once, after the outcome can be polled.
    ///
    /// Work that was stopped before a thread was free is never begun.
    pub(super) fn spawn(
        workers: &Workers,
        wake: Wake,
        work: impl FnOnce(&Progress) -> Result<T, E> + Send + 'static,
    ) -> Self {
        let watch = Arc::<JobWatch>::default();
        let (sender, outcome) = sync_channel(1);
        let seen = Arc::clone(&watch);
        workers.submit(move || {
            if seen.progress.stop_requested() {
                seen.end(Ending::Stopped);
                return;
            }
            seen.start();
            let result = match catch_unwind(AssertUnwindSafe(|| work(&seen.progress))) {
                Ok(result) => result.map_err(JobError::Failed),
                Err(payload) => Err(JobError::Panicked {
                    message: panic_message(&*payload),
                }),
            };
            seen.end(ending_of(&result, seen.progress.stop_requested()));
            // The receiver is gone when nobody wants this result any more.
            sender.send(result).ok();
            wake();
        });
        Self {
            watch,
            outcome,
            own_thread: None,
        }
    }

    /// Asks the work to stop; what it returns then, perhaps its best so far, can still be polled.
    pub fn stop(&self) {
        self.watch.progress.stop();
    }

    /// The outcome, once: `None` while the work still runs.
    pub fn poll(&mut self) -> Option<Result<T, JobError<E>>> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(JobError::Lost)),
        }
    }
}

impl<T, E> Job<T, E> {
    /// Progress, time left and ending, for whoever shows them.
    pub fn watch(&self) -> &Arc<JobWatch> {
        &self.watch
    }
}

impl<T, E> Drop for Job<T, E> {
    fn drop(&mut self) {
        self.watch.progress.stop();
    }
}

/// An error after "stop" is the stop itself, whatever the work calls it.
fn ending_of<T, E: Display>(result: &Result<T, JobError<E>>, stop_requested: bool) -> Ending {
    match result {
        Ok(_) => Ending::Done,
        Err(JobError::Failed(_)) if stop_requested => Ending::Stopped,
        Err(JobError::Failed(error)) => Ending::Failed(error.to_string()),
        Err(JobError::Panicked { message }) => Ending::Failed(format!("bug: {message}")),
        Err(JobError::Lost) => Ending::Failed("the worker thread ended".to_owned()),
    }
}

/// What a panic said.
pub(super) fn panic_message(payload: &(dyn Any + Send)) -> String {
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
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

    fn pool() -> Workers {
        Workers::start("job", 1).unwrap()
    }

    fn wait<T: Send + 'static, E: Display + Send + 'static>(
        job: &mut Job<T, E>,
    ) -> Result<T, JobError<E>> {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(5) {
            if let Some(outcome) = job.poll() {
                return outcome;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        panic!("job did not finish");
    }

    fn until_stopped(progress: &Progress) -> Result<(), Stopped> {
        loop {
            std::thread::sleep(Duration::from_millis(1));
            progress.step()?;
        }
    }

    #[test]
    fn a_finished_job_wakes_the_window_once() {
        let wakes = Arc::new(AtomicUsize::new(0));
        let counter = Arc::clone(&wakes);
        let wake: Wake = Arc::new(move || {
            counter.fetch_add(1, Ordering::SeqCst);
        });
        let pool = pool();
        let mut job: Job<u32, Stopped> = Job::spawn(&pool, wake, |_| Ok(7));
        let watch = Arc::clone(job.watch());
        assert!(matches!(wait(&mut job), Ok(7)));
        drop(pool);
        assert_eq!(wakes.load(Ordering::SeqCst), 1);
        assert_eq!(watch.ending(), Some(&Ending::Done));
    }

    #[test]
    fn dropping_a_job_stops_its_work_within_half_a_second() {
        let pool = pool();
        let job: Job<(), Stopped> = Job::spawn(&pool, Arc::new(|| ()), until_stopped);
        let watch = Arc::clone(job.watch());
        while watch.started.get().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        let asked = Instant::now();
        drop(job);
        drop(pool);
        assert!(asked.elapsed() < Duration::from_millis(500));
        assert_eq!(watch.ending(), Some(&Ending::Stopped));
    }

    #[test]
    fn a_job_alone_has_ended_once_it_is_dropped() {
        let job: Job<(), Stopped> = Job::alone(Arc::new(|| ()), until_stopped).unwrap();
        let watch = Arc::clone(job.watch());
        drop(job);
        assert_eq!(watch.ending(), Some(&Ending::Stopped));
    }

    #[test]
    fn a_job_that_was_stopped_in_the_queue_never_begins() {
        let pool = pool();
        let blocker: Job<(), Stopped> = Job::spawn(&pool, Arc::new(|| ()), until_stopped);
        let begun = Arc::new(AtomicBool::new(false));
        let seen = Arc::clone(&begun);
        let queued: Job<(), Stopped> = Job::spawn(&pool, Arc::new(|| ()), move |_| {
            seen.store(true, Ordering::SeqCst);
            Ok(())
        });
        let watch = Arc::clone(queued.watch());
        drop(queued);
        drop(blocker);
        drop(pool);
        assert!(!begun.load(Ordering::SeqCst));
        assert_eq!(watch.ending(), Some(&Ending::Stopped));
        assert_eq!(watch.elapsed(), Duration::ZERO);
    }

    #[test]
    fn a_panic_becomes_an_error_card_not_an_endless_spinner() {
        let pool = pool();
        let mut job: Job<(), Stopped> =
            Job::spawn(&pool, Arc::new(|| ()), |_| panic!("index out of range"));
        let error = wait(&mut job).unwrap_err();
        assert_eq!(error.to_string(), "internal error: index out of range");
        let mut next: Job<u32, Stopped> = Job::spawn(&pool, Arc::new(|| ()), |_| Ok(1));
        assert!(matches!(wait(&mut next), Ok(1)), "the thread lives on");
    }

    #[test]
    fn a_quarter_done_in_two_seconds_leaves_six() {
        assert_eq!(
            time_left(Duration::from_secs(2), 0.25),
            Some(Duration::from_secs(6))
        );
        assert_eq!(time_left(Duration::from_secs(2), 0.01), None);
        assert_eq!(time_left(Duration::from_millis(100), 0.5), None);
        assert_eq!(time_left(Duration::from_secs(2), 1.0), Some(Duration::ZERO));
        let long = time_left(Duration::from_secs(4), 0.01).unwrap();
        assert!((long.as_secs_f64() - 396.0).abs() < 0.1);
        assert_eq!(time_left(Duration::from_secs(9), 0.0), None);
    }
}
