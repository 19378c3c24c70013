//! One point of a map, as plain values.

/// What a point is within the cycle; it decides the mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PosePhase {
    /// The pose of largest volume, or a step that begins there.
    EndDiastole,
    /// The pose of smallest volume, or a step that begins there.
    EndSystole,
    /// Any other pose.
    #[default]
    Between,
    /// The whole motion.
    WholeMotion,
}

impl PosePhase {
    /// What a frame is, given the frames of end-diastole and end-systole.
    pub fn of(frame: usize, (end_diastole, end_systole): (Option<usize>, Option<usize>)) -> Self {
        if end_diastole == Some(frame) {
            Self::EndDiastole
        } else if end_systole == Some(frame) {
            Self::EndSystole
        } else {
            Self::Between
        }
    }
}

/// One point. Points of a subject, and within it of a patch, follow each other in order of frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScatterPoint {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place of its patch in the list, from 0; `None` where the subject has one path.
    pub patch: Option<usize>,
    /// First and last frame that it stands for, the same for a pose; `None` for a whole motion.
    pub frames: Option<[usize; 2]>,
    /// The frame from which a click plays.
    pub start_frame: usize,
    /// Place on the map; it has no unit.
    pub at: [f64; 2],
    /// Share of the cycle at its first frame, in `0..1`.
    pub share: f64,
    /// Whether the length of the cycle is known; else frames share it evenly.
    pub rr_is_known: bool,
    /// What it is within the cycle.
    pub phase: PosePhase,
    /// What follows the subject's name beside the point while the subject is selected; `None`
    /// writes nothing there.
    pub label: Option<&'static str>,
    /// The cluster that k-means assigns.
    pub cluster: Option<usize>,
    /// Subjects that are linked to this point while it is selected, nearest first.
    pub nearest: Vec<usize>,
    /// Lines of the hover card below those of the subject.
    pub facts: Vec<String>,
}

/// What a point is known by from one map to the next: its subject, patch and first frame.
pub type PointKey = (usize, Option<usize>, Option<usize>);

impl ScatterPoint {
    /// What it is known by from one map to the next.
    pub fn key(&self) -> PointKey {
        let first = self.frames.map(|[first, _]| first);
        (self.subject, self.patch, first)
    }

    /// Whether another point is of the same path.
    pub fn shares_path(&self, other: &Self) -> bool {
        (self.subject, self.patch) == (other.subject, other.patch)
    }

    /// Whether the way to the next point of its path is known: poses follow each other; a step does
    /// only where it ends at the frame at which the next begins.
    pub fn leads_to(&self, next: &Self) -> bool {
        match (self.frames, next.frames) {
            (Some([from, to]), Some([next_from, _])) => {
                from == to || (to == next_from && next_from > from)
            }
            _ => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(from: usize, to: usize) -> ScatterPoint {
        ScatterPoint {
            frames: Some([from, to]),
            ..ScatterPoint::default()
        }
    }

    #[test]
    fn steps_that_do_not_touch_leave_a_gap_and_poses_never_do() {
        assert!(step(1, 2).leads_to(&step(2, 3)));
        assert!(!step(1, 2).leads_to(&step(3, 4)));
        assert!(!step(4, 0).leads_to(&step(0, 1)), "the end of the beat");
        assert!(step(1, 1).leads_to(&step(4, 4)));
    }

    #[test]
    fn a_frame_is_the_phase_that_the_study_says() {
        let phases = (Some(0), Some(4));
        assert_eq!(PosePhase::of(0, phases), PosePhase::EndDiastole);
        assert_eq!(PosePhase::of(4, phases), PosePhase::EndSystole);
        assert_eq!(PosePhase::of(3, phases), PosePhase::Between);
        assert_eq!(PosePhase::of(0, (None, None)), PosePhase::Between);
    }
}
