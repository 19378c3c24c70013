//! One way to ask: typed questions to a study, and the one store that answers them.

mod ask;
mod cell;
mod dependencies;
mod interrupted;
mod memory;
mod query;
mod queue;
mod shelf;
mod shelves;
#[expect(
    clippy::module_inception,
    reason = "the folder's main type carries the folder's name"
)]
mod store;
#[cfg(test)]
mod tests;
mod work;

pub use ask::Answered;
pub use dependencies::Dependencies;
pub use interrupted::{Failure, Interrupted, SharedError};
pub use memory::{Memory, configure_memory, default_budget};
pub use query::{Context, Query};
pub use queue::Urgency;
pub use shelves::FailedWork;
pub use store::{Showing, Store, StoreOptions};
