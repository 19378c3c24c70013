//! Which part of the wall does not thicken?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.4–4.6.

mod akinetic_regions;
mod averaged_thickening;
mod by_place;
mod curve;
mod diffusion;
mod error;
mod neighbours;
mod noise;
mod params;
mod patches;
mod result;
mod settings;
mod smallest_detectable;
mod stability;
mod steps;
mod surface;
mod temporal_consistency;
#[cfg(test)]
mod tests;
#[expect(
    clippy::module_inception,
    reason = "the folder's main function carries the folder's name"
)]
mod thickening;

pub use by_place::{PlaceThickening, thickening_of_levels, thickening_of_segments};
pub use error::ThickeningError;
pub use params::{AKINETIC_PT, CheckedThickeningParams, ThickeningParamError, ThickeningParams};
pub use result::{
    HalfBeat, Patch, PatchSegment, SmallestPatch, TemporalConsistency, Thickening, ThickeningStep,
    WallThickening,
};
pub use settings::ThickeningSettings;
pub use steps::{half_beat_of, thickness_ratios};
pub use surface::phases;
pub use thickening::thickening;
