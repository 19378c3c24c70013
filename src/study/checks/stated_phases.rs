//! Can the stated end-diastole and end-systole be right?

use super::enclosed_volume::enclosed_volume;
use crate::study::{Notice, Subject, SurfaceKind};

/// What is wrong with the frames that the input calls end-diastole and end-systole.
///
/// Why it matters: ejection fraction is the share of blood lost from one to the other; with the
/// two swapped, or at frames that do not exist, it is nonsense.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatedPhases {
    /// End-diastole is said to be at a frame that is not there.
    pub end_diastole_beyond: Option<usize>,
    /// End-systole is said to be at a frame that is not there.
    pub end_systole_beyond: Option<usize>,
    /// The cavity encloses less at end-diastole than at end-systole.
    pub swapped: bool,
    /// Both are said to be one frame.
    pub both_at: Option<usize>,
}

impl StatedPhases {
    /// Compares them with the number of frames and with the enclosed volumes.
    pub fn of(subject: &Subject) -> Self {
        let frames = subject.sequence.frame_count();
        let beyond = |stated: Option<usize>| stated.filter(|&frame| frame >= frames);
        let volume = |frame: Option<usize>| -> Option<f64> {
            let surface = subject
                .sequence
                .surface(SurfaceKind::Endocardium)
                .or_else(|| subject.sequence.surface(SurfaceKind::Cavity))?;
            let mesh = surface.frames().get(frame?)?;
            let loops = surface.faces().boundary_loops();
            Some(enclosed_volume(mesh.vertices(), mesh.triangles(), &loops).abs())
        };
        let swapped = match (volume(subject.end_diastole), volume(subject.end_systole)) {
            (Some(diastole), Some(systole)) => diastole < systole,
            _ => false,
        };
        Self {
            end_diastole_beyond: beyond(subject.end_diastole),
            end_systole_beyond: beyond(subject.end_systole),
            swapped,
            both_at: subject
                .end_diastole
                .filter(|frame| Some(*frame) == subject.end_systole && *frame < frames),
        }
    }

    /// What the load report says.
    pub fn notices(&self, subject: &Subject) -> Vec<Notice> {
        let last = subject.sequence.frame_count() - 1;
        let beyond = |name: &str, frame: Option<usize>| {
            frame.map(|frame| {
                Notice::warning(format!(
                    "{name} is set to frame {frame}, but the last frame is {last}; it is computed from the volumes"
                ))
            })
        };
        let swapped = self.swapped.then(|| {
            Notice::warning(
                "the cavity is smaller at the given end-diastole than at the given end-systole; are the two swapped?",
            )
        });
        beyond("end-diastole", self.end_diastole_beyond)
            .into_iter()
            .chain(beyond("end-systole", self.end_systole_beyond))
            .chain(swapped)
            .chain(
                self.both_at
                    .map(|frame| Notice::warning(both_phases_at(frame))),
            )
            .collect()
    }
}

/// What is said of a subject of which one frame is end-diastole and end-systole, whoever says so.
pub fn both_phases_at(frame: usize) -> String {
    format!("end-diastole and end-systole are both frame {frame}: no ejection fraction")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceSequence};
    use crate::units::LengthUnit;

    fn stated(end_diastole: usize, end_systole: usize) -> Vec<Notice> {
        let frames = vec![phantom::sphere(1, 3.0), phantom::sphere(1, 2.0)];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let mut subject = Subject::new("p", sequence, LengthUnit::Millimetre);
        subject.end_diastole = Some(end_diastole);
        subject.end_systole = Some(end_systole);
        StatedPhases::of(&subject).notices(&subject)
    }

    #[test]
    fn a_frame_that_is_not_there_is_told() {
        assert_eq!(
            stated(0, 7),
            [Notice::warning(
                "end-systole is set to frame 7, but the last frame is 1; it is computed from the volumes"
            )]
        );
    }

    #[test]
    fn swapped_phases_are_told() {
        assert!(stated(0, 1).is_empty());
        assert!(stated(1, 0)[0].text.ends_with("are the two swapped?"));
        assert!(stated(1, 1)[0].text.ends_with(": no ejection fraction"));
    }
}
