//! Local linearity: the map in which every item is the same mean of its neighbours as in space.

use crate::progress::Progress;

use super::flattest::flattest;
use super::orientation::oriented;
use super::parts::closed_parts;
use super::{Embedding, EmbeddingError, LocalWeights, Neighbours};

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

/// Map of points, `items` rows one after the other, that keeps how each is a mean of its neighbours.
///
/// With W the weights of [`LocalWeights`], coordinates Y minimise Σᵢ |yᵢ − Σⱼ Wᵢⱼ yⱼ|² under
/// Yᵀ Y = 1 and Σᵢ yᵢ = 0: the eigenvectors of M = (1 − W)ᵀ(1 − W) with the least eigenvalues, that of
/// the constant vector left out. Columns have length 1, so distances on the map mean nothing by
/// themselves. Eigenvalues are those of the axes, ascending; `reconstruction_error` is their sum, what is
/// left of the minimised one.
///
/// Where neighbourhoods fall into parts that do not see each other, M has several vectors of eigenvalue
/// zero and the map would show which part an item lies in, and nothing else. Then a fourth more
/// neighbours are tried, and again, until there is one part; `neighbours` says how many were used, and
/// `parts` into how many parts those asked for fall.
///
/// Source: Roweis and Saul (2000), Science 290; Saul and Roweis (2003), JMLR 4, sections 3–4.
///
/// # Errors
/// If stopped, if rows are not finite or of equal length, or if there are not more items than
/// neighbours and than dimensions.
pub fn lle(
    points: &[f64],
    items: usize,
    params: &CheckedLleParams,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let weights = LocalWeights::of_points(points, items, params, progress)?;
    let parts = closed_parts(weights.neighbours());
    if parts == 1 {
        return lle_of_weights(&weights, params, progress);
    }
    let mut count = params.0.neighbours;
    loop {
        count = (count + 1.max(count / 4)).min(items - 1);
        let neighbours = Neighbours::of_points(points, items, count, progress)?;
        // All others as neighbours are one part.
        if count + 1 == items || closed_parts(&neighbours) == 1 {
            let regularisation = params.0.regularisation;
            let weights =
                LocalWeights::of_neighbours(points, neighbours, regularisation, progress)?;
            let map = lle_of_weights(&weights, params, progress)?;
            return Ok(Embedding {
                parts: Some(parts),
                ..map
            });
        }
    }
}

/// The map of [`lle()`] from weights that are known, of which only the dimensions of `params` are
/// asked: after an item was added, say.
///
/// Parts that do not see each other are not joined here, but counted.
///
/// # Errors
/// If stopped, or if there are not more items than dimensions.
pub fn lle_of_weights(
    weights: &LocalWeights,
    params: &CheckedLleParams,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let items = weights.neighbours().len();
    let dimensions = params.0.dimensions;
    if dimensions >= items {
        return Err(EmbeddingError::Dimensions { dimensions, items });
    }
    let (values, vectors) = flattest(weights, dimensions, progress)?;
    let coordinates = (0..items)
        .flat_map(|item| vectors.iter().map(move |vector| vector[item]))
        .collect();
    Ok(Embedding {
        dimensions,
        coordinates: oriented(coordinates, dimensions),
        reconstruction_error: Some(values.iter().sum()),
        eigenvalues: Some(values),
        neighbours: Some(weights.neighbours().count()),
        parts: Some(closed_parts(weights.neighbours())),
        ..Embedding::default()
    })
}

#[cfg(test)]
mod tests;
