//! Are some subjects of a cohort the same heart?

use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use super::words::counted;
use crate::mesh::Point3;
use crate::study::{Notice, Subject};

/// Pairs that are told one by one.
const MAX_TOLD: usize = 5;

/// Subjects with frames of exactly the same positions.
///
/// Why it matters: a heart that is in a cohort twice counts twice, and a classifier that has seen the one copy knows the
/// other, so that leaving one out leaves nothing out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RepeatedSubjects {
    /// Indices of subjects that are the same in all frames, two or more each; ascending.
    pub same: Vec<Vec<usize>>,
    /// Two subjects, by index, that share some frames, and how many.
    pub overlapping: Vec<(usize, usize, usize)>,
}

impl RepeatedSubjects {
    /// Compares the vertices of all frames of all subjects, by their hashes first.
    pub fn of(subjects: &[Arc<Subject>]) -> Self {
        let poses: Vec<Vec<u64>> = subjects.iter().map(|subject| hashes(subject)).collect();
        let mut by_all: BTreeMap<&[u64], Vec<usize>> = BTreeMap::new();
        for (subject, poses) in poses.iter().enumerate() {
            by_all.entry(poses).or_default().push(subject);
        }
        let mut found = Self::default();
        for group in by_all.into_values() {
            let mut left = group;
            while let Some((&first, others)) = left.split_first() {
                let (equal, differing): (Vec<usize>, Vec<usize>) = others
                    .iter()
                    .partition(|&&other| equal_frames(&subjects[first], &subjects[other]));
                if !equal.is_empty() {
                    found
                        .same
                        .push(std::iter::once(first).chain(equal).collect());
                }
                left = differing;
            }
        }
        found.same.sort();
        let twin: HashMap<usize, usize> = (found.same.iter())
            .flat_map(|group| group.iter().map(|&member| (member, group[0])))
            .collect();
        let kind = |subject: usize| twin.get(&subject).copied().unwrap_or(subject);
        let mut by_pose: HashMap<u64, usize> = HashMap::new();
        let mut shared: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for (subject, poses) in poses.iter().enumerate() {
            // of subjects that are the same, the first stands for all
            if kind(subject) != subject {
                continue;
            }
            for &pose in poses {
                let first = *by_pose.entry(pose).or_insert(subject);
                if first != subject {
                    *shared.entry((first, subject)).or_default() += 1;
                }
            }
        }
        found.overlapping = shared
            .into_iter()
            .map(|((a, b), count)| (a, b, count))
            .collect();
        found
    }

    /// What the load report says.
    pub fn notices(&self, subjects: &[Arc<Subject>]) -> Vec<Notice> {
        let id = |subject: usize| {
            subjects
                .get(subject)
                .map_or("", |subject| subject.id.as_str())
        };
        let mut notices: Vec<Notice> = (self.same.iter().take(MAX_TOLD))
            .map(|group| {
                let mut ids: Vec<&str> = group.iter().take(MAX_TOLD).map(|&subject| id(subject)).collect();
                let last = ids.pop().unwrap_or_default();
                Notice::warning(format!(
                    "{} and {last} have the same meshes{}: one heart listed more than once, or a copy",
                    ids.join(", "),
                    more(group.len(), "subject", "subjects")
                ))
            })
            .collect();
        if let Some(rest) = self
            .same
            .len()
            .checked_sub(MAX_TOLD)
            .filter(|&rest| rest > 0)
        {
            notices.push(Notice::warning(format!(
                "{} have the same meshes as well",
                counted(rest, "more group of subjects", "more groups of subjects")
            )));
        }
        notices.extend(
            self.overlapping
                .iter()
                .take(MAX_TOLD)
                .map(|&(a, b, frames)| {
                    Notice::warning(format!(
                        "{} and {} have {} in common: perhaps one heart under two ids",
                        id(a),
                        id(b),
                        counted(frames, "identical frame", "identical frames")
                    ))
                }),
        );
        notices
    }
}

fn more(count: usize, singular: &str, plural: &str) -> String {
    match count.checked_sub(MAX_TOLD) {
        Some(rest) if rest > 0 => format!(
            ", with {}",
            counted(rest, &format!("more {singular}"), &format!("more {plural}"))
        ),
        _ => String::new(),
    }
}

/// A hash of each frame's vertices.
fn hashes(subject: &Subject) -> Vec<u64> {
    let surfaces = subject.sequence.surfaces();
    (0..subject.sequence.frame_count())
        .map(|frame| {
            let mut hasher = DefaultHasher::new();
            for mesh in surfaces
                .iter()
                .filter_map(|surface| surface.frames().get(frame))
            {
                mesh.vertices().len().hash(&mut hasher);
                for point in mesh.vertices() {
                    for coordinate in [point.x, point.y, point.z] {
                        // zero has two signs
                        (coordinate + 0.0).to_bits().hash(&mut hasher);
                    }
                }
            }
            hasher.finish()
        })
        .collect()
}

fn equal_frames(a: &Subject, b: &Subject) -> bool {
    let positions = |subject: &Subject| -> Vec<Vec<Point3>> {
        let frames = 0..subject.sequence.frame_count();
        frames
            .filter_map(|frame| subject.sequence.pose(frame))
            .collect()
    };
    positions(a) == positions(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn cohort(radii: &[&[f64]]) -> Vec<Arc<Subject>> {
        (radii.iter().enumerate())
            .map(|(place, radii)| {
                let frames = radii
                    .iter()
                    .map(|&radius| phantom::sphere(1, radius))
                    .collect();
                let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
                let sequence = MeshSequence::new(vec![surface]).unwrap();
                Arc::new(Subject::new(
                    format!("p{place}"),
                    sequence,
                    LengthUnit::Millimetre,
                ))
            })
            .collect()
    }

    #[test]
    fn subjects_of_the_same_meshes_are_told_together() {
        let subjects = cohort(&[&[30.0, 20.0], &[31.0, 21.0], &[30.0, 20.0], &[30.0, 20.0]]);
        let found = RepeatedSubjects::of(&subjects);
        assert_eq!(found.same, [vec![0, 2, 3]]);
        assert!(found.overlapping.is_empty());
        let notices = found.notices(&subjects);
        assert!(
            notices[0]
                .text
                .starts_with("p0, p2 and p3 have the same meshes"),
            "{notices:?}"
        );
    }

    #[test]
    fn subjects_that_share_frames_are_told() {
        let subjects = cohort(&[&[30.0, 20.0, 25.0], &[30.0, 20.0], &[33.0, 22.0]]);
        let found = RepeatedSubjects::of(&subjects);
        assert_eq!(
            (found.same.len(), found.overlapping.as_slice()),
            (0, &[(0, 1, 2)][..])
        );
        assert!(
            found.notices(&subjects)[0]
                .text
                .contains("2 identical frames in common")
        );
    }

    #[test]
    fn different_subjects_bring_nothing() {
        let subjects = cohort(&[&[30.0, 20.0], &[31.0, 21.0]]);
        assert_eq!(RepeatedSubjects::of(&subjects), RepeatedSubjects::default());
        assert_eq!(RepeatedSubjects::of(&[]), RepeatedSubjects::default());
    }
}
