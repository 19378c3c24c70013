//! The ways in which distances become a map.

/// How distances become a map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MapMethod {
    /// Classical scaling: the leading eigenvectors of the doubly centred squared distances.
    ClassicalMds,
    /// Stress majorisation, started from classical scaling.
    #[default]
    Smacof,
    /// Classical scaling of the shortest ways from neighbour to neighbour.
    Isomap {
        /// Nearest items that each item is linked to.
        neighbours: u16,
    },
}

impl MapMethod {
    /// Isomap with as many neighbours as suit the poses of some twenty subjects.
    pub const ISOMAP: Self = Self::Isomap { neighbours: 10 };
}
