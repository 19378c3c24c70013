//! Which subjects of a study can be compared vertex by vertex, and in which size.

use std::collections::HashMap;

use crate::study::{CorrespondenceKey, Study, Subject};

use super::SizeScale;

/// A subject that takes part.
#[derive(Clone, Copy, Debug)]
pub struct Comparable<'a> {
    /// Index into the study's subjects.
    pub index: usize,
    /// The subject.
    pub subject: &'a Subject,
    /// Frame of end-diastole: as stated by the subject, else 0. It exists.
    pub end_diastole: usize,
    /// What its coordinates are divided by.
    pub scale: SizeScale,
}

/// A subject that takes no part, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Why, in a sentence.
    pub reason: String,
}

/// The largest group of subjects whose vertices correspond, each with its scale: the largest box
/// side at end-diastole, as stated by the subject, else of frame 0.
///
/// The largest group counts subjects; of equal ones that of the first subject is taken. Subjects
/// of other groups, and those that have no size, are left out with a reason. Both lists are in the
/// order of the study.
pub fn comparable_subjects(study: &Study) -> (Vec<Comparable<'_>>, Vec<LeftOut>) {
    let (mut members, mut left_out) = (Vec::new(), Vec::new());
    let Some(group) = largest_group(study) else {
        return (members, left_out);
    };
    for (index, subject) in study.subjects.iter().enumerate() {
        match usable(subject, group) {
            Ok((end_diastole, scale)) => members.push(Comparable {
                index,
                subject,
                end_diastole,
                scale,
            }),
            Err(reason) => left_out.push(LeftOut {
                subject: index,
                reason,
            }),
        }
    }
    (members, left_out)
}

/// The key that most subjects have, and the first of them.
#[derive(Clone, Copy)]
struct Group<'a> {
    key: CorrespondenceKey,
    first: &'a Subject,
}

fn largest_group(study: &Study) -> Option<Group<'_>> {
    let mut counts: HashMap<CorrespondenceKey, usize> = HashMap::new();
    for subject in &study.subjects {
        *counts.entry(subject.sequence.correspondence()).or_default() += 1;
    }
    let count = |subject: &Subject| counts.get(&subject.sequence.correspondence());
    // `max_by_key` would take the last of equals.
    let first = (study.subjects.iter()).reduce(|best, next| {
        if count(next) > count(best) {
            next
        } else {
            best
        }
    })?;
    Some(Group {
        key: first.sequence.correspondence(),
        first,
    })
}

fn usable(subject: &Subject, group: Group<'_>) -> Result<(usize, SizeScale), String> {
    let sequence = &subject.sequence;
    // Equal counts are not enough: vertex i must mean the same place in both.
    if sequence.correspondence() != group.key {
        return Err(format!(
            "its vertices ({} with {} faces) do not correspond with those of {} ({} with {} faces)",
            sequence.vertex_count(),
            sequence.face_count(),
            group.first.id,
            group.first.sequence.vertex_count(),
            group.first.sequence.face_count(),
        ));
    }
    let end_diastole = subject.start_frame();
    let points = sequence.pose(end_diastole).unwrap_or_default();
    // Points that coincide would divide by zero.
    let scale = SizeScale::of_end_diastole(&points).ok_or_else(|| {
        format!("its size at end-diastole (frame {end_diastole}) is not measurable")
    })?;
    Ok((end_diastole, scale))
}
