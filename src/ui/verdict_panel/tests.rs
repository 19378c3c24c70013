//! The pane of verdicts: its states, what it says, what its buttons do.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;

fn told() -> ToldVerdict {
    let heart = |subject: usize, id: &str, role| AlikeHeart {
        subject,
        id: id.to_owned(),
        label: "NOR".to_owned(),
        role,
        verdict: "none".to_owned(),
    };
    ToldVerdict {
        mark: VerdictMark::Patch,
        heading: "Abnormal patch · 31 % of the LV".to_owned(),
        sentence: "A part of the wall does not thicken as the rest does".to_owned(),
        probability: Some(0.973),
        calibrated: true,
        source: "By a rule that has not seen this heart",
        familiar: Some(Familiar {
            words: "1.2 × the usual distance".to_owned(),
            unlike: false,
        }),
        evidence: vec![EvidenceRow {
            name: "Wall that stands still",
            what: "Share of the wall",
            value: "31 %".to_owned(),
            normal: "0–5 %".to_owned(),
            place: Some(0.8),
            band: Some([0.0, 0.1]),
            read: true,
        }],
        alike: [
            vec![heart(4, "N05", LabelRole::Normal)],
            vec![heart(11, "P03", LabelRole::Abnormal)],
        ],
    }
}

fn rule() -> RuleTold {
    RuleTold {
        source: "Learnt from 9 normal and 14 abnormal hearts".to_owned(),
        results: vec![Chance {
            name: "Right answers",
            what: "Leave-one-out",
            value: "22 of 23".to_owned(),
            chance: "by chance 11.6 · p 0.005".to_owned(),
        }],
    }
}

fn harness(
    state: VerdictState,
    told: Option<ToldVerdict>,
    subject: Option<&'static str>,
) -> Harness<'static, Vec<Command>> {
    let rule = told.as_ref().map(|_| rule());
    let mut harness = Harness::builder()
        .with_size([210.0, 700.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = VerdictPanelView {
                    subject,
                    state: &state,
                    told: told.as_ref(),
                    rule: rule.as_ref(),
                };
                verdict_panel_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

#[test]
fn a_verdict_stands_with_its_probability_evidence_and_rule() {
    let shown = harness(VerdictState::Ready, Some(told()), Some("P07"));
    for words in [
        "Abnormal patch · 31 % of the LV",
        "Probability, abnormal: 97 %",
        "By a rule that has not seen this heart",
        "Wall that stands still: 31 %, normal hearts 0–5 %",
        "Right answers: 22 of 23, by chance 11.6 · p 0.005",
        "Research use, no diagnosis",
    ] {
        shown.get_by_label(words);
    }
    assert!(shown.query_by_label("Cancel judging").is_none());
}

#[test]
fn a_heart_alike_is_selected_by_a_click() {
    let mut shown = harness(VerdictState::Ready, Some(told()), Some("P07"));
    shown.get_by_label("Select N05, most alike").click();
    shown.run();
    shown.get_by_label("Select P03, most alike").click();
    shown.run();
    let wanted = [4, 11].map(Command::SelectSubject);
    assert_eq!(shown.into_state(), wanted);
}

#[test]
fn work_under_way_shows_how_far_it_is_and_can_be_cancelled() {
    let state = VerdictState::Computing {
        fraction: 0.42,
        phase: "assessing walls",
        seconds_left: Some(3.0),
    };
    for before in [None, Some(told())] {
        let again = before.is_some();
        let mut shown = harness(state.clone(), before, Some("P07"));
        shown.get_by_label("42 % · 3 s left");
        let of_before = shown.query_by_label("This is of the thresholds before");
        assert_eq!(of_before.is_some(), again);
        shown.get_by_label("Cancel judging").click();
        shown.run();
        assert_eq!(
            shown.into_state(),
            [Command::Cancel(Topic::of::<VerdictSettings>())]
        );
    }
}

#[test]
fn what_was_stopped_or_failed_can_be_asked_for_again() {
    let failed = VerdictState::Failed("ridge must be between 0.001 and 1000".to_owned());
    for (state, button) in [
        (VerdictState::Stopped, "Judge the hearts"),
        (failed, "Judge again"),
    ] {
        let mut shown = harness(state, None, Some("P07"));
        shown.get_by_label(button).click();
        shown.run();
        assert_eq!(
            shown.into_state(),
            [Command::Retry(Topic::of::<VerdictSettings>())]
        );
    }
}

#[test]
fn an_order_is_not_called_a_probability() {
    let fixed = ToldVerdict {
        calibrated: false,
        ..told()
    };
    let shown = harness(VerdictState::Ready, Some(fixed), Some("P07"));
    shown.get_by_label("Score, no probability: 0.97");
    assert!(shown.query_by_label_contains("Probability").is_none());
}

#[test]
fn what_is_not_assessed_says_why_and_has_no_numbers() {
    let why = "the wall is not resolved";
    let not = ToldVerdict {
        mark: VerdictMark::NotAssessed,
        heading: "Not assessed".to_owned(),
        sentence: why.to_owned(),
        ..ToldVerdict::default()
    };
    let shown = harness(VerdictState::Ready, Some(not), Some("P07"));
    shown.get_by_label("Not assessed");
    shown.get_by_label(why);
    assert!(shown.query_by_label_contains("Probability").is_none());
    assert!(shown.query_by_label("Evidence").is_none());
}

#[test]
fn without_a_heart_the_pane_says_what_would_fill_it() {
    let shown = harness(VerdictState::Empty, None, None);
    shown.get_by_label("No heart selected");
}
