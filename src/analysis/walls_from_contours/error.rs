//! What can be wrong with contours.

use std::fmt;

use crate::analysis::walls_from_masks::MaskError;
use crate::image::{Contour, ContourPart, FrameError};

/// Which contour is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContourName {
    /// Its place in the list, from 0.
    pub contour: usize,
    /// Its instant, from 0.
    pub instant: usize,
    /// What it goes around.
    pub part: ContourPart,
}

impl ContourName {
    /// The contour at a place of a list.
    pub(super) fn of(contour: usize, of: &Contour) -> Self {
        Self {
            contour,
            instant: of.instant,
            part: of.part,
        }
    }
}

impl fmt::Display for ContourName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = part_name(self.part);
        write!(f, "the contour of the {part} at instant {}", self.instant)
    }
}

/// A part as sentences name it.
pub(super) fn part_name(part: ContourPart) -> &'static str {
    match part {
        ContourPart::Endocardium => "endocardium",
        ContourPart::Epicardium => "epicardium",
        ContourPart::RightCavity => "right ventricle",
    }
}

/// Why contours make no masks. Instants are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContourError {
    /// There is none.
    #[error("there are no contours")]
    Empty,
    /// A contour is of an instant that the image does not have.
    #[error("{which}: there are {instants} instants")]
    Instant {
        /// Which contour.
        which: ContourName,
        /// Instants of the image.
        instants: usize,
    },
    /// Fewer than three corners, all on one line, or one that is not a number.
    #[error("{0} encloses no area")]
    NoArea(ContourName),
    /// Its corners do not lie in a plane of slices.
    #[error(
        "{which} is not parallel to the slices: its corners lie {off_mm:.1} mm apart across them"
    )]
    Oblique {
        /// Which contour.
        which: ContourName,
        /// Extent across the slices.
        off_mm: f64,
    },
    /// It lies in a plane between two slices.
    #[error(
        "{which} lies {off_mm:.1} mm beside the nearest slice, and slices are {step_mm:.1} mm apart"
    )]
    BetweenSlices {
        /// Which contour.
        which: ContourName,
        /// Distance of its plane from that of the nearest slice.
        off_mm: f64,
        /// Distance of slices.
        step_mm: f64,
    },
    /// It lies outside of the image.
    #[error("{0} lies outside of the image")]
    Outside(ContourName),
    /// It does not enclose the middle of the cavity in its slice.
    #[error("{0} does not go around the middle of the cavity, so that no epicardium can be added")]
    NotAround(ContourName),
    /// The contours reach over more voxels than masks may have, even without a finer grid.
    #[error("the contours reach over {voxels} voxels; at most {most} are possible")]
    TooLarge {
        /// Voxels over all instants.
        voxels: u64,
        /// The limit.
        most: u64,
    },
    /// Without an image, contours must stand in parallel planes at even distances.
    #[error("{0}")]
    NoStack(String),
    /// Nothing says where the epicardium is at any instant.
    #[error("no contour of the epicardium at any instant, so there is no wall")]
    NoEpicardium,
    /// The numbers of the grid are none.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The masks are none.
    #[error(transparent)]
    Masks(#[from] MaskError),
}
