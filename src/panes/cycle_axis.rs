//! Positions counted in frames, and the share of the cardiac cycle of each.

use crate::study::{CycleTiming, Subject};

/// Times of the frames within the cardiac cycle: one share in `0..1` per frame, ascending; after the last
/// frame the cycle continues with the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CycleAxis {
    /// Share of the cycle of each frame.
    pub frame_shares: Vec<f64>,
}

impl CycleAxis {
    /// The frames of a subject.
    pub fn of(subject: &Subject) -> Self {
        Self::of_instants(&subject.timing, subject.sequence.frame_count())
    }

    /// So many instants of a beat.
    pub fn of_instants(timing: &CycleTiming, count: usize) -> Self {
        let instants = 0..count;
        Self {
            frame_shares: instants
                .map(|instant| timing.phase(instant as f64, count))
                .collect(),
        }
    }

    /// Number of frames.
    pub fn frame_count(&self) -> usize {
        self.frame_shares.len()
    }

    /// Share of a whole frame; the frame after the last is the end of the cycle.
    fn share_of(&self, frame: usize) -> f64 {
        self.frame_shares.get(frame).copied().unwrap_or(1.0)
    }

    /// Share of the cycle at a position: 1.5 is half-way from frame 1 to frame 2.
    pub fn share_at(&self, position: f64) -> f64 {
        let position = position.clamp(0.0, self.frame_count() as f64);
        let frame = position.floor() as usize;
        let part = position - frame as f64;
        let (here, next) = (self.share_of(frame), self.share_of(frame + 1));
        here + part * (next - here)
    }

    /// The same below `frame_count`: the end of the cycle is its start.
    pub fn position_within(&self, share: f64) -> f64 {
        let position = self.position_at(share);
        if position >= self.frame_count() as f64 {
            0.0
        } else {
            position
        }
    }

    /// Position at a share of the cycle, in `0..=frame_count`.
    pub fn position_at(&self, share: f64) -> f64 {
        let count = self.frame_count();
        let after = self.frame_shares.partition_point(|given| *given <= share);
        let Some(frame) = after.checked_sub(1) else {
            return 0.0;
        };
        let (here, next) = (self.share_of(frame), self.share_of(frame + 1));
        let part = if next > here {
            ((share - here) / (next - here)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (frame as f64 + part).min(count as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_and_positions_undo_each_other() {
        let axis = CycleAxis {
            frame_shares: vec![0.0, 0.1, 0.4, 0.7],
        };
        for position in [0.0, 0.5, 1.25, 2.0, 3.9, 4.0] {
            let share = axis.share_at(position);
            assert!(
                (axis.position_at(share) - position).abs() < 1e-12,
                "{position}"
            );
        }
        assert!((axis.share_at(3.5) - 0.85).abs() < 1e-12);
    }

    #[test]
    fn a_motion_without_frames_stays_at_its_start() {
        let axis = CycleAxis::default();
        assert!(axis.position_at(0.7).abs() < 1e-12);
    }
}
