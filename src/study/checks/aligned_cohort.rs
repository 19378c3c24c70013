//! Were the subjects of a cohort pre-aligned, frame by frame?

use std::collections::BTreeMap;
use std::sync::Arc;

use super::words::counted;

use crate::mesh::{Point3, Vector3};
use crate::study::{Notice, Subject};

/// Subjects count as aligned where the mean vertex of each lies within this share of its size (root
/// mean square over the cohort). Published subjects of an atlas, aligned by Procrustes' method, reach
/// 0.034; subjects that share only the axis of the camera 0.11; subjects in scanners 1.
const ALIGNED: f64 = 0.05;

/// Frames in which all subjects of a cohort coincide.
///
/// Why it matters: subjects that were aligned for an atlas have lost their place in the body, and
/// where each frame was aligned by itself, the motion of the subject as a whole too.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AlignedCohort {
    /// Root mean square distance of mean vertices from their common mean, over the size of the
    /// subjects, in the frame where it is largest; `None` for fewer than three comparable subjects.
    pub spread: Option<f64>,
    /// Frames that all have.
    pub frames: usize,
    /// Subjects that were compared.
    pub hearts: usize,
}

impl AlignedCohort {
    /// Compares the subjects that have the commonest connectivity and number of frames.
    pub fn of(subjects: &[Arc<Subject>]) -> Self {
        let mut groups: BTreeMap<_, Vec<&Subject>> = BTreeMap::new();
        for subject in subjects {
            let frames = subject.sequence.frame_count();
            let key = (subject.sequence.correspondence(), frames);
            groups.entry(key).or_default().push(subject);
        }
        let Some(((_, frames), hearts)) = groups.into_iter().max_by_key(|(_, group)| group.len())
        else {
            return Self::default();
        };
        let spread = (hearts.len() >= 3).then(|| {
            (0..frames)
                .map(|frame| spread(&hearts, frame))
                .fold(0.0, f64::max)
        });
        Self {
            spread,
            frames,
            hearts: hearts.len(),
        }
    }

    /// What the load report says, if they are aligned.
    pub fn notice(&self) -> Option<Notice> {
        let each = if self.frames > 1 {
            ", each frame separately: these files do not contain position or motion of the heart as a whole"
        } else {
            ""
        };
        (self.spread? <= ALIGNED).then(|| {
            Notice::info(format!(
                "{} appear pre-aligned, as for an atlas{each}",
                counted(self.hearts, "subject", "subjects")
            ))
        })
    }
}

fn spread(subjects: &[&Subject], frame: usize) -> f64 {
    let facts: Vec<(Vector3, f64)> = subjects
        .iter()
        .filter_map(|subject| Some(mean_and_size_squared(&subject.sequence.pose(frame)?)))
        .collect();
    let count = facts.len().max(1) as f64;
    let middle: Vector3 = facts.iter().map(|(mean, _)| mean).sum::<Vector3>() / count;
    let apart: f64 = facts
        .iter()
        .map(|(mean, _)| (mean - middle).norm_squared())
        .sum();
    let size: f64 = facts.iter().map(|(_, size)| size).sum();
    if size > 0.0 {
        (apart / size).sqrt()
    } else {
        f64::INFINITY
    }
}

/// Mean vertex, and mean squared distance from it.
fn mean_and_size_squared(points: &[Point3]) -> (Vector3, f64) {
    let count = points.len().max(1) as f64;
    let mean = points.iter().map(|p| p.coords).sum::<Vector3>() / count;
    let size = points
        .iter()
        .map(|p| (p.coords - mean).norm_squared())
        .sum::<f64>()
        / count;
    (mean, size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn cohort(shift: f64) -> Vec<Arc<Subject>> {
        (0..4)
            .map(|place| {
                let ball = phantom::sphere(1, 30.0 + f64::from(place));
                let points: Vec<Point3> = ball
                    .vertices()
                    .iter()
                    .map(|p| Point3::new(p.x + shift * f64::from(place), p.y, p.z))
                    .collect();
                let mesh = TriMesh::new(points, ball.faces().clone()).unwrap();
                let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![mesh; 2]).unwrap();
                let sequence = MeshSequence::new(vec![surface]).unwrap();
                let id = format!("p{place}");
                Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
            })
            .collect()
    }

    #[test]
    fn hearts_laid_upon_each_other_are_told_and_hearts_in_scanners_are_not() {
        assert!(AlignedCohort::of(&cohort(0.0)).notice().is_some());
        assert_eq!(AlignedCohort::of(&cohort(10.0)).notice(), None);
        assert_eq!(AlignedCohort::of(&cohort(0.0)[..2]).notice(), None);
        assert_eq!(AlignedCohort::of(&[]).notice(), None);
    }
}
