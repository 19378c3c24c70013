//! When each frame was taken within the beat.

use crate::units::Seconds;

/// Times of a sequence's frames; what the input does not say stays unknown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CycleTiming {
    /// Time of each frame after the R peak, ascending.
    pub frame_times_s: Option<Vec<f64>>,
    /// Length of the whole beat, R peak to R peak.
    pub rr: Option<Seconds>,
}

impl CycleTiming {
    /// Share of the beat at a position between frames, in `0..1`, where `position` counts
    /// frames (1.5 is half-way from frame 1 to frame 2) and the last frame runs into the first.
    pub fn phase(&self, position: f64, frame_count: usize) -> f64 {
        match (self.time_at(position, frame_count), self.rr) {
            (Some(time), Some(rr)) if rr.0 > 0.0 => (time.0 / rr.0).rem_euclid(1.0),
            _ if frame_count > 0 => (position / frame_count as f64).rem_euclid(1.0),
            _ => 0.0,
        }
    }

    /// Time after the R peak at a position between frames, if times or the beat's length are known.
    pub fn time_at(&self, position: f64, frame_count: usize) -> Option<Seconds> {
        let whole = position.floor();
        let part = position - whole;
        match (&self.frame_times_s, self.rr) {
            (Some(times), rr) => {
                let index = whole as usize;
                let here = *times.get(index)?;
                let next = times.get(index + 1).copied().or(rr.map(|rr| rr.0));
                Some(Seconds(
                    next.map_or(here, |next| here + part * (next - here)),
                ))
            }
            (None, Some(rr)) if frame_count > 0 => {
                Some(Seconds(rr.0 * position / frame_count as f64))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_frame_runs_into_the_next_beat() {
        let timing = CycleTiming {
            frame_times_s: Some(vec![0.0, 0.3, 0.6]),
            rr: Some(Seconds(0.9)),
        };
        assert_eq!(timing.time_at(2.5, 3), Some(Seconds(0.75)));
        assert!((timing.phase(2.5, 3) - 0.75 / 0.9).abs() < 1e-12);
    }

    #[test]
    fn without_times_frames_share_the_beat_evenly() {
        let timing = CycleTiming::default();
        assert_eq!(timing.time_at(2.0, 8), None);
        assert!((timing.phase(2.0, 8) - 0.25).abs() < 1e-12);
    }
}
