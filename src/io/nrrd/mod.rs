//! NRRD: volumes and sequences of volumes of 3D Slicer, with the values in the same file or beside it.

mod axes;
mod header;
mod read;
mod space;
#[cfg(test)]
mod tests;
mod values;

pub(super) use header::recognises;
pub(super) use read::read_nrrd;
