//! A cohort is judged as a whole, from the cache where it can be.

use super::*;
use crate::analysis::verdicts::Finding;
use crate::study::Revision;
use crate::study::built_in::{BuiltInParams, cohort};

fn settings() -> VerdictSettings {
    let mut settings = VerdictSettings::default();
    settings.thickening.thickening.redraws = 3;
    settings.verdicts.permutations = 19;
    settings
}

#[test]
fn a_cohort_is_judged_once_and_read_from_the_cache_afterwards() {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let study = cohort(&params).unwrap().study;
    let cache = Cache::default();
    let request = AnalysisRequest::Verdicts(settings());
    let first = run(&study, &request, &cache, &Progress::default()).unwrap();
    let found = first.verdicts().unwrap();
    assert_eq!(found.subjects.len(), study.subjects.len());
    let patches = (found.subjects.iter().flatten())
        .filter(|verdict| verdict.finding == Finding::Patch)
        .count();
    assert!(patches >= 5, "{patches}");
    let stopped = Progress::default();
    stopped.stop();
    let again = run(&study, &request, &cache, &stopped).unwrap();
    assert_eq!(again.verdicts(), Some(found));
    // Labels make the rule: an edit of one asks for new verdicts.
    let mut edited = (*study.subjects[0]).clone();
    edited.label = Some("abnormal".to_owned());
    let edited = study.with_subject(0, edited, Revision(study.revision.0 + 1));
    let other = run(&edited, &request, &cache, &Progress::default()).unwrap();
    assert_ne!(other.verdicts(), Some(found));
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
            std::sync::Arc::new(crate::study::Subject::new(
                subject.id.clone(),
                sequence,
                subject.unit,
            ))
        })
        .collect(),
        ..Study::default()
    };
    let request = AnalysisRequest::Verdicts(settings());
    let outcome = run(&study, &request, &Cache::default(), &Progress::default()).unwrap();
    let found = outcome.verdicts().unwrap();
    assert!(found.subjects.iter().all(Result::is_err));
    assert!(found.quality.is_none());
}
