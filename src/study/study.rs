//! The cohort as one immutable value; an edit makes another with the next revision.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::label::plain_label;
use super::{LabelClass, LabelClasses, Subject};

/// Names one state of one study in this run of the program; results are keyed by it.
///
/// Whoever opens or edits a study gives it a number that was not used before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Revision(pub u64);

/// Subjects and the classes of their labels. Shared as `Arc<Study>`, never changed.
///
/// An index of a subject counts those of the cohort first, then those excluded from it.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// What the window's title bar says.
    pub name: String,
    /// The subjects that are read, in the order of the input.
    pub subjects: Vec<Arc<Subject>>,
    /// Those still to be read, in the order of the input: apart, so that no analysis takes one for a subject without
    /// surfaces. What is asked of the whole cohort has no answer while there are any.
    pub unread: Vec<UnreadSubject>,
    /// Subjects that no analysis of the cohort counts, in the order of the input.
    pub excluded: Vec<ExcludedSubject>,
    /// What labels count as.
    pub label_classes: LabelClasses,
    /// Which edit this is.
    pub revision: Revision,
}

/// A subject that is still to be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadSubject {
    /// Pseudonym.
    pub id: String,
    /// Free text of the study.
    pub label: Option<String>,
    /// How many subjects that are read stand before it in the order of the input.
    pub read_before: usize,
}

/// What came of one that was to be read; `None` where its files cannot be read.
pub type ReadSubject = (String, Option<Arc<Subject>>);

/// A subject that stays in the study and that no analysis of the cohort counts.
#[derive(Clone, Debug)]
pub struct ExcludedSubject {
    /// Its place among all subjects in the order of the input.
    pub place: usize,
    /// Who.
    pub subject: Arc<Subject>,
}

impl Study {
    /// The class of a subject's label.
    pub fn class_of(&self, subject: &Subject) -> LabelClass {
        self.label_classes.class_of(subject.label.as_deref())
    }

    /// Whether telling normal from abnormal subjects is another question than telling their labels apart: subjects of
    /// both classes are there, under more than two labels.
    pub fn has_other_classes_than_labels(&self) -> bool {
        let labels = self.subjects.iter().filter_map(|s| s.label.as_deref());
        let labels: BTreeSet<String> = labels.map(plain_label).collect();
        self.has_both_classes() && labels.len() > 2
    }

    /// Whether there are subjects of class normal and of class abnormal.
    pub fn has_both_classes(&self) -> bool {
        let has = |class| {
            self.subjects
                .iter()
                .any(|subject| self.class_of(subject) == class)
        };
        has(LabelClass::Normal) && has(LabelClass::Abnormal)
    }

    /// Index of the subject with this id.
    pub fn index_of(&self, id: &str) -> Option<usize> {
        self.all().position(|subject| subject.id == id)
    }

    /// A subject by its index, excluded ones included.
    pub fn subject(&self, index: usize) -> Option<&Arc<Subject>> {
        let excluded = || {
            let excluded = self.excluded.get(index.checked_sub(self.subjects.len())?)?;
            Some(&excluded.subject)
        };
        self.subjects.get(index).or_else(excluded)
    }

    /// All subjects by their indices: those of the cohort, then those excluded from it.
    pub fn all(&self) -> impl Iterator<Item = &Arc<Subject>> {
        let excluded = self.excluded.iter().map(|excluded| &excluded.subject);
        self.subjects.iter().chain(excluded)
    }

    /// Number of all subjects, excluded ones included.
    pub fn count(&self) -> usize {
        self.subjects.len() + self.excluded.len()
    }

    /// Whether no analysis of the cohort counts the subject of an index.
    pub fn is_excluded(&self, index: usize) -> bool {
        index >= self.subjects.len()
    }

    /// The indices of all subjects in the order of the input.
    pub fn in_order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.subjects.len()).collect();
        for (index, excluded) in (self.subjects.len()..).zip(&self.excluded) {
            order.insert(excluded.place.min(order.len()), index);
        }
        order
    }

    /// The same study with subjects that were read since, in their places, as another revision; and for each subject of
    /// this one, its index there.
    pub fn with_read(&self, read: &[ReadSubject], revision: Revision) -> (Self, Vec<usize>) {
        let mut study = Self {
            revision,
            ..self.clone()
        };
        let mut index: Vec<usize> = (0..self.subjects.len()).collect();
        for (id, subject) in read {
            let Some(place) = study.unread.iter().position(|unread| unread.id == *id) else {
                continue;
            };
            let at = study.unread.remove(place).read_before;
            if let Some(subject) = subject {
                study.subjects.insert(at, Arc::clone(subject));
                for later in &mut study.unread[place..] {
                    later.read_before += 1;
                }
                for old in index.iter_mut().filter(|old| **old >= at) {
                    *old += 1;
                }
            }
        }
        (study, index)
    }

    /// The same study without what was not read, as another revision.
    pub fn without_unread(&self, revision: Revision) -> Self {
        Self {
            unread: Vec::new(),
            revision,
            ..self.clone()
        }
    }

    /// Memory that its surfaces hold, nearly.
    pub fn bytes(&self) -> usize {
        let surfaces = (self.subjects.iter()).flat_map(|subject| subject.sequence.surfaces());
        surfaces
            .map(|surface| {
                let faces = size_of_val(surface.faces().triangles());
                let frames = surface.frames().iter();
                faces
                    + frames
                        .map(|mesh| size_of_val(mesh.vertices()))
                        .sum::<usize>()
            })
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn read(id: &str) -> ReadSubject {
        let surface =
            SurfaceSequence::new(SurfaceKind::Cavity, vec![phantom::sphere(1, 30.0)]).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let subject = Subject::new(id, sequence, LengthUnit::Millimetre);
        (id.to_owned(), Some(Arc::new(subject)))
    }

    fn unread(ids: &str) -> Study {
        let unread = ids.chars().map(|id| UnreadSubject {
            id: id.to_string(),
            label: None,
            read_before: 0,
        });
        Study {
            unread: unread.collect(),
            ..Study::default()
        }
    }

    fn ids(study: &Study) -> String {
        study.subjects.iter().map(|s| s.id.as_str()).collect()
    }

    #[test]
    fn in_whichever_order_subjects_are_read_they_stand_in_the_order_of_the_input() {
        for order in ["abcdef", "fedcba", "dafbec", "ebacfd"] {
            let mut study = unread("abcdef");
            for (count, id) in order.chars().enumerate() {
                let before = study.clone();
                let revision = Revision(count as u64 + 1);
                let (with, index) = before.with_read(&[read(&id.to_string())], revision);
                for (old, &new) in index.iter().enumerate() {
                    assert!(Arc::ptr_eq(&before.subjects[old], &with.subjects[new]));
                }
                for unread in &with.unread {
                    let read = with.subjects.iter().filter(|s| s.id < unread.id);
                    assert_eq!(unread.read_before, read.count(), "{order}, {}", unread.id);
                }
                study = with;
            }
            assert_eq!(ids(&study), "abcdef");
            assert!(study.unread.is_empty());
        }
    }

    #[test]
    fn what_cannot_be_read_leaves_no_subject_and_what_is_of_no_row_is_ignored() {
        let study = unread("abc");
        let news = [read("b"), ("a".to_owned(), None), read("x")];
        let (study, _) = study.with_read(&news, Revision(7));
        assert_eq!((ids(&study).as_str(), study.unread.len()), ("b", 1));
        assert_eq!(study.unread[0].read_before, 1);
        assert_eq!(study.revision, Revision(7));
        let settled = study.without_unread(Revision(8));
        assert_eq!((ids(&settled).as_str(), settled.unread.len()), ("b", 0));
        assert!(settled.bytes() >= 42 * 24);
    }
}
