//! The quasi-conformal metric: change of angles and of Gaussian curvature (eq. 3.5).

use nalgebra::Matrix3;

use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::pair_sums::{Both, angles, curvature, stretches};
use crate::analysis::metrics::params::{Corners, CurvatureRole, Form, MetricParams};
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;
use crate::mesh::{Point3, Vector3};

use super::corner_passes::{add_corner_energies, add_corner_shares, corner_stiffness};
use super::metric_terms::{MetricTerms, MetricWords, Motion, each_product};

pub(super) struct QuasiConformal;

impl MetricTerms for QuasiConformal {
    fn words(&self) -> MetricWords {
        MetricWords {
            name: "Quasi-conformal",
            id: "quasi-conformal",
            summary: "Change of angles and of Gaussian curvature",
            ignores: "position, rotation and uniform scaling",
            penalises: "changes of angles and of curvature",
            term: "change of angles",
            forms: &[
                ("quasi-conformal, additive", Form::Additive),
                ("quasi-conformal, frozen", Form::Frozen),
                ("quasi-conformal, bilinear", Form::Bilinear),
                ("quasi-conformal, printed", Form::Printed),
            ],
        }
    }

    /// On real beats displacement is then a fifth of the energy at most, see `SHARES.md` of the experiments.
    fn lambda(&self) -> f64 {
        0.25
    }

    fn ignores_scale(&self) -> bool {
        true
    }

    fn curvature_role(&self, form: Form) -> CurvatureRole {
        match form {
            Form::Printed | Form::Bilinear => CurvatureRole::StepFactor,
            // Frozen at the change between the ends, a factor is no function of the field any more.
            Form::Frozen => CurvatureRole::FrozenFactor,
            Form::Additive => CurvatureRole::Term,
        }
    }

    fn is_inner_product(&self, form: Form) -> bool {
        match form {
            // The curvature change that multiplies the corners depends on the field itself.
            Form::Printed | Form::Bilinear | Form::Frozen => false,
            Form::Additive => true,
        }
    }

    fn path_energy_can_vanish(&self, params: &MetricParams) -> bool {
        // A subject may shrink, change while it is small, and grow again for nothing.
        params.corners == Corners::Raw
            || match params.form {
                // Steps that change angles alone and steps that change curvature alone cost nothing.
                Form::Printed | Form::Bilinear => true,
                Form::Frozen | Form::Additive => false,
            }
    }

    fn pair(
        &self,
        metric: &Metric,
        [a, b]: [&PreparedPose; 2],
        (rotation, _): Motion,
        scratch: &mut PairScratch,
    ) -> Both {
        stretches(a, b, rotation, &mut scratch.stretch);
        if self.curvature_role(metric.params.form).is_factor() {
            let change = a.curvature.iter().zip(&b.curvature);
            scratch.curvature_change.clear();
            scratch
                .curvature_change
                .extend(change.map(|(before, after)| after - before));
            let change = Some(scratch.curvature_change.as_slice());
            return angles(metric, a, b, &scratch.stretch, change);
        }
        let angle = angles(metric, a, b, &scratch.stretch, None);
        let curvature = curvature(metric, a, b);
        [0, 1].map(|side| angle[side] + metric.params.mu * curvature[side])
    }

    /// Printed (eq. 3.5) and bilinear: that of angles with t_c(X) ΔK_c(X), where ΔK(X) = K(M + X) − K(M); frozen: like
    /// bilinear; additive: with + μ Σ_p dK_p(X) dK_p(Y), dK the rate of curvature along the field.
    fn product(&self, metric: &Metric, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        if self.curvature_role(metric.params.form).is_factor() {
            let (of_x, of_y) = (
                metric.curvature_change(at, x),
                metric.curvature_change(at, y),
            );
            return metric.corner_product(at, x, y, Some([&of_x, &of_y]));
        }
        let rates = (metric.curvature_rates(at, x).into_iter()).zip(metric.curvature_rates(at, y));
        let curvature: f64 = (metric.vertex_weights(at).iter())
            .zip(rates)
            .map(|(weight, (x, y))| weight * x * y)
            .sum();
        metric.corner_product(at, x, y, None) + metric.params.mu * curvature
    }

    fn products(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        x: &[Vector3],
        y: &[Vector3],
    ) -> [f64; 3] {
        if !self.is_inner_product(metric.params.form) {
            // The factors of X and of Y differ, so that no pass can be shared.
            return each_product(self, metric, at, x, y);
        }
        let mut sums = metric.corner_products(at, x, y);
        let rates = (metric.curvature_rates(at, x).into_iter()).zip(metric.curvature_rates(at, y));
        for ((x, y), weight) in rates.zip(metric.vertex_weights(at)) {
            for (sum, product) in sums.iter_mut().zip([x * x, x * y, y * y]) {
                *sum += metric.params.mu * weight * product;
            }
        }
        sums
    }

    fn add_coordinates(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        metric.add_corner_coordinates(at, field, coordinates);
        let rates = metric.curvature_rates(at, field).into_iter();
        let weights = metric.vertex_weights(at).into_iter();
        let mu = metric.params.mu;
        coordinates.extend(
            rates
                .zip(weights)
                .map(|(rate, weight)| (mu * weight).sqrt() * rate),
        );
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
        let factors = (self.curvature_role(metric.params.form).is_factor()).then(|| change(poses));
        add_corner_shares(metric, poses, &scratch.stretch, factors.as_deref(), shares);
    }

    fn vertex_terms(
        &self,
        metric: &Metric,
        poses: [&PreparedPose; 2],
        _: &PreparedPose,
        _: &[Point3],
        _: &[Vector3],
    ) -> Option<Vec<f64>> {
        let term = |change: f64| 0.5 * metric.params.mu * change * change;
        match self.curvature_role(metric.params.form) {
            CurvatureRole::Term => Some(change(poses).into_iter().map(term).collect()),
            CurvatureRole::Unused | CurvatureRole::StepFactor | CurvatureRole::FrozenFactor => None,
        }
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
        // The curvature term is left out: averaged over rings, it would fill the matrix.
        Some(corner_stiffness(params, length2, corner_weights))
    }
}

/// K(B) − K(A) of each vertex.
fn change([a, b]: [&PreparedPose; 2]) -> Vec<f64> {
    (a.curvature.iter().zip(&b.curvature))
        .map(|(before, after)| after - before)
        .collect()
}
