//! Bytes to study and results to files, one file per format, both ways.

mod binary_cursor;
mod csv_mesh;
mod detect;
mod experiment_csv;
mod experiment_json;
mod experiment_svg;
mod gltf_file;
mod limits;
mod medial_csv;
mod medial_experiment_csv;
mod medial_experiment_json;
mod medial_experiment_svg;
mod medial_map_csv;
mod mesh_draft;
mod mesh_file;
mod obj;
mod open;
mod opened;
mod ply;
mod report_csv;
mod report_json;
mod stl;
#[cfg(test)]
mod tests;
mod text_lines;
mod thickening_csv;
mod thickening_json;
mod verdict_csv;
mod verdict_json;
mod vtk_legacy;
mod vtp;
mod write_study;

pub use detect::{mesh_file_endings, read_mesh, read_mesh_with_siblings};
pub use experiment_csv::{
    comparison_csv, interpolation_csv, noise_csv, partners_csv, transfer_study_csv,
};
pub use experiment_json::{comparison_json, noise_json, partners_json};
pub use experiment_svg::noise_svg;
pub use limits::Limits;
pub use medial_csv::medial_csv;
pub use medial_experiment_csv::{localisation_csv, noise_medial_csv};
pub use medial_experiment_json::noise_medial_json;
pub use medial_experiment_svg::noise_medial_svg;
pub use medial_map_csv::{medial_map_json, medial_mds_csv};
pub use mesh_file::{MeshFile, ReadMeshError};
pub use obj::write_obj;
pub use open::{looks_openable, open_paths, read_head};
pub use opened::{OpenError, Opened};
pub use ply::write_ply;
pub use report_csv::{deformations_csv, distances_csv, frames_csv, poses_csv, subjects_csv};
pub use report_json::{classification_json, deformations_json, subjects_json, summary_json};
pub use thickening_csv::{
    AssessedWall, atoms_csv, atoms_csv_header, patches_csv, patches_csv_header, segments_csv,
    segments_csv_header,
};
pub use thickening_json::{thickening_params_json, unassessed_wall_json, wall_json};
pub use verdict_csv::verdicts_csv;
pub use verdict_json::verdicts_json;
pub use vtp::{write_pvd, write_vtp};
pub use write_study::{MeshFormat, WriteStudyError, write_study};
