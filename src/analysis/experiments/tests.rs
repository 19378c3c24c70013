//! Synthetic studies have the classes, the noise and the variety that they say.

use super::*;
use crate::progress::Progress;

mod known;

#[test]
fn classes_differ_more_than_their_members() {
    for kind in ObjectKind::ALL {
        let params = SyntheticParams {
            object: kind,
            per_class: 3,
            ..SyntheticParams::default()
        };
        let cohort = synthetic_cohort(&params).unwrap();
        assert_eq!(cohort.labels().len(), 12);
        let study = cohort.study().unwrap();
        assert_eq!(study.subjects[4].label.as_deref(), Some("twist"));
        let params = crate::analysis::pose_distances::PoseDistanceParams::default();
        let found = crate::analysis::pose_distances::pose_distances(
            &study,
            &params.check().unwrap(),
            &Progress::default(),
        )
        .unwrap();
        let last = |subject: usize| 3 * subject + 2;
        let (mut within, mut between) = (0.0_f64, f64::MAX);
        for i in 0..12 {
            for j in 0..i {
                let d = found.distances.get(last(i), last(j));
                if i / 3 == j / 3 {
                    within = within.max(d);
                } else {
                    between = between.min(d);
                }
            }
        }
        assert!(within < between, "{}: {within} {between}", kind.name());
    }
}

fn small() -> NoiseDeformationParams {
    NoiseDeformationParams {
        objects: vec![ObjectKind::ALL[1]],
        cohort: SyntheticParams {
            per_class: 6,
            ..SyntheticParams::default()
        },
        families: vec![NoiseFamily::Gaussian],
        percents: vec![1.0, 400.0],
        references: vec![NoiseReference::Shape],
        redraws: 2,
        methods: vec![Method::default_metric(), Method::printed()],
        restarts: 10,
        ..NoiseDeformationParams::default()
    }
}

#[test]
fn the_same_seed_gives_the_same_noise_and_another_does_not() {
    let cohort = synthetic_cohort(&SyntheticParams {
        per_class: 1,
        ..SyntheticParams::default()
    });
    let study = cohort.unwrap().study().unwrap();
    let noise = Noise {
        family: NoiseFamily::Poisson,
        percent: 5.0,
        reference: NoiseReference::Shape,
        seed: 4,
    };
    let poses = |noise: &Noise, subject: usize| {
        let study = noisy_study(&study, noise).unwrap();
        study.subjects[subject].sequence.pose(0).unwrap()
    };
    assert_eq!(poses(&noise, 2), poses(&noise, 2));
    assert_ne!(poses(&noise, 2), poses(&Noise { seed: 5, ..noise }, 2));
    let rest = |subject: usize| study.subjects[subject].sequence.pose(0).unwrap();
    let added = |subject: usize| poses(&noise, subject)[0] - rest(subject)[0];
    assert!((added(1) - added(2)).norm() > 1e-3);
    let wrong = Noise {
        percent: -1.0,
        ..noise
    };
    let error = noisy_study(&study, &wrong).unwrap_err();
    assert!(error.to_string().contains("-1 %"), "{error}");
}

#[test]
fn more_noise_tells_less_and_past_all_measure_no_more_than_chance() {
    let params = small();
    let result = noise_deformation(&params, &Progress::default()).unwrap();
    assert_eq!(result.cells.len(), 6);
    let shape = NoiseReference::Shape;
    let gaussian = Some(NoiseFamily::Gaussian);
    let tau = |percent| result.cell("default", gaussian, percent, shape).unwrap();
    let clean = result.cell("default", None, 0.0, shape).unwrap();
    assert!(clean.tau > 0.95, "{}", clean.tau);
    assert!(tau(1.0).tau > 0.9);
    assert!(tau(400.0).tau < 0.75);
    assert!(tau(400.0).tau - tau(400.0).baseline < 0.3);
    assert!((tau(1.0).published.unwrap() - 0.994).abs() < 1e-12);
    // Chance level for four classes of six, far below one.
    assert!(
        clean.baseline > 0.3 && clean.baseline < 0.6,
        "{}",
        clean.baseline
    );
    assert!(
        result
            .protocol()
            .iter()
            .any(|line| line.contains("2 redraws"))
    );
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let params = NoiseDeformationParams {
        percents: vec![5.0],
        ..small()
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| noise_deformation(&params, &Progress::default()))
    };
    assert_eq!(on(1).unwrap(), on(3).unwrap());
}

#[test]
fn a_stopped_study_says_so_and_an_empty_one_is_refused() {
    let progress = Progress::default();
    progress.stop();
    let stopped = noise_deformation(&small(), &progress).unwrap_err();
    assert_eq!(stopped, ExperimentError::Stopped(crate::progress::Stopped));
    let none = NoiseDeformationParams {
        redraws: 0,
        ..small()
    };
    let error = noise_deformation(&none, &Progress::default()).unwrap_err();
    assert!(error.to_string().contains("redraws"), "{error}");
}

#[test]
fn one_table_tells_the_labels_of_the_built_in_cohort_beside_ef_and_chance() {
    let built_in = crate::study::built_in::BuiltInParams {
        vertices: 200,
        ..Default::default()
    };
    let study = crate::study::built_in::cohort(&built_in).unwrap().study;
    let mut params = MetricComparisonParams::all_metrics(None);
    params.methods.truncate(1);
    params.percents = vec![0.0, 2.5];
    params.redraws = 2;
    params.classes.permutations = 20;
    let table = metric_comparison(&study, &params, &Progress::default()).unwrap();
    let names: Vec<&str> = table.rows.iter().map(|row| row.method).collect();
    assert_eq!(names.len(), 4);
    assert_eq!((names[1], names[3]), ("EF alone", "EF alone"));
    assert_eq!((table.rows[0].copies, table.rows[2].copies), (1, 2));
    for row in &table.rows {
        assert_eq!(row.labelled, 23, "{}", row.method);
        for accuracy in [
            row.nearest_neighbour,
            row.linear_classifier,
            row.plane_classifier,
            row.tau,
        ] {
            assert!((0.0..=1.0).contains(&accuracy.share), "{row:?}");
            assert!(
                accuracy.baseline > 0.2 && accuracy.baseline < 0.8,
                "{row:?}"
            );
        }
    }
    let progress = Progress::default();
    progress.stop();
    let stopped = metric_comparison(&study, &params, &progress).unwrap_err();
    assert_eq!(stopped, ExperimentError::Stopped(crate::progress::Stopped));
}

#[test]
fn a_transported_motion_is_nearer_to_the_truth_than_a_copied_one() {
    let error = |transport: crate::analysis::transport::TransportParams| {
        let mut params = TransportExperimentParams {
            transport,
            ..TransportExperimentParams::default()
        };
        params.cohort.per_class = 1;
        let study = transport_experiment(&params, &Progress::default()).unwrap();
        let of = |target: &str| {
            let cases = study.cases.iter().filter(|case| case.target == target);
            let errors: Vec<f64> = cases.map(|case| case.relative_error).collect();
            errors.iter().sum::<f64>() / errors.len() as f64
        };
        [of("ellipsoid"), of("deformed torus")]
    };
    let transported = error(Default::default());
    // In the plain metric of displacement, along the straight line, nothing changes on the way.
    let copied = error(crate::analysis::transport::TransportParams {
        metric: crate::analysis::metrics::MetricParams {
            area_weights: false,
            ..Default::default()
        },
        interpolated_poses: 0,
        ..Default::default()
    });
    for (transported, copied) in transported.into_iter().zip(copied) {
        assert!(transported < copied, "{transported} {copied}");
    }
}

#[test]
fn motions_are_followed_by_other_objects_and_paths_stay_near_them() {
    let mut params = TransportExperimentParams::default();
    params.objects.truncate(1);
    params.cohort.per_class = 1;
    params.transport.interpolated_poses = 0;
    let study = transport_experiment(&params, &Progress::default()).unwrap();
    assert_eq!(study.cases.len(), 4);
    for case in &study.cases {
        assert!(case.cosine > 0.8, "{case:?}");
        assert_eq!(case.target, "ellipsoid");
    }
    let mut params = InterpolationExperimentParams::default();
    params.objects.truncate(1);
    params.geodesic.interpolated_poses = 1;
    let study = interpolation_experiment(&params, &Progress::default()).unwrap();
    for case in &study.cases {
        assert!(case.energy_ratio <= 1.0 + 1e-12, "{:?}", case.motion);
        assert!(
            case.midpoint_error < 0.3,
            "{:?} {}",
            case.motion,
            case.midpoint_error
        );
    }
}
