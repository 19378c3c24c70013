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
    let united = united(plans, classes);
    let mut notices: Vec<Notice> = (united.changed.iter())
        .map(|((label, meant), ids)| {
            Notice::warning(format!(
                "label {label:?} of {} is read as {meant:?}, from which it differs only in letter case or blanks",
                few(ids)
            ))
        })
        .collect();
    if let Some(classes) = classes {
        notices.extend(unborne(&united, classes));
        notices.extend(in_both_lists(classes));
        notices.extend(in_no_list(&united, classes));
    }
    notices
}

/// Labels of one spelling each. A label is known by its plain form, without letter case and blanks.
struct United {
    /// How each is spelt.
    spelling: BTreeMap<String, String>,
    /// Those that subjects have.
    borne: BTreeSet<String>,
    /// Subjects whose label was spelt anew, by what it was and what it is.
    changed: BTreeMap<(String, String), Vec<String>>,
}

fn lists(classes: &LabelClasses) -> [(&'static str, &[String]); 2] {
    [("normal", &classes.normal), ("abnormal", &classes.abnormal)]
}

fn united(plans: &mut [SubjectPlan], classes: Option<&LabelClasses>) -> United {
    let mut spelling: BTreeMap<String, String> = BTreeMap::new();
    for label in (classes.into_iter().flat_map(lists)).flat_map(|(_, labels)| labels) {
        spelling
            .entry(plain_label(label))
            .or_insert_with(|| label.clone());
    }
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
    United {
        spelling,
        borne,
        changed,
    }
}

/// Labels of the lists that no subject has, where subjects have any.
fn unborne(united: &United, classes: &LabelClasses) -> Vec<Notice> {
    if united.borne.is_empty() {
        return Vec::new();
    }
    let all = (lists(classes).into_iter())
        .flat_map(|(name, labels)| labels.iter().map(move |label| (name, label)));
    all.filter(|(_, label)| !united.borne.contains(&plain_label(label)))
        .map(|(name, label)| {
            Notice::warning(format!(
                "no subject has the label {label:?}, which study.toml lists as {name}"
            ))
        })
        .collect()
}

fn in_both_lists(classes: &LabelClasses) -> Vec<Notice> {
    let both = classes.normal.iter().filter(|label| {
        let plain = plain_label(label);
        classes
            .abnormal
            .iter()
            .any(|other| plain_label(other) == plain)
    });
    both.map(|label| {
        Notice::warning(format!(
            "study.toml lists the label {label:?} as normal and as abnormal: it counts as normal"
        ))
    })
    .collect()
}

fn in_no_list(united: &United, classes: &LabelClasses) -> Option<Notice> {
    let listed: BTreeSet<String> = (lists(classes).iter())
        .flat_map(|(_, labels)| labels.iter().map(|label| plain_label(label)))
        .collect();
    let names: Vec<String> = (united.borne.iter())
        .filter(|label| !listed.contains(*label))
        .filter_map(|plain| united.spelling.get(plain).cloned())
        .collect();
    (!names.is_empty()).then(|| {
        Notice::info(format!(
            "{} in no list of study.toml, of no class: {}",
            counted(names.len(), "label is", "labels are"),
            few(&names)
        ))
    })
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
