//! Commands about work in the background and its errors.

use crate::engine::Topic;

/// Commands about work in the background and its errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WorkCommand {
    /// Compute what was cancelled or failed again.
    Retry(Topic),
    /// Stop background work.
    Cancel(Topic),
    /// Close an error card.
    DismissError(usize),
}
