//! How large is the ventricle, and how much of its blood does a beat expel?

mod result;

pub use result::{FrameMeasures, PhaseSource, SubjectMeasures};
