//! DICOM by hand: small files that are written here, and the troubles that others had with such files.

mod attacks;
mod enhanced;
mod nuclear;
mod numbers;
mod stacks;
mod times;
mod words_of_patients;
mod writer;
mod zips;

pub(in crate::io) use enhanced::named_segmentation;
