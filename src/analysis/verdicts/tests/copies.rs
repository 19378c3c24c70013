//! Subjects that are listed under several ids, and walls that are none.

use std::sync::Arc;

use super::{assessed, cohort, input, study};
use crate::analysis::verdicts::*;
use crate::mesh::{Point3, TriMesh, Vector3, phantom};
use crate::progress::Progress;
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};

fn found(study: &Study, hearts: &[Result<Examined, NotAssessed>]) -> Verdicts {
    let params = VerdictParams {
        permutations: 19,
        ..VerdictParams::default()
    };
    verdicts(
        study,
        hearts,
        &params.check().unwrap(),
        None,
        &Progress::default(),
    )
    .unwrap()
}

#[test]
fn a_cohort_that_lists_every_subject_twice_gives_the_verdicts_of_the_cohort() {
    let (hearts, labels) = cohort();
    let once: Vec<_> = hearts.iter().map(input).collect();
    let alone = study(&labels);
    let mut doubled = alone.clone();
    for subject in &alone.subjects {
        let mut copy = Subject::clone(subject);
        copy.id += " again";
        doubled.subjects.push(Arc::new(copy));
    }
    let (single, twice) = (
        found(&alone, &once),
        found(&doubled, &[once.clone(), once.clone()].concat()),
    );
    assert_eq!(twice.classifier, single.classifier);
    assert_eq!(twice.quality, single.quality);
    let count = hearts.len();
    for index in 0..count {
        for copy in [index, index + count] {
            let (a, b) = (assessed(&single, index), assessed(&twice, copy));
            assert!((a.probability - b.probability).abs() < 1e-9, "{copy}");
            assert_eq!(a.similar_normal, b.similar_normal);
            let apart = |verdict: &Verdict| verdict.training_set_distance.unwrap().distance;
            assert!((apart(a) - apart(b)).abs() < 1e-9);
        }
    }
}

#[test]
fn copies_with_different_labels_train_nothing() {
    let (hearts, labels) = cohort();
    let inputs: Vec<_> = hearts.iter().map(input).collect();
    let mut torn = study(&labels);
    let mut copy = Subject::clone(&torn.subjects[0]);
    copy.label = Some("abnormal".to_owned());
    torn.subjects.push(Arc::new(copy));
    let inputs = [inputs.clone(), vec![inputs[0].clone()]].concat();
    assert_eq!(
        found(&torn, &inputs).classifier,
        ClassifierSource::Cohort {
            normal: 6,
            abnormal: 7
        }
    );
}

#[test]
fn a_wall_between_surfaces_that_are_apart_gets_no_verdict_and_trains_nothing() {
    let (hearts, labels) = cohort();
    let inputs: Vec<_> = hearts.iter().map(input).collect();
    let mut study = study(&labels);
    let sheet = |kind, radius: f64, shift: f64| {
        let bowl = phantom::bowl(radius, 6, 12);
        let points: Vec<Point3> = (bowl.vertices().iter())
            .map(|p| p + Vector3::new(shift, 0.0, 0.0))
            .collect();
        let mesh = TriMesh::new(points, bowl.faces().clone()).unwrap();
        SurfaceSequence::new(kind, vec![mesh]).unwrap()
    };
    let sequence = MeshSequence::new(vec![
        sheet(SurfaceKind::Endocardium, 25.0, 80.0),
        sheet(SurfaceKind::Epicardium, 35.0, 0.0),
    ])
    .unwrap();
    let mut apart = Subject::clone(&study.subjects[2]);
    apart.sequence = sequence;
    study.subjects[2] = Arc::new(apart);
    let verdicts = found(&study, &inputs);
    let reason = verdicts.subjects[2].as_ref().unwrap_err();
    assert!(
        reason.to_string().contains("do not lie in each other"),
        "{reason}"
    );
    assert_eq!(
        verdicts.classifier,
        ClassifierSource::Cohort {
            normal: 6,
            abnormal: 7
        }
    );
}
