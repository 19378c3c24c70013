//! Walls from masks: which smooth endocardium and epicardium have the outlines and the volumes of masks on thick slices,
//! at every instant with the same vertices?
//!
//! Begin with [`walls_from_masks`]. Interpolation of outlines between slices follows the idea of shape-based interpolation
//! (Raya and Udupa 1990, IEEE Trans Med Imaging 9(1), 32–42), with the square of the radius in place of the distance from the outline:
//! it keeps areas, so that the volume of the surface is that of the mask.

mod error;
mod fit;
mod from_slices;
mod masks;
mod params;
mod planes;
mod preparation;
mod radial;
mod region;
mod rotated_planes;
mod sequence;
mod shape;
mod sheets;
mod shifts;
mod slices;
mod smooth_profile;
#[cfg(test)]
mod tests;

pub use error::{FrameWallError, MaskError, WallError};
pub use fit::SurfaceFit;
pub use masks::{MaskLabels, Masks, Tissue};
pub use params::{CheckedWallParams, WallParams, WallParamsError};
pub use preparation::SliceShift;
pub use sequence::{Walls, walls_from_masks};
