//! Results as rows with columns: tables, JSON and a dictionary of columns for scripts; headings, units and digits for
//! panes, figures and the report.

mod analysis;
mod assessed_wall;
mod atoms;
mod cell_text;
mod column;
mod dictionary;
mod experiment_json;
mod experiments;
mod fits;
mod maps;
mod measures;
mod medial_atoms;
mod medial_experiment_json;
mod medial_experiments;
mod npy;
mod parameter_words;
mod patch_segments;
mod patches;
#[cfg(test)]
mod row_tests;
mod segments;
mod shared;
mod summary;
mod table;
#[cfg(test)]
mod testing;
mod verdict_json;
mod verdicts;
mod vertex_curvatures;
mod wall_json;
#[cfg(test)]
mod wall_tests;

pub use analysis::AnalysisReport;
pub use assessed_wall::AssessedWall;
pub use atoms::AtomRow;
pub use column::{Cell, Column, ColumnWords, Digits, NO_VALUE, Unit};
pub use dictionary::{all_columns_md, all_tables, columns_md};
pub use experiment_json::{comparison_json, noise_json, partners_json};
pub use experiments::NoiseRow;
pub use fits::FitRow;
pub use maps::{
    DeformationRow, MedialPoseRow, PoseRow, coordinates_csv, distances_csv, distances_json,
};
pub use measures::{FrameRow, SubjectRow, subjects_json};
pub use medial_atoms::MedialAtomRow;
pub use medial_experiment_json::noise_medial_json;
pub use npy::{npy_header, npy_row};
pub use parameter_words::{medial_words, thickening_words};
pub use patch_segments::PatchSegmentRow;
pub use patches::PatchRow;
pub use segments::SegmentRow;
pub use summary::beat_shares_json;
pub use table::{Row, TableWords, csv, csv_header, csv_rows, named_csv, pretty_json};
pub use verdicts::VerdictRow;
pub use vertex_curvatures::VertexCurvatureRow;
pub use wall_json::{thickening_params_json, unassessed_wall_json, wall_json};
