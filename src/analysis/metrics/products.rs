//! All inner products of two fields at once, at the cost of little more than one.

use crate::mesh::Vector3;

use super::curvature::{deficit_rates, density_rates};
use super::metric::Metric;
use super::params::{Form, MetricKind};
use super::pose::PreparedPose;

impl Metric {
    /// ⟨⟨X, X⟩⟩, ⟨⟨X, Y⟩⟩ and ⟨⟨Y, Y⟩⟩ at a pose, as [`Self::inner_product`] gives them.
    ///
    /// Terms and rates of curvature of each field are computed once where the form is bilinear.
    pub fn products(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> [f64; 3] {
        let by_terms = match self.params.kind {
            MetricKind::Isometric | MetricKind::Rigid => false,
            MetricKind::AnglePreserving => self.params.form != Form::Printed,
            MetricKind::QuasiConformal => self.params.form == Form::Additive,
        };
        let fits = |field: &[Vector3]| field.len() == self.mesh.vertex_count;
        if !(by_terms && fits(x) && fits(y)) {
            return [(x, x), (x, y), (y, y)].map(|(x, y)| self.inner_product(at, x, y));
        }
        let mut sums = [0.0; 3];
        let terms = self
            .corner_terms(at, x)
            .into_iter()
            .zip(self.corner_terms(at, y));
        for ((x, y), weight) in terms.zip(&at.face_weight) {
            for (x, y) in x.into_iter().zip(y) {
                add(&mut sums, *weight, x, y);
            }
        }
        if self.params.kind == MetricKind::QuasiConformal {
            let (points, rings) = (at.points(), self.params.curvature_rings);
            let rates = |field: &[Vector3]| {
                if self.params.area_weights {
                    density_rates(&self.mesh, &points, field, rings)
                } else {
                    deficit_rates(&self.mesh, &points, field)
                }
            };
            let rates = rates(x).into_iter().zip(rates(y));
            for ((x, y), weight) in rates.zip(self.vertex_weights(at)) {
                add(&mut sums, self.params.mu * weight, x, y);
            }
        }
        let pairs = [(x, x), (x, y), (y, y)];
        let rest = pairs.map(|(x, y)| self.regulariser(at, x, y));
        [0, 1, 2].map(|i| sums[i] + rest[i])
    }
}

fn add(sums: &mut [f64; 3], weight: f64, x: f64, y: f64) {
    for (sum, product) in sums.iter_mut().zip([x * x, x * y, y * y]) {
        *sum += weight * product;
    }
}
