//! Settings of a locally linear map.

/// Settings of a locally linear map; [`LleParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LleParams {
    /// Nearest items that each item is written as a mean of.
    pub neighbours: usize,
    /// Share of its trace that is added to the diagonal of each local Gram matrix.
    pub regularisation: f64,
    /// Numbers per item of the map.
    pub dimensions: usize,
}

impl Default for LleParams {
    /// Twelve neighbours and a share of 10⁻³, as customary, in the plane.
    fn default() -> Self {
        Self {
            neighbours: 12,
            regularisation: 1e-3,
            dimensions: 2,
        }
    }
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedLleParams(pub(super) LleParams);

/// Why settings cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LleParamError {
    /// No neighbours.
    #[error("at least 1 neighbour is needed")]
    Neighbours,
    /// Not a share of a trace.
    #[error("regularisation must be above 0 and at most 1, not {0}")]
    Regularisation(f64),
}

impl LleParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If there is no neighbour, or the regularisation is not in 0..=1 or is 0: then the local
    /// problems have no single answer where there are more neighbours than dimensions.
    pub fn check(self) -> Result<CheckedLleParams, LleParamError> {
        if self.neighbours == 0 {
            return Err(LleParamError::Neighbours);
        }
        if !(self.regularisation > 0.0 && self.regularisation <= 1.0) {
            return Err(LleParamError::Regularisation(self.regularisation));
        }
        Ok(CheckedLleParams(self))
    }
}
