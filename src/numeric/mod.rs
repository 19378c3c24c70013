//! Linear algebra that several questions share: symmetric eigenvalues, whole and leading.

mod lanczos;
mod symmetric_eigen;

pub use lanczos::{LeadingEigenError, leading_eigen};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
