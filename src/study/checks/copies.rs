//! Is one subject listed under several ids?

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, PoisonError};

use super::words::counted;
use crate::mesh::{Point3, Vector3};
use crate::study::{CorrespondenceKey, Notice, SequenceId, Subject, plain_label};

/// Distances from the mean vertex agree within this share of their root mean square: files with two digits after the
/// point round a heart in millimetres by 2·10⁻⁴ of it. Two frames of one heart differ by more than 10⁻².
const EQUAL: f64 = 3e-4;

/// Subjects with one pose in common that each further one is compared with; all with the same poses count as one.
const COMPARED: usize = 64;

/// What was found last, and of which surfaces: the load report, classifiers and verdicts ask one after the other.
static LAST: Mutex<Option<(Vec<SequenceId>, Arc<Copies>)>> = Mutex::new(None);

/// Groups, pairs and ids that the load report lists.
const LISTED: usize = 4;

/// Subjects whose meshes are those of another subject, turned and moved or not.
///
/// Why it matters: a classifier that has seen a copy of the subject it is tested on knows its label, so that
/// leave-one-out leaves nothing out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Copies {
    first: Vec<usize>,
    /// Two subjects that are no copies, by index, and how many frames of the later one are poses of the earlier one.
    overlapping: Vec<(usize, usize, usize)>,
}

/// One pose of one subject, and its size.
struct Pose<'a> {
    subject: usize,
    frame: usize,
    of: &'a Subject,
    mean: Point3,
    size: f64,
}

impl Copies {
    /// Compares the poses of all subjects whose vertices correspond.
    ///
    /// Two subjects are copies if every pose of the one with fewer frames is a pose of the other: the distances of its
    /// vertices from their mean, which no rigid motion changes, are equal. Asked again for the same surfaces, the answer is
    /// that of before.
    pub fn of(subjects: &[Arc<Subject>]) -> Arc<Self> {
        let ids: Vec<SequenceId> = subjects
            .iter()
            .map(|subject| subject.sequence.id())
            .collect();
        let last = || LAST.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((known, copies)) = &*last()
            && *known == ids
        {
            return Arc::clone(copies);
        }
        let copies = Arc::new(Self::compared(subjects));
        *last() = Some((ids, Arc::clone(&copies)));
        copies
    }

    fn compared(subjects: &[Arc<Subject>]) -> Self {
        let mut groups: BTreeMap<CorrespondenceKey, Vec<Pose<'_>>> = BTreeMap::new();
        for (index, subject) in subjects.iter().enumerate() {
            let poses = groups.entry(subject.sequence.correspondence()).or_default();
            for frame in 0..subject.sequence.frame_count() {
                poses.push(Pose::new(index, frame, subject));
            }
        }
        let mut first: Vec<usize> = (0..subjects.len()).collect();
        let mut overlapping = Vec::new();
        for poses in groups.into_values() {
            let shapes = shapes_of(poses);
            // Subjects with the same shapes are copies, however many they are; the first of them is compared on.
            let mut firsts: BTreeMap<&BTreeSet<usize>, usize> = BTreeMap::new();
            for (&subject, own) in &shapes {
                first[subject] = *firsts.entry(own).or_insert(subject);
            }
            for (earlier, later) in sharing(&firsts) {
                let [own, other] = [&shapes[&later], &shapes[&earlier]];
                if own.is_subset(other) || other.is_subset(own) {
                    first[later] = first[later].min(first[earlier]);
                } else {
                    let frames = own.intersection(other).count();
                    overlapping.push((earlier, later, frames));
                }
            }
        }
        // A copy of a copy is a copy of the first.
        for subject in 0..first.len() {
            first[subject] = first[first[subject]];
        }
        // Of copies the first stands for all.
        overlapping.retain(|&(a, b, _)| first[a] == a && first[b] == b);
        overlapping.sort_unstable();
        Self { first, overlapping }
    }

    /// The first subject with the meshes of this one: itself where there is none before it.
    pub fn first_of(&self, subject: usize) -> usize {
        self.first.get(subject).copied().unwrap_or(subject)
    }

    /// Whether two subjects have the same meshes; a subject has its own.
    pub fn are_copies(&self, a: usize, b: usize) -> bool {
        self.first_of(a) == self.first_of(b)
    }

    /// Each first subject with its copies, ascending; none of those that are alone.
    pub fn groups(&self) -> Vec<Vec<usize>> {
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (subject, &first) in self.first.iter().enumerate() {
            groups.entry(first).or_default().push(subject);
        }
        groups
            .into_values()
            .filter(|group| group.len() > 1)
            .collect()
    }

    /// The labels that classifiers train and test on, each subject once: those of first subjects. Of copies with different
    /// labels none counts.
    pub fn labels_once<'a>(&self, subjects: &'a [Arc<Subject>]) -> Vec<Option<&'a str>> {
        let mut labels: Vec<Option<&str>> = subjects
            .iter()
            .map(|subject| subject.label.as_deref())
            .collect();
        for group in self.groups() {
            let mut known = group.iter().filter_map(|&member| labels[member]);
            let label = known.next();
            let agreed = label.filter(|label| known.all(|other| same_label(other, label)));
            for &member in &group {
                labels[member] = None;
            }
            labels[group[0]] = agreed;
        }
        labels
    }

    /// What the load report says.
    pub fn notices(&self, subjects: &[Arc<Subject>]) -> Vec<Notice> {
        let id = |subject: usize| subjects[subject].id.as_str();
        let listed = |mut sentences: Vec<String>, count: usize, between: &str| {
            if count > LISTED {
                sentences.push("…".to_owned());
            }
            sentences.join(between)
        };
        let mut notices = Vec::new();
        let groups = self.groups();
        if !groups.is_empty() {
            let texts = (groups.iter().take(LISTED))
                .map(|group| {
                    let ids = group.iter().take(LISTED).map(|&s| id(s).to_owned());
                    listed(ids.collect(), group.len(), " = ")
                })
                .collect();
            notices.push(Notice::warning(format!(
                "the same meshes under several ids: {}; classifiers count each subject once, so that none is tested on a copy of itself{}",
                listed(texts, groups.len(), ", "),
                differing_labels(&groups, subjects)
            )));
        }
        if !self.overlapping.is_empty() {
            let texts = (self.overlapping.iter().take(LISTED))
                .map(|&(a, b, frames)| {
                    let frames = counted(frames, "frame", "frames");
                    format!("{} and {} ({frames})", id(a), id(b))
                })
                .collect();
            notices.push(Notice::warning(format!(
                "subjects with some frames in common, perhaps one subject under two ids: {}",
                listed(texts, self.overlapping.len(), ", ")
            )));
        }
        notices
    }
}

/// What happens to copies whose labels contradict each other, where there are any.
fn differing_labels(groups: &[Vec<usize>], subjects: &[Arc<Subject>]) -> &'static str {
    let differ = |group: &Vec<usize>| {
        let mut labels = (group.iter()).filter_map(|&s| subjects[s].label.as_deref());
        let first = labels.next().unwrap_or_default();
        labels.any(|label| !same_label(label, first))
    };
    if groups.iter().any(differ) {
        "; copies with different labels take no part"
    } else {
        ""
    }
}

/// Labels are equal as everywhere: letter case and blanks do not matter.
fn same_label(a: &str, b: &str) -> bool {
    plain_label(a) == plain_label(b)
}

/// The shapes of each subject: poses that are equal have the number of one shape. A pose is compared with the first of
/// each shape alone, so that many copies of one subject cost no more than as many different ones.
fn shapes_of(mut poses: Vec<Pose<'_>>) -> BTreeMap<usize, BTreeSet<usize>> {
    poses.sort_by(|a, b| a.size.total_cmp(&b.size).then(a.subject.cmp(&b.subject)));
    let mut shapes: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    let mut first_poses: Vec<&Pose<'_>> = Vec::new();
    for pose in &poses {
        // Equal poses have equal sizes, so they lie side by side.
        let near = (first_poses.iter().enumerate().rev())
            .take_while(|(_, other)| pose.size - other.size <= EQUAL * pose.size);
        let known = near
            .filter(|(_, other)| pose.equals(other))
            .map(|(shape, _)| shape)
            .last();
        let shape = known.unwrap_or(first_poses.len());
        if shape == first_poses.len() {
            first_poses.push(pose);
        }
        shapes.entry(pose.subject).or_default().insert(shape);
    }
    shapes
}

/// Pairs of subjects that have a shape in common, the earlier first, each once.
fn sharing(subjects: &BTreeMap<&BTreeSet<usize>, usize>) -> BTreeSet<(usize, usize)> {
    let mut with_shape: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (shapes, &subject) in subjects {
        for &shape in *shapes {
            with_shape.entry(shape).or_default().push(subject);
        }
    }
    let mut pairs = BTreeSet::new();
    for mut subjects in with_shape.into_values() {
        subjects.sort_unstable();
        for (place, &later) in subjects.iter().enumerate() {
            let earlier = subjects[..place].iter().take(COMPARED);
            pairs.extend(earlier.map(|&earlier| (earlier, later)));
        }
    }
    pairs
}

impl<'a> Pose<'a> {
    fn new(subject: usize, frame: usize, of: &'a Subject) -> Self {
        let mut pose = Self {
            subject,
            frame,
            of,
            mean: Point3::origin(),
            size: 0.0,
        };
        let count = pose.points().count().max(1) as f64;
        if let Some(&first) = pose.points().next() {
            let offsets: Vector3 = pose.points().map(|point| point - first).sum();
            pose.mean = first + offsets / count;
        }
        let squares: f64 = pose.radii().map(|radius| radius * radius).sum();
        pose.size = (squares / count).sqrt();
        pose
    }

    fn points(&self) -> impl Iterator<Item = &'a Point3> + use<'a> {
        let frame = self.frame;
        let surfaces = self.of.sequence.surfaces().iter();
        surfaces.flat_map(move |surface| surface.frames()[frame].vertices())
    }

    fn radii(&self) -> impl Iterator<Item = f64> + use<'a> {
        let mean = self.mean;
        self.points().map(move |point| (point - mean).norm())
    }

    fn equals(&self, other: &Self) -> bool {
        let slack = EQUAL * self.size;
        (self.radii().zip(other.radii())).all(|(a, b)| (a - b).abs() <= slack)
    }
}

#[cfg(test)]
mod tests;
