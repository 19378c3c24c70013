//! Synthetic studies have the classes, the noise and the variety that they say.

use super::*;

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
        let study = cohort.study(None).unwrap();
        assert_eq!(study.subjects[4].label.as_deref(), Some("twist"));
        let rigid = crate::analysis::metrics::MetricParams {
            kind: crate::analysis::metrics::MetricKind::Rigid,
            ..Default::default()
        };
        let params = crate::analysis::pose_distances::PoseDistanceParams {
            metric: rigid,
            ..Default::default()
        };
        let found = crate::analysis::pose_distances::pose_distances(
            &study,
            &params.check().unwrap(),
            &crate::progress::Progress::default(),
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

#[test]
fn the_same_seed_gives_the_same_noise_and_another_does_not() {
    let cohort = synthetic_cohort(&SyntheticParams {
        per_class: 1,
        ..SyntheticParams::default()
    })
    .unwrap();
    let noise = Noise {
        family: NoiseFamily::Poisson,
        percent: 5.0,
        reference: NoiseReference::Shape,
        seed: 4,
    };
    let poses = &cohort.deformations[2].poses;
    let first = noisy(poses, &noise, 2);
    assert_eq!(first, noisy(poses, &noise, 2));
    assert_ne!(first, noisy(poses, &noise, 3));
    assert_ne!(first, noisy(poses, &Noise { seed: 5, ..noise }, 2));
}
