//! Shared values that are compared by which they are, not by what they hold.

use std::sync::Arc;

/// A shared value that is equal only to itself.
#[derive(Debug)]
pub struct Same<T>(pub Arc<T>);

impl<T> Same<T> {
    /// Holds a value that may be absent.
    pub fn of(value: Option<&Arc<T>>) -> Option<Self> {
        value.map(|value| Self(Arc::clone(value)))
    }
}

impl<T> Clone for Same<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
