//! What do other ways of measuring say about the thickness of the wall? For comparison with twice the
//! medial radius, and as a check on it.

mod centreline;
mod contour;
mod error;
mod field_lines;
mod label_grid;
mod laplace;
mod laplace_field;
mod measure;
mod nearest;
mod params;
mod result;
mod spread;
#[cfg(test)]
mod tests;
mod volume_over_area;
mod wall_voxels;

pub use error::ThicknessError;
pub use label_grid::{LabelGrid, VoxelLabel};
pub use laplace_field::{LaplaceField, laplace_field};
pub use measure::{all_methods, thickness};
pub use params::{CheckedThicknessParams, ThicknessParams};
pub use result::{ThicknessMap, ThicknessMethod};
pub use spread::{Agreement, ThicknessSpread};
pub use volume_over_area::mean_wall_thickness;
