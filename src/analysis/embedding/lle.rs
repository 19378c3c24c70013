//! Local linearity: the map in which every item is the same mean of its neighbours as in space.

use crate::numeric::moderate_unit;
use crate::progress::Progress;

use super::bottom_eigenvectors::bottom_eigenvectors;
use super::orientation::oriented;
use super::parts::closed_parts;
use super::{CheckedLleParams, Embedding, EmbeddingError, LocalWeights, Neighbours};

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
    let unit = moderate_unit(points.iter().fold(0.0, |most, x| x.abs().max(most)));
    if unit != 1.0 {
        // Weights do not change with the unit of length, and so neither does the map.
        let moderate: Vec<f64> = points.iter().map(|x| x / unit).collect();
        return locally_linear(&moderate, items, params, progress);
    }
    locally_linear(points, items, params, progress)
}

fn locally_linear(
    points: &[f64],
    items: usize,
    params: &CheckedLleParams,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let weights = LocalWeights::of_points(points, items, params, progress)?;
    // Counted before any eigenvalue is computed: with several parts the smallest ones are all zero and their vectors
    // arbitrary.
    let parts = closed_parts(weights.neighbours());
    if parts == 1 {
        return lle_of_weights(&weights, params, progress);
    }
    let mut count = params.0.neighbours;
    loop {
        // By a quarter, so that few rounds do and the neighbourhood grows little past what is needed.
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
    // n items span n − 1 dimensions beside the constant vector.
    if dimensions >= items {
        return Err(EmbeddingError::Dimensions { dimensions, items });
    }
    let (values, vectors) = bottom_eigenvectors(weights, dimensions, progress)?;
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
