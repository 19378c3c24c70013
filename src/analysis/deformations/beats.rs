//! Rows of poses as beats: which rows are one subject's, in which order, at which share of the beat.

use crate::analysis::pose_distances::PoseId;
use crate::study::{Study, Subject};

/// The poses of one subject from end-diastole on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Beat {
    /// Index into the study's subjects.
    pub(super) subject: usize,
    /// Its rows, from end-diastole to the frame before it; at least one.
    pub(super) rows: Vec<usize>,
    /// Share of the beat at each row since end-diastole: 0 first, ascending, below 1.
    pub(super) times: Vec<f64>,
}

/// A time within a beat: between two rows, `share` of the way from one to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Between {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) share: f64,
}

impl Beat {
    /// Where a share of the beat in `0.0..=1.0` lies; the last row runs into the first.
    pub(super) fn at(&self, time: f64) -> Between {
        // At least one row is there.
        let last = self.rows.len() - 1;
        let next = self.times.partition_point(|t| *t <= time);
        let before = next.saturating_sub(1).min(last);
        let start = self.times[before];
        // After the last row the cycle closes: the next end-diastole is at 1.
        let end = self.times.get(before + 1).copied().unwrap_or(1.0);
        Between {
            from: self.rows[before],
            to: self.rows[if before == last { 0 } else { before + 1 }],
            // Round-off at the ends must not extrapolate.
            share: ((time - start) / (end - start)).clamp(0.0, 1.0),
        }
    }
}

/// One beat per subject, in the order of the rows, which stand by subject and then by frame.
///
/// A beat begins at [`Subject::start_frame`], where the size by which lengths are normalised is taken.
pub(super) fn beats(study: &Study, poses: &[PoseId]) -> Vec<Beat> {
    let mut first_row = 0;
    poses
        .chunk_by(|a, b| a.subject == b.subject)
        .map(|of_subject| {
            let subject = of_subject[0].subject;
            let count = of_subject.len();
            let begin = study.subjects.get(subject).map_or(0, |s| s.start_frame());
            let order = || (0..count).map(|step| (begin + step) % count);
            let beat = Beat {
                subject,
                rows: order().map(|frame| first_row + frame).collect(),
                times: times(study.subjects.get(subject).map(|s| &**s), order(), count),
            };
            first_row += count;
            beat
        })
        .collect()
}

/// Shares of the beat since the first of `frames`. Frames share the beat evenly where the stated
/// times do not ascend within one beat.
fn times(subject: Option<&Subject>, frames: impl Iterator<Item = usize>, count: usize) -> Vec<f64> {
    let even = |step: usize| step as f64 / count as f64;
    let Some(subject) = subject else {
        return (0..count).map(even).collect();
    };
    let phases: Vec<f64> = frames
        .map(|frame| subject.timing.phase(frame as f64, count))
        .collect();
    let mut times = vec![0.0; count];
    for step in 1..count {
        // Phases jump from 1 to 0 where the next cycle begins; differences modulo 1 do not.
        times[step] = times[step - 1] + (phases[step] - phases[step - 1]).rem_euclid(1.0);
    }
    // Equal or falling times would make chords of no duration, and shares without meaning.
    let ascend = times.windows(2).all(|pair| pair[0] < pair[1]);
    if ascend && times.last().is_some_and(|last| *last < 1.0) {
        times
    } else {
        (0..count).map(even).collect()
    }
}
