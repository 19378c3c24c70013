//! Bytes to study and study to bytes: one file per format of meshes.

mod binary_cursor;
mod csv_mesh;
mod detect;
mod formats;
mod gltf_file;
mod limits;
mod mesh_draft;
mod mesh_file;
mod obj;
mod open;
mod opened;
mod ply;
mod stl;
#[cfg(test)]
mod tests;
mod text_encoding;
mod text_lines;
mod vtk_legacy;
mod vtp;
mod write_study;
mod xml;

pub use detect::{read_mesh, read_mesh_with_siblings};
pub use formats::{MeshFormat, mesh_file_endings, mesh_format_names, openable_extensions};
pub use limits::{
    Limits, MAX_XML_ATTRIBUTES, MAX_XML_ATTRIBUTES_IN_ALL, MAX_XML_NAMESPACES, MAX_XML_NODES,
};
pub use mesh_file::{MeshFile, ReadMeshError};
pub use obj::write_obj;
pub use open::{
    OpenListener, looks_openable, open_paths, open_paths_in_stages, read_head, read_mesh_file,
    renew_cohort_notices,
};
pub use opened::{OpenError, Opened};
pub use ply::write_ply;
pub use vtp::{write_pvd, write_vtp};
pub use write_study::{WriteStudyError, write_study};
