//! A cohort is classified as a whole, from known walls where it can be.

use std::sync::Arc;

use super::*;
use crate::analysis::verdicts::Finding;
use crate::engine::queries::tests::{ask, edited, store};
use crate::study::Study;
use crate::study::built_in::{BuiltInParams, cohort};

fn settings() -> VerdictQuery {
    let mut settings = VerdictQuery::default();
    settings.thickening.patches.redraws = 3;
    settings.verdicts.permutations = 19;
    settings
}

#[test]
fn a_cohort_is_classified_once_and_kept() {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let study = Arc::new(cohort(&params).unwrap().study);
    let store = store();
    let found = ask(&store, &study, &settings());
    assert_eq!(found.subjects.len(), study.subjects.len());
    let patches = (found.subjects.iter().flatten())
        .filter(|verdict| verdict.finding == Finding::AbnormalPatch)
        .count();
    assert!(patches >= 5, "{patches}");
    assert!(Arc::ptr_eq(&found, &ask(&store, &study, &settings())));
    // Labels make the classifier: an edit of one asks for new verdicts, and for no wall.
    let walls = store.answers::<WallThickeningQuery>();
    let relabelled = edited(&study, 0, |subject| {
        subject.label = Some("abnormal".to_owned());
    });
    assert_ne!(*ask(&store, &relabelled, &settings()), *found);
    assert_eq!(store.answers::<WallThickeningQuery>(), walls);
}

#[test]
fn a_study_without_walls_is_not_assessed_and_says_why() {
    let study = Study {
        subjects: cohort(&BuiltInParams {
            vertices: 400,
            ..BuiltInParams::default()
        })
        .unwrap()
        .study
        .subjects
        .iter()
        .take(2)
        .map(|subject| {
            let endo = subject.sequence.surfaces()[0].frames().to_vec();
            let cavity =
                crate::study::SurfaceSequence::new(crate::study::SurfaceKind::Cavity, endo);
            let sequence = crate::study::MeshSequence::new(vec![cavity.unwrap()]).unwrap();
            Arc::new(crate::study::Subject::new(
                subject.id.clone(),
                sequence,
                subject.unit,
            ))
        })
        .collect(),
        ..Study::default()
    };
    let found = ask(&store(), &Arc::new(study), &settings());
    assert!(found.subjects.iter().all(Result::is_err));
    assert!(found.quality.is_none());
}
