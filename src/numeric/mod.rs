//! Mathematics that several questions share: symmetric eigenvalues, sparse solutions, minimisation,
//! numbers side by side.

mod lanczos;
mod lanes;
mod lbfgs;
mod line_search;
mod sparse_cholesky;
mod sparse_inverse;
mod symmetric_eigen;

pub use lanczos::{LeadingEigenError, leading_eigen};
pub use lanes::{Arithmetic, LANES, Lanes, both, three};
pub use lbfgs::{Ending, LbfgsParams, Minimum, Objective, lbfgs};
pub use sparse_cholesky::{SparseCholesky, SparseCholeskyError};
pub use sparse_inverse::{LowerColumns, NotPositive, SparseInverse};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
