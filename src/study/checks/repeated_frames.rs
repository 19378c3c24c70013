//! Do some frames repeat others?

use super::words::{all_of, frames_phrase};
use crate::study::{Notice, SurfaceSequence};

/// Frames with exactly the positions of an earlier frame.
///
/// Why it matters: a frame that was copied to fill a gap is not a measurement, stops the motion,
/// and counts twice in averages and maps. The last frame equal to the first is a beat closed by hand.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RepeatedFrames {
    /// Each repeating frame with the first frame that it repeats.
    pub pairs: Vec<(usize, usize)>,
}

impl RepeatedFrames {
    /// Compares all frames.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let frames = surface.frames();
        let mut pairs = Vec::new();
        for (later, mesh) in frames.iter().enumerate() {
            if let Some(earlier) = frames[..later]
                .iter()
                .position(|other| other.vertices() == mesh.vertices())
            {
                pairs.push((later, earlier));
            }
        }
        Self { pairs }
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        let (name, count) = (surface.kind().name(), surface.frames().len());
        match self.pairs.as_slice() {
            [] => None,
            pairs if pairs.len() + 1 == count => Some(Notice::warning(format!(
                "{name}: {} are identical: it does not move",
                all_of(count, "frames")
            ))),
            [(later, 0)] if later + 1 == count => Some(Notice::info(format!(
                "{name}: the last frame repeats the first"
            ))),
            [(later, earlier)] => Some(Notice::warning(format!(
                "{name}: frame {later} is identical to frame {earlier}"
            ))),
            pairs => {
                let later: Vec<usize> = pairs.iter().map(|&(later, _)| later).collect();
                Some(Notice::warning(format!(
                    "{name}: {} repeat earlier frames",
                    frames_phrase(&later, count)
                )))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceKind;

    fn note_on(radii: &[f64]) -> Option<Notice> {
        let frames = radii.iter().map(|&r| phantom::sphere(1, r)).collect();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        RepeatedFrames::of(&surface).notice(&surface)
    }

    #[test]
    fn copied_frames_are_told_by_number() {
        assert_eq!(note_on(&[3.0, 2.0, 2.5]), None);
        assert_eq!(
            note_on(&[3.0, 2.0, 2.0, 2.5]).unwrap().text,
            "cavity: frame 2 is identical to frame 1"
        );
        assert_eq!(
            note_on(&[3.0, 2.0, 2.0, 2.5, 3.0]).unwrap().text,
            "cavity: frames 2, 4 repeat earlier frames"
        );
    }

    #[test]
    fn a_beat_closed_by_hand_is_a_remark_and_a_still_heart_a_warning() {
        assert_eq!(
            note_on(&[3.0, 2.0, 3.0]),
            Some(Notice::info("cavity: the last frame repeats the first"))
        );
        assert_eq!(
            note_on(&[3.0, 3.0]),
            Some(Notice::warning(
                "cavity: both frames are identical: it does not move"
            ))
        );
        assert_eq!(note_on(&[3.0]), None);
    }
}
