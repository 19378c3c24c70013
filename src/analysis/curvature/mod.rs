//! How does a surface bend at each of its vertices, most and least, and in which directions?
//!
//! Begin with [`surface_curvature`]. What follows from the two principal curvatures is asked of [`Curvature`]; how a surface
//! shares its area among shapes is its [`shape_spectrum`].
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.1.2; the fit is that of F. Cazals and M. Pouget (2005), Estimating
//! differential quantities using polynomial fitting of osculating jets, Computer Aided Geometric Design 22(2), 121–146.

mod error;
mod fit;
mod principal;
mod rings;
mod spectrum;
mod surface;
#[cfg(test)]
mod tests;

pub use error::CurvatureError;
pub use principal::Curvature;
pub use spectrum::{SPECTRUM_BINS, shape_spectrum};
pub use surface::{SurfaceCurvature, surface_curvature};
