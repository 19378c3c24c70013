//! The rigid metric: displacement that no rigid motion explains (2.3.7).

use nalgebra::Matrix3;

use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::pair_sums::Both;
use crate::analysis::metrics::params::{Form, MetricParams};
use crate::analysis::metrics::path_energy::rigid_steps;
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;
use crate::analysis::metrics::rigid::{rigid_part, rigid_product};
use crate::mesh::{Point3, Vector3};
use crate::numeric::Lanes;

use super::metric_terms::{MetricTerms, MetricWords, Motion};

pub(super) struct Rigid;

impl MetricTerms for Rigid {
    fn words(&self) -> MetricWords {
        MetricWords {
            name: "Rigid",
            id: "rigid",
            summary: "Displacement that no rigid motion explains",
            ignores: "position and rotation",
            penalises: "every other displacement",
            term: "displacement beyond a rigid motion",
            forms: &[("rigid", Form::Additive)],
        }
    }

    fn ignores_scale(&self) -> bool {
        false
    }

    fn penalises_displacement(&self) -> bool {
        true
    }

    fn is_inner_product(&self, _: Form) -> bool {
        true
    }

    fn path_energy_can_vanish(&self, _: &MetricParams) -> bool {
        false
    }

    fn pair(
        &self,
        metric: &Metric,
        [a, b]: [&PreparedPose; 2],
        (rotation, translation): Motion,
        _: &mut PairScratch,
    ) -> Both {
        let before = a.points();
        let after: Vec<_> = (b.points().iter())
            .map(|p| Point3::from(rotation * p.coords + translation))
            .collect();
        let field: Vec<Vector3> = after.iter().zip(&before).map(|(q, p)| q - p).collect();
        // At both poses: the rigid part that is taken out depends on where the vertices are.
        [(a, &before), (b, &after)].map(|(pose, points)| {
            rigid_product(points, &metric.vertex_weights(pose), &field, &field)
        })
    }

    /// Σ_p w_p X'·Y', X' and Y' without their own rigid parts.
    fn product(&self, metric: &Metric, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        let weights = metric.vertex_weights(at);
        rigid_product(&at.points(), &weights, x, y)
    }

    fn add_coordinates(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        let (points, weights) = (at.points(), metric.vertex_weights(at));
        let rigid = rigid_part(&points, &weights, field);
        for ((point, x), weight) in points.iter().zip(field).zip(&weights) {
            let left = (x - rigid.at(point)) * weight.sqrt();
            coordinates.extend(left.iter());
        }
    }

    fn add_face_shares(
        &self,
        _: &Metric,
        _: [&PreparedPose; 2],
        _: &Matrix3<f64>,
        _: &mut PairScratch,
        _: &mut [f64],
    ) {
    }

    fn vertex_terms(
        &self,
        metric: &Metric,
        _: [&PreparedPose; 2],
        at: &PreparedPose,
        points: &[Point3],
        field: &[Vector3],
    ) -> Option<Vec<f64>> {
        let rigid = rigid_part(points, &metric.vertex_weights(at), field);
        let terms = (points.iter().zip(field)).map(|(p, x)| 0.5 * (x - rigid.at(p)).norm_squared());
        Some(terms.collect())
    }

    fn add_face_energies(&self, _: &Plan, _: &mut PathState, gradients: &mut Gradients) {
        // Faces cost nothing, and what the last evaluation left here must not count.
        gradients.face_area.fill(Lanes::default());
    }

    fn add_vertex_energies(&self, plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
        rigid_steps::add_energies(plan, state, gradients);
    }

    fn side_stiffness(
        &self,
        _: &MetricParams,
        _: [f64; 3],
        _: Option<[f64; 3]>,
    ) -> Option<[[f64; 3]; 3]> {
        None
    }
}
