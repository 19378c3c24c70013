//! Thickness of a wall given as voxels, by Laplace's equation.

use crate::progress::{Progress, Stopped};

use super::field_lines::line_lengths;
use super::label_grid::{LabelGrid, WallGraph};
use super::laplace::potential;

/// The potential in a wall of voxels and the lengths of its field lines.
#[derive(Clone, Debug)]
pub struct LaplaceField {
    /// Voxels of the wall, ascending, x fastest.
    pub voxels: Vec<u32>,
    /// Potential of each: 0 at the inner, 1 at the outer side.
    pub potential: Vec<f64>,
    /// Length of the field line through each, in coordinates; not a number where it reaches no side.
    pub thickness: Vec<f64>,
    /// Place of each voxel of the grid among those of the wall.
    pub(super) nodes: Vec<Option<u32>>,
}

/// Potential and thickness in every voxel of a wall of which only the labels are known, as of a
/// segmented image: sides run halfway between voxels.
///
/// Source: Jones, Buchbinder and Aharon (2000), Hum Brain Mapp 11, 12–32; Yezzi and Prince (2003), IEEE Trans
/// Med Imaging 22(10), 1332–1339.
///
/// # Errors
/// [`Stopped`] if asked to stop.
pub fn laplace_field(grid: &LabelGrid, progress: &Progress) -> Result<LaplaceField, Stopped> {
    field_of(grid.mask_graph(), progress)
}

/// The same of a wall whose sides are known exactly.
pub(super) fn field_of(graph: WallGraph, progress: &Progress) -> Result<LaplaceField, Stopped> {
    let potential = potential(&graph, progress)?;
    let thickness = line_lengths(&graph, &potential, progress)?;
    Ok(LaplaceField {
        voxels: graph.voxels,
        potential,
        thickness,
        nodes: graph.nodes,
    })
}
