//! Settings of walls from cine MR.

use serde::{Deserialize, Serialize};

/// What can be set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CineParams {
    /// Greatest distance of the endocardium from the middle of the cavity, in millimetres.
    pub max_radius_mm: f64,
    /// Thinnest wall, in millimetres.
    pub min_wall_mm: f64,
    /// Thickest wall, in millimetres.
    pub max_wall_mm: f64,
    /// Height of the endocardium's values between those of muscle (0) and of blood (1).
    pub endocardium: f64,
    /// How strongly neighbouring instants and slices pull at an outline; 1 as usual, 0 not at all.
    pub coherence: f64,
    /// Time after which what an outline set by hand says counts half as much, as a share of the beat.
    pub edit_reach_beats: f64,
    /// Distance along the axis after which it counts half as much, in millimetres.
    pub edit_reach_mm: f64,
}

impl Default for CineParams {
    /// Chosen on half of the patients of ACDC of whom images are known; see the tests of real data.
    fn default() -> Self {
        Self {
            max_radius_mm: 45.0,
            min_wall_mm: 3.0,
            max_wall_mm: 22.0,
            endocardium: 0.28,
            coherence: 1.0,
            edit_reach_beats: 0.15,
            edit_reach_mm: 8.0,
        }
    }
}

/// A setting out of range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name} must lie between {least} and {most}, but is {value}")]
pub struct CineParamsError {
    /// Which setting.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The least possible value.
    pub least: f64,
    /// The greatest.
    pub most: f64,
}

/// Settings in range.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedCineParams(CineParams);

impl CineParams {
    /// Checks the ranges.
    ///
    /// # Errors
    /// If a setting is out of range or no number.
    pub fn check(self) -> Result<CheckedCineParams, CineParamsError> {
        // Lengths of human ventricles, of children and of the greatest ones; the others are shares and factors.
        let ranges = [
            ("max_radius_mm", self.max_radius_mm, 10.0, 80.0),
            ("min_wall_mm", self.min_wall_mm, 1.0, 10.0),
            ("max_wall_mm", self.max_wall_mm, 12.0, 40.0),
            ("endocardium", self.endocardium, 0.1, 0.9),
            ("coherence", self.coherence, 0.0, 100.0),
            ("edit_reach_beats", self.edit_reach_beats, 0.01, 10.0),
            ("edit_reach_mm", self.edit_reach_mm, 0.1, 1000.0),
        ];
        match ranges
            .into_iter()
            .find(|(_, value, least, most)| !(*least..=*most).contains(value))
        {
            Some((name, value, least, most)) => Err(CineParamsError {
                name,
                value,
                least,
                most,
            }),
            None => Ok(CheckedCineParams(self)),
        }
    }
}

impl CheckedCineParams {
    /// The settings.
    pub fn get(&self) -> CineParams {
        self.0
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn settings_out_of_range_are_refused_by_name() {
        let usual = CineParams::default();
        assert!(usual.check().is_ok());
        for max_radius_mm in [0.0, 1e6, f64::NAN] {
            let wrong = CineParams {
                max_radius_mm,
                ..usual
            };
            assert_eq!(wrong.check().unwrap_err().name, "max_radius_mm");
        }
        for coherence in [-1.0, f64::INFINITY, f64::NAN] {
            let wrong = CineParams { coherence, ..usual };
            assert!(
                wrong
                    .check()
                    .unwrap_err()
                    .to_string()
                    .starts_with("coherence must lie")
            );
        }
    }
}
