//! Is one subject listed under several ids?

use std::collections::BTreeMap;
use std::sync::Arc;

use super::words::counted;
use crate::mesh::{Point3, Vector3};
use crate::study::{CorrespondenceKey, Notice, Subject};

/// Distances from the mean vertex agree within this share of their root mean square: files with two digits after the
/// point round a heart in millimetres by 2·10⁻⁴ of it. Two frames of one heart differ by more than 10⁻².
const EQUAL: f64 = 3e-4;

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
    /// vertices from their mean, which no rigid motion changes, are equal.
    pub fn of(subjects: &[Arc<Subject>]) -> Self {
        let mut groups: BTreeMap<CorrespondenceKey, Vec<Pose<'_>>> = BTreeMap::new();
        for (index, subject) in subjects.iter().enumerate() {
            let poses = groups.entry(subject.sequence.correspondence()).or_default();
            for frame in 0..subject.sequence.frame_count() {
                poses.push(Pose::new(index, frame, subject));
            }
        }
        let mut first: Vec<usize> = (0..subjects.len()).collect();
        let mut overlapping = Vec::new();
        for ((earlier, later), shared) in groups.into_values().flat_map(shared_frames) {
            let frames = |index: usize| subjects[index].sequence.frame_count();
            let seen = |side: fn(&(usize, usize)) -> usize| {
                let mut seen: Vec<usize> = shared.iter().map(side).collect();
                seen.sort_unstable();
                seen.dedup();
                seen.len()
            };
            let seen_of_later = seen(|pair| pair.1);
            if seen(|pair| pair.0) == frames(earlier) || seen_of_later == frames(later) {
                first[later] = first[later].min(first[earlier]);
            } else {
                overlapping.push((earlier, later, seen_of_later));
            }
        }
        // Of copies the first stands for all.
        overlapping.retain(|&(a, b, _)| first[a] == a && first[b] == b);
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
            let agreed = label.filter(|label| known.all(|other| other == *label));
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
            let told = (groups.iter().take(LISTED))
                .map(|group| {
                    let ids = group.iter().take(LISTED).map(|&s| id(s).to_owned());
                    listed(ids.collect(), group.len(), " = ")
                })
                .collect();
            notices.push(Notice::warning(format!(
                "the same meshes under several ids: {}; classifiers count each subject once, so that none is tested on a copy of itself{}",
                listed(told, groups.len(), ", "),
                differing_labels(&groups, subjects)
            )));
        }
        if !self.overlapping.is_empty() {
            let told = (self.overlapping.iter().take(LISTED))
                .map(|&(a, b, frames)| {
                    let frames = counted(frames, "frame", "frames");
                    format!("{} and {} ({frames})", id(a), id(b))
                })
                .collect();
            notices.push(Notice::warning(format!(
                "subjects with some frames in common, perhaps one subject under two ids: {}",
                listed(told, self.overlapping.len(), ", ")
            )));
        }
        notices
    }
}

/// What happens to copies whose labels contradict each other, where there are any.
fn differing_labels(groups: &[Vec<usize>], subjects: &[Arc<Subject>]) -> &'static str {
    let differ = |group: &Vec<usize>| {
        let mut labels = (group.iter()).filter_map(|&s| subjects[s].label.as_deref());
        let first = labels.next();
        labels.any(|label| Some(label) != first)
    };
    if groups.iter().any(differ) {
        "; copies with different labels take no part"
    } else {
        ""
    }
}

/// Which frames of which two subjects are the same pose.
type Shared = Vec<((usize, usize), Vec<(usize, usize)>)>;

fn shared_frames(mut poses: Vec<Pose<'_>>) -> Shared {
    poses.sort_by(|a, b| a.size.total_cmp(&b.size).then(a.subject.cmp(&b.subject)));
    let mut shared: BTreeMap<(usize, usize), Vec<(usize, usize)>> = BTreeMap::new();
    for (place, pose) in poses.iter().enumerate() {
        // Equal poses have equal sizes, so they lie side by side.
        let near = (poses[place + 1..].iter())
            .take_while(|other| other.size - pose.size <= EQUAL * pose.size);
        for other in near.filter(|other| other.subject != pose.subject && pose.equals(other)) {
            let (a, b) = if pose.subject < other.subject {
                (pose, other)
            } else {
                (other, pose)
            };
            shared
                .entry((a.subject, b.subject))
                .or_default()
                .push((a.frame, b.frame));
        }
    }
    shared.into_iter().collect()
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
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    /// A heart of its own shape, moved as asked.
    fn heart(
        id: &str,
        shape: f64,
        frames: usize,
        place: impl Fn(Point3) -> Point3,
    ) -> Arc<Subject> {
        let ball = phantom::sphere(2, 30.0);
        let meshes = (0..frames)
            .map(|frame| {
                let beat = 1.0 - 0.05 * frame as f64;
                let points: Vec<Point3> = (ball.vertices().iter())
                    .map(|p| place(Point3::new(p.x * beat, p.y * (1.0 + shape), p.z * beat)))
                    .collect();
                TriMesh::new(points, ball.faces().clone()).unwrap()
            })
            .collect();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
    }

    fn labelled(mut subject: Arc<Subject>, label: &str) -> Arc<Subject> {
        Arc::make_mut(&mut subject).label = Some(label.to_owned());
        subject
    }

    #[test]
    fn copies_are_found_moved_turned_rounded_or_cut_short() {
        let motion = nalgebra::Isometry3::new(
            Vector3::new(120.0, -40.0, 1e5),
            Vector3::new(0.3, -1.2, 0.7),
        );
        let rounded = |p: Point3| p.map(|x| (x * 100.0).round() / 100.0);
        let subjects = [
            heart("a", 0.1, 4, |p| p),
            heart("b", 0.2, 4, |p| p),
            heart("a again", 0.1, 4, |p| p),
            heart("a elsewhere", 0.1, 4, |p| motion * p),
            heart("b in two digits", 0.2, 4, rounded),
            heart("a at two frames", 0.1, 2, |p| p),
            heart("c", 0.11, 4, |p| p),
        ];
        let copies = Copies::of(&subjects);
        assert_eq!(copies.groups(), [vec![0, 2, 3, 5], vec![1, 4]]);
        assert!(copies.are_copies(3, 5) && !copies.are_copies(0, 6));
        assert_eq!(copies.first_of(6), 6);
        let text = &copies.notices(&subjects)[0].text;
        assert!(
            text.contains("same meshes") && text.contains("b = b in two digits"),
            "{text}"
        );
        assert_eq!(Copies::of(&subjects[..2]).notices(&subjects), []);
        assert_eq!(Copies::of(&[]), Copies::default());
    }

    #[test]
    fn subjects_that_share_some_frames_are_told_and_are_no_copies() {
        let cavity = |id: &str, radii: &[f64]| {
            let meshes = radii.iter().map(|&radius| phantom::sphere(1, radius));
            let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes.collect()).unwrap();
            let sequence = MeshSequence::new(vec![surface]).unwrap();
            Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
        };
        let subjects = [
            cavity("a", &[30.0, 20.0, 25.0]),
            cavity("b", &[30.0, 20.0, 27.0]),
            cavity("b again", &[30.0, 20.0, 27.0]),
            cavity("c", &[33.0, 22.0]),
        ];
        let copies = Copies::of(&subjects);
        assert_eq!(copies.groups(), [vec![1, 2]]);
        let told = copies.notices(&subjects);
        assert_eq!(told.len(), 2);
        assert!(
            told[1].text.ends_with("two ids: a and b (2 frames)"),
            "{told:?}"
        );
    }

    #[test]
    fn a_label_counts_once_and_labels_that_differ_do_not_count() {
        let subjects = [
            labelled(heart("a", 0.1, 2, |p| p), "ill"),
            labelled(heart("a2", 0.1, 2, |p| p), "ill"),
            labelled(heart("b", 0.2, 2, |p| p), "ill"),
            labelled(heart("b2", 0.2, 2, |p| p), "normal"),
            heart("c", 0.3, 2, |p| p),
            labelled(heart("c2", 0.3, 2, |p| p), "normal"),
        ];
        let copies = Copies::of(&subjects);
        assert_eq!(
            copies.labels_once(&subjects),
            [Some("ill"), None, None, None, Some("normal"), None]
        );
        assert!(
            copies.notices(&subjects)[0]
                .text
                .contains("different labels")
        );
    }
}
