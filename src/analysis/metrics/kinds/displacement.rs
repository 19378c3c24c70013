//! The metric of displacement, the rigid-body metric of the text: what no rigid motion explains (2.3.7).

use std::array::from_fn;

use nalgebra::Matrix3;

use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::pair_sums::Both;
use crate::analysis::metrics::params::{Form, MetricParams};
use crate::analysis::metrics::path_energy::rigid_steps;
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;
use crate::analysis::metrics::rigid::{Moments, rigid_part, rigid_product};
use crate::mesh::{Point3, Vector3};
use crate::numeric::{Arithmetic, LANES, Lanes, three};

use super::metric_terms::{MetricTerms, MetricWords, Motion};

pub(super) struct Displacement;

/// Σ w X, Σ w (p − p̄) × X and Σ w |X|² at one pose: what the displacement beyond a rigid motion follows from.
#[derive(Clone, Copy, Default)]
struct WaySums {
    momentum: [Lanes; 3],
    torque: [Lanes; 3],
    energy: Lanes,
}

impl WaySums {
    #[inline(always)]
    fn add(&mut self, weight: Lanes, arm: [Lanes; 3], x: [Lanes; 3]) {
        let pull = three(|axis| x[axis] * weight);
        self.energy += pull[0] * x[0] + pull[1] * x[1] + pull[2] * x[2];
        for axis in 0..3 {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            self.momentum[axis] += pull[axis];
            self.torque[axis] += arm[next] * pull[last] - arm[last] * pull[next];
        }
    }

    /// Σ w |X'|², X' the way without its rigid part: by orthogonality Σ w |X|² less what the rigid part has of it.
    /// Poses are aligned before they are compared, so the part is not large against the rest and little cancels.
    fn left_over(&self, moments: &Moments, to_axes: &Matrix3<f64>) -> f64 {
        let sum = |lanes: Lanes| lanes.0.iter().sum::<f64>();
        let vector = |of: [Lanes; 3]| to_axes * Vector3::from(three(|axis| sum(of[axis])));
        let explained = moments.energy(vector(self.momentum), vector(self.torque));
        (sum(self.energy) - explained).max(0.0)
    }
}

/// Σ_p w_p |X'_p|² at both poses, X the way from the first to the second where a rigid motion lays that one. At the
/// second the way back is −Rᵀ X in its own axes. One pass without memory of its own, since matrices of poses spend
/// their time here.
fn left_over(
    metric: &Metric,
    [a, b]: [&PreparedPose; 2],
    rotation: &Matrix3<f64>,
    translation: &Vector3,
) -> Both {
    let (Some(moments_a), Some(moments_b)) = (&a.moments, &b.moments) else {
        // Poses of this metric are all prepared with their moments.
        return [f64::NAN; 2];
    };
    let count = a.vertex_share.len();
    let weight = |pose: &PreparedPose, at: usize| match metric.params.area_weights {
        true => lanes_at(&pose.vertex_share, at),
        // Beyond the last vertex nothing weighs.
        false => Lanes(from_fn(|lane| f64::from(at + lane < count))),
    };
    let splat = |vector: Vector3| three(|axis| Lanes::splat(vector[axis]));
    let r = three(|row| three(|column| Lanes::splat(rotation[(row, column)])));
    let shift = splat(*translation);
    let centre_a = splat(moments_a.centre);
    // Where the centre of the second pose is laid.
    let centre_b = splat(rotation * moments_b.centre + translation);
    let (mut sums_a, mut sums_b) = (WaySums::default(), WaySums::default());
    for at in (0..count).step_by(LANES) {
        let p = three(|axis| lanes_at(&a.axes[axis], at));
        let q = three(|axis| lanes_at(&b.axes[axis], at));
        let laid = three(|i| r[i][0] * q[0] + r[i][1] * q[1] + r[i][2] * q[2] + shift[i]);
        let x = three(|axis| laid[axis] - p[axis]);
        sums_a.add(weight(a, at), three(|axis| p[axis] - centre_a[axis]), x);
        sums_b.add(weight(b, at), three(|axis| laid[axis] - centre_b[axis]), x);
    }
    [
        sums_a.left_over(moments_a, &Matrix3::identity()),
        sums_b.left_over(moments_b, &rotation.transpose()),
    ]
}

/// Four values from a place on, with zeros beyond the last.
#[inline(always)]
fn lanes_at(values: &[f64], at: usize) -> Lanes {
    match values.get(at..at + LANES) {
        Some(&[a, b, c, d]) => Lanes([a, b, c, d]),
        _ => Lanes(from_fn(|lane| {
            values.get(at + lane).copied().unwrap_or(0.0)
        })),
    }
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
        // At both poses: the rigid part that is taken out depends on where the vertices are.
        left_over(metric, [a, b], rotation, translation)
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
