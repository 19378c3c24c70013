//! Numbers of the studies that can be said beforehand.

use super::*;
use crate::analysis::experiments::noise_result::mean_and_error;
use crate::analysis::experiments::noise_study::classified;
use crate::analysis::experiments::transport_experiment::difference;
use crate::mesh::{Point3, phantom};

#[test]
fn the_error_of_a_mean_is_that_of_the_text_book() {
    let (mean, error) = mean_and_error(&[1.0, 2.0, 3.0]);
    assert!((mean - 2.0).abs() < 1e-15 && (error - 3.0_f64.sqrt().recip()).abs() < 1e-15);
    assert_eq!(mean_and_error(&[4.0]), (4.0, 0.0));
}

#[test]
fn a_level_of_displacement_is_its_mean_square_per_coordinate() {
    let rest = vec![Point3::origin(); 5];
    let moved = vec![Point3::new(2.0, 2.0, 2.0); 5];
    let poses = [rest, moved.clone(), moved];
    let sigma = |percent| noise_sigma(&poses, percent, NoiseReference::Displacement);
    assert!((sigma(100.0) - 2.0).abs() < 1e-15 && (sigma(25.0) - 1.0).abs() < 1e-15);
}

#[test]
fn every_subject_has_noise_of_its_own() {
    let params = SyntheticParams {
        per_class: 1,
        ..SyntheticParams::default()
    };
    let mut study = synthetic_cohort(&params).unwrap().study().unwrap();
    study.subjects[1] = study.subjects[0].clone();
    let noise = Noise {
        family: NoiseFamily::Gaussian,
        percent: 1.0,
        reference: NoiseReference::Shape,
        seed: 3,
    };
    let noisy = noisy_study(&study, &noise).unwrap();
    let [a, b] = [0, 1].map(|subject: usize| noisy.subjects[subject].sequence.pose(0));
    assert_ne!(a, b);
}

#[test]
fn amplitudes_vary_as_much_as_is_said() {
    let amplitudes = |amplitude_jitter| {
        let params = SyntheticParams {
            amplitude_jitter,
            per_class: 4,
            ..SyntheticParams::default()
        };
        let cohort = synthetic_cohort(&params).unwrap();
        let shares = cohort.deformations.iter().map(|deformation| {
            let motion = Motion::ALL[deformation.class];
            deformation.amplitude / motion.typical_amplitude(params.object.solid)
        });
        shares.collect::<Vec<f64>>()
    };
    assert!(amplitudes(0.0).iter().all(|share| *share == 1.0));
    let varied = amplitudes(0.3);
    assert!(varied.iter().all(|share| (share - 1.0).abs() <= 0.3));
    assert!(varied.iter().any(|share| (share - 1.0).abs() > 0.1));
}

#[test]
fn each_object_keeps_its_own_draws() {
    let two = NoiseDeformationParams {
        objects: vec![ObjectKind::ALL[1], ObjectKind::ALL[4]],
        percents: vec![20.0],
        methods: vec![Method::printed()],
        ..small()
    };
    let run = |params: &NoiseDeformationParams| {
        noise_deformation(params, &Progress::default())
            .unwrap()
            .cells
    };
    let both = run(&two);
    let alone = run(&NoiseDeformationParams {
        objects: two.objects[1..].to_vec(),
        ..two.clone()
    });
    for (both, alone) in both.iter().zip(&alone) {
        assert_eq!(both.by_object[1], alone.by_object[0]);
    }
    assert!(
        both.iter()
            .any(|cell| cell.by_object[0].1 != cell.by_object[1].1)
    );
}

#[test]
fn steps_of_a_path_have_a_longest_and_a_shortest_and_its_middle_is_near_the_motion() {
    let mut params = InterpolationExperimentParams::default();
    params.objects.truncate(1);
    params.geodesic.interpolated_poses = 1;
    let study = interpolation_experiment(&params, &Progress::default()).unwrap();
    for case in &study.cases {
        assert!((1.0..1.5).contains(&case.step_ratio), "{case:?}");
    }
    // A bend moves little beside its own path: its middle is that of the motion.
    let least = study
        .cases
        .iter()
        .map(|case| case.midpoint_error)
        .fold(1.0, f64::min);
    assert!(least < 0.05, "{least}");
}

/// Copies with the same noise would have no scatter.
#[test]
fn every_copy_of_a_level_has_noise_of_its_own() {
    let built_in = crate::study::built_in::BuiltInParams {
        vertices: 200,
        ..Default::default()
    };
    let study = crate::study::built_in::cohort(&built_in).unwrap().study;
    let mut params = MetricComparisonParams::all_metrics(None);
    // EF alone, which no map is needed for.
    params.methods.clear();
    params.percents = vec![0.0, 20.0];
    params.classes.permutations = 5;
    let rows = metric_comparison(&study, &params, &Progress::default())
        .unwrap()
        .rows;
    let scatter = |row: &ComparisonRow| {
        let accuracies = [row.nearest_neighbour, row.linear_classifier, row.tau];
        accuracies
            .map(|accuracy| accuracy.standard_error)
            .iter()
            .sum::<f64>()
    };
    assert_eq!((rows[0].copies, rows[1].copies), (1, 3));
    assert_eq!(scatter(&rows[0]), 0.0);
    assert!(scatter(&rows[1]) > 0.0, "{rows:?}");
}

#[test]
fn a_transported_motion_is_compared_with_the_truth_and_not_with_itself() {
    let rest = phantom::sphere(2, 1.0);
    let solid = ObjectKind::ALL[0].solid;
    let moved = |amplitude: f64| -> Vec<Point3> {
        let moved = |p: &Point3| Motion::Bump.moved(solid, p, amplitude);
        rest.vertices().iter().map(moved).collect()
    };
    let truth = moved(0.8);
    let against = |transported: &[Point3]| {
        difference(transported, &truth, rest.vertices(), rest.triangles()).unwrap()
    };
    // Elsewhere in space, but right.
    let shifted: Vec<Point3> = truth
        .iter()
        .map(|p| Point3::new(p.z + 3.0, p.x, p.y))
        .collect();
    let right = against(&shifted);
    assert!(right.relative_error < 1e-12 && (right.cosine - 1.0).abs() < 1e-12);
    assert!((right.norm_ratio - 1.0).abs() < 1e-12 && right.flipped_faces == 0);
    let half = against(&moved(0.4));
    assert!(
        half.norm_ratio < 0.8 && half.relative_error > 0.2,
        "{half:?}"
    );
    // A vertex pulled across its neighbours turns some of its faces over, and no other.
    let mut folded = truth.clone();
    let face = rest.triangles()[0].map(|v| v as usize);
    let [a, b, c] = face.map(|v| truth[v]);
    folded[face[0]] = a + 2.0 * (nalgebra::center(&b, &c) - a);
    let around = rest
        .triangles()
        .iter()
        .filter(|t| t.contains(&(face[0] as u32)));
    let found = against(&folded);
    assert!(found.flipped_faces > 0, "{found:?}");
    assert!(found.flipped_faces <= around.count(), "{found:?}");
    // Seen in a mirror nearly all are, whatever the rigid motion.
    let mirrored: Vec<Point3> = truth.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
    assert!(2 * against(&mirrored).flipped_faces > rest.triangles().len());
}

#[test]
fn a_deformation_that_cannot_be_compared_counts_as_wrong() {
    let params = small();
    let cohort = |object| {
        synthetic_cohort(&SyntheticParams {
            object,
            ..params.cohort
        })
        .unwrap()
    };
    let (own, other) = (cohort(params.objects[0]), cohort(ObjectKind::ALL[4]));
    let mut study = own.study().unwrap();
    let labels: Vec<Option<usize>> = own.labels().into_iter().map(Some).collect();
    let method = &params.methods[0];
    let tau = |study: &crate::study::Study| {
        let scored = classified(&params, study, &labels, method, 1, &Progress::default());
        scored.unwrap().tau
    };
    assert!(tau(&study) > 0.9);
    study.subjects[0] = other.study().unwrap().subjects[0].clone();
    // A count out of all, at least one of them wrong.
    let all = study.subjects.len() as f64;
    let right = tau(&study) * all;
    assert!((right - right.round()).abs() < 1e-9, "{right} of {all}");
    assert!(right < all - 0.5 && right > 0.8 * all, "{right} of {all}");
}
