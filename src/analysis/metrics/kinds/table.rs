//! From a metric's kind to its file.

use crate::analysis::metrics::kind::MetricKind;
use crate::analysis::metrics::params::{CurvatureRole, MetricParams};

use super::metric_terms::{MetricTerms, MetricWords};
use super::{angle_preserving, displacement, isometric, quasi_conformal};

/// What is specific to a metric.
pub(in crate::analysis::metrics) fn terms(kind: MetricKind) -> &'static dyn MetricTerms {
    match kind {
        MetricKind::QuasiConformal => &quasi_conformal::QuasiConformal,
        MetricKind::AnglePreserving => &angle_preserving::AnglePreserving,
        MetricKind::Isometric => &isometric::Isometric,
        MetricKind::Displacement => &displacement::Displacement,
    }
}

impl MetricKind {
    /// What a person reads about it.
    pub fn words(self) -> MetricWords {
        terms(self).words()
    }

    /// Whether a [form](crate::analysis::metrics::Form) makes a difference.
    pub fn has_forms(self) -> bool {
        self.words().forms.len() > 1
    }

    /// The weight of the regulariser with which it is offered.
    pub fn lambda(self) -> f64 {
        terms(self).lambda()
    }

    /// Whether uniform scaling costs nothing, without a regulariser and with scale-free corners.
    pub fn ignores_scale(self) -> bool {
        terms(self).ignores_scale()
    }

    /// Whether displacement of vertices is penalised even without a regulariser.
    pub fn penalises_displacement(self) -> bool {
        terms(self).penalises_displacement()
    }
}

impl MetricParams {
    /// What curvature is used for.
    pub fn curvature_role(&self) -> CurvatureRole {
        terms(self.kind).curvature_role(self.form)
    }

    /// Whether products of two fields are linear in each of them.
    pub fn is_inner_product(&self) -> bool {
        terms(self.kind).is_inner_product(self.form)
    }

    /// Whether, without a regulariser, paths of several steps can cost nothing although their ends differ.
    pub fn path_energy_can_vanish(&self) -> bool {
        terms(self.kind).path_energy_can_vanish(self)
    }

    /// The quadratic form of a face on the relative rates of length of its sides ab, bc, ca, from their squared
    /// lengths; `None` where faces have no terms.
    ///
    /// `corner_weights` multiply squared corner terms: squared curvature change in the forms where it is a factor.
    pub fn side_stiffness(
        &self,
        length2: [f64; 3],
        corner_weights: Option<[f64; 3]>,
    ) -> Option<[[f64; 3]; 3]> {
        terms(self.kind).side_stiffness(self, length2, corner_weights)
    }
}
