//! What do other ways of measuring say about the thickness of the wall? For comparison with twice the
//! medial radius, and as a check on it.

mod result;

pub use result::{ThicknessMap, ThicknessMethod};
