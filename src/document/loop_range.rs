//! The part of the cycle that plays.

use crate::study::Subject;

/// A part of the cardiac cycle from one frame to another, kept as shares of the cycle: the same phases of every subject,
/// however many frames these have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopRange {
    /// Share of the cycle where it begins, in `0..1`.
    start: f64,
    /// Share of the cycle where it ends, above `start`, at most 1.
    end: f64,
}

impl LoopRange {
    /// Between two frames of a subject; the frame after the last is the end of the cycle. `None` unless the first is
    /// before the second and both are there.
    pub fn of_frames(subject: &Subject, [from, to]: [usize; 2]) -> Option<Self> {
        let count = subject.sequence.frame_count();
        let [start, end] = [from, to].map(|frame| share_of_frame(subject, frame));
        (from < to && to <= count && start < end).then_some(Self { start, end })
    }

    /// The frames of a subject that are nearest to its ends; `None` where it has no two.
    pub fn frames_of(&self, subject: &Subject) -> Option<[usize; 2]> {
        let count = subject.sequence.frame_count();
        let nearest = |share: f64| {
            let apart = |frame: &usize| (share_of_frame(subject, *frame) - share).abs();
            (0..=count).min_by(|a, b| apart(a).total_cmp(&apart(b)))
        };
        let (from, to) = (nearest(self.start)?, nearest(self.end)?);
        (from < to && count > 1).then_some([from, to])
    }
}

/// Share of the cycle at a frame; the frame after the last is the end of the cycle.
pub(super) fn share_of_frame(subject: &Subject, frame: usize) -> f64 {
    let count = subject.sequence.frame_count();
    match frame < count {
        true => subject.timing.phase(frame as f64, count),
        false => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::subject_with_frames;

    #[test]
    fn a_range_is_of_the_same_phases_in_a_subject_with_other_frames() {
        let (few, many) = (subject_with_frames("a", 8), subject_with_frames("b", 24));
        let range = LoopRange::of_frames(&few, [3, 8]).unwrap();
        assert_eq!(range.frames_of(&few), Some([3, 8]));
        assert_eq!(range.frames_of(&many), Some([9, 24]));
        let still = subject_with_frames("c", 1);
        assert_eq!(range.frames_of(&still), None);
    }

    #[test]
    fn frames_that_make_no_range_are_refused() {
        let subject = subject_with_frames("a", 8);
        for frames in [[3, 3], [5, 2], [0, 9], [8, 8], [9, 12]] {
            assert_eq!(LoopRange::of_frames(&subject, frames), None, "{frames:?}");
        }
        for from in 0..8 {
            for to in from + 1..=8 {
                let range = LoopRange::of_frames(&subject, [from, to]).unwrap();
                assert_eq!(range.frames_of(&subject), Some([from, to]));
            }
        }
    }
}
