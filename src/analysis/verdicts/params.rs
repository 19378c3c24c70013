//! How a verdict is made, and when there is none.

/// Settings of verdicts; [`VerdictParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerdictParams {
    /// Fewest assessed subjects of each class from which a classifier is trained.
    pub min_labelled: u32,
    /// Least share of its volume at end-diastole that the wall still has at end-systole. Myocardium keeps
    /// nearly all of it; a wall that loses more is blurred, and its thickening hidden.
    pub min_wall_volume: f64,
    /// Permutations of the labels for the baselines.
    pub permutations: u32,
    /// Of the permutations.
    pub seed: u64,
}

impl Default for VerdictParams {
    /// The least wall volume lies between what real walls have (the least of 125 that are resolved: 0.89) and
    /// blurred ones (the greatest of 16: 0.79). 200 permutations tell p to half a per cent.
    fn default() -> Self {
        Self {
            min_labelled: 5,
            min_wall_volume: 0.85,
            permutations: 200,
            seed: 2009,
        }
    }
}

/// Settings that have been checked; read them like the fields of [`VerdictParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedVerdictParams(VerdictParams);

impl std::ops::Deref for CheckedVerdictParams {
    type Target = VerdictParams;

    fn deref(&self) -> &VerdictParams {
        &self.0
    }
}

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum VerdictParamError {
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
}

impl VerdictParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If a number is out of range or not a number.
    pub fn check(self) -> Result<CheckedVerdictParams, VerdictParamError> {
        let ranges = [
            // With one of a class nothing is left of it when that one is left out.
            (
                "minimum number of labelled subjects of each class",
                f64::from(self.min_labelled),
                3.0,
                1000.0,
            ),
            ("minimum wall volume ratio", self.min_wall_volume, 0.0, 1.0),
            ("permutations", f64::from(self.permutations), 1.0, 10_000.0),
        ];
        for (name, value, least, most) in ranges {
            if !(least..=most).contains(&value) {
                return Err(VerdictParamError::Range {
                    name,
                    value,
                    least,
                    most,
                });
            }
        }
        Ok(CheckedVerdictParams(self))
    }
}
