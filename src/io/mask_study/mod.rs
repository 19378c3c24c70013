//! Masks of a cohort on disk: folders such as `patient001/patient001_frame01_gt.nii.gz` with or without an `Info.cfg`, and pairs
//! `NAME_endo.nii.gz`, `NAME_epi.nii.gz`.

mod find;
mod info;
mod name;
mod read;
mod segmentation;
#[cfg(test)]
mod tests;
mod united;

pub use find::{MaskFiles, MaskKind, find_mask_studies, is_mask_file};
pub use info::MaskFacts;
pub(in crate::io) use name::is_mask_name;
pub use read::{MaskSeries, MaskStudyError, read_masks};
pub use segmentation::NamedLabels;
pub use united::united_notices;
