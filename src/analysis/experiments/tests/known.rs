//! Numbers of the studies that can be said beforehand.

use super::*;
use crate::analysis::experiments::noise_result::mean_and_error;
use crate::mesh::Point3;

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
    let mut params = InterpolationStudyParams::default();
    params.objects.truncate(1);
    params.geodesic.in_betweens = 1;
    let study = interpolation_study(&params, &Progress::default()).unwrap();
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
