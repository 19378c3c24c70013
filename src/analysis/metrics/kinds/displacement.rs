//! The metric of displacement, the rigid-body metric of the text: what no rigid motion explains (2.3.7).

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

pub(super) struct Displacement;

/// Σ_p w_p |X'_p|² at a pose, X the way to another one that is moved by a rigid motion. In two passes without memory of
/// their own, since matrices of poses spend their time here.
fn left_over(
    metric: &Metric,
    [here, there]: [&PreparedPose; 2],
    rotation: &Matrix3<f64>,
    translation: &Vector3,
) -> f64 {
    let Some(moments) = &here.moments else {
        // Poses of this metric are all prepared with their moments.
        return f64::NAN;
    };
    let count = here.vertex_share.len();
    let share = &here.vertex_share[..count];
    let [hx, hy, hz] = here.axes.each_ref().map(|axis| &axis[..count]);
    let [tx, ty, tz] = there.axes.each_ref().map(|axis| &axis[..count]);
    let weight = |v: usize| {
        if metric.params.area_weights {
            share[v]
        } else {
            1.0
        }
    };
    let way = |v: usize| {
        let point = Vector3::new(hx[v], hy[v], hz[v]);
        let other = rotation * Vector3::new(tx[v], ty[v], tz[v]) + translation;
        (point, other - point)
    };
    let (mut momentum, mut torque) = (Vector3::zeros(), Vector3::zeros());
    for v in 0..count {
        let (point, x) = way(v);
        let pull = x * weight(v);
        momentum += pull;
        torque += (point - moments.centre).cross(&pull);
    }
    let rigid = moments.motion(momentum, torque);
    (0..count)
        .map(|v| {
            let (point, x) = way(v);
            weight(v) * (x - rigid.at(&Point3::from(point))).norm_squared()
        })
        .sum()
}

impl MetricTerms for Displacement {
    fn words(&self) -> MetricWords {
        MetricWords {
            name: "Displacement",
            id: "displacement",
            summary: "Displacement that no rigid motion explains",
            ignores: "position and rotation",
            penalises: "every other displacement",
            term: "displacement beyond a rigid motion",
            forms: &[("default: displacement", Form::Additive)],
        }
    }

    fn lambda(&self) -> f64 {
        // It is displacement already.
        0.0
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
        let back = rotation.transpose();
        // At both poses, each in its own axes: the rigid part that is taken out depends on where the vertices are.
        [
            left_over(metric, [a, b], rotation, translation),
            left_over(metric, [b, a], &back, &(-back * translation)),
        ]
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
