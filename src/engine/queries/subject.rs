//! The subject of a question by its index.

use crate::study::{Study, Subject};

/// A question names a subject that the study does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no subject {index} among {count}")]
pub struct NoSubject {
    /// The index that was asked for.
    pub index: usize,
    /// How many subjects there are.
    pub count: usize,
}

/// A subject of the study.
pub(super) fn subject_of(study: &Study, index: usize) -> Result<&Subject, NoSubject> {
    let subject = study.subject(index).map(|subject| &**subject);
    subject.ok_or(NoSubject {
        index,
        count: study.count(),
    })
}
