//! VTK XML PolyData (`.vtp`): reading text, base64 and raw arrays, zlib or plain; writing; and
//! `.pvd` lists of files over time.
//!
//! The reader is our own, on roxmltree, flate2 and base64: the crate for the format panics on
//! damaged arrays and names neither line nor byte.
//!
//! Order of checks, for a file that is refused: size, packing and format in `io/detect.rs`; the appended section is cut off in
//! `appended.rs`, so that its bytes are no text; the encoding of the rest in `io/text_encoding.rs`; elements and attributes in
//! `io/xml.rs`, before it is parsed; the root in `read.rs`; each array in `array.rs` and `encoded.rs`.

mod appended;
mod array;
mod base64_stream;
mod encoded;
mod file;
mod read;
mod write;

pub(super) use read::read_vtp;
pub use write::{write_pvd, write_vtp};
