//! Settings: what is akinetic, what is a patch, and what is noise.

use serde::{Deserialize, Serialize};

use crate::analysis::medial_space::RatioForm;

/// PT from end-diastole to end-systole below which a wall is akinetic, thickening of 10 %: "roughly equal to one" (4.4).
pub const AKINETIC_PT: f64 = 1.1;

/// Settings of the search for the part of the wall that does not thicken;
/// [`ThickeningParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ThickeningParams {
    /// |ln PT| of a step up to which an atom is akinetic (M̂ of 4.4). `None`: as much as noise alone
    /// makes of PT = 1, twice its standard deviation, but at least ln 1.05.
    pub tolerance: Option<f64>,
    /// What r̂ of a descriptor is made of.
    pub ratio: RatioForm,
    /// Core threshold: the core of a patch thickens over the beat by less than this share of what remote myocardium does.
    #[serde(rename = "core")]
    pub core_threshold: f64,
    /// Akinetic threshold: the core also thickens by less than this, ln PT from end-diastole to end-systole.
    #[serde(rename = "still")]
    pub akinetic_threshold: f64,
    /// Extent threshold: a patch reaches as far as the wall thickens by less than this share of what remote myocardium
    /// does.
    #[serde(rename = "border")]
    pub extent_threshold: f64,
    /// Least area of a patch, as a share of the regular medial surface; its core has at least half of that, and
    /// both are doubled where there are fewer than four poses.
    #[serde(rename = "least_share")]
    pub min_share: f64,
    /// Where even remote myocardium thickens by less than this (ln PT from end-diastole to
    /// end-systole), hypokinesia is global and no part of it is called a patch.
    #[serde(rename = "least_thickening")]
    pub min_thickening: f64,
    /// Least area over which thickening is averaged, as a share of the regular medial surface.
    pub smoothing: f64,
    /// Redraws of the noise from which detection stability is estimated; 0: none, stability 1.
    pub redraws: u32,
    /// Seed of the noise that is drawn again.
    pub seed: u64,
}

impl Default for ThickeningParams {
    /// Chosen on the built-in cohort and the labels of ACDC as wholes, not on single subjects. In the cohort (23 subjects, 2,450
    /// vertices) patches thicken by 0.05 to 0.2 of remote myocardium, the apex of normal subjects by 0.3 and that of
    /// hypertrophic ones by 0.2; the extent threshold between is where a patch ends by half. `akinetic_threshold` keeps normal
    /// subjects of ACDC, which thicken unevenly but everywhere (median PT 1.8), from having patches.
    fn default() -> Self {
        Self {
            tolerance: None,
            ratio: RatioForm::GeometricMean,
            core_threshold: 0.2,
            akinetic_threshold: AKINETIC_PT.ln(),
            extent_threshold: 0.4,
            min_share: 0.02,
            min_thickening: AKINETIC_PT.ln(),
            smoothing: 0.01,
            redraws: 50,
            seed: 2009,
        }
    }
}

/// Settings that have been checked; read them like the fields of [`ThickeningParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedThickeningParams(ThickeningParams);

impl std::ops::Deref for CheckedThickeningParams {
    type Target = ThickeningParams;

    fn deref(&self) -> &ThickeningParams {
        &self.0
    }
}

/// Redraws beyond this add nothing: the standard error of a share is then below 2 %.
const MAX_REDRAWS: u32 = 1000;

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThickeningParamError {
    /// A number out of range.
    #[error("{name} must be between {least} and {most}, not {value}")]
    Range {
        /// Name of the setting that is refused.
        name: &'static str,
        /// The value that was given.
        value: f64,
        /// The smallest value that is accepted.
        least: f64,
        /// The largest value that is accepted.
        most: f64,
    },
    /// The extent threshold is at least the core threshold.
    #[error("the extent threshold, {extent}, must not be below the core threshold, {core}")]
    Order {
        /// Core threshold.
        core: f64,
        /// Extent threshold.
        extent: f64,
    },
}

impl ThickeningParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If a number is out of range or not a number, or the extent threshold lies below the core threshold.
    pub fn check(self) -> Result<CheckedThickeningParams, ThickeningParamError> {
        let ranges = [
            ("tolerance", self.tolerance.unwrap_or(0.0), 0.0, 2.0),
            ("core threshold", self.core_threshold, 0.0, 1.0),
            ("akinetic threshold", self.akinetic_threshold, 0.0, 2.0),
            ("extent threshold", self.extent_threshold, 0.0, 1.0),
            ("minimum area of a patch", self.min_share, 0.0, 0.5),
            ("minimum thickening", self.min_thickening, 0.0, 2.0),
            ("smoothing", self.smoothing, 0.0, 0.5),
            (
                "redraws",
                f64::from(self.redraws),
                0.0,
                f64::from(MAX_REDRAWS),
            ),
        ];
        for (name, value, least, most) in ranges {
            if !(least..=most).contains(&value) {
                return Err(ThickeningParamError::Range {
                    name,
                    value,
                    least,
                    most,
                });
            }
        }
        // A region is grown from its core: the core must be part of it.
        if self.extent_threshold < self.core_threshold {
            return Err(ThickeningParamError::Order {
                core: self.core_threshold,
                extent: self.extent_threshold,
            });
        }
        Ok(CheckedThickeningParams(self))
    }
}
