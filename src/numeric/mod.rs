//! Mathematics that several questions share: symmetric eigenvalues, sparse solutions, numbers side by side.

mod lanczos;
mod lanes;
mod sparse_inverse;
mod symmetric_eigen;

pub use lanczos::{LeadingEigenError, leading_eigen};
pub use lanes::{Arithmetic, LANES, Lanes};
pub use sparse_inverse::{LowerColumns, NotPositive, SparseInverse};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
