//! This beat on that heart: the carried beat as a heart of its own, and how far it lies from the
//! heart's own beat.

use std::sync::Arc;

use crate::analysis::transport::TransportParams;
use crate::mesh::Point3;
use crate::study::{MeshSequence, Revision, Subject};

use crate::document::document::{CarriedBeat, Document, phase_of, position_at_phase};

/// How the carrying of a beat stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CarryingState {
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

/// A beat that was carried over to another heart.
#[derive(Clone, Debug)]
pub struct CarriedHeart {
    /// Whose beat on whose heart, of which state of the study, with which settings.
    pub key: (Revision, CarriedBeat, TransportParams),
    /// What came of it, as the engine gave it.
    pub sequence: Arc<MeshSequence>,
    /// The heart with the carried beat: the frames are those of the beat, the rest is the heart's.
    pub subject: Arc<Subject>,
    /// For every frame, the distance of each vertex from where the heart's own beat has it at the
    /// same phase, in the heart's unit; surfaces one after the other.
    pub distances: Arc<Vec<Vec<f32>>>,
}

impl CarriedHeart {
    /// Makes a heart of what the engine gave.
    pub fn new(
        key: (Revision, CarriedBeat, TransportParams),
        sequence: &Arc<MeshSequence>,
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
                carried_title(from, onto),
                MeshSequence::clone(sequence),
                onto.unit,
            )
        };
        Self {
            distances: Arc::new(distances_from_own_beat(&subject, onto)),
            key,
            sequence: Arc::clone(sequence),
            subject: Arc::new(subject),
        }
    }
}

/// `Motion of P07 on N03`.
pub fn carried_title(from: &Subject, onto: &Subject) -> String {
    format!("Motion of {} on {}", from.id, onto.id)
}

/// Settings with which the document has beats carried over.
pub fn transport_params(document: &Document) -> TransportParams {
    TransportParams {
        metric: document.map.distances.metric,
        ..TransportParams::default()
    }
}

/// The distance of each vertex of a carried beat from the heart's own beat at the same phase,
/// frame by frame.
fn distances_from_own_beat(carried: &Subject, own: &Subject) -> Vec<Vec<f32>> {
    (0..carried.sequence.frame_count())
        .filter_map(|frame| {
            let position = position_at_phase(own, phase_of(carried, frame as f64));
            let (there, here) = (carried.sequence.pose(frame)?, pose_between(own, position)?);
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
    use crate::document::testing::subject_with_frames;

    #[test]
    fn a_beat_carried_to_its_own_heart_is_nowhere_away_from_it() {
        let heart = subject_with_frames("a", 6);
        let beat = CarriedBeat { from: 0, onto: 1 };
        let key = (Revision(1), beat, TransportParams::default());
        let sequence = Arc::new(heart.sequence.clone());
        let carried = CarriedHeart::new(key, &sequence, &heart, &heart);
        assert_eq!(carried.distances.len(), 6);
        assert!(carried.distances.iter().flatten().all(|d| *d < 1e-6));
        assert_eq!(carried.subject.id, "Motion of a on a");
    }

    #[test]
    fn distances_compare_equal_phases_whatever_the_number_of_frames() {
        // The sphere of the tests shrinks by 1 mm a frame: at the same phase, 4 frames are half as far.
        let (fast, slow) = (subject_with_frames("a", 4), subject_with_frames("b", 8));
        let beat = CarriedBeat { from: 0, onto: 1 };
        let key = (Revision(1), beat, TransportParams::default());
        let carried = CarriedHeart::new(key, &Arc::new(fast.sequence.clone()), &fast, &slow);
        for (frame, distances) in carried.distances.iter().enumerate() {
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
