//! The angle-preserving metric: change of angles (eq. 3.3, 3.4).

use nalgebra::Matrix3;

use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::pair_sums::{Both, angles, stretches};
use crate::analysis::metrics::params::{Corners, Form, MetricParams};
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;
use crate::mesh::Vector3;

use super::corner_passes::{add_corner_energies, add_corner_shares, corner_stiffness};
use super::metric_terms::{MetricTerms, MetricWords, Motion, each_product};

pub(super) struct AnglePreserving;

impl MetricTerms for AnglePreserving {
    fn words(&self) -> MetricWords {
        MetricWords {
            name: "Angle-preserving",
            id: "angle-preserving",
            summary: "Change of angles",
            ignores: "position, rotation and uniform scaling",
            penalises: "changes of angles",
            term: "change of angles",
            forms: &[
                ("angle-preserving", Form::Additive),
                ("angle-preserving, printed", Form::Printed),
            ],
        }
    }

    /// Angles are the part of a motion that suffers most from noise: with a quarter of this, clusters of motions on noisy
    /// meshes agree less with their kinds (τ 0.90 instead of 0.98 at 5 % of displacement, `tests/it/motions_and_shapes.rs`).
    fn lambda(&self) -> f64 {
        1.0
    }

    fn ignores_scale(&self) -> bool {
        true
    }

    fn is_inner_product(&self, form: Form) -> bool {
        match form {
            // Absolute values: the product of X with −X is positive.
            Form::Printed => false,
            Form::Bilinear | Form::Frozen | Form::Additive => true,
        }
    }

    fn path_energy_can_vanish(&self, params: &MetricParams) -> bool {
        // A subject may shrink, change while it is small, and grow again for nothing.
        params.corners == Corners::Raw || !self.is_inner_product(params.form)
    }

    fn pair(
        &self,
        metric: &Metric,
        [a, b]: [&PreparedPose; 2],
        (rotation, _): Motion,
        scratch: &mut PairScratch,
    ) -> Both {
        stretches(a, b, rotation, &mut scratch.stretch);
        angles(metric, a, b, &scratch.stretch, None)
    }

    /// Printed Σ_f (Σ_c |t_c(X)|)(Σ_c |t_c(Y)|) (eq. 3.4), else Σ_f Σ_c t_c(X) t_c(Y).
    fn product(&self, metric: &Metric, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        metric.corner_product(at, x, y, None)
    }

    fn products(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        x: &[Vector3],
        y: &[Vector3],
    ) -> [f64; 3] {
        if self.is_inner_product(metric.params.form) {
            metric.corner_products(at, x, y)
        } else {
            each_product(self, metric, at, x, y)
        }
    }

    fn add_coordinates(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        metric.add_corner_coordinates(at, field, coordinates);
    }

    fn add_face_shares(
        &self,
        metric: &Metric,
        poses: [&PreparedPose; 2],
        rotation: &Matrix3<f64>,
        scratch: &mut PairScratch,
        shares: &mut [f64],
    ) {
        stretches(poses[0], poses[1], rotation, &mut scratch.stretch);
        add_corner_shares(metric, poses, &scratch.stretch, None, shares);
    }

    fn add_face_energies(&self, plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
        add_corner_energies(plan, state, gradients);
    }

    fn side_stiffness(
        &self,
        params: &MetricParams,
        length2: [f64; 3],
        corner_weights: Option<[f64; 3]>,
    ) -> Option<[[f64; 3]; 3]> {
        Some(corner_stiffness(params, length2, corner_weights))
    }
}
