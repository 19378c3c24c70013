//! Bytes to study and study to bytes: one file per format of meshes, one folder per format of images.

mod binary_cursor;
mod contours;
mod csv_mesh;
mod data_files;
mod detect;
mod dicom;
mod formats;
mod gltf_file;
mod image_file;
mod image_formats;
#[cfg(test)]
mod image_samples;
mod image_source;
mod image_times;
mod limits;
mod mask_study;
mod mesh_draft;
mod mesh_file;
mod metaimage;
mod nifti;
mod nrrd;
mod obj;
mod open;
mod opened;
mod packed;
mod ply;
mod stl;
#[cfg(test)]
mod tests;
mod text_encoding;
mod text_lines;
mod voxels;
mod vtk_legacy;
mod vtp;
mod write_study;
mod xml;

pub use contours::{
    ContourStudy, ContourStudyError, ContouredImage, find_contour_studies, read_contours,
};
pub use detect::{read_mesh, read_mesh_with_siblings};
pub use dicom::{
    ContouredStructure, DicomReading, LeftOut, SliceSource, read_dicom, read_dicom_bytes,
};
pub use formats::{MeshFormat, mesh_file_endings, mesh_format_names, openable_extensions};
pub use image_file::{Gates, ImageSeries, Modality, Provenance, ReadImageError, neutral_name};
pub use image_formats::{image_format_names, is_image_head, read_image};
pub use image_source::Sibling;
pub use limits::{
    Limits, MAX_XML_ATTRIBUTES, MAX_XML_ATTRIBUTES_IN_ALL, MAX_XML_NAMESPACES, MAX_XML_NODES,
};
pub use mask_study::{
    MaskFacts, MaskFiles, MaskKind, MaskSeries, MaskStudyError, NamedLabels, find_mask_studies,
    is_mask_file, read_masks, united_notices,
};
pub use mesh_file::{MeshFile, ReadMeshError};
pub use obj::write_obj;
pub use open::{
    FoundImage, FramesRead, ImageReport, OpenListener, PassedOver, SubjectFrames, each_image,
    looks_like_image, looks_openable, open_paths, open_paths_in_stages, read_frames, read_head,
    read_image_file, read_images, read_images_beside, read_mesh_file, renew_cohort_notices,
};
pub use opened::{OpenError, Opened, OpenedImages};
pub use ply::write_ply;
pub use vtp::{write_pvd, write_vtp};
pub use write_study::{WriteStudyError, write_study};
