//! Mathematics that several questions share: symmetric eigenvalues, numbers side by side.

mod lanczos;
mod lanes;
mod symmetric_eigen;

pub use lanczos::{LeadingEigenError, leading_eigen};
pub use lanes::{Arithmetic, LANES, Lanes, both, three};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
