//! How far apart are two poses, when what does not matter is ignored?
//!
//! A [`Metric`] is made once per connectivity, prepares each pose once ([`PreparedPose`]) and then
//! answers for a pair in one pass over edges, faces and vertices.
//!
//! With t_c(X) the corner terms of eq. 3.3, X = B − A, and ΔK = K(B) − K(A):
//!
//! | form | squared norm of X at a pose | inner product? |
//! |---|---|---|
//! | printed (eqs. 3.4, 3.5) | Σ_f a_f (Σ_c \|ΔK_c t_c(X)\|)² | no: ⟨X, −X⟩ = +⟨X, X⟩, and with ΔK homogeneous of degree 4 |
//! | bilinear | Σ_f a_f Σ_c (ΔK_c t_c(X))² | angle-preserving yes; quasi-conformal no, since ΔK depends on X |
//! | frozen | Σ_f a_f Σ_c w_c t_c(X)², w_c = (ΔK_c)² of the pair | yes, for that pair of poses |
//! | additive | Σ_f a_f Σ_c t_c(X)² + μ Σ_p a_p (ΔK_p)² | yes, with the rate dK_p(X) in the place of ΔK_p |
//!
//! The printed forms, and the bilinear quasi-conformal one, are for one-step distances only, compared at the
//! same number of steps. As energies of paths they fail: a product of angle and curvature change costs nothing
//! where one of them rests, so that paths change them in turn; a term of fourth degree makes k equal
//! steps cost k⁻³ instead of k⁻¹; and raw corners let a subject shrink, change and grow for nothing. They can be
//! optimised here ([`PathEnergy`]) to show just that.
//!
//! The angle-preserving metric is the same without ΔK. All add λ Σ_p a_p X_p·X_p.
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, sections 2.3.6–2.3.7 and 3.2.

mod compared_curvature;
mod connectivity;
mod contributions;
mod corner;
mod face_energy;
mod face_shares;
mod field_terms;
mod fields;
mod kind;
mod kinds;
mod metric;
mod pair;
mod pair_sums;
mod params;
mod path_energy;
mod pose;
mod rigid;
mod shares;
mod smoothing;

pub use kind::{METRICS, MetricKind};
pub use kinds::MetricWords;
pub use metric::{Metric, MetricError, PairNorms, PairScratch};
pub use params::{
    CheckedMetricParams, Corners, CurvatureMean, CurvatureRole, Form, MetricParams, ParamError,
    Regulariser,
};
pub use path_energy::PathEnergy;
pub use pose::PreparedPose;
pub use rigid::{RigidField, rigid_part};
pub use shares::EnergyShares;
pub use smoothing::Smoother;

#[cfg(test)]
mod tests;
#[cfg(test)]
pub(super) use tests::bent;
