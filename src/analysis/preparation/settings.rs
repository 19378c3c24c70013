//! All settings of an import, in one value.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Road;
use crate::analysis::walls_from_masks::{WallParams, WallParamsError};
use crate::analysis::walls_from_spect::{SpectParams, SpectParamsError};
use crate::image::{Contour, MarkedPoints, VolumeEdit, VolumeEditError};
use crate::mesh::Point3;

/// How the walls of one image, or of a batch of images, are made. What the window's document holds and undo restores.
///
/// As JSON or TOML it is a table of names, as `mesh` writes it beside its output; reading one checks its ranges.
#[derive(Clone, Debug, PartialEq)]
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

/// Greatest blur: beyond, the walls on both sides of the cavity flow together.
const MAX_BLUR_MM: f64 = 20.0;

/// A setting that cannot be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// Distances between voxels.
    #[error(
        "the distance {0} mm between voxels is not a number above 0 and up to {MAX_SPACING_MM}"
    )]
    Spacing(f64),
    /// Times of volumes.
    #[error("times of volumes must be increasing numbers of milliseconds")]
    Times,
    /// The length of a beat.
    #[error("a beat of {0} ms; {least} to {most} are possible", least = CYCLE_MS[0], most = CYCLE_MS[1])]
    Cycle(f64),
    /// The blur.
    #[error("a blur of {0} mm; 0 to {MAX_BLUR_MM} are possible")]
    Blur(f64),
    /// The threshold.
    #[error("the threshold {0} is not between 0 and 1: it is a share of the maximum")]
    Threshold(f64),
    /// An edit.
    #[error(transparent)]
    Edit(#[from] VolumeEditError),
    /// A marked point or an outline.
    #[error("{0} has coordinates that are not numbers, or fewer than three corners")]
    Geometry(&'static str),
    /// A number of vertices that walls cannot have.
    #[error(transparent)]
    Walls(#[from] WallParamsError),
    /// A setting of SPECT.
    #[error(transparent)]
    Spect(#[from] SpectParamsError),
}

impl Preparation {
    /// The settings of a road by default.
    pub fn of_road(road: Road) -> Self {
        let walls = WallParams::default();
        Self {
            road,
            spacing_mm: None,
            times: None,
            blur_mm: SpectParams::default().blur_mm,
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

/// Distances between voxels: a mistake in the unit lies beyond.
const MAX_SPACING_MM: f64 = 100.0;
/// Lengths of a beat: 6 to 600 beats a minute.
const CYCLE_MS: [f64; 2] = [100.0, 10_000.0];

impl Preparation {
    /// Checks all ranges; what was read from a file is in them.
    ///
    /// # Errors
    /// With the first setting that cannot be.
    pub fn check(&self) -> Result<(), SettingsError> {
        let spacing = self.spacing_mm.iter().flatten().copied();
        let possible = |mm: &f64| *mm > 0.0 && *mm <= MAX_SPACING_MM;
        if let Some(wrong) = spacing.clone().find(|mm| !possible(mm)) {
            return Err(SettingsError::Spacing(wrong));
        }
        self.check_times()?;
        if !(0.0..=MAX_BLUR_MM).contains(&self.blur_mm) {
            return Err(SettingsError::Blur(self.blur_mm));
        }
        if let Some(wrong) = self
            .threshold
            .filter(|share| !(*share > 0.0 && *share < 1.0))
        {
            return Err(SettingsError::Threshold(wrong));
        }
        for (number, edit) in (1..).zip(&self.edits) {
            edit.check(number)?;
        }
        let points = self.points;
        let marked = [points.apex, points.base, points.septum, points.blood];
        if !marked.iter().flatten().all(is_finite) {
            return Err(SettingsError::Geometry("a marked point"));
        }
        let is_outline = |c: &Contour| c.points.len() >= 3 && c.points.iter().all(is_finite);
        if !self.contours.iter().all(is_outline) {
            return Err(SettingsError::Geometry("an outline"));
        }
        self.wall_params().check()?;
        self.spect_params().check()?;
        Ok(())
    }

    fn check_times(&self) -> Result<(), SettingsError> {
        match &self.times {
            None => Ok(()),
            Some(TypedTimes::Cycle(ms)) if (CYCLE_MS[0]..=CYCLE_MS[1]).contains(ms) => Ok(()),
            Some(TypedTimes::Cycle(ms)) => Err(SettingsError::Cycle(*ms)),
            Some(TypedTimes::Each(times)) => {
                let increasing = times.windows(2).all(|pair| pair[0] < pair[1]);
                match increasing && times.iter().all(|ms| ms.is_finite()) {
                    true => Ok(()),
                    false => Err(SettingsError::Times),
                }
            }
        }
    }

    /// The settings of SPECT among them.
    pub(super) fn spect_params(&self) -> SpectParams {
        let usual = SpectParams::default();
        SpectParams {
            blur_mm: self.blur_mm,
            threshold: self.threshold.unwrap_or(usual.threshold),
            ..usual
        }
    }

    /// The settings of the surfaces among them.
    pub(super) fn wall_params(&self) -> WallParams {
        WallParams {
            vertices: self.vertices,
            correct_shifts: self.correct_shifts,
            septum: self.points.septum,
        }
    }
}

fn is_finite(point: &Point3) -> bool {
    point.coords.iter().all(|x| x.is_finite())
}

impl Default for Preparation {
    fn default() -> Self {
        Self::of_road(Road::ALL[0])
    }
}
