//! What the colours on a heart can stand for.

/// A number on every vertex, or plain tissue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// The colour of tissue; no number.
    #[default]
    Tissue,
    /// Distance from the vertex's place at end-diastole.
    Displacement,
    /// Area around the vertex relative to end-diastole; 1 is unchanged.
    AreaRatio,
}

impl Quantity {
    /// All of them, in the order in which one key steps through them.
    pub const ALL: [Self; 3] = [Self::Tissue, Self::Displacement, Self::AreaRatio];

    /// The word in menus.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tissue => "Tissue",
            Self::Displacement => "Displacement",
            Self::AreaRatio => "Area ratio",
        }
    }

    /// The word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Tissue => "tissue",
            Self::Displacement => "displacement",
            Self::AreaRatio => "area-ratio",
        }
    }

    /// The next one, and after the last the first.
    pub fn next(self) -> Self {
        match self {
            Self::Tissue => Self::Displacement,
            Self::Displacement => Self::AreaRatio,
            Self::AreaRatio => Self::Tissue,
        }
    }
}
