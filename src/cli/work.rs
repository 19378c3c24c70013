//! Runs long work of a command with a progress bar, and hears Ctrl-C.

use std::fmt::Display;
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::cli::outcome::CliError;
use crate::cli::print::say;
use crate::engine::{Job, JobError, JobWatch};
use crate::progress::{Progress, Stopped};

/// Set by Ctrl-C, for all work of this run.
static STOP: AtomicBool = AtomicBool::new(false);

/// Time between two looks at the progress.
const TICK: Duration = Duration::from_millis(50);
/// What takes less shows no bar.
const SHOW_AFTER: Duration = Duration::from_millis(200);
/// Where standard error is no terminal, a line at most this often, over all work of this run.
const LINE_EVERY: Duration = Duration::from_secs(5);
/// When the last such line was written.
static LAST_LINE: Mutex<Option<Instant>> = Mutex::new(None);

/// From now on Ctrl-C stops work at its next step instead of ending the program.
pub(super) fn hear_ctrl_c() {
    // Refused only where somebody else hears it already; then Ctrl-C ends the program as ever.
    ctrlc::set_handler(|| STOP.store(true, Ordering::SeqCst)).ok();
}

/// Runs `work` on a worker thread, drawing its progress on standard error meanwhile. After Ctrl-C
/// the work is asked to stop, and what it then still has to give, such as its best so far, is
/// returned.
///
/// # Errors
/// [`CliError::Stopped`] after Ctrl-C, else what the work says.
pub(super) fn run_work<T, E>(
    work: impl FnOnce(&Progress) -> Result<T, E> + Send + 'static,
) -> Result<T, CliError>
where
    T: Send + 'static,
    E: Display + Send + 'static,
{
    let (sender, news) = sync_channel::<()>(1);
    let wake = Arc::new(move || {
        sender.try_send(()).ok();
    });
    let mut job = Job::alone(wake, work).map_err(CliError::unusable)?;
    let mut meter = Meter::default();
    let outcome = loop {
        let waited = news.recv_timeout(TICK);
        if let Some(outcome) = job.poll() {
            break outcome;
        }
        if waited == Err(RecvTimeoutError::Disconnected) {
            break Err(JobError::Lost);
        }
        if STOP.load(Ordering::SeqCst) {
            job.stop();
        }
        meter.show(job.watch());
    };
    meter.clear();
    drop(job);
    match outcome {
        Ok(value) => Ok(value),
        Err(_) if STOP.load(Ordering::SeqCst) => Err(Stopped.into()),
        Err(error) => Err(CliError::unusable(error)),
    }
}

/// A bar on a terminal; sparse lines elsewhere.
#[derive(Default)]
struct Meter {
    drawn: bool,
}

/// Whether a line is due, `elapsed` after the work began, and marks it as written.
///
/// A command does much work one after the other: what counts is the time since the last line of any of them.
fn line_is_due(last: &mut Option<Instant>, now: Instant, elapsed: Duration) -> bool {
    let since = last.map_or(elapsed, |last| now.saturating_duration_since(last));
    let due = since >= LINE_EVERY;
    if due {
        *last = Some(now);
    }
    due
}

impl Meter {
    fn show(&mut self, watch: &JobWatch) {
        let elapsed = watch.elapsed();
        if elapsed < SHOW_AFTER {
            return;
        }
        if std::io::stderr().is_terminal() {
            self.drawn = true;
            let line = bar(watch.phase(), watch.fraction(), watch.time_left());
            let mut out = std::io::stderr().lock();
            write!(out, "\r\x1b[2K{line}")
                .and_then(|()| out.flush())
                .ok();
        } else if line_is_due(
            &mut LAST_LINE.lock().unwrap_or_else(PoisonError::into_inner),
            watch.queued() + elapsed,
            elapsed,
        ) {
            say(&format!(
                "{} {:.0} %",
                watch.phase(),
                100.0 * watch.fraction()
            ));
        }
    }

    fn clear(&mut self) {
        if self.drawn {
            let mut out = std::io::stderr().lock();
            write!(out, "\r\x1b[2K").and_then(|()| out.flush()).ok();
        }
    }
}

/// `comparing poses  ██████░░░░░░  52 %  4 s left`
fn bar(phase: &str, fraction: f32, left: Option<Duration>) -> String {
    const CELLS: usize = 24;
    let full = (fraction * CELLS as f32).round() as usize;
    let cells = "█".repeat(full) + &"░".repeat(CELLS.saturating_sub(full));
    let left = left.map_or_else(String::new, |left| {
        format!("  {} s left", left.as_secs_f64().ceil())
    });
    format!("{phase:<20} {cells} {:3.0} %{left}", 100.0 * fraction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn much_short_work_writes_no_more_lines_than_one_long_piece() {
        let begin = JobWatch::default().queued();
        let mut last = None;
        // Sixty pieces of work of a second each, looked at twenty times a second.
        let mut lines = 0;
        for look in 0..60 * 20_u32 {
            let now = begin + TICK * look;
            lines += u32::from(line_is_due(&mut last, now, TICK * (look % 20)));
        }
        assert_eq!(lines, 0, "none of them is long enough to be told of");
        for look in 0..60 * 20_u32 {
            let now = begin + TICK * look;
            lines += u32::from(line_is_due(&mut last, now, TICK * look));
        }
        assert_eq!(lines, 11);
    }

    #[test]
    fn the_bar_says_what_how_much_and_how_long() {
        let line = bar("comparing poses", 0.5, Some(Duration::from_millis(3_200)));
        assert_eq!(line.matches('█').count(), 12);
        assert_eq!(line.matches('░').count(), 12);
        assert!(line.ends_with("50 %  4 s left"), "{line}");
    }
}
