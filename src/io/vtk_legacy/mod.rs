//! Legacy VTK files (`.vtk`): surfaces from PolyData and from UnstructuredGrid, text and binary.
//!
//! The reader is our own: the crate for the format names neither line nor byte, and reserves
//! memory by the header's counts.

mod cells;
mod cursor;
mod read;
mod skip;

pub(super) use read::{is_legacy_header, read_vtk_legacy};
