//! Thickness of the wall per vertex, whichever way it was found.

use crate::numeric::median;
use crate::study::SurfaceKind;

/// A way of telling how thick the wall is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ThicknessMethod {
    /// Distance from a vertex of the inner side to the nearest point of the outer one.
    Nearest,
    /// Chords across the centre line between the contours of short-axis slices.
    Centreline,
    /// Length of the field line of Laplace's equation through the wall.
    Laplace,
    /// Volume of a piece of the wall over the mean of its inner and outer area.
    VolumeOverArea,
}

impl ThicknessMethod {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Nearest,
        Self::Centreline,
        Self::Laplace,
        Self::VolumeOverArea,
    ];

    /// The words for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nearest => "nearest distance",
            Self::Centreline => "centreline in slices",
            Self::Laplace => "Laplace field lines",
            Self::VolumeOverArea => "volume over area",
        }
    }
}

/// Thickness at each vertex of the wall's inner side at one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct ThicknessMap {
    /// How it was found.
    pub method: ThicknessMethod,
    /// The surface whose vertices these are.
    pub surface: SurfaceKind,
    /// Per vertex of that surface, in coordinates; `None` where the method gives none.
    pub thickness: Vec<Option<f64>>,
}

impl ThicknessMap {
    /// How many vertices have a thickness.
    pub fn count(&self) -> usize {
        self.thickness.iter().flatten().count()
    }

    /// Median of the thicknesses that are known, in coordinates.
    pub fn median(&self) -> Option<f64> {
        median(self.thickness.iter().flatten().copied().collect())
    }
}
