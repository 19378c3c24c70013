//! Edits of a study, each of which makes another one: who belongs to it, and what its labels are.

use std::collections::HashSet;
use std::sync::Arc;

use super::study::ExcludedSubject;
use super::{LabelClass, Notice, Revision, Study, Subject, plain_label};

/// Why a study was not edited.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// Who belongs to the study is not known yet.
    #[error("the study is still being read")]
    StillReading,
    /// There is no such subject.
    #[error("there is no such subject in the study")]
    NoSubject,
    /// A cohort has subjects.
    #[error("{id} is the only subject of the cohort")]
    LastSubject {
        /// Its id.
        id: String,
    },
    /// An id names a subject.
    #[error("an id cannot be empty")]
    EmptyId,
    /// Two subjects of one id could not be distinguished.
    #[error("another subject has the id {id}")]
    TakenId {
        /// The id.
        id: String,
    },
}

impl Study {
    /// The same study with one subject changed, as another revision.
    pub fn with_subject(&self, index: usize, subject: Subject, revision: Revision) -> Self {
        self.with_subjects(vec![(index, subject)], revision)
    }

    /// The same study with some subjects changed, by their indices.
    pub fn with_subjects(&self, changed: Vec<(usize, Subject)>, revision: Revision) -> Self {
        let mut edited = self.revised(revision);
        let count = edited.subjects.len();
        for (index, subject) in changed {
            if let Some(place) = edited.subjects.get_mut(index) {
                *place = Arc::new(subject);
            } else if let Some(excluded) = edited.excluded.get_mut(index - count) {
                excluded.subject = Arc::new(subject);
            }
        }
        edited
    }

    /// The study with a subject of the cohort excluded from it; its place in the order stays.
    ///
    /// # Errors
    /// If there is no such subject in the cohort, or no other.
    pub fn excluding(&self, index: usize, revision: Revision) -> Result<Self, EditError> {
        self.is_read()?;
        let subject = self.subjects.get(index).ok_or(EditError::NoSubject)?;
        self.others_than(index, subject)?;
        let place = self.place_of(index);
        let mut edited = self.revised(revision);
        edited.excluded.push(ExcludedSubject {
            place,
            subject: edited.subjects.remove(index),
        });
        edited.excluded.sort_by_key(|excluded| excluded.place);
        Ok(edited)
    }

    /// The study with an excluded subject in the cohort again, where it was.
    ///
    /// # Errors
    /// If no excluded subject has this index.
    pub fn including(&self, index: usize, revision: Revision) -> Result<Self, EditError> {
        self.is_read()?;
        let nth = index.checked_sub(self.subjects.len());
        let nth = nth.filter(|nth| *nth < self.excluded.len());
        let nth = nth.ok_or(EditError::NoSubject)?;
        let mut edited = self.revised(revision);
        let excluded = edited.excluded.remove(nth);
        // All excluded ones before it in their list are before it in the order.
        let at = excluded.place - nth;
        edited
            .subjects
            .insert(at.min(edited.subjects.len()), excluded.subject);
        Ok(edited)
    }

    /// The study without a subject.
    ///
    /// # Errors
    /// If there is no such subject, or it is the only one of the cohort.
    pub fn removing(&self, index: usize, revision: Revision) -> Result<Self, EditError> {
        self.is_read()?;
        let subject = self.subject(index).ok_or(EditError::NoSubject)?;
        let place = self.place_of(index);
        let mut edited = self.revised(revision);
        if self.is_excluded(index) {
            edited.excluded.remove(index - self.subjects.len());
        } else {
            self.others_than(index, subject)?;
            edited.subjects.remove(index);
        }
        for excluded in edited
            .excluded
            .iter_mut()
            .filter(|other| other.place > place)
        {
            excluded.place -= 1;
        }
        Ok(edited)
    }

    /// The study with the subjects of another one after its own; who has an id that is taken gets a number, and a note
    /// says so. What labels count as is taken over for labels that this study has no class for.
    pub fn adding(&self, other: &Study, revision: Revision) -> Self {
        let mut edited = self.revised(revision);
        let mut taken: HashSet<String> = self.all().map(|subject| subject.id.clone()).collect();
        let count = self.count();
        for (place, index) in (count..).zip(other.in_order()) {
            let Some(added) = other.subject(index) else {
                continue;
            };
            let subject = with_free_id(added, &mut taken);
            if other.is_excluded(index) {
                edited.excluded.push(ExcludedSubject { place, subject });
            } else {
                edited.subjects.push(subject);
            }
        }
        let theirs = &other.label_classes;
        for (labels, class) in [
            (&theirs.normal, LabelClass::Normal),
            (&theirs.abnormal, LabelClass::Abnormal),
        ] {
            for label in labels {
                if self.label_classes.class_of(Some(label)) == LabelClass::Neither {
                    edited.label_classes.set(label, class);
                }
            }
        }
        edited
    }

    /// Whether a subject may have an id, blanks around it apart.
    ///
    /// # Errors
    /// If the id is empty, or another subject has it.
    pub fn check_id(&self, index: usize, id: &str) -> Result<(), EditError> {
        let id = id.trim();
        if id.is_empty() {
            return Err(EditError::EmptyId);
        }
        let unread = self.unread.iter().any(|unread| unread.id == id);
        match self.index_of(id) {
            _ if unread => Err(EditError::TakenId { id: id.to_owned() }),
            Some(other) if other != index => Err(EditError::TakenId { id: id.to_owned() }),
            _ => Ok(()),
        }
    }

    /// The study with these subjects labelled; an empty label is none. A label that differs from another one only in
    /// letter case or blanks is that one.
    pub fn labelling(&self, indices: &[usize], label: &str, revision: Revision) -> Self {
        let label = Some(label.trim()).filter(|label| !label.is_empty());
        let label = label.map(|label| self.spelling(label, indices));
        let labelled = indices.iter().filter_map(|&index| {
            let mut subject = Subject::clone(self.subject(index)?);
            subject.label.clone_from(&label);
            Some((index, subject))
        });
        self.with_subjects(labelled.collect(), revision)
    }

    /// The labels of the study, each once, in the order of their letters.
    pub fn labels(&self) -> Vec<&str> {
        let mut labels: Vec<&str> = self.all().filter_map(|s| s.label.as_deref()).collect();
        labels.sort_unstable();
        labels.dedup();
        labels
    }

    /// The study with another class for a label.
    pub fn with_class(&self, label: &str, class: LabelClass, revision: Revision) -> Self {
        let mut edited = self.revised(revision);
        edited.label_classes.set(label, class);
        edited
    }

    fn is_read(&self) -> Result<(), EditError> {
        match self.unread.is_empty() {
            true => Ok(()),
            false => Err(EditError::StillReading),
        }
    }

    fn revised(&self, revision: Revision) -> Self {
        Self {
            revision,
            ..self.clone()
        }
    }

    fn others_than(&self, index: usize, subject: &Subject) -> Result<(), EditError> {
        match self.subjects.len() {
            1 if index == 0 => Err(EditError::LastSubject {
                id: subject.id.clone(),
            }),
            _ => Ok(()),
        }
    }

    /// Place of a subject among all, in the order of the input.
    fn place_of(&self, index: usize) -> usize {
        let order = self.in_order();
        order
            .iter()
            .position(|other| *other == index)
            .unwrap_or(index)
    }

    /// How the lists of the study or its other subjects spell a label.
    fn spelling(&self, label: &str, but: &[usize]) -> String {
        let lists = [&self.label_classes.normal, &self.label_classes.abnormal];
        let of_lists = lists.into_iter().flatten().map(String::as_str);
        let others = self
            .all()
            .enumerate()
            .filter(|(index, _)| !but.contains(index));
        let of_others = others.filter_map(|(_, subject)| subject.label.as_deref());
        let plain = plain_label(label);
        let known = of_lists
            .chain(of_others)
            .find(|known| plain_label(known) == plain);
        known.unwrap_or(label).to_owned()
    }
}

/// A subject with its id, or with a number behind it where that is taken.
fn with_free_id(subject: &Arc<Subject>, taken: &mut HashSet<String>) -> Arc<Subject> {
    if taken.insert(subject.id.clone()) {
        return Arc::clone(subject);
    }
    let free = (2..).map(|number| format!("{} ({number})", subject.id));
    let mut named = Subject::clone(subject);
    named.id = { free }
        .find(|id| taken.insert(id.clone()))
        .unwrap_or_default();
    let text = format!(
        "the study had a subject {:?} already: this one is shown as {:?}",
        subject.id, named.id
    );
    named.notices.insert(0, Notice::warning(text));
    Arc::new(named)
}

#[cfg(test)]
mod tests;
