//! A series of images as a part of a question: the same one, not one with equal values.

use std::fmt;
use std::sync::Arc;

use crate::analysis::preparation::PreparationError;
use crate::engine::store::Interrupted;
use crate::io::ImageSeries;

/// A series, compared by identity.
#[derive(Clone)]
pub struct SeriesRef(pub Arc<ImageSeries>);

impl PartialEq for SeriesRef {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for SeriesRef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.name)
    }
}

/// An error of a preparation: a stop is one, however it is wrapped.
pub(super) fn interrupted(error: PreparationError) -> Interrupted {
    match error {
        PreparationError::Stopped(_) => Interrupted::Stopped,
        error => error.into(),
    }
}
