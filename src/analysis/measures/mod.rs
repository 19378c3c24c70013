//! How large is the ventricle, and how much of its blood does a beat expel?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.1.1.

mod inner_side;
mod measure;
mod reference_range;
mod result;
#[cfg(test)]
mod tests;
mod volumes;
mod wall_sides;

pub use inner_side::InnerSideError;
pub use measure::{measure_study, measure_subject, phases_of, unknown_volumes};
pub use reference_range::{
    ADULT_RANGES, EDV_RANGE, EF_RANGE, ESV_RANGE, MASS_RANGE, OutsideRange, ReferenceRange,
    SV_RANGE, outside_reference,
};
pub use result::{FrameMeasures, MeasureNote, PhaseSource, SubjectMeasures};
pub use volumes::UnknownVolume;
pub use wall_sides::{Side, WallSides, split_wall, wall_sides};
