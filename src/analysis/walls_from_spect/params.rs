//! Settings of walls from gated SPECT.

use serde::{Deserialize, Serialize};

/// How the values of a file lie in space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SpectGrid {
    /// Whatever the image shows: turned planes if it has the same middle line in each, else a volume.
    #[default]
    Recognised,
    /// A volume whose voxels stand where its frame says.
    Volume,
    /// Planes through the long axis, each turned a little further, by half a turn in all.
    TurnedPlanes,
}

/// What can be set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SpectParams {
    /// Standard deviation of the Gaussian blur in space, in millimetres.
    pub blur_mm: f64,
    /// Share of the greatest counts above which edits see a component, 0 to 1.
    pub threshold: f64,
    /// Endocardium: height of its counts between those of the cavity (0) and of the middle of the wall (1).
    pub endocardium: f64,
    /// Epicardium: height of its counts between those beyond the wall (0) and of the middle of the wall (1).
    pub epicardium: f64,
    /// Plane of the valve: share of the wall's usual counts to which they fall there.
    pub base: f64,
    /// Side of the voxels of the masks that are made, in millimetres.
    pub spacing_mm: f64,
    /// How the values lie in space.
    pub grid: SpectGrid,
}

impl Default for SpectParams {
    /// Chosen on half of ten patients whose masks are known and on four of the built-in hearts; the tests use the others, too.
    fn default() -> Self {
        Self {
            blur_mm: 3.0,
            threshold: 0.5,
            endocardium: 0.6,
            epicardium: 0.33,
            base: 0.6,
            spacing_mm: 2.0,
            grid: SpectGrid::Recognised,
        }
    }
}

/// Longest standard deviation of the blur: half of a wall's distance from the wall across the cavity.
const MAX_BLUR_MM: f64 = 20.0;
/// Sides of the voxels of masks: finer than anything SPECT shows, and no coarser than its own voxels.
const SPACING_MM: [f64; 2] = [1.0, 5.0];

/// A setting out of range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SpectParamsError {
    /// A share that must lie between 0 and 1, without these.
    #[error("{name} must lie between 0 and 1, but is {value}")]
    Share {
        /// Which setting.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The blur.
    #[error("the blur must be 0 to {MAX_BLUR_MM} mm, but is {0} mm")]
    Blur(f64),
    /// The voxels of the masks.
    #[error("the voxels of the masks must be {low} to {high} mm, but are {0} mm", low = SPACING_MM[0], high = SPACING_MM[1])]
    Spacing(f64),
}

/// Settings in range.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedSpectParams(SpectParams);

impl SpectParams {
    /// Checks the ranges.
    ///
    /// # Errors
    /// If a setting is out of range or no number.
    pub fn check(self) -> Result<CheckedSpectParams, SpectParamsError> {
        if !(0.0..=MAX_BLUR_MM).contains(&self.blur_mm) {
            return Err(SpectParamsError::Blur(self.blur_mm));
        }
        if !(SPACING_MM[0]..=SPACING_MM[1]).contains(&self.spacing_mm) {
            return Err(SpectParamsError::Spacing(self.spacing_mm));
        }
        let shares = [
            ("threshold", self.threshold),
            ("endocardium", self.endocardium),
            ("epicardium", self.epicardium),
            ("base", self.base),
        ];
        match shares
            .into_iter()
            .find(|(_, value)| !(*value > 0.0 && *value < 1.0))
        {
            Some((name, value)) => Err(SpectParamsError::Share { name, value }),
            None => Ok(CheckedSpectParams(self)),
        }
    }
}

impl CheckedSpectParams {
    /// The settings.
    pub fn get(&self) -> SpectParams {
        self.0
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn settings_out_of_range_are_refused_by_name() {
        let usual = SpectParams::default();
        assert!(usual.check().is_ok());
        for blur_mm in [-1.0, 21.0, f64::NAN] {
            assert!(SpectParams { blur_mm, ..usual }.check().is_err());
        }
        for spacing_mm in [0.5, 6.0, f64::NAN] {
            assert!(
                SpectParams {
                    spacing_mm,
                    ..usual
                }
                .check()
                .is_err()
            );
        }
        for base in [0.0, 1.0, f64::NAN] {
            let error = SpectParams { base, ..usual }.check().unwrap_err();
            assert!(error.to_string().starts_with("base must lie"), "{error}");
        }
    }
}
