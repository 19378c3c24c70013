//! One fixed colour range for a whole cohort, so that colours mean the same on every heart.

use crate::analysis::measures::{SubjectMeasures, phases_of};
use crate::picture::quantity::Quantity;
use crate::picture::ticks::nice_ceiling;
use crate::render::ColourRange;
use crate::study::{Study, Subject};

/// Colour ranges that hold for all subjects and frames of a study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CohortColourRanges {
    /// From zero to a round length.
    pub displacement: ColourRange,
    /// From half to double.
    pub area_ratio: ColourRange,
}

impl Default for CohortColourRanges {
    fn default() -> Self {
        Self {
            displacement: ColourRange {
                low: 0.0,
                high: 1.0,
                logarithmic: false,
            },
            area_ratio: ColourRange {
                low: 0.5,
                high: 2.0,
                logarithmic: true,
            },
        }
    }
}

/// Up to four times the mean, the same for every pair; what is beyond has the end colour.
const CONTRIBUTION: ColourRange = ColourRange {
    low: 0.0,
    high: 4.0,
    logarithmic: false,
};

/// From half to double: a normal wall thickens by half, and the scale is even about unchanged.
pub(crate) const THICKNESS_RATIO: ColourRange = ColourRange {
    low: 0.5,
    high: 2.0,
    logarithmic: true,
};

/// Share of all displacements that the range covers: a few stray vertices in one of a hundred
/// hearts must not make the others look still. What is beyond has its own colour.
const COVERED_SHARE: f64 = 0.995;
/// Displacements looked at; more would not move the share by a visible amount.
const MAX_SAMPLES: usize = 400_000;

impl CohortColourRanges {
    /// Ranges of a study. `reference_frames` holds each subject's frame of end-diastole.
    pub fn of(study: &Study, reference_frames: &[usize]) -> Self {
        let ranges = Self::default();
        let mut samples = displacement_samples(study, reference_frames);
        if samples.is_empty() {
            return ranges;
        }
        let place = ((samples.len() - 1) as f64 * COVERED_SHARE) as usize;
        let (_, covered, _) = samples.select_nth_unstable_by(place, f64::total_cmp);
        let step = nice_ceiling(*covered / 5.0);
        let high = ((*covered / step - 1e-6).ceil().max(1.0) * step) as f32;
        Self {
            displacement: ColourRange {
                high,
                ..ranges.displacement
            },
            ..ranges
        }
    }

    /// The range of one quantity.
    pub fn range(&self, quantity: Quantity) -> ColourRange {
        match quantity {
            Quantity::Tissue | Quantity::Displacement => self.displacement,
            // Two beats differ by less than either moves; a round share keeps colours comparable.
            Quantity::MotionDifference => ColourRange {
                high: 0.5 * self.displacement.high,
                ..self.displacement
            },
            Quantity::AreaRatio => self.area_ratio,
            Quantity::ThicknessRatio => THICKNESS_RATIO,
            Quantity::Contribution => CONTRIBUTION,
        }
    }
}

/// The frame that motion is counted from: end-diastole as stated or measured, else the first.
pub fn reference_frame(subject: &Subject, measures: Option<&SubjectMeasures>) -> usize {
    let (end_diastole, _) = phases_of(subject, measures);
    (end_diastole.filter(|&frame| frame < subject.sequence.frame_count())).unwrap_or(0)
}

fn displacement_samples(study: &Study, reference_frames: &[usize]) -> Vec<f64> {
    let total: usize = study
        .subjects
        .iter()
        .map(|subject| subject.sequence.vertex_count() * subject.sequence.frame_count())
        .sum();
    let stride = total.div_ceil(MAX_SAMPLES).max(1);
    let mut samples = Vec::with_capacity(total / stride + 1);
    for (subject, &reference) in study.subjects.iter().zip(reference_frames) {
        for surface in subject.sequence.surfaces() {
            let frames = surface.frames();
            let Some(start) = frames.get(reference) else {
                continue;
            };
            for frame in frames {
                let moved = frame.vertices().iter().zip(start.vertices());
                samples.extend(moved.step_by(stride).map(|(a, b)| (a - b).norm()));
            }
        }
    }
    samples
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Point3, TriMesh, phantom};
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;
    use std::sync::Arc;

    fn shifted(distance: f64) -> Arc<Subject> {
        let start = phantom::sphere(2, 20.0);
        let moved: Vec<Point3> = start
            .vertices()
            .iter()
            .map(|p| Point3::new(p.x + distance, p.y, p.z))
            .collect();
        let end = TriMesh::new(moved, Arc::clone(start.faces())).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![start, end]).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Arc::new(Subject::new("P", sequence, LengthUnit::Millimetre))
    }

    #[test]
    fn the_range_is_round_and_holds_the_whole_cohort() {
        let study = Study {
            subjects: vec![shifted(4.0), shifted(11.3)],
            ..Study::default()
        };
        let ranges = CohortColourRanges::of(&study, &[0, 0]);
        assert_eq!(ranges.displacement.high, 15.0);
        assert_eq!(ranges.range(Quantity::AreaRatio).low, 0.5);
    }

    #[test]
    fn a_study_without_motion_has_a_usable_range() {
        let ranges = CohortColourRanges::of(&Study::default(), &[]);
        assert!(ranges.displacement.high > ranges.displacement.low);
        let still = Study {
            subjects: vec![shifted(0.0)],
            ..Study::default()
        };
        let ranges = CohortColourRanges::of(&still, &[0]);
        assert!(ranges.displacement.high > ranges.displacement.low);
    }
}
