//! Which poses lie between two poses, on the path of least energy in a metric?
//!
//! The path from one pose to another that minimises the path energy
//! E = Σ_i ⟨⟨X_i, X_i⟩⟩ at M_i + ⟨⟨X_i, X_i⟩⟩ at M_{i+1}, with X_i = M_{i+1} − M_i.
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, sections 3.2.3 and 3.3.1.

mod coarse;
mod interpolate;
mod minimise;
mod params;
mod path_ends;
mod result;
mod solver;
mod stiffness;

pub use interpolate::geodesic;
pub use params::{CheckedGeodesicParams, GeodesicParamError, GeodesicParams};
pub use path_ends::same_pose;
pub use result::{GeodesicError, GeodesicPath};
pub use solver::GeodesicSolver;

#[cfg(test)]
mod tests;
