//! Patches of the built-in cohort against what is true of it, with and without noise; run with
//! `--nocapture` for the table.

use std::sync::Arc;

use cardiomorph::analysis::experiments::{NoiseFamily, NoiseReference, noise_sigma};
use cardiomorph::analysis::segments::Segment;
use cardiomorph::analysis::thickening::WallThickening;
use cardiomorph::mesh::{Point3, TriMesh};
use cardiomorph::study::built_in::{Abnormality, BuiltInParams, GroundTruth, cohort};
use cardiomorph::study::{MeshSequence, Subject, SurfaceSequence};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::shared::thickened;

/// What was found in one heart, beside what is there.
struct Scored {
    id: String,
    abnormality: Abnormality,
    /// Share of the regular medial surface and best Dice of each true patch.
    true_patches: Vec<[f64; 2]>,
    found: usize,
    /// Segments of which a third lies in a true patch; and those of them found so.
    segments: [usize; 2],
    wall_thickening: WallThickening,
}

impl Scored {
    /// A normal heart with a patch, or a patch of 4 % and more that is not there.
    fn errors(&self) -> usize {
        let missed = |[share, dice]: &&[f64; 2]| *share >= 0.04 && *dice < 0.5;
        let false_patches = self.abnormality == Abnormality::None && self.found > 0;
        self.true_patches.iter().filter(missed).count() + usize::from(false_patches)
    }

    fn row(&self) -> String {
        let patches: Vec<String> = (self.true_patches.iter())
            .map(|[share, dice]| format!("{:.0} % Dice {dice:.2}", 100.0 * share))
            .collect();
        format!(
            "{} {:?}: {} found, {:?}; {}; segments {} of {}",
            self.id,
            self.abnormality,
            self.found,
            self.wall_thickening,
            patches.join(", "),
            self.segments[1],
            self.segments[0]
        )
    }
}

/// The subject with Gaussian noise on every vertex of every pose: `percent` of the mean square
/// displacement from rest per coordinate.
fn noisy(subject: &Subject, percent: f64, seed: u64) -> Subject {
    let poses: Vec<Vec<Point3>> = (0..subject.sequence.frame_count())
        .map(|frame| subject.sequence.pose(frame).unwrap())
        .collect();
    let sigma = noise_sigma(&poses, percent, NoiseReference::Displacement);
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut surface = |surface: &SurfaceSequence| {
        let frames = (surface.frames().iter())
            .map(|mesh| {
                let points = NoiseFamily::Gaussian.added(mesh.vertices(), sigma, &mut random);
                TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
            })
            .collect();
        SurfaceSequence::new(surface.kind(), frames).unwrap()
    };
    let surfaces = subject
        .sequence
        .surfaces()
        .iter()
        .map(&mut surface)
        .collect();
    let mut noisy = subject.clone();
    noisy.sequence = MeshSequence::new(surfaces).unwrap();
    noisy
}

fn scored(subject: &Subject, truth: &GroundTruth) -> Scored {
    let (beat, found) = thickened(subject).unwrap();
    let surface = truth
        .surfaces
        .iter()
        .find(|surface| surface.kind == beat.surface)
        .unwrap();
    let atoms = beat.regular.len();
    let count = |keep: &dyn Fn(usize) -> bool| (0..atoms).filter(|&i| keep(i)).count() as f64;
    let regular = count(&|i| beat.regular[i]);
    let true_patches = (1..=truth.patches as u8)
        .map(|number| {
            let inside =
                |i: usize| beat.regular[i] && surface.patch[beat.vertices[i] as usize] == number;
            let size = count(&inside);
            let dice = |atoms: &[u32]| {
                let common = atoms.iter().filter(|&&i| inside(i as usize)).count();
                2.0 * common as f64 / (size + atoms.len() as f64)
            };
            let best = found
                .patches
                .iter()
                .map(|patch| dice(&patch.atoms))
                .fold(0.0, f64::max);
            [size / regular, best]
        })
        .collect();
    let told = |number: u8| {
        let of = |segment: Segment| -> f64 {
            (found.patches.iter().flat_map(|patch| &patch.segments))
                .filter(|share| share.segment == segment)
                .map(|share| share.of_segment)
                .sum()
        };
        of(Segment::new(number).unwrap()) >= 1.0 / 3.0
    };
    Scored {
        id: subject.id.clone(),
        abnormality: truth.abnormality,
        true_patches,
        found: found.patches.len(),
        segments: [
            truth.segments.len(),
            truth
                .segments
                .iter()
                .filter(|&&number| told(number))
                .count(),
        ],
        wall_thickening: found.wall_thickening,
    }
}

fn all_scored(vertices: usize, percent: f64, seed: u64) -> Vec<Scored> {
    let params = BuiltInParams {
        vertices,
        ..BuiltInParams::default()
    };
    let cohort = cohort(&params).unwrap();
    let hearts: Vec<Scored> = (cohort.study.subjects.iter().zip(&cohort.truths))
        .map(|(subject, truth)| match percent {
            0.0 => scored(subject, truth),
            _ => scored(&noisy(subject, percent, seed), truth),
        })
        .collect();
    hearts
        .iter()
        .for_each(|heart| println!("{percent} % {}", heart.row()));
    hearts
}

/// Mean Dice over true patches, share of their segments found, and errors.
fn summary(hearts: &[Scored]) -> (f64, f64, usize) {
    let dices: Vec<f64> = hearts
        .iter()
        .flat_map(|h| &h.true_patches)
        .map(|[_, dice]| *dice)
        .collect();
    let segments = |which: usize| hearts.iter().map(|h| h.segments[which]).sum::<usize>() as f64;
    let errors = hearts.iter().map(Scored::errors).sum();
    let mean = dices.iter().sum::<f64>() / dices.len() as f64;
    println!(
        "mean Dice {mean:.3}, segments {:.3}, errors {errors}",
        segments(1) / segments(0)
    );
    (mean, segments(1) / segments(0), errors)
}

#[test]
fn patches_of_the_built_in_cohort_are_found_where_they_are() {
    let hearts = all_scored(1200, 0.0, 0);
    let (dice, segments, errors) = summary(&hearts);
    assert_eq!(errors, 0);
    assert!(dice >= 0.9, "{dice}");
    assert!(segments >= 0.9, "{segments}");
    for heart in &hearts {
        let there = heart.true_patches.len();
        assert_eq!(heart.found, there, "{}", heart.row());
    }
}

#[test]
fn noise_on_the_vertices_costs_at_most_one_patch() {
    let hearts = all_scored(2500, 5.0, 1);
    let (dice, segments, errors) = summary(&hearts);
    assert!(errors <= 1, "{errors}");
    assert!(dice >= 0.8, "{dice}");
    assert!(segments >= 0.9, "{segments}");
}
