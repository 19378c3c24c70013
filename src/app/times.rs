//! How long the window takes: to its first picture, to the finished pose map, and for each frame.

use std::collections::VecDeque;
use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::document::state::State;
use crate::panes::viewport::shown_subject::ShownSubject;

/// The variable that makes the program write its times to standard error.
const SWITCH: &str = "CARDIOMORPH_TIMES";

/// Frames that the running figures look back on: about four seconds of play.
const LOOK_BACK: usize = 240;

/// Processor time that the window itself spends on drawing, by frame.
#[derive(Debug)]
pub struct Times {
    started: Instant,
    print: bool,
    /// What the window shows once, in the order of [`FIRSTS`].
    firsts: [Moment; FIRSTS.len()],
    /// The subject that was chosen last, and since when it is not on screen yet.
    chosen: Option<String>,
    chosen_at: Option<Instant>,
    followed: Option<(String, Instant)>,
    /// Added to by the paint callback, which runs after `ui`.
    prepare_ns: Arc<AtomicU64>,
    this_frame: Duration,
    playing_frames: VecDeque<Duration>,
    playing_count: usize,
}

/// What is told of when it is seen first.
const FIRSTS: [&str; 4] = [
    "rows of the cohort",
    "first picture",
    "all subjects",
    "finished pose map",
];

/// Something that is on screen once, from the frame after the one that drew it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Moment {
    #[default]
    Ahead,
    Drawn(Duration),
    Seen,
}

impl Moment {
    /// It was drawn; whether this was the first time.
    fn draw(&mut self, elapsed: Duration) -> bool {
        let first = *self == Self::Ahead;
        if first {
            *self = Self::Drawn(elapsed);
        }
        first
    }

    /// A frame begins, so the one before was handed to the screen: when it was drawn, if it is
    /// seen now first.
    fn see(&mut self) -> Option<Duration> {
        let Self::Drawn(at) = *self else {
            return None;
        };
        *self = Self::Seen;
        Some(at)
    }
}

/// Processor time per frame while playing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameTimes {
    /// Half of the frames took less.
    pub median: Duration,
    /// One frame in twenty took more.
    pub high: Duration,
    /// The longest.
    pub longest: Duration,
}

impl Times {
    /// Counts from `started`.
    pub fn new(started: Instant) -> Self {
        Self {
            started,
            print: std::env::var_os(SWITCH).is_some_and(|value| !value.is_empty() && value != "0"),
            firsts: Default::default(),
            chosen: None,
            chosen_at: None,
            followed: None,
            prepare_ns: Arc::default(),
            this_frame: Duration::ZERO,
            playing_frames: VecDeque::with_capacity(LOOK_BACK),
            playing_count: 0,
        }
    }

    /// Where the paint callback adds the time that it spends.
    pub fn prepare_meter(&self) -> Arc<AtomicU64> {
        Arc::clone(&self.prepare_ns)
    }

    /// A frame begins: takes in the one before.
    pub fn begin_frame(&mut self, playing: bool) {
        let elapsed_s = self.started.elapsed().as_secs_f64();
        if let Some((id, chosen_at)) = self.followed.take() {
            let taken_s = chosen_at.elapsed().as_secs_f64();
            self.say(&format!(
                "{id} on screen {taken_s:.3} s after it was chosen"
            ));
        }
        for (place, what) in FIRSTS.into_iter().enumerate() {
            if let Some(drawn) = self.firsts[place].see() {
                self.say(&format!(
                    "{what} after {elapsed_s:.3} s ({:.3} s of it on the graphics card)",
                    elapsed_s - drawn.as_secs_f64()
                ));
            }
        }
        let prepare = Duration::from_nanos(self.prepare_ns.swap(0, Ordering::Relaxed));
        let frame = std::mem::take(&mut self.this_frame) + prepare;
        if !playing || frame.is_zero() {
            return;
        }
        if self.playing_frames.len() == LOOK_BACK {
            self.playing_frames.pop_front();
        }
        self.playing_frames.push_back(frame);
        self.playing_count += 1;
        if self.playing_count.is_multiple_of(LOOK_BACK) || self.playing_count == 30 {
            self.print_frames();
        }
    }

    /// Adds a part of this frame's work.
    pub fn add(&mut self, part: Duration) {
        self.this_frame += part;
    }

    /// What this frame draws; whether another frame is needed to tell when it was seen.
    pub fn drawn(&mut self, state: &State, shown: &[ShownSubject]) -> bool {
        let elapsed = self.started.elapsed();
        let study = state.document.study();
        let rows = !study.subjects.is_empty();
        let all = rows && study.unread.is_empty();
        let now = [rows, !shown.is_empty(), all, state.map().is_some()];
        let mut news = false;
        for (first, _) in self.firsts.iter_mut().zip(now).filter(|(_, now)| *now) {
            news |= first.draw(elapsed);
        }
        self.print && (self.follow(state, shown.first()) || news)
    }

    /// Notes when a subject is chosen, and whether that one is on screen now.
    fn follow(&mut self, state: &State, shown: Option<&ShownSubject>) -> bool {
        let selected = state.document.selected().map(|subject| &subject.id);
        let chosen = state.awaited.as_ref().or(selected);
        if self.chosen.as_ref() != chosen {
            self.chosen_at = Some(Instant::now());
            self.chosen = chosen.cloned();
        }
        let on_screen = shown.map(|shown| &shown.subject.id);
        if self.chosen.is_none() || on_screen != self.chosen.as_ref() {
            return false;
        }
        let chosen_at = self.chosen_at.take();
        self.followed = self.chosen.clone().zip(chosen_at);
        self.followed.is_some()
    }

    /// Processor time of the latest frames while playing; `None` before any.
    pub fn frames(&self) -> Option<FrameTimes> {
        let mut sorted: Vec<Duration> = self.playing_frames.iter().copied().collect();
        sorted.sort_unstable();
        Some(FrameTimes {
            median: *sorted.get(sorted.len() / 2)?,
            high: *sorted.get(sorted.len() * 19 / 20)?,
            longest: *sorted.last()?,
        })
    }

    fn print_frames(&self) {
        if let Some(times) = self.frames() {
            let ms = |time: Duration| 1e3 * time.as_secs_f64();
            self.say(&format!(
                "window's own work per frame while playing: median {:.2} ms, 95 % below {:.2} ms, \
                 longest {:.2} ms ({} frames)",
                ms(times.median),
                ms(times.high),
                ms(times.longest),
                self.playing_frames.len()
            ));
        }
    }

    fn say(&self, line: &str) {
        if self.print {
            // Nobody is left to hear that standard error is closed.
            writeln!(std::io::stderr(), "cardiomorph: {line}").ok();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_of_the_callback_counts_to_the_frame_that_asked_for_it() {
        let mut times = Times::new(Instant::now());
        for ms in 1..=20 {
            times.begin_frame(true);
            times.add(Duration::from_millis(ms));
            times
                .prepare_meter()
                .fetch_add(1_000_000, Ordering::Relaxed);
        }
        times.begin_frame(true);
        let frames = times.frames().unwrap();
        assert_eq!(frames.longest, Duration::from_millis(21));
        assert_eq!(frames.median, Duration::from_millis(12));
    }

    #[test]
    fn frames_of_an_idle_window_are_not_counted() {
        let mut times = Times::new(Instant::now());
        times.begin_frame(false);
        times.add(Duration::from_millis(3));
        times.begin_frame(false);
        assert_eq!(times.frames(), None);
    }
}
