//! The cohort as one immutable value; an edit makes another with the next revision.

use std::sync::Arc;

use super::{LabelRole, LabelRoles, Subject};

/// Names one state of one study in this run of the program; results are keyed by it.
///
/// Whoever opens or edits a study gives it a number that was not used before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Revision(pub u64);

/// Subjects and the roles of their labels. Shared as `Arc<Study>`, never changed.
///
/// An index of a subject counts those of the cohort first, then those excluded from it.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// What the window's title bar says.
    pub name: String,
    /// The subjects of the cohort, in the order of the input: what every analysis of the cohort reads.
    pub subjects: Vec<Arc<Subject>>,
    /// Subjects that no analysis of the cohort counts, in the order of the input.
    pub excluded: Vec<ExcludedSubject>,
    /// What labels count as.
    pub label_roles: LabelRoles,
    /// Which edit this is.
    pub revision: Revision,
}

/// A subject that stays in the study and that no analysis of the cohort counts.
#[derive(Clone, Debug)]
pub struct ExcludedSubject {
    /// Its place among all subjects in the order of the input.
    pub place: usize,
    /// Who.
    pub subject: Arc<Subject>,
}

impl Study {
    /// The role of a subject's label.
    pub fn role(&self, subject: &Subject) -> LabelRole {
        self.label_roles.role(subject.label.as_deref())
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
}
