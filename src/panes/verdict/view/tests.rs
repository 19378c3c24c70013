//! The words of a verdict, by finding and by classifier.

use super::*;
use crate::analysis::classification::Accuracy;
use crate::analysis::verdicts::{Features, LabelProbability, LabelQuality, NotAssessed};
use crate::document::testing::{state_of, subject_with_frames};
use std::sync::Arc;

fn verdict(finding: Finding, probability: f64) -> Verdict {
    Verdict {
        finding,
        abnormal: finding != Finding::Nothing,
        probability,
        features: Features::default(),
        patched: 0.312,
        similar_normal: vec![1],
        similar_abnormal: vec![0],
        training_set_distance: Some(TrainingSetDistance {
            distance: 0.6,
            median: 0.5,
            as_far: 0.4,
        }),
        wall: true,
        labels: vec![label("MINF", 0.93), label("NOR", 0.07)],
        reasons: Vec::new(),
        outside: Vec::new(),
    }
}

fn label(label: &str, probability: f64) -> LabelProbability {
    LabelProbability {
        label: label.to_owned(),
        probability,
    }
}

fn classified(classifier: ClassifierSource) -> State {
    let ids = ["a", "b", "c"];
    let mut state = state_of(ids.map(|id| subject_with_frames(id, 3)).to_vec());
    let reason = NotAssessed::WallNotResolved { share: 0.61 };
    let verdicts = Verdicts {
        subjects: vec![
            Ok(verdict(Finding::AbnormalPatch, 0.97)),
            Ok(verdict(Finding::Nothing, 0.04)),
            Err(reason),
        ],
        classifier,
        features: Feature::MODEL_FEATURES.to_vec(),
        quality: None,
    };
    state.answers.verdicts = Some(Showing::Ready(Arc::new(verdicts)));
    state
}

const TRAINED: ClassifierSource = ClassifierSource::Cohort {
    normal: 9,
    abnormal: 14,
};

#[test]
fn only_the_finding_of_a_patch_is_called_one() {
    let mut state = classified(TRAINED);
    let shown = report(&state).unwrap();
    assert_eq!(shown.heading, "Abnormal patch · 31 % of the LV");
    assert_eq!(shown.mark, VerdictMark::Patch);
    let labels = [("MINF", "93 %"), ("NOR", "7 %")].map(|(a, b)| (a.to_owned(), b.to_owned()));
    assert_eq!(shown.labels, labels);
    assert_eq!(shown.similar[0][0].id, "b");
    assert_eq!(shown.similar[0][0].verdict, "no finding");
    state.document.subject = 1;
    let shown = report(&state).unwrap();
    assert_eq!(shown.heading, "No regional abnormality");
    assert!(shown.sentence.ends_with("low thickening in 31 % of the LV"));
    assert_eq!(cohort_verdict(&state, 1).unwrap().text(), "no finding");
    assert_eq!(cohort_verdict(&state, 0).unwrap().text(), "patch 31 %");
}

#[test]
fn what_is_not_assessed_says_why_in_pane_and_table() {
    let mut state = classified(TRAINED);
    state.document.subject = 2;
    let shown = report(&state).unwrap();
    assert_eq!(shown.heading, "Not assessed");
    assert!(shown.sentence.starts_with("The wall is not resolved"));
    assert_eq!(shown.probability, None);
    let row = cohort_verdict(&state, 2).unwrap();
    assert_eq!(row.text(), "not assessed");
    assert!(row.words.contains("61 %"), "{}", row.words);
}

#[test]
fn the_built_in_classifier_says_what_it_was_trained_on_and_why_it_is_taken() {
    let state = classified(ClassifierSource::OtherStudy(AppliedClassifier {
        name: "built-in".to_owned(),
        study: "Walls".to_owned(),
        normal: 20,
        abnormal: 40,
        auc: Some(0.994),
        labelled: Some([2, 0]),
    }));
    let shown = report(&state).unwrap();
    assert!(shown.source.starts_with("Built-in classifier"));
    let (verdicts, _) = state.verdicts().unwrap();
    let report = classifier_report(verdicts);
    assert_eq!(
        report.source,
        "Classifier “built-in”, trained on 60 subjects of Walls (20 normal, 40 abnormal), AUC 0.99 there; too few \
         labelled subjects here (2 normal, 0 abnormal) to train one"
    );
    assert!(report.results.is_empty());
}

#[test]
fn a_subject_far_from_the_training_subjects_is_to_be_read_with_caution() {
    let at = |distance: f64, as_far: f64| {
        let found = TrainingSetDistance {
            distance,
            median: 0.5,
            as_far,
        };
        training_distance(&found, &[])
    };
    let near = at(0.6, 0.4);
    assert!(
        !near.outside && near.words.contains("1.2 ×") && near.words.contains("60th percentile")
    );
    let far = at(12.0, 0.0);
    assert!(far.outside && far.words.contains("24 ×") && far.words.contains("100th percentile"));
}

#[test]
fn a_classifier_from_a_file_says_so_and_what_it_has_not_seen() {
    let mut state = classified(ClassifierSource::OtherStudy(AppliedClassifier::default()));
    let seen = state.verdicts().unwrap().0;
    let mut verdicts = (**seen).clone();
    if let Ok(verdict) = &mut verdicts.subjects[0] {
        verdict.outside = vec![Feature::EjectionFraction];
    }
    verdicts.subjects[2] = Err(NotAssessed::NotComparable(
        "meshes of 9 vertices".to_owned(),
    ));
    state.answers.verdicts = Some(Showing::Ready(Arc::new(verdicts)));
    let shown = report(&state).unwrap();
    assert!(shown.source.ends_with("from a file"));
    let distance = shown.training_distance.unwrap();
    assert!(distance.outside && distance.words.ends_with("range: Ejection fraction"));
    state.document.subject = 2;
    let shown = report(&state).unwrap();
    assert_eq!(shown.heading, "Not comparable");
    assert_eq!(shown.sentence, "Meshes of 9 vertices");
}

#[test]
fn accuracy_and_auc_have_permutation_means() {
    let quality = ClassifierQuality {
        accuracy: Accuracy {
            correct: 22,
            of: 23,
            baseline: 0.5,
            p_value: 0.004_975,
        },
        false_positives: 0,
        false_negatives: 1,
        auc: 0.984,
        auc_baseline: 0.46,
        auc_p_value: 0.004_975,
        labels: Some(LabelQuality {
            correct: 18,
            of: 20,
            largest_label: 8,
        }),
    };
    let rows = results(&quality, 9, 14);
    assert_eq!(rows[0].value, "22 of 23 · 96 %");
    assert_eq!(rows[0].permutation_test, "permutation mean 11.5 · p 0.005");
    assert_eq!(rows[1].value, "0.98");
    assert_eq!(rows[1].permutation_test, "permutation mean 0.46 · p 0.005");
    assert_eq!(rows[2].value, "0 of 9 normal");
    assert_eq!(rows[3].value, "1 of 14 abnormal");
    assert_eq!(rows[4].value, "18 of 20");
}
