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
