//! The motion of one subject transported to another, as a subject of its own, and its difference from that
//! other subject's own motion.

use std::sync::Arc;

use crate::analysis::transport::{TransportParams, TransportedMotion as Transport};
use crate::mesh::Point3;
use crate::study::{Revision, Subject};

use crate::document::document::{Document, TransportChoice, cycle_share, position_at_phase};

/// How the transport of a motion stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TransportState {
    /// It was not asked for, or it is there.
    #[default]
    Done,
    /// It is being computed.
    Computing,
    /// The user stopped it.
    Stopped,
    /// It failed; a card says why.
    Failed,
}

/// A motion that was transported to another subject.
#[derive(Clone, Debug)]
pub struct TransportedSubject {
    /// Whose motion on which subject, of which state of the study, with which settings.
    pub key: (Revision, TransportChoice, TransportParams),
    /// What came of it, as the engine gave it, with how it was made.
    pub motion: Arc<Transport>,
    /// The subject with the transported motion: frames of the motion, all else of the subject.
    pub subject: Arc<Subject>,
    /// For every frame, the distance of each vertex from where the subject's own motion has it at the
    /// same phase, in the subject's unit; surfaces one after the other.
    pub distances: Arc<Vec<Vec<f32>>>,
}

impl TransportedSubject {
    /// A subject with the sequence that the engine gave.
    pub fn new(
        key: (Revision, TransportChoice, TransportParams),
        motion: &Arc<Transport>,
        from: &Subject,
        onto: &Subject,
    ) -> Self {
        let subject = Subject {
            label: onto.label.clone(),
            unit: onto.unit,
            timing: from.timing.clone(),
            end_diastole: from.end_diastole,
            end_systole: from.end_systole,
            anatomy: onto.anatomy,
            ..Subject::new(
                transported_title(from, onto),
                motion.sequence.clone(),
                onto.unit,
            )
        };
        Self {
            distances: Arc::new(differences_from_own_motion(&subject, onto)),
            key,
            motion: Arc::clone(motion),
            subject: Arc::new(subject),
        }
    }
}

/// `Motion of P07 on N03`.
pub fn transported_title(from: &Subject, onto: &Subject) -> String {
    format!("Motion of {} on {}", from.id, onto.id)
}

/// Settings with which the document has motions transported.
pub fn transport_params(document: &Document) -> TransportParams {
    TransportParams {
        metric: document.map.distances.metric.of_paths(),
        ..TransportParams::default()
    }
}

/// The distance of each vertex of a transported motion from the subject's own motion at the same phase,
/// frame by frame.
fn differences_from_own_motion(transported: &Subject, own: &Subject) -> Vec<Vec<f32>> {
    (0..transported.sequence.frame_count())
        .filter_map(|frame| {
            let position = position_at_phase(own, cycle_share(transported, frame as f64));
            let (there, here) = (
                transported.sequence.pose(frame)?,
                pose_between(own, position)?,
            );
            let pairs = there.iter().zip(&here);
            Some(pairs.map(|(a, b)| (a - b).norm() as f32).collect())
        })
        .collect()
}

/// A subject's vertices at a position, on the straight line between frames.
fn pose_between(subject: &Subject, position: f64) -> Option<Vec<Point3>> {
    let frames = subject.sequence.frame_count();
    let frame = (position.floor().max(0.0) as usize).min(frames.checked_sub(1)?);
    let share = position - frame as f64;
    let start = subject.sequence.pose(frame)?;
    if share <= 0.0 {
        return Some(start);
    }
    let end = subject.sequence.pose((frame + 1) % frames)?;
    Some(
        start
            .iter()
            .zip(&end)
            .map(|(a, b)| a + share * (b - a))
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::transport::TransportAccount;
    use crate::document::testing::subject_with_frames;

    fn as_it_is(subject: &Subject) -> Arc<Transport> {
        Arc::new(Transport {
            sequence: subject.sequence.clone(),
            account: TransportAccount::default(),
        })
    }

    #[test]
    fn a_motion_transported_to_its_own_subject_has_no_difference() {
        let heart = subject_with_frames("a", 6);
        let motion = TransportChoice { from: 0, onto: 1 };
        let key = (Revision(1), motion, TransportParams::default());
        let transported = TransportedSubject::new(key, &as_it_is(&heart), &heart, &heart);
        assert_eq!(transported.distances.len(), 6);
        assert!(transported.distances.iter().flatten().all(|d| *d < 1e-6));
        assert_eq!(transported.subject.id, "Motion of a on a");
    }

    #[test]
    fn distances_compare_equal_phases_whatever_the_number_of_frames() {
        // The sphere of the tests shrinks by 1 mm a frame: at the same phase, 4 frames are half as far.
        let (fast, slow) = (subject_with_frames("a", 4), subject_with_frames("b", 8));
        let motion = TransportChoice { from: 0, onto: 1 };
        let key = (Revision(1), motion, TransportParams::default());
        let transported = TransportedSubject::new(key, &as_it_is(&fast), &fast, &slow);
        for (frame, distances) in transported.distances.iter().enumerate() {
            let wanted = frame as f32;
            assert!(
                distances.iter().all(|d| (d - wanted).abs() < 1e-4),
                "frame {frame}"
            );
        }
        let half_way = pose_between(&slow, 2.5).unwrap();
        assert!(
            half_way
                .iter()
                .all(|p| (p.coords.norm() - 27.5).abs() < 1e-9)
        );
        let last = pose_between(&slow, 7.5).unwrap();
        assert!(last.iter().all(|p| (p.coords.norm() - 26.5).abs() < 1e-9));
    }
}
