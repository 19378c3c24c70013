//! Why masks give no walls.

use crate::mesh::MeshError;
use crate::progress::Stopped;
use crate::study::SequenceError;

/// Why the values of images are not the masks of a ventricle.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaskError {
    /// No voxel of any instant has the label.
    #[error("no voxel has label {label} ({tissue}); labels that occur: {}", listed(.present))]
    LabelAbsent {
        /// The value that was looked for.
        label: i32,
        /// What it stands for.
        tissue: &'static str,
        /// Values that occur, ascending; the first sixteen.
        present: Vec<i32>,
    },
    /// Two tissues were given one label.
    #[error("label {label} stands for two tissues")]
    LabelTwice {
        /// The value.
        label: i32,
    },
    /// Two masks that belong together lie on different grids.
    #[error("the grids of the masks differ (instant {instant}): {}", two_sizes(.sizes))]
    GridsDiffer {
        /// The first instant whose grid is another.
        instant: usize,
        /// The sizes of the first grid and of that one.
        sizes: [[usize; 3]; 2],
    },
    /// Two masks that belong together have different numbers of instants.
    #[error("endo has {endo} instants, epi {epi}")]
    InstantsDiffer {
        /// Instants of the mask of the cavity.
        endo: usize,
        /// Instants of the mask of the whole ventricle.
        epi: usize,
    },
    /// There is nothing to look at.
    #[error("there is no mask")]
    Empty,
}

fn listed(labels: &[i32]) -> String {
    match labels {
        [] => "none".to_owned(),
        _ => labels
            .iter()
            .map(i32::to_string)
            .collect::<Vec<_>>()
            .join(", "),
    }
}

fn two_sizes([a, b]: &[[usize; 3]; 2]) -> String {
    let size = |s: &[usize; 3]| format!("{}×{}×{}", s[0], s[1], s[2]);
    if a == b {
        format!("{} at two positions", size(a))
    } else {
        format!("{} and {}", size(a), size(b))
    }
}

/// Why the masks of a subject give no walls.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WallError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// One frame cannot be made, so that there is no sequence in correspondence.
    #[error("frame {frame}: {reason}")]
    Frame {
        /// Which, from 0.
        frame: usize,
        /// Why not.
        reason: FrameWallError,
    },
    /// The meshes make no sequence.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}

/// Why the masks of one instant give no wall.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrameWallError {
    /// No voxel is cavity.
    #[error("the cavity is empty")]
    NoCavity,
    /// No voxel is wall.
    #[error("the wall is empty")]
    NoWall,
    /// In no slice does the wall lie around most of the cavity.
    #[error(
        "in no slice does the wall enclose more than half of the cavity (at best {} %); are the labels right?",
        (100.0 * .share).round()
    )]
    NotEnclosed {
        /// The greatest enclosed share of the cavity's outline.
        share: f64,
    },
    /// A surface cannot be made from so few slices.
    #[error("{slices} {} with {tissue} below the base; at least {needed} are needed", slice_word(*.slices))]
    FewSlices {
        /// What is looked for in the slices.
        tissue: &'static str,
        /// How many there are.
        slices: usize,
        /// How many there must be.
        needed: usize,
    },
    /// The surface would have to be made much larger or smaller to have the volume of the mask.
    #[error("a smooth {surface} holds {mesh_ml:.1} ml where the mask has {mask_ml:.1} ml")]
    Volume {
        /// Which surface.
        surface: &'static str,
        /// Volume of the surface before correction.
        mesh_ml: f64,
        /// Volume of the mask.
        mask_ml: f64,
    },
    /// The slices do not determine a smooth surface.
    #[error("the slices do not determine a smooth {surface}")]
    Undetermined {
        /// Which surface.
        surface: &'static str,
    },
    /// A coordinate is not a finite number.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

fn slice_word(count: usize) -> &'static str {
    if count == 1 { "slice" } else { "slices" }
}
