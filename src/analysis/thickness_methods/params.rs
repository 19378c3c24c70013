//! Settings of the other ways of measuring thickness.

use super::ThicknessError;

/// Settings; [`ThicknessParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThicknessParams {
    /// Short-axis slices between base and end of the cavity.
    pub slices: u16,
    /// Chords in each slice.
    pub chords: u16,
    /// Voxels across the median thickness of the wall, for Laplace's equation and for volumes.
    pub voxels_across: f64,
}

impl Default for ThicknessParams {
    /// 24 slices of some 3.5 mm and the 100 chords of Sheehan et al.; 8 voxels across the wall, with which
    /// thickness of a spherical shell is right to 2 % everywhere and a subject takes some 100,000 voxels.
    fn default() -> Self {
        Self {
            slices: 24,
            chords: 100,
            voxels_across: 8.0,
        }
    }
}

/// Settings that are in range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedThicknessParams(ThicknessParams);

impl ThicknessParams {
    /// Checks ranges: 1–500 slices, 12–2000 chords, 2–64 voxels.
    ///
    /// # Errors
    /// Names the first setting out of range.
    pub fn check(self) -> Result<CheckedThicknessParams, ThicknessError> {
        for (name, value, least, most) in [
            ("number of slices", f64::from(self.slices), 1.0, 500.0),
            ("number of chords", f64::from(self.chords), 12.0, 2_000.0),
            ("voxels across the wall", self.voxels_across, 2.0, 64.0),
        ] {
            if !(least..=most).contains(&value) {
                return Err(ThicknessError::Setting {
                    name,
                    value,
                    least,
                    most,
                });
            }
        }
        Ok(CheckedThicknessParams(self))
    }
}

impl CheckedThicknessParams {
    /// The settings.
    pub fn get(&self) -> ThicknessParams {
        self.0
    }
}
