//! Columns of verdicts: each feature under its own name, reasons for those not assessed.

use super::*;
use crate::analysis::measures::measure_subject;
use crate::analysis::medial::{MedialParams, medial_beat};
use crate::analysis::thickening::{ThickeningParams, thickening};
use crate::analysis::verdicts::{
    ClassifierSource, Feature, Features, Finding, LabelProbability, NotAssessed, Reason,
    TrainingSetDistance, VerdictInput, VerdictParams, examine, verdicts,
};
use crate::mesh::phantom;
use crate::progress::Progress;
use crate::report::table::Row;
use crate::report::{csv, testing};
use crate::study::built_in::{BuiltInParams, cohort};
use std::sync::Arc;

fn study() -> Study {
    let frames = vec![phantom::sphere(1, 30.0)];
    testing::study(&[("P, 1", "MINF"), ("N1", "NOR")], frames)
}

/// A heart's features, nearly all different: each stands in the column of its own name.
#[test]
fn features_stand_in_the_columns_that_scripts_rely_on() {
    let progress = Progress::default();
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole
        .subjects
        .iter()
        .find(|s| s.id.starts_with('P'))
        .unwrap();
    let medial = MedialParams::default().check().unwrap();
    let beat = medial_beat(ill, &medial, &progress).unwrap();
    let params = ThickeningParams::default().check().unwrap();
    let found = thickening(&beat, &measure_subject(ill), None, &params, &progress).unwrap();
    let heart = VerdictInput {
        beat: &beat,
        thickening: &found,
    };
    let params = VerdictParams::default().check().unwrap();
    let examined = examine(&heart, &params).unwrap();
    let alone = Study {
        subjects: vec![Arc::clone(ill)],
        ..whole
    };
    let features = examined.features.clone();
    let classified = verdicts(&alone, &[Ok(examined)], &params, None, &progress).unwrap();
    let table = csv(&VerdictRow::of_study(&alone, &classified));
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let columns = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let names = [
        (Feature::AkineticShare, "still_share"),
        (Feature::Median, "median_ln_pt"),
        (Feature::Spread, "spread_ln_pt"),
        (Feature::RelativeSpread, "relative_spread"),
        (Feature::TenthPercentile, "weakest_tenth_ln_pt"),
        (Feature::Remote, "well_ln_pt"),
        (Feature::UpperRange, "reach_ln_pt"),
        (Feature::PatchShare, "patch_share"),
        (Feature::Confidence, "patch_confidence"),
        (Feature::PatchThickening, "patch_relative_thickening"),
        (Feature::Compactness, "patch_compactness"),
        (Feature::MeanPoseDistance, "pose_distance"),
        (Feature::NormalSpread, "normal_spread_rad"),
        (Feature::MeanPositionDistance, "gap_sizes"),
    ];
    let listed = <VerdictRow as Row>::COLUMNS.iter().map(|column| column.key);
    assert_eq!(
        columns.iter().collect::<Vec<_>>(),
        listed.collect::<Vec<_>>()
    );
    // Features of the wall stand together, in the order of before; those of the whole heart were added behind them.
    let first = columns.iter().position(|name| name == names[0].1).unwrap();
    assert_eq!(&columns[first + names.len()], "outside_range");
    for (place, (feature, name)) in (first..).zip(names) {
        assert_eq!(&columns[place], name);
        let value = features.get(feature).unwrap();
        assert_eq!(row[place].parse::<f64>().unwrap(), value, "{name}");
    }
    let place = columns
        .iter()
        .position(|name| name == "ejection_fraction")
        .unwrap();
    let measured = measure_subject(ill);
    assert_eq!(
        row[place].parse::<f64>().unwrap(),
        measured.ef.unwrap(),
        "as in subjects.csv"
    );
    // Confidence and compactness of a round patch are both 1; all others differ.
    let distinct: std::collections::HashSet<&str> =
        row.iter().skip(first).take(names.len()).collect();
    assert!(distinct.len() + 1 >= names.len(), "{row:?}");
}

#[test]
fn verdicts_stand_a_row_per_subject_with_reasons_for_those_not_assessed() {
    let verdict = Verdict {
        finding: Finding::AbnormalPatch,
        abnormal: true,
        probability: 0.1 + 0.2,
        features: Features::default(),
        patched: 0.31,
        similar_normal: vec![1],
        similar_abnormal: vec![0, 1],
        training_set_distance: Some(TrainingSetDistance {
            distance: 0.5,
            median: 0.25,
            as_far: 0.1,
        }),
        wall: true,
        labels: vec![LabelProbability {
            label: "MINF".to_owned(),
            probability: 0.75,
        }],
        reasons: vec![Reason {
            feature: Feature::AkineticShare,
            log_odds: 1.5,
        }],
        outside: Vec::new(),
    };
    let reason = NotAssessed::WallNotResolved { share: 0.61 };
    let verdicts = Verdicts {
        subjects: vec![Ok(verdict), Err(reason.clone())],
        classifier: ClassifierSource::Cohort {
            normal: 9,
            abnormal: 9,
        },
        features: Vec::new(),
        quality: None,
    };
    let table = csv(&VerdictRow::of_study(&study(), &verdicts));
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let columns: Vec<String> = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    assert_eq!(
        columns[..6],
        [
            "subject",
            "label",
            "verdict",
            "probability",
            "assessed",
            "reason"
        ]
    );
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let cell = |row: usize, name: &str| {
        let place = columns.iter().position(|column| column == name).unwrap();
        rows[row][place].to_owned()
    };
    assert_eq!(
        rows[0].iter().take(6).collect::<Vec<_>>().join("|"),
        "P, 1|MINF|abnormal|0.30000000000000004|yes|"
    );
    assert_eq!(cell(0, "finding"), Finding::AbnormalPatch.name());
    assert_eq!(
        ["kind", "kind_probability", "kind_probabilities", "reasons"].map(|name| cell(0, name)),
        ["MINF", "0.75", "MINF 0.750", "Akinetic region +1.50"]
    );
    assert_eq!(cell(1, "finding"), "not assessed");
    assert_eq!(
        (cell(0, "alike_abnormal"), cell(0, "distance_from_seen")),
        ("P, 1 N1".to_owned(), "0.5".to_owned())
    );
    let further = ["calibrated", "alike_normal", "usual_distance"];
    assert_eq!(further.map(|name| cell(0, name)), ["yes", "N1", "0.25"]);
    assert_eq!(
        (cell(1, "verdict"), cell(1, "assessed")),
        (String::new(), "no".to_owned())
    );
    assert_eq!(cell(1, "reason"), reason.to_string());
    assert_eq!(cell(1, "still_share"), "");
}
