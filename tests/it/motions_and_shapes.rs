//! The aim itself: hearts of widely varying shape and size, each with motions of four kinds. Distances of deformations tell the
//! motions, whatever the heart; distances of shapes tell the hearts, whatever they do.

use std::f64::consts::TAU;
use std::sync::Arc;

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use cardiomorph::analysis::classification::{k_means, tau};
use cardiomorph::analysis::deformations::{
    Comparison, DeformationMapParams, PartDistances, PartParams, distances_at_equal_phases,
    map_of_distances, part_distances,
};
use cardiomorph::analysis::embedding::classical_mds;
use cardiomorph::analysis::experiments::{Method, Noise, NoiseFamily, NoiseReference, noisy_study};
use cardiomorph::analysis::pose_distances::DistanceMatrix;
use cardiomorph::mesh::{Point3, TriMesh, phantom};
use cardiomorph::progress::Progress;
use cardiomorph::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use cardiomorph::units::LengthUnit;

const HEARTS: usize = 40;
const KINDS: usize = 4;
const SEED: u64 = 3;

/// How a heart is shaped: what makes it of a half sphere of radius 1 with its apex down.
struct Shape {
    axes: [f64; 3],
    bend: f64,
    pear: f64,
    size_mm: f64,
}

impl Shape {
    fn drawn(random: &mut ChaCha8Rng) -> Self {
        Self {
            axes: [
                random.random_range(0.75..1.3),
                random.random_range(0.75..1.3),
                random.random_range(0.9..2.0),
            ],
            bend: random.random_range(-0.3..0.3),
            pear: random.random_range(-0.25..0.25),
            size_mm: random.random_range(20.0..60.0),
        }
    }

    fn of(&self, point: Point3) -> Point3 {
        // Wider or narrower towards the apex, then bent sideways with the square of the depth.
        let wide = 1.0 + self.pear * point.z;
        let [x, y, z] = [0, 1, 2].map(|axis| self.axes[axis] * point[axis]);
        self.size_mm * Point3::new(wide * x + self.bend * z * z, wide * y, z)
    }
}

/// Four kinds of motion of the half sphere.
fn moved(kind: usize, amount: f64, point: &Point3) -> Point3 {
    let Point3 { coords } = point;
    let (x, y, z) = (coords.x, coords.y, coords.z);
    match kind {
        // The circumference shortens, the length stays.
        0 => Point3::new((1.0 - amount) * x, (1.0 - amount) * y, z),
        // The length shortens.
        1 => Point3::new(x, y, (1.0 - amount) * z),
        // The apex turns against the base.
        2 => {
            let (sin, cos) = (3.0 * amount * z).sin_cos();
            Point3::new(cos * x - sin * y, sin * x + cos * y, z)
        }
        // One side moves in, the other stays.
        _ => {
            let side = amount * (1.0 + x).powi(2) / 2.0;
            Point3::new(x - side * x.max(0.0), (1.0 - 0.5 * side) * y, z)
        }
    }
}

/// Every heart with every kind of motion: beats of four frames, amounts that vary by a fifth.
fn study() -> Study {
    let bowl = phantom::bowl(1.0, 9, 18);
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut subjects = Vec::new();
    for heart in 0..HEARTS {
        let shape = Shape::drawn(&mut random);
        for kind in 0..KINDS {
            let most = 0.25 * random.random_range(0.8..1.2);
            let turn = nalgebra::Rotation3::from_euler_angles(
                random.random_range(0.0..TAU),
                random.random_range(0.0..TAU),
                0.0,
            );
            let frames = [0.0, 0.5, 1.0, 0.5].map(|share| {
                let points = bowl
                    .vertices()
                    .iter()
                    .map(|p| turn * shape.of(moved(kind, share * most, p)));
                TriMesh::new(points.collect::<Vec<Point3>>(), Arc::clone(bowl.faces())).unwrap()
            });
            let surface = SurfaceSequence::new(SurfaceKind::Endocardium, frames.to_vec()).unwrap();
            let sequence = MeshSequence::new(vec![surface]).unwrap();
            let id = format!("heart {heart}, motion {kind}");
            subjects.push(Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre)));
        }
    }
    Study {
        subjects,
        ..Study::default()
    }
}

/// Share of beats in the cluster of their motion, on the map of these distances.
fn motions_told(distances: &DistanceMatrix) -> f64 {
    let progress = Progress::default();
    let plane = DeformationMapParams::default().check().unwrap();
    let map = map_of_distances(distances, &plane, &progress).unwrap();
    let clusters = k_means(&map.coordinates, map.dimensions, KINDS, 50, 1, &progress).unwrap();
    let kinds: Vec<Option<usize>> = (0..map.len()).map(|i| Some(i % KINDS)).collect();
    tau(&clusters.clusters, &kinds).correct as f64 / kinds.len() as f64
}

/// Share of beats in the cluster of their heart, by these distances.
fn hearts_told(distances: &DistanceMatrix) -> f64 {
    let progress = Progress::default();
    let map = classical_mds(distances, 10, &progress).unwrap();
    let clusters = k_means(&map.coordinates, map.dimensions, HEARTS, 50, 1, &progress).unwrap();
    let hearts: Vec<Option<usize>> = (0..map.len()).map(|i| Some(i / KINDS)).collect();
    tau(&clusters.clusters, &hearts).correct as f64 / hearts.len() as f64
}

/// Both parts, as a method compares them.
fn parts_of(study: &Study, method: &Method) -> PartDistances {
    let params = PartParams::like(&method.distances, method.deformation_smoothing);
    part_distances(study, &params.check().unwrap(), &Progress::default()).unwrap()
}

/// τ of the motions by another method.
fn told_by(study: &Study, method: &Method) -> f64 {
    if method.comparison != Comparison::Poses {
        return motions_told(&parts_of(study, method).deformation);
    }
    let poses = method.distances.check().unwrap();
    let whole = distances_at_equal_phases(study, &poses, &Progress::default()).unwrap();
    motions_told(&whole.distances)
}

#[test]
fn clusters_of_deformations_are_the_motions_and_those_of_shapes_the_hearts() {
    let clean = study();
    let noise = Noise {
        family: NoiseFamily::Gaussian,
        percent: 5.0,
        reference: NoiseReference::Displacement,
        seed: SEED,
    };
    let noisy = noisy_study(&clean, &noise).unwrap();
    for (study, percent, least) in [(&clean, 0, 0.98), (&noisy, 5, 0.95)] {
        let parts = parts_of(study, &Method::deformation());
        let both = [&parts.deformation, &parts.shape];
        let [motions, crossed] = both.map(motions_told);
        let [other_crossed, hearts] = both.map(hearts_told);
        let others = [
            Method::printed(),
            Method::default_metric(),
            Method::displacement(),
        ]
        .map(|method| (method.name, told_by(study, &method)));
        let table = format!(
            "{percent} % noise: τ of motions {motions:.3} by deformation, {crossed:.3} by shape, {others:.3?}; \
             of hearts {hearts:.3} by shape, {other_crossed:.3} by deformation"
        );
        println!("{table}");
        assert!(motions >= least && hearts >= least, "{table}");
        // Each part is blind to what the other tells, and curves of poses are curves of hearts.
        assert!(crossed < 0.5 && other_crossed < 0.5, "{table}");
        assert!(others[..2].iter().all(|(_, share)| *share < 0.7), "{table}");
    }
}
