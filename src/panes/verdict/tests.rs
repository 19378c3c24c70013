//! The verdict pane: its states, its text, its buttons.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::panes::verdict_marks::VerdictMark;
use crate::panes::{SelectCommand, WorkCommand, WorkState};

fn report() -> VerdictReport {
    let subject = |subject: usize, id: &str| SimilarSubject {
        subject,
        id: id.to_owned(),
        label: "NOR".to_owned(),
        verdict: "no regional abnormality".to_owned(),
    };
    VerdictReport {
        mark: VerdictMark::Patch,
        heading: "Abnormal patch · 31 % of the LV".to_owned(),
        sentence: "Thickening in part of the wall is far below that of remote myocardium"
            .to_owned(),
        probability: Some(0.973),
        labels: vec![("MINF".to_owned(), "97 %".to_owned())],
        reasons: "Strongest features: Akinetic region 31 %".to_owned(),
        source: "Leave-one-out: this subject was not in the training set",
        training_distance: Some(TrainingDistance {
            words: "1.2 × the median distance".to_owned(),
            outside: false,
        }),
        evidence: vec![EvidenceRow {
            name: "Akinetic region",
            what: "Share of the wall",
            value: "31 %".to_owned(),
            normal: "0–5 %".to_owned(),
            place: Some(0.8),
            band: Some([0.0, 0.1]),
            model_feature: true,
        }],
        similar: [vec![subject(4, "N05")], vec![subject(11, "P03")]],
    }
}

fn classifier() -> ClassifierReport {
    ClassifierReport {
        source: "Trained on 9 normal and 14 abnormal subjects".to_owned(),
        results: vec![ClassifierResult {
            name: "Accuracy (leave-one-out)",
            what: "Leave-one-out",
            value: "22 of 23".to_owned(),
            permutation_test: "permutation mean 11.6 · p 0.005".to_owned(),
        }],
    }
}

fn harness(
    state: WorkState,
    report: Option<VerdictReport>,
    subject: Option<&'static str>,
) -> Harness<'static, Vec<Command>> {
    let classifier = report.as_ref().map(|_| classifier());
    let mut harness = Harness::builder()
        .with_size([210.0, 700.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = VerdictPanelView {
                    subject,
                    state: state.clone(),
                    verdict: report.clone(),
                    classifier: classifier.clone(),
                };
                verdict_panel_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

#[test]
fn a_verdict_is_shown_with_its_probability_evidence_and_classifier() {
    let shown = harness(WorkState::Ready, Some(report()), Some("P07"));
    for words in [
        "Abnormal patch · 31 % of the LV",
        "Predicted probability of abnormal: 97 %",
        "Leave-one-out: this subject was not in the training set",
        "Akinetic region: 31 %, normal subjects 0–5 %",
        "Accuracy (leave-one-out): 22 of 23, permutation mean 11.6 · p 0.005",
        "Research use, not for diagnosis",
    ] {
        shown.get_by_label(words);
    }
    assert!(shown.query_by_label("Cancel classification").is_none());
}

#[test]
fn a_similar_subject_is_selected_by_a_click() {
    let mut shown = harness(WorkState::Ready, Some(report()), Some("P07"));
    shown.get_by_label("Select N05, a similar subject").click();
    shown.run();
    shown.get_by_label("Select P03, a similar subject").click();
    shown.run();
    let wanted = [4, 11].map(|subject| Command::Select(SelectCommand::SelectSubject(subject)));
    assert_eq!(shown.into_state(), wanted);
}

#[test]
fn work_under_way_shows_how_far_it_is_and_can_be_cancelled() {
    let state = WorkState::Computing {
        fraction: 0.42,
        phase: "assessing walls".to_owned(),
        seconds_left: Some(3.0),
    };
    for before in [None, Some(report())] {
        let again = before.is_some();
        let mut shown = harness(state.clone(), before, Some("P07"));
        shown.get_by_label("42 % · 3 s left");
        let of_before = shown.query_by_label("Results of the previous thresholds");
        assert_eq!(of_before.is_some(), again);
        shown.get_by_label("Cancel classification").click();
        shown.run();
        assert_eq!(
            shown.into_state(),
            [Command::Work(WorkCommand::Cancel(
                Topic::of::<VerdictQuery>()
            ))]
        );
    }
}

#[test]
fn what_was_stopped_or_failed_can_be_asked_for_again() {
    let failed = WorkState::Failed("ridge must be between 0.001 and 1000".to_owned());
    for (state, button) in [
        (WorkState::Stopped, "Classify the subjects"),
        (failed, "Retry"),
    ] {
        let mut shown = harness(state, None, Some("P07"));
        shown.get_by_label(button).click();
        shown.run();
        assert_eq!(
            shown.into_state(),
            [Command::Work(WorkCommand::Retry(
                Topic::of::<VerdictQuery>()
            ))]
        );
    }
}

#[test]
fn what_is_not_assessed_says_why_and_has_no_numbers() {
    let why = "the wall is not resolved";
    let not = VerdictReport {
        mark: VerdictMark::NotAssessed,
        heading: "Not assessed".to_owned(),
        sentence: why.to_owned(),
        ..VerdictReport::default()
    };
    let shown = harness(WorkState::Ready, Some(not), Some("P07"));
    shown.get_by_label("Not assessed");
    shown.get_by_label(why);
    assert!(shown.query_by_label_contains("probability").is_none());
    assert!(shown.query_by_label("Evidence").is_none());
}

#[test]
fn without_a_subject_the_pane_says_what_would_fill_it() {
    let shown = harness(WorkState::Empty, None, None);
    shown.get_by_label("No subject selected");
}
