//! Mathematics that several questions share: symmetric eigenvalues, Cholesky factors, minimisation,
//! numbers side by side.

mod dense_cholesky;
mod in_waves;
mod lanczos;
mod lanes;
mod lbfgs;
mod line_search;
mod lower_columns;
mod median;
mod moderate_unit;
mod sparse_cholesky;
mod symmetric_eigen;
mod vectors;

pub use dense_cholesky::{factorise_positive, solve_lower, solve_positive};
pub use in_waves::in_waves;
pub use lanczos::{LeadingEigenError, leading_eigen};
pub use lanes::{Arithmetic, LANES, Lanes, both, three};
pub use lbfgs::{Ending, LbfgsParams, Minimum, Objective, lbfgs};
pub use lower_columns::LowerCsc;
pub use median::{lower_median, median};
pub use moderate_unit::moderate_unit;
pub use sparse_cholesky::{SparseCholesky, SparseCholeskyError};
pub use symmetric_eigen::{Eigen, EigenDiverged, symmetric_eigen};
pub use vectors::{add_scaled, dot};
