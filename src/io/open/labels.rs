//! Labels that differ only in letter case or blanks are one label.

use std::collections::{BTreeMap, BTreeSet};

use super::plan::SubjectPlan;
use crate::study::checks::counted;
use crate::study::{LabelClasses, Notice, plain_label};

/// Labels and ids that one notice names.
const MAX_NAMED: usize = 3;

/// Gives labels that differ only in letter case or blanks one spelling: that of the manifest's lists, else the first.
/// Tells which, and which lists fit no subject.
pub(super) fn unite_labels(
    plans: &mut [SubjectPlan],
    classes: Option<&LabelClasses>,
) -> Vec<Notice> {
    let mut notices = Vec::new();
    let mut spelling: BTreeMap<String, String> = BTreeMap::new();
    let lists =
        classes.map(|classes| [("normal", &classes.normal), ("abnormal", &classes.abnormal)]);
    for (_, labels) in lists.iter().flatten() {
        for label in *labels {
            spelling
                .entry(plain_label(label))
                .or_insert_with(|| label.clone());
        }
    }
    let listed: BTreeSet<String> = spelling.keys().cloned().collect();
    let mut changed: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    let mut borne: BTreeSet<String> = BTreeSet::new();
    for plan in plans.iter_mut() {
        let Some(label) = &mut plan.stated.label else {
            continue;
        };
        let plain = plain_label(label);
        // Nobody types control characters into a label: another program wrote it so, and means it.
        if plain.is_empty() || label.contains(char::is_control) {
            continue;
        }
        let meant = spelling
            .entry(plain.clone())
            .or_insert_with(|| label.clone());
        borne.insert(plain);
        if meant != label {
            let pair = (label.clone(), meant.clone());
            changed.entry(pair).or_default().push(plan.id.clone());
            label.clone_from(meant);
        }
    }
    for ((label, meant), ids) in changed {
        notices.push(Notice::warning(format!(
            "label {label:?} of {} is read as {meant:?}, from which it differs only in letter case or blanks",
            few(&ids)
        )));
    }
    let Some(classes) = classes else {
        return notices;
    };
    for (name, labels) in lists.iter().flatten() {
        for label in labels
            .iter()
            .filter(|label| !borne.contains(&plain_label(label)))
        {
            if !borne.is_empty() {
                notices.push(Notice::warning(format!(
                    "no subject has the label {label:?}, which study.toml lists as {name}"
                )));
            }
        }
    }
    let both = classes.normal.iter().filter(|label| {
        let plain = plain_label(label);
        classes
            .abnormal
            .iter()
            .any(|other| plain_label(other) == plain)
    });
    notices.extend(both.map(|label| {
        Notice::warning(format!(
            "study.toml lists the label {label:?} as normal and as abnormal: it counts as normal"
        ))
    }));
    let without: Vec<&str> = borne
        .iter()
        .filter(|label| !listed.contains(*label))
        .map(String::as_str)
        .collect();
    if !without.is_empty() {
        let names: Vec<String> = without
            .iter()
            .filter_map(|plain| spelling.get(*plain).cloned())
            .collect();
        notices.push(Notice::info(format!(
            "{} in no list of study.toml, of no class: {}",
            counted(names.len(), "label is", "labels are"),
            few(&names)
        )));
    }
    notices
}

/// The first of some names.
fn few(names: &[String]) -> String {
    let more = names.len().saturating_sub(MAX_NAMED);
    let shown = names[..names.len() - more].join(", ");
    if more == 0 {
        shown
    } else {
        format!("{shown} and {more} more")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::open::plan::Stated;

    fn united(labels: &[&str], normal: &[&str], abnormal: &[&str]) -> (Vec<String>, Vec<String>) {
        let mut plans: Vec<SubjectPlan> = (labels.iter().enumerate())
            .map(|(place, label)| SubjectPlan {
                id: format!("p{place}"),
                place: std::path::PathBuf::new(),
                surfaces: Vec::new(),
                stated: Stated {
                    label: Some((*label).to_owned()),
                    ..Stated::default()
                },
                notices: Vec::new(),
            })
            .collect();
        let owned = |labels: &[&str]| labels.iter().map(|label| (*label).to_owned()).collect();
        let classes = LabelClasses {
            normal: owned(normal),
            abnormal: owned(abnormal),
        };
        let given = (!normal.is_empty()).then_some(&classes);
        let notices = unite_labels(&mut plans, given);
        let labels = plans
            .into_iter()
            .filter_map(|plan| plan.stated.label)
            .collect();
        (
            labels,
            notices.into_iter().map(|notice| notice.text).collect(),
        )
    }

    #[test]
    fn labels_are_spelt_as_the_lists_spell_them() {
        let (labels, texts) = united(&["Normal", " ILL", "ill"], &["normal"], &["ill"]);
        assert_eq!(labels, ["normal", "ill", "ill"]);
        assert_eq!(texts.len(), 2);
        assert!(
            texts
                .iter()
                .any(|text| text.starts_with("label \"Normal\" of p0 is read as \"normal\""))
        );
    }

    #[test]
    fn labels_of_no_list_are_spelt_as_the_first() {
        let (labels, texts) = united(&["MINF", "Minf", "minf "], &[], &[]);
        assert_eq!((labels, texts.len()), (vec!["MINF".to_owned(); 3], 2));
        assert_eq!(united(&["MINF", "DCM"], &[], &[]).1.len(), 0);
    }

    #[test]
    fn lists_that_fit_nobody_are_told() {
        let (_, texts) = united(&["NOR", "RV"], &["NOR"], &["MINF"]);
        assert!(
            texts[0].contains("no subject has the label \"MINF\""),
            "{texts:?}"
        );
        assert!(texts[1].contains("RV"), "{texts:?}");
        let (_, texts) = united(&["NOR"], &["NOR"], &["nor"]);
        assert!(
            texts
                .iter()
                .any(|text| text.contains("as normal and as abnormal")),
            "{texts:?}"
        );
    }
}
