//! Ids of subjects: one name each, and none that is another's in other letters.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::Path;

use super::folder_contents::folder_name;
use super::folders::composed;
use super::plan::SubjectPlan;
use super::read_file::name_of;
use crate::study::Notice;

/// Gives subjects ids of their own: see [`unique_ids`].
pub(super) fn make_ids_unique(plans: &mut [SubjectPlan]) {
    let named: Vec<(&str, &Path)> = (plans.iter())
        .map(|plan| (plan.id.as_str(), plan.place.as_path()))
        .collect();
    let unique = unique_ids(&named);
    for (plan, (id, notices)) in plans.iter_mut().zip(unique) {
        plan.id = id;
        plan.notices.extend(notices);
    }
}

/// An id of its own for each subject, from what it is called and where it lies, with what there is to say about it:
/// subjects of one name get the name of the folder around theirs too, and a number where that does not help.
pub(in crate::io) fn unique_ids(named: &[(&str, &Path)]) -> Vec<(String, Vec<Notice>)> {
    // One name is one id, whichever system wrote its letters.
    let mut ids: Vec<String> = named.iter().map(|(id, _)| composed(id)).collect();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for id in &ids {
        *counts.entry(id.clone()).or_default() += 1;
    }
    for (id, (_, place)) in ids.iter_mut().zip(named) {
        let own_folder = place
            .ancestors()
            .find(|place| composed(&name_of(place)) == *id);
        if counts.get(id).is_some_and(|&count| count > 1)
            && let Some(around) = own_folder.and_then(Path::parent).map(folder_name)
            && !around.is_empty()
        {
            *id = format!("{around}/{id}");
        }
    }
    let mut taken: HashSet<String> = HashSet::new();
    // where the search for a free number goes on, so that many subjects of one id are numbered in one go
    let mut next: HashMap<String, usize> = HashMap::new();
    let mut unique: Vec<(String, Vec<Notice>)> = Vec::with_capacity(ids.len());
    for id in ids {
        let (mut own, number) = (id.clone(), next.entry(id.clone()).or_insert(2));
        while !taken.insert(own.clone()) {
            own = format!("{id} ({number})");
            *number += 1;
        }
        let notice = (own != id).then(|| {
            Notice::warning(format!(
                "another subject has the id {id:?} too: this one is shown as {own:?}"
            ))
        });
        unique.push((own, notice.into_iter().collect()));
    }
    tell_nearly_equal_ids(&mut unique);
    unique
}

/// Ids that a reader cannot distinguish: they differ only in letter case or blanks.
fn tell_nearly_equal_ids(ids: &mut [(String, Vec<Notice>)]) {
    let plain = |id: &str| id.split_whitespace().collect::<String>().to_lowercase();
    let mut first: HashMap<String, String> = HashMap::new();
    for (id, notices) in ids {
        let known = first.entry(plain(id)).or_insert_with(|| id.clone());
        if known != id {
            notices.push(Notice::warning(format!(
                "the id {id:?} differs from {known:?} only in letter case or blanks: two subjects, by their ids"
            )));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plans(ids: &[&str]) -> Vec<SubjectPlan> {
        ids.iter()
            .map(|id| SubjectPlan {
                id: (*id).to_owned(),
                place: std::path::PathBuf::new(),
                surfaces: Vec::new(),
                stated: Default::default(),
                notices: Vec::new(),
            })
            .collect()
    }

    fn unique(ids: &[&str]) -> Vec<SubjectPlan> {
        let mut plans = plans(ids);
        make_ids_unique(&mut plans);
        plans
    }

    #[test]
    fn one_name_in_two_spellings_of_unicode_is_one_id() {
        let plans = unique(&["M\u{fc}ller", "Mu\u{308}ller"]);
        assert_eq!(plans[1].id, "M\u{fc}ller (2)");
        assert!(
            plans[1].notices[0]
                .text
                .contains("another subject has the id")
        );
    }

    #[test]
    fn ids_that_differ_in_case_or_blanks_are_told() {
        let plans = unique(&["p1", "P1", "p 1", "p2"]);
        let counts: Vec<usize> = plans.iter().map(|plan| plan.notices.len()).collect();
        assert_eq!(counts, [0, 1, 1, 0]);
    }

    #[test]
    fn many_subjects_of_one_id_are_numbered_at_once() {
        let plans = unique(&vec!["a"; 20_000]);
        assert_eq!(plans[19_999].id, "a (20000)");
    }
}
