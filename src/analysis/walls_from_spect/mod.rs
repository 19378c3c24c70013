//! Walls from gated SPECT: where do endocardium and epicardium lie in images of the counts of a perfusion study, without a mask?
//!
//! Begin with [`segment_spect`]. The wall is followed by its middle, where counts are greatest, as in Germano et al. (1995, J Nucl
//! Med 36(11), 2138–2147) and after blurring and threshold as in section 3.6.1 of the text.

mod axis;
mod base;
mod borders;
mod error;
mod fill;
mod find;
mod middle;
mod params;
mod place;
mod rays;
mod segment;
#[cfg(test)]
mod tests;
mod unturned;

pub use error::SpectError;
pub use params::{CheckedSpectParams, SpectGrid, SpectParams, SpectParamsError};
pub use segment::{SpectSegmentation, segment_spect};
