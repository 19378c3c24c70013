//! Opening: from dropped paths to a study of all that could be read.
//!
//! Paths become a plan (which files make which surface of which subject: [`find_sequences`],
//! [`study_toml`], [`group_files`]); the plan's files are read in parallel and joined
//! ([`read_subjects`]), subject by subject ([`stages`]); what was assumed and found stands with each subject.

mod copies;
mod file_name;
mod find_images;
mod find_sequences;
mod folder_contents;
mod folders;
mod frame_facts;
mod frame_folders;
mod frame_name;
mod frames;
mod group_files;
mod labels;
mod length_unit;
mod listed_files;
mod loose_files;
mod manifest_subjects;
mod name_words;
mod one_ending;
mod patterns;
mod plan;
mod plausible;
mod read_file;
mod read_images;
mod read_subjects;
mod readings;
mod seams;
mod series_files;
mod series_parts;
mod series_times;
mod sheet_by_shape;
mod sheet_folders;
mod stages;
mod study_budget;
mod study_toml;
mod subject_ids;
mod toml_fields;
mod words;

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use find_sequences::{looks_like_image, looks_openable};

use super::{Limits, OpenError, Opened};
use crate::progress::{Progress, Stopped};
use crate::study::checks::{AlignedCohort, Copies, all_of, counted};
use crate::study::{ExcludedSubject, LabelClasses, Notice, Study, Subject, UnreadSubject};
pub use find_images::PassedOver;
use find_sequences::Search;
use folder_contents::folder_name;
pub use frames::SubjectFrames;
use group_files::stem;
use labels::unite_labels;
pub use read_file::{read_head, read_mesh_file};
pub use read_images::{
    FoundImage, ImageReport, each_image, read_image_file, read_images, read_images_beside,
};
pub use stages::OpenListener;
use subject_ids::make_ids_unique;
pub(in crate::io) use subject_ids::unique_ids;

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
    open_paths_in_stages(paths, limits, progress, &())
}

/// The same, with each subject handed to `listener` as soon as it is read. If that has enough before all are read, what
/// was read is opened, and a note says how many were not.
///
/// # Errors
/// Only [`Stopped`].
pub fn open_paths_in_stages(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
    listener: &dyn OpenListener,
) -> Result<Opened, Stopped> {
    let mut search = Search::new(paths, limits, progress);
    search.paths(paths)?;
    let mut plan = search.plan;
    make_ids_unique(&mut plan.subjects);
    let notices = unite_labels(&mut plan.subjects, plan.label_classes.as_ref());
    plan.notices.extend(notices);
    let own_name = plan.name.filter(|_| paths.len() == 1);
    let mut opened = Opened {
        study: Study {
            name: own_name.unwrap_or_else(|| name_of_paths(paths)),
            label_classes: plan.label_classes.unwrap_or_default(),
            ..Study::default()
        },
        errors: plan.errors,
        notices: plan.notices,
        images: Vec::new(),
    };
    let unread = plan.subjects.iter().map(|subject| UnreadSubject {
        id: subject.id.clone(),
        label: subject.stated.label.clone(),
        read_before: 0,
    });
    let planned = Study {
        unread: unread.collect(),
        ..opened.study.clone()
    };
    let count = plan.subjects.len();
    let excluded: Vec<bool> = plan.subjects.iter().map(|s| s.stated.excluded).collect();
    // Who belongs to the cohort is known of all subjects at once, so such a study is shown when all is read.
    if !excluded.contains(&true) {
        listener.planned(planned, stages::bytes_of(&plan.subjects));
    }
    let outcomes = stages::read_subjects(&plan.subjects, limits, progress, listener)?;
    let mut left = 0;
    for (outcome, excluded) in outcomes.into_iter().zip(excluded) {
        let study = &mut opened.study;
        match outcome {
            Some(Ok(subject)) if excluded => study.excluded.push(ExcludedSubject {
                place: study.count(),
                subject,
            }),
            Some(Ok(subject)) => study.subjects.push(subject),
            Some(Err(errors)) => opened.errors.extend(errors),
            None => left += 1,
        }
    }
    if opened.study.subjects.is_empty() && !opened.study.excluded.is_empty() {
        let all = std::mem::take(&mut opened.study.excluded).into_iter();
        opened.study.subjects = all.map(|excluded| excluded.subject).collect();
        let text = "study.toml excludes all subjects, which leaves no cohort: none is excluded";
        opened.notices.push(Notice::warning(text));
    }
    if left > 0 {
        opened.notices.push(Notice::warning(format!(
            "reading was stopped: {left} of {count} subjects were not read"
        )));
    }
    opened
        .notices
        .extend(cohort_notices(&opened.study.subjects));
    Ok(opened)
}

/// Reads what [`open_paths`] would open, with the frames of each subject as separate meshes, whether or not their vertices
/// correspond; and one error for each thing that cannot be read.
///
/// # Errors
/// Only [`Stopped`].
pub fn read_frames(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<FramesRead, Stopped> {
    let mut search = Search::new(paths, limits, progress);
    search.paths(paths)?;
    let mut plan = search.plan;
    make_ids_unique(&mut plan.subjects);
    let mut notices = plan.notices;
    notices.extend(unite_labels(
        &mut plan.subjects,
        plan.label_classes.as_ref(),
    ));
    let own_name = plan.name.filter(|_| paths.len() == 1);
    let mut read = FramesRead {
        name: own_name.unwrap_or_else(|| name_of_paths(paths)),
        label_classes: plan.label_classes.unwrap_or_default(),
        subjects: Vec::new(),
        errors: plan.errors,
        notices,
    };
    for outcome in stages::read_frames_of(&plan.subjects, limits, progress)? {
        match outcome {
            Ok(subject) => read.subjects.push(subject),
            Err(errors) => read.errors.extend(errors),
        }
    }
    Ok(read)
}

/// The outcome of [`read_frames`].
#[derive(Clone, Debug, Default)]
pub struct FramesRead {
    /// What the study is called.
    pub name: String,
    /// What its labels count as.
    pub label_classes: LabelClasses,
    /// All subjects that could be read, also those that a manifest excludes.
    pub subjects: Vec<SubjectFrames>,
    /// One for each thing that could not be read.
    pub errors: Vec<OpenError>,
    /// What was assumed about the study as a whole.
    pub notices: Vec<Notice>,
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

/// What holds for the cohort: whether its vertices correspond, whether its units agree, who is listed twice.
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
    notices.extend(Copies::of(subjects).notices(subjects));
    let units: HashSet<_> = subjects.iter().map(|subject| subject.unit).collect();
    if units.len() > 1 {
        notices.push(Notice::warning(
            "some subjects are in mm and some in file units: their sizes cannot be compared",
        ));
    }
    notices
}

/// Replaces what held for the cohort of the first study by what holds for that of the second.
pub fn renew_cohort_notices(notices: &mut Vec<Notice>, [before, now]: [&Study; 2]) {
    let before = cohort_notices(&before.subjects);
    notices.retain(|notice| !before.contains(notice));
    notices.extend(cohort_notices(&now.subjects));
}

#[cfg(test)]
mod tests;
