//! The store of answers: it runs a query once, shows how far it is, and keeps its answer within the memory budget.
//!
//! Begin with `query.rs` (what a query is) and `store.rs` (how panes and commands ask). `ask.rs` is how a running query
//! asks another one. A shelf holds the entries of one type of query, an entry one question with its slot, a slot the
//! answer or the work that is under way. `queue.rs` has the threads and their order.

mod ask;
mod dependencies;
mod interrupted;
mod memory;
mod query;
mod queue;
mod shelf;
mod shelves;
mod slot;
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
pub use interrupted::{Interrupted, SharedError};
pub use memory::{Memory, configure_memory, default_budget};
pub use query::{Context, Query};
pub use queue::Urgency;
pub use shelves::FailedWork;
pub use store::{Showing, Store, StoreOptions};
