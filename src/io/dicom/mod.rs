//! DICOM: files, folders and archives of slices to volumes that stand in the patient.
//!
//! Elements are parsed here, not by a crate: `dicom-object` 0.10 takes as much memory as a file states (3 GiB for a
//! file of 249 bytes whose text says that it is so long), and its codecs copy beyond their target when a stream is damaged.

mod assembly;
mod codecs;
mod contents;
mod contours;
mod element;
mod file;
mod functional_groups;
mod group;
mod instants;
mod join;
mod jpeg_ls;
mod jpeg_ls_bits;
mod jpeg_ls_head;
mod layout;
mod nuclear;
mod nuclear_grid;
mod pixels;
mod plane;
mod read;
mod reading;
mod rle;
mod segmentation;
mod segments;
mod series;
mod sources;
mod sources_of_slices;
mod stack;
mod tag;
#[cfg(test)]
pub(super) mod tests;

pub use contours::ContouredStructure;
pub(super) use file::looks_like_dicom;
pub use read::{read_dicom, read_dicom_bytes};
pub use reading::{DicomReading, LeftOut};
pub(super) use segments::{is_segmentation_head, segment_parts};
pub use sources_of_slices::SliceSource;
