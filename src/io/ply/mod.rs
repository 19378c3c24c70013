//! PLY (Stanford polygon format): text and binary of both byte orders, reading and writing.
//!
//! The reader is our own: the crates for it reserve memory by the header's counts and name
//! neither line nor byte.

mod body;
mod header;
mod read;
mod write;

pub(super) use read::read_ply;
pub use write::write_ply;
