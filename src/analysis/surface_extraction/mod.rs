//! From a volume or a mask to a closed surface: isosurface, smoothing that keeps volume, decimation, normalisation.

mod cell_polygons;
mod crossings;
mod decimated;
mod error;
mod isosurface;
mod normalise;
mod taubin;
mod volume_keeping;

pub use decimated::decimated;
pub use error::SurfaceError;
pub use isosurface::{isosurface, mask_surface};
pub use normalise::{Centre, Normalisation};
pub use taubin::{CheckedTaubinParams, TaubinParams, TaubinSettingError, taubin};

#[cfg(test)]
mod tests;
