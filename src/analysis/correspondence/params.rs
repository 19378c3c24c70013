//! How stiffly a template is bent, and how badly it may fit.

use super::CorrespondenceError;

/// Settings of [`correspond`](super::correspond()). Lengths are shares of a surface's size, so that they hold in any unit: twice
/// the greatest distance of its vertices from their mean, some 110 mm of a usual endocardium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorrespondenceParams {
    /// Smoothing λ of the thin-plate spline: landmarks are approached, not met, as they are placed no better than that.
    pub smoothing: f64,
    /// Greatest mean distance between surface and template.
    pub max_mean: f64,
    /// Greatest 95th percentile of the distances.
    pub max_p95: f64,
    /// Greatest share of the template's faces that are folded over.
    pub max_foldovers: f64,
}

impl Default for CorrespondenceParams {
    /// λ 0.01 (1 mm), mean 0.015 (1.7 mm), 95th percentile 0.05 (5.5 mm), one face in a hundred.
    ///
    /// Remeshed hearts of the built-in cohort stay below a tenth of these limits; what is beyond them has another form than a
    /// ventricle.
    fn default() -> Self {
        Self {
            smoothing: 0.01,
            max_mean: 0.015,
            max_p95: 0.05,
            max_foldovers: 0.01,
        }
    }
}

/// Settings that can be used.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedCorrespondenceParams(pub(super) CorrespondenceParams);

impl CorrespondenceParams {
    /// Checks the settings.
    ///
    /// # Errors
    /// At the first that is out of range.
    pub fn check(self) -> Result<CheckedCorrespondenceParams, CorrespondenceError> {
        let all = [
            ("the smoothing", self.smoothing),
            ("the greatest mean distance", self.max_mean),
            ("the greatest 95th percentile", self.max_p95),
            ("the greatest share of foldovers", self.max_foldovers),
        ];
        match all
            .into_iter()
            .find(|(_, value)| !(0.0..=1.0).contains(value))
        {
            Some((name, value)) => Err(CorrespondenceError::Setting {
                name,
                range: "0 to 1",
                value,
            }),
            None => Ok(CheckedCorrespondenceParams(self)),
        }
    }
}
