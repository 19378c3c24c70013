//! Linear algebra that several questions share: symmetric eigenvalues, whole and leading, and sparse solutions.

mod lanczos;
mod sparse_inverse;
mod symmetric_eigen;

pub use lanczos::{LeadingEigenError, leading_eigen};
pub use sparse_inverse::{LowerColumns, NotPositive, SparseInverse};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
