//! The cohort as one immutable value; an edit makes another with the next revision.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::label::plain_label;
use super::{LabelRole, LabelRoles, Subject};

/// Names one state of one study in this run of the program; results are keyed by it.
///
/// Whoever opens or edits a study gives it a number that was not used before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Revision(pub u64);

/// Subjects and the roles of their labels. Shared as `Arc<Study>`, never changed.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// What the window's title bar says.
    pub name: String,
    /// The subjects, in the order of the input.
    pub subjects: Vec<Arc<Subject>>,
    /// What labels count as.
    pub label_roles: LabelRoles,
    /// Which edit this is.
    pub revision: Revision,
}

impl Study {
    /// The role of a subject's label.
    pub fn role(&self, subject: &Subject) -> LabelRole {
        self.label_roles.role(subject.label.as_deref())
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
        let has = |role| {
            self.subjects
                .iter()
                .any(|subject| self.role(subject) == role)
        };
        has(LabelRole::Normal) && has(LabelRole::Abnormal)
    }

    /// Index of the subject with this id.
    pub fn index_of(&self, id: &str) -> Option<usize> {
        self.subjects.iter().position(|subject| subject.id == id)
    }

    /// The same study with one subject changed, as another revision.
    pub fn with_subject(&self, index: usize, subject: Subject, revision: Revision) -> Self {
        let mut subjects = self.subjects.clone();
        if let Some(place) = subjects.get_mut(index) {
            *place = Arc::new(subject);
        }
        Self {
            name: self.name.clone(),
            subjects,
            label_roles: self.label_roles.clone(),
            revision,
        }
    }
}
