//! Verdicts as a table for scripts: names and order of columns are fixed, further ones stand at the end.

use crate::analysis::verdicts::{Feature, RuleSource, Verdict, Verdicts};
use crate::study::Study;

use super::report_csv::Table;

/// Verdicts, a row per subject. `verdict` is `normal` or `abnormal`; it is empty where `assessed` is `no`, and
/// `reason` says why. `calibrated` is `yes` where `probability` is one, by a rule learnt from the labelled hearts
/// without this one. `alike_normal` and `alike_abnormal` name the most alike hearts, nearest first;
/// `distance_from_seen` is the distance to the nearest heart that the rule has seen, and `usual_distance` the
/// median of the same among those. Features follow.
pub fn verdicts_csv(study: &Study, verdicts: &Verdicts) -> String {
    let mut header = vec![
        "subject",
        "label",
        "verdict",
        "probability",
        "assessed",
        "reason",
        "finding",
        "calibrated",
        "alike_normal",
        "alike_abnormal",
        "distance_from_seen",
        "usual_distance",
    ];
    header.extend(Feature::ALL.map(Feature::column));
    let mut table = Table::new(&header);
    for (subject, found) in study.subjects.iter().zip(&verdicts.subjects) {
        let mut row = vec![
            subject.id.clone(),
            subject.label.clone().unwrap_or_default(),
        ];
        match found {
            Ok(verdict) => row.extend(told(study, verdict, verdicts.rule)),
            Err(reason) => {
                row.extend([
                    String::new(),
                    String::new(),
                    "no".to_owned(),
                    reason.to_string(),
                ]);
                row.resize(header.len(), String::new());
            }
        }
        table.row(row);
    }
    table.text
}

fn told(study: &Study, verdict: &Verdict, rule: RuleSource) -> Vec<String> {
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let names = |others: &[usize]| {
        let ids = others.iter().filter_map(|&other| study.subjects.get(other));
        ids.map(|subject| subject.id.as_str())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let calibrated = matches!(rule, RuleSource::Cohort { .. });
    let mut cells = vec![
        if verdict.abnormal {
            "abnormal"
        } else {
            "normal"
        }
        .to_owned(),
        verdict.probability.to_string(),
        "yes".to_owned(),
        String::new(),
        verdict.finding.key().to_owned(),
        if calibrated { "yes" } else { "no" }.to_owned(),
        names(&verdict.alike_normal),
        names(&verdict.alike_abnormal),
        number(verdict.familiarity.map(|near| near.distance)),
        number(verdict.familiarity.map(|near| near.usual)),
    ];
    cells.extend(Feature::ALL.map(|feature| number(verdict.features.get(feature))));
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_subject;
    use crate::analysis::medial::{MedialParams, medial_beat};
    use crate::analysis::thickening::{ThickeningParams, thickening};
    use crate::analysis::verdicts::{
        Familiarity, Features, Finding, NotAssessed, VerdictInput, VerdictParams, examine, verdicts,
    };
    use crate::mesh::phantom;
    use crate::progress::Progress;
    use crate::study::built_in::{BuiltInParams, cohort};
    use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;
    use std::sync::Arc;

    fn study() -> Study {
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![phantom::sphere(1, 30.0)]);
        let sequence = MeshSequence::new(vec![surface.unwrap()]).unwrap();
        let subject = |(id, label): (&str, &str)| {
            let mut subject = Subject::new(id, sequence.clone(), LengthUnit::Millimetre);
            subject.label = Some(label.to_owned());
            Arc::new(subject)
        };
        Study {
            subjects: [("P, 1", "MINF"), ("N1", "NOR")].map(subject).to_vec(),
            ..Study::default()
        }
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
        let judged = verdicts(&alone, &[Ok(examined)], &params, &progress).unwrap();
        let table = verdicts_csv(&alone, &judged);
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let columns = reader.headers().unwrap().clone();
        let row = reader.records().next().unwrap().unwrap();
        let names = [
            (Feature::StillShare, "still_share"),
            (Feature::Median, "median_ln_pt"),
            (Feature::Spread, "spread_ln_pt"),
            (Feature::RelativeSpread, "relative_spread"),
            (Feature::WeakestTenth, "weakest_tenth_ln_pt"),
            (Feature::Well, "well_ln_pt"),
            (Feature::Reach, "reach_ln_pt"),
            (Feature::PatchShare, "patch_share"),
            (Feature::Confidence, "patch_confidence"),
            (Feature::PatchThickening, "patch_relative_thickening"),
            (Feature::Compactness, "patch_compactness"),
            (Feature::Closeness, "pose_distance"),
            (Feature::NormalSpread, "normal_spread_rad"),
            (Feature::Gap, "gap_sizes"),
        ];
        assert_eq!(columns.len(), 12 + names.len());
        for (place, (feature, name)) in (12_usize..).zip(names) {
            assert_eq!(&columns[place], name);
            let told = features.get(feature).unwrap();
            assert_eq!(row[place].parse::<f64>().unwrap(), told, "{name}");
        }
        // Confidence and compactness of a round patch are both 1; all others differ.
        let told: std::collections::HashSet<&str> = row.iter().skip(12).collect();
        assert!(told.len() + 1 >= names.len(), "{row:?}");
    }

    #[test]
    fn verdicts_stand_a_row_per_subject_with_reasons_for_those_not_assessed() {
        let verdict = Verdict {
            finding: Finding::Patch,
            abnormal: true,
            probability: 0.1 + 0.2,
            features: Features::default(),
            patched: 0.31,
            alike_normal: vec![1],
            alike_abnormal: vec![0, 1],
            familiarity: Some(Familiarity {
                distance: 0.5,
                usual: 0.25,
                as_far: 0.1,
            }),
        };
        let reason = NotAssessed::WallNotResolved { share: 0.61 };
        let verdicts = Verdicts {
            subjects: vec![Ok(verdict), Err(reason.clone())],
            rule: RuleSource::Cohort {
                normal: 9,
                abnormal: 9,
            },
            quality: None,
        };
        let table = verdicts_csv(&study(), &verdicts);
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
        assert_eq!(cell(0, "finding"), "abnormal patch");
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
}
