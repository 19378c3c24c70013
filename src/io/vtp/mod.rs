//! VTK XML PolyData (`.vtp`): reading text, base64 and raw arrays, zlib or plain; writing; and
//! `.pvd` lists of files over time.
//!
//! The reader is our own, on roxmltree, flate2 and base64: the crate for the format panics on
//! damaged arrays and names neither line nor byte.

mod appended;
mod array;
mod base64_stream;
mod encoded;
mod read;
mod write;

pub(super) use read::read_vtp;
pub use write::{write_pvd, write_vtp};
