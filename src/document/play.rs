//! The clock that plays a motion: from seconds on the wall to a place between poses.

pub use crate::picture::is_between;

use crate::picture::PreparedSubject;
use crate::render::GeometryPose;
use crate::study::{CycleTiming, Subject};

use crate::document::document::{cycle_share, position_at_phase, position_in_cycle};
use crate::document::loop_range::{LoopRange, share_of_frame};

/// Length of a cycle whose input does not say it: 60 cycles a minute.
const ASSUMED_CYCLE_S: f64 = 1.0;

/// Slowest and fastest play.
pub const SPEEDS: std::ops::RangeInclusive<f32> = 0.05..=4.0;

/// Whether and how fast a motion plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlayClock {
    /// Whether time runs.
    pub playing: bool,
    /// Recorded cycles per cycle: 1 is real time.
    pub speed: f32,
    /// Whether the motion starts over at its end.
    pub repeat: bool,
}

impl Default for PlayClock {
    fn default() -> Self {
        Self {
            playing: false,
            speed: 1.0,
            repeat: true,
        }
    }
}

impl PlayClock {
    /// Sets the speed to the nearest of [`SPEEDS`]; what is no number changes nothing.
    pub fn set_speed(&mut self, speed: f32) {
        if speed.is_finite() {
            self.speed = speed.clamp(*SPEEDS.start(), *SPEEDS.end());
        }
    }

    /// The position `elapsed_s` after `position`, and whether play goes on.
    ///
    /// Time runs evenly over the cycle, so frames that were taken at uneven times are shown for
    /// unequal times. Without repeat, play ends at the last frame. With a range, play begins at its
    /// start wherever the position was outside of it, and starts over or ends at its end.
    pub fn advance(
        &self,
        subject: &Subject,
        position: f64,
        range: Option<LoopRange>,
        elapsed_s: f64,
    ) -> (f64, bool) {
        let count = subject.sequence.frame_count();
        if !self.playing || count < 2 {
            return (position, self.playing && count >= 2);
        }
        let share = elapsed_s.max(0.0) * f64::from(self.speed) / cycle_s(subject);
        let now = cycle_share(subject, position);
        let last = count - 1;
        let part = range.and_then(|range| range.frames_of(subject));
        let ([start, end], end_frame) = match part {
            Some([from, to]) => (
                [from, to].map(|frame| share_of_frame(subject, frame)),
                to.min(last),
            ),
            None => ([0.0, 1.0], last),
        };
        let phase = if (start..end).contains(&now) {
            now
        } else {
            start
        } + share;
        let stop = end.min(cycle_share(subject, end_frame as f64));
        if !self.repeat && phase >= stop {
            return (end_frame as f64, false);
        }
        let phase = start + (phase - start).rem_euclid(end - start);
        (position_at_phase(subject, phase), true)
    }

    /// The same over `count` images of a beat, of which no subject is made.
    pub fn advance_images(
        &self,
        timing: &CycleTiming,
        count: usize,
        position: f64,
        elapsed_s: f64,
    ) -> (f64, bool) {
        if !self.playing || count < 2 {
            return (position, self.playing && count >= 2);
        }
        let share = elapsed_s.max(0.0) * f64::from(self.speed) / length_s(timing);
        let phase = timing.phase(position, count) + share;
        let last = count as f64 - 1.0;
        if !self.repeat && phase >= timing.phase(last, count) {
            return (last, false);
        }
        let phase = phase.rem_euclid(1.0);
        (position_in_cycle(timing, count, phase), true)
    }
}

/// Length of a subject's cycle: as recorded, else one second.
pub fn cycle_s(subject: &Subject) -> f64 {
    length_s(&subject.timing)
}

fn length_s(timing: &CycleTiming) -> f64 {
    timing
        .rr
        .map(|rr| rr.0)
        .filter(|rr| *rr > 0.0)
        .unwrap_or(ASSUMED_CYCLE_S)
}

/// The pose at a position: between two frames, eased so that the subject does not jerk where one
/// straight path meets the next.
///
/// The blend is half-way between the plain share x and 3x² − 2x³: speed dips near given poses
/// by half and never stops. The last frame runs into the first where the motion repeats.
pub fn pose_at(position: f64, frame_count: usize) -> GeometryPose {
    let count = frame_count.max(1);
    let position = position.max(0.0).rem_euclid(count as f64);
    let from = (position.floor() as usize).min(count - 1);
    let part = position - from as f64;
    let eased = 0.5 * part + 0.5 * part * part * (3.0 - 2.0 * part);
    GeometryPose {
        from,
        to: (from + 1) % count,
        blend: if is_between(position) {
            eased as f32
        } else {
            part.round() as f32
        },
    }
}

/// The pose of a prepared subject at a position: through the poses between two frames where it has
/// them, each for an equal share of the interval; else as [`pose_at`] blends the frames.
pub fn pose_in(prepared: &PreparedSubject, position: f64) -> GeometryPose {
    let straight = pose_at(position, prepared.frame_count);
    let (from, to) = (
        prepared.pose_of_frame(straight.from),
        prepared.pose_of_frame(straight.to),
    );
    let steps = prepared.interpolated_poses(straight.from) + 1;
    if steps == 1 || straight.blend == 0.0 || straight.blend == 1.0 {
        return GeometryPose {
            from,
            to,
            blend: straight.blend,
        };
    }
    let place = (position - position.floor()) * steps as f64;
    let step = (place.floor() as usize).min(steps - 1);
    GeometryPose {
        from: from + step,
        to: if step + 1 == steps {
            to
        } else {
            from + step + 1
        },
        blend: (place - step as f64) as f32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::subject_with_frames;
    use crate::units::Seconds;

    #[test]
    fn a_beat_lasts_as_long_as_it_was_recorded() {
        let mut subject = subject_with_frames("a", 8);
        subject.timing.rr = Some(Seconds(0.8));
        let clock = PlayClock {
            playing: true,
            ..PlayClock::default()
        };
        let mut position = 0.0;
        for _ in 0..8 {
            position = clock.advance(&subject, position, None, 0.05).0;
        }
        assert!(
            (position - 4.0).abs() < 1e-9,
            "half a beat after 0.4 s, not {position}"
        );
        for _ in 0..8 {
            position = clock.advance(&subject, position, None, 0.05).0;
        }
        assert!((position + 1e-6).rem_euclid(8.0) < 2e-6);
    }

    #[test]
    fn half_speed_takes_twice_as_long() {
        let subject = subject_with_frames("a", 10);
        let clock = PlayClock {
            playing: true,
            speed: 0.5,
            repeat: true,
        };
        assert!((clock.advance(&subject, 0.0, None, 0.4).0 - 2.0).abs() < 1e-9);
    }

    #[test]
    fn without_repeat_play_ends_on_the_last_frame() {
        let subject = subject_with_frames("a", 4);
        let clock = PlayClock {
            playing: true,
            speed: 1.0,
            repeat: false,
        };
        assert_eq!(clock.advance(&subject, 2.9, None, 0.5), (3.0, false));
    }

    #[test]
    fn a_range_plays_from_its_first_to_its_last_frame_and_over_again() {
        let subject = subject_with_frames("a", 10);
        let range = LoopRange::of_frames(&subject, [3, 6]);
        let mut clock = PlayClock {
            playing: true,
            ..PlayClock::default()
        };
        let at = |clock: &PlayClock, position, elapsed_s| {
            let (position, on) = clock.advance(&subject, position, range, elapsed_s);
            ((position * 1e9).round() / 1e9, on)
        };
        assert_eq!(at(&clock, 3.0, 0.2), (5.0, true));
        assert_eq!(
            at(&clock, 5.0, 0.2),
            (4.0, true),
            "over the end to the start"
        );
        assert_eq!(
            at(&clock, 8.0, 0.0),
            (3.0, true),
            "from outside to the start"
        );
        assert_eq!(at(&clock, 1.0, 0.1), (4.0, true));
        clock.repeat = false;
        assert_eq!(at(&clock, 5.0, 0.2), (6.0, false));
        // Diastole: up to the first frame of the next cycle.
        let range = LoopRange::of_frames(&subject, [4, 10]);
        clock.repeat = true;
        let (position, on) = clock.advance(&subject, 9.5, range, 0.1);
        assert!((position - 4.5).abs() < 1e-9 && on, "{position}");
        clock.repeat = false;
        assert_eq!(clock.advance(&subject, 8.9, range, 0.5), (9.0, false));
    }

    #[test]
    fn a_heart_with_one_frame_does_not_play() {
        let subject = subject_with_frames("a", 1);
        let clock = PlayClock {
            playing: true,
            ..PlayClock::default()
        };
        assert_eq!(clock.advance(&subject, 0.0, None, 0.5), (0.0, false));
    }

    #[test]
    fn given_poses_are_shown_as_they_are() {
        for frame in 0..8 {
            let pose = pose_at(f64::from(frame), 8);
            assert_eq!((pose.from, pose.blend), (frame as usize, 0.0));
            assert!(!is_between(f64::from(frame)));
        }
        assert!(is_between(0.5));
    }

    #[test]
    fn poses_between_frames_are_passed_at_equal_shares() {
        let subject = subject_with_frames("a", 3);
        let between: Vec<_> = (0..3).map(|_| subject.sequence.pose(0).unwrap()).collect();
        let prepared =
            PreparedSubject::with_interpolated_poses(&subject, 0, &[&[], &between, &between]);
        let at = |position| {
            let pose = pose_in(&prepared, position);
            (pose.from, pose.to, pose.blend)
        };
        assert_eq!(at(0.0), (0, 1, 0.0));
        assert_eq!((at(0.5).0, at(0.5).1), (0, 1));
        assert_eq!(at(1.0), (1, 5, 0.0));
        assert_eq!(at(1.25), (2, 3, 0.0));
        assert_eq!(at(1.875), (4, 5, 0.5));
        assert_eq!(at(2.0).0, 5);
        assert_eq!(
            at(2.875),
            (8, 0, 0.5),
            "the last interval leads to the first frame"
        );
    }

    #[test]
    fn easing_goes_forward_and_never_stops() {
        let blends: Vec<f32> = (0..100)
            .map(|i| pose_at(f64::from(i) / 100.0, 8).blend)
            .collect();
        assert!(blends.windows(2).all(|pair| pair[1] - pair[0] > 0.004));
        let last = pose_at(7.5, 8);
        assert_eq!((last.from, last.to), (7, 0));
        assert!((last.blend - 0.5).abs() < 1e-6);
    }
}
