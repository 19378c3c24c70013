//! Opening: from dropped paths to a study of all that could be read.
//!
//! Paths become a plan (which files make which surface of which subject: [`find_sequences`],
//! [`study_toml`], [`group_files`]); the plan's files are read in parallel and joined
//! ([`read_subjects`]); what was assumed and found stands with each subject.

mod file_name;
mod find_sequences;
mod group_files;
mod length_unit;
mod manifest_subjects;
mod natural_order;
mod patterns;
mod plan;
mod read_file;
mod read_subjects;
mod series_files;
mod sheet_by_shape;
mod study_toml;
mod toml_fields;

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use find_sequences::looks_openable;

use super::{Limits, Opened};
use crate::progress::{Progress, Stopped};
use crate::study::checks::{AlignedCohort, Copies, all_of, counted};
use crate::study::{Notice, Study, Subject};
use find_sequences::{Search, folder_name};
use group_files::stem;
use plan::SubjectPlan;
use read_file::name_of;
pub use read_file::read_head;

/// Opens studies, folders, series and mesh files, together as one study.
///
/// Files are read in parallel, each a step of `progress`. A file that cannot be read costs its
/// subject and brings one error; all other subjects are there. The study's revision is left at its
/// default, for the caller to set.
///
/// # Errors
/// Only [`Stopped`].
pub fn open_paths(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<Opened, Stopped> {
    let mut search = Search::new(limits, progress);
    search.paths(paths)?;
    let mut plan = search.plan;
    make_ids_unique(&mut plan.subjects);
    let own_name = plan.name.filter(|_| paths.len() == 1);
    let mut opened = Opened {
        study: Study {
            name: own_name.unwrap_or_else(|| name_of_paths(paths)),
            label_roles: plan.label_roles.unwrap_or_default(),
            ..Study::default()
        },
        errors: plan.errors,
        notices: plan.notices,
    };
    for outcome in read_subjects::read_subjects(plan.subjects, limits, progress)? {
        match outcome {
            Ok(subject) => opened.study.subjects.push(Arc::new(subject)),
            Err(errors) => opened.errors.extend(errors),
        }
    }
    opened
        .notices
        .extend(cohort_notices(&opened.study.subjects));
    Ok(opened)
}

/// Names that say nothing without the folder around them.
const GENERIC: &[&str] = &["meshes", "mesh", "models", "surfaces", "frames", "data"];

/// What to call a study that does not name itself.
fn name_of_paths(paths: &[PathBuf]) -> String {
    let name = |path: &Path| {
        if !path.is_dir() {
            return stem(path);
        }
        let name = folder_name(path);
        match path.parent().map(folder_name) {
            Some(around) if GENERIC.contains(&name.as_str()) && !around.is_empty() => {
                format!("{around}/{name}")
            }
            _ => name,
        }
    };
    match paths {
        [] => String::new(),
        [one] => name(one),
        [first, ..] => {
            let folders: BTreeSet<Option<&Path>> = paths.iter().map(|p| p.parent()).collect();
            match (folders.len(), first.parent()) {
                (1, Some(folder)) if !folder_name(folder).is_empty() => folder_name(folder),
                _ => format!("{} and {} more", name(first), paths.len() - 1),
            }
        }
    }
}

/// Gives subjects of one name the name of the folder around it too, and a number where that does not help.
fn make_ids_unique(plans: &mut [SubjectPlan]) {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for plan in plans.iter() {
        *counts.entry(plan.id.clone()).or_default() += 1;
    }
    for plan in plans.iter_mut() {
        let own_folder = plan
            .place
            .ancestors()
            .find(|place| name_of(place) == plan.id);
        if counts.get(&plan.id).is_some_and(|&count| count > 1)
            && let Some(around) = own_folder.and_then(Path::parent).map(folder_name)
            && !around.is_empty()
        {
            plan.id = format!("{around}/{}", plan.id);
        }
    }
    let mut taken: HashSet<String> = HashSet::new();
    for plan in plans.iter_mut() {
        let id = plan.id.clone();
        let mut number = 2;
        while !taken.insert(plan.id.clone()) {
            plan.id = format!("{id} ({number})");
            number += 1;
        }
        if plan.id != id {
            plan.notices.push(Notice::warning(format!(
                "another subject has the id {id:?} too: this one is shown as {:?}",
                plan.id
            )));
        }
    }
}

/// What holds for the cohort: whether its vertices correspond, and whether its units agree.
fn cohort_notices(subjects: &[Arc<Subject>]) -> Vec<Notice> {
    let mut notices = Vec::new();
    if subjects.len() < 2 {
        return notices;
    }
    let mut groups: BTreeMap<_, usize> = BTreeMap::new();
    for subject in subjects {
        *groups.entry(subject.sequence.correspondence()).or_default() += 1;
    }
    if groups.len() == 1 {
        notices.push(Notice::info(format!(
            "{} have the same faces: their vertices correspond",
            all_of(subjects.len(), "subjects")
        )));
    } else {
        let mut sizes: Vec<usize> = groups.into_values().collect();
        sizes.sort_unstable_by(|a, b| b.cmp(a));
        let all_apart = sizes.first() == Some(&1);
        notices.push(Notice::warning(if all_apart {
            "no two subjects have the same faces: their poses cannot be compared vertex by vertex"
                .to_owned()
        } else {
            format!(
                "subjects have {} different meshes (the most frequent in {}): poses are compared only where the mesh is the same",
                sizes.len(),
                counted(sizes[0], "subject", "subjects")
            )
        }));
    }
    notices.extend(AlignedCohort::of(subjects).notice());
    notices.extend(Copies::of(subjects).notice(subjects));
    let units: HashSet<_> = subjects.iter().map(|subject| subject.unit).collect();
    if units.len() > 1 {
        notices.push(Notice::warning(
            "some subjects are in mm and some in file units: their sizes cannot be compared",
        ));
    }
    notices
}

#[cfg(test)]
mod tests;
