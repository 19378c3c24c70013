//! All settings of an import, in one value.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Road;
use super::settings_file::SettingsFile;
use crate::image::{Contour, MarkedPoints, VolumeEdit};

/// How the walls of one image, or of a batch of images, are made. What the window's document holds and undo restores.
///
/// As JSON or TOML it is a table of names, as `mesh` writes it beside its output; reading one checks its ranges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "SettingsFile", into = "SettingsFile")]
pub struct Preparation {
    /// How walls are found.
    pub road: Road,
    /// Distances between voxels along i, j and k in millimetres, typed because the file does not say them or says them wrong.
    pub spacing_mm: Option<[f64; 3]>,
    /// Times of the volumes, typed because the file does not say them.
    pub times: Option<TypedTimes>,
    /// Standard deviation of the blur before the threshold, in millimetres; 0 for none. SPECT and the preview of its surface.
    pub blur_mm: f64,
    /// What is bright, as a share of the maximum of each volume; `None`: as the road chooses. SPECT and its preview.
    pub threshold: Option<f64>,
    /// What is taken away or kept before a surface is made, in this order.
    pub edits: Vec<VolumeEdit>,
    /// Points that somebody marked.
    pub points: MarkedPoints,
    /// Outlines that somebody drew or dragged; they win over those that are found.
    pub contours: Arc<Vec<Contour>>,
    /// Vertices of each surface at most.
    pub vertices: usize,
    /// What becomes of the base.
    pub base: BaseEnd,
    /// Whether slices that stand beside their neighbours (another breath-hold) are put back.
    pub correct_shifts: bool,
}

/// What becomes of the surfaces at the plane of the valve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BaseEnd {
    /// They end there in a boundary, as the method has it.
    #[default]
    Open,
    /// Each is closed by a lid.
    Closed,
}

impl BaseEnd {
    /// The word for it in files and options.
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Closed => "closed",
        }
    }
}

/// Times of volumes as somebody types them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TypedTimes {
    /// Of each volume, in milliseconds after the R wave.
    Each(Vec<f64>),
    /// The length of the beat in milliseconds: the volumes are equal parts of it, and the first begins at the R wave.
    Cycle(f64),
}

/// Standard deviation of the blur by default, in millimetres: counts of single voxels are noisy, and the wall of a heart in
/// SPECT is some 20 mm wide.
const BLUR_MM: f64 = 3.0;
/// Greatest blur: wider than a heart, nothing is left to be seen.
const MAX_BLUR_MM: f64 = 50.0;

/// A setting that cannot be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// Distances between voxels.
    #[error("the distance {0} mm between voxels is not a number above 0 and up to 100")]
    Spacing(f64),
    /// Times of volumes.
    #[error("times of volumes must be increasing numbers of milliseconds")]
    Times,
    /// The length of a beat.
    #[error("a beat of {0} ms; 100 to 10000 are possible")]
    Cycle(f64),
    /// The blur.
    #[error("a blur of {0} mm; 0 to {MAX_BLUR_MM} are possible")]
    Blur(f64),
    /// The threshold.
    #[error("the threshold {0} is not between 0 and 1: it is a share of the maximum")]
    Threshold(f64),
    /// A marked point, an edit or an outline.
    #[error("{0} has coordinates that are not numbers, or no size")]
    Geometry(&'static str),
    /// A number of vertices that walls cannot have.
    #[error(transparent)]
    Walls(#[from] crate::analysis::walls_from_masks::WallParamsError),
}

impl Preparation {
    /// The settings of a road by default.
    pub fn of_road(road: Road) -> Self {
        let walls = crate::analysis::walls_from_masks::WallParams::default();
        Self {
            road,
            spacing_mm: None,
            times: None,
            blur_mm: BLUR_MM,
            threshold: None,
            edits: Vec::new(),
            points: MarkedPoints::default(),
            contours: Arc::default(),
            vertices: walls.vertices,
            base: BaseEnd::default(),
            correct_shifts: walls.correct_shifts,
        }
    }
}

impl Default for Preparation {
    fn default() -> Self {
        Self::of_road(Road::ALL[0])
    }
}
