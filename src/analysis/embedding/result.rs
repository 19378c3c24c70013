//! A map: coordinates per item, with how well they keep the distances.

/// Coordinates of items, `dimensions` numbers each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Embedding {
    /// Numbers per item.
    pub dimensions: usize,
    /// Item after item.
    pub coordinates: Vec<f64>,
    /// Kruskal's stress 1, √(Σ(d − δ)² / Σδ²) over pairs, δ the given distances; those along the
    /// graph for Isomap. None where distances on the map mean nothing, as with local linearity.
    pub stress: Option<f64>,
    /// Eigenvalues of classical scaling, descending: all of them for up to 512 items, where negative ones
    /// show that the distances are not Euclidean; those of the axes and the next one for more. Of principal components: the variances. Of locally
    /// linear maps: those of the axes, ascending.
    pub eigenvalues: Option<Vec<f64>>,
    /// Majorisation steps done.
    pub iterations: Option<usize>,
    /// Nearest items that each item was linked to, where the method looks at neighbours only. More
    /// than was asked for where fewer leave a locally linear map without shape.
    pub neighbours: Option<usize>,
    /// What the map fails to keep; see [`isomap()`](super::isomap()) and [`lle()`](super::lle()).
    pub reconstruction_error: Option<f64>,
    /// Parts that the graph of neighbours falls into before they are joined; 1 is one piece.
    pub parts: Option<usize>,
}

impl Embedding {
    /// Coordinates of one item.
    pub fn point(&self, item: usize) -> &[f64] {
        &self.coordinates[item * self.dimensions..][..self.dimensions]
    }

    /// Number of items.
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dimensions.max(1)
    }

    /// Whether the map is empty.
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }
}
