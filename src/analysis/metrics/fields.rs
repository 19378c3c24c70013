//! Inner products of two fields at a pose: the metric as a form on displacements.

use crate::mesh::Vector3;

use super::kinds::terms;
use super::metric::Metric;
use super::pose::PreparedPose;

impl Metric {
    /// ⟨⟨X, Y⟩⟩ at a pose, for fields with one displacement per vertex: the product of the metric's kind (one file each in
    /// `kinds`) plus λ Σ_p a_p X_p·Y_p.
    ///
    /// Linear in each field where [`super::MetricParams::is_inner_product`] says so. Frozen products take the curvature
    /// change of each field.
    /// Pairs of poses use ΔK = K(B) − K(A) also in the additive form, which agrees with its rate dK to first
    /// order in B − A. Fields of another length than the pose yield NaN.
    pub fn inner_product(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        if !self.fits(x) || !self.fits(y) {
            return f64::NAN;
        }
        terms(self.params.kind).product(self, at, x, y) + self.regulariser(at, x, y)
    }

    /// Squared norm ⟨⟨X, X⟩⟩ at a pose.
    pub fn norm2(&self, at: &PreparedPose, x: &[Vector3]) -> f64 {
        self.inner_product(at, x, x)
    }

    /// ⟨⟨X, X⟩⟩, ⟨⟨X, Y⟩⟩ and ⟨⟨Y, Y⟩⟩ at a pose, as [`Self::inner_product`] gives them.
    ///
    /// Terms and rates of curvature of each field are computed once where the form is bilinear.
    pub fn products(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> [f64; 3] {
        if !self.fits(x) || !self.fits(y) {
            // Fields that do not fit give not-a-number, as single products do.
            return [(x, x), (x, y), (y, y)].map(|(x, y)| self.inner_product(at, x, y));
        }
        // In one pass where a metric has one: transport asks for all three at every sample.
        let own = terms(self.params.kind).products(self, at, x, y);
        let rest = [(x, x), (x, y), (y, y)].map(|(x, y)| self.regulariser(at, x, y));
        [0, 1, 2].map(|i| own[i] + rest[i])
    }

    /// A field as numbers in which the metric at a pose is Euclidean: ⟨⟨X, Y⟩⟩ is the sum of products of those of X and of
    /// Y. Linear in the field, so that distances of many fields cost no more than differences of numbers. Some ten per
    /// vertex; empty for fields of another length than the pose. Of forms that are no inner product, those of the
    /// additive form.
    pub fn coordinates(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        let mut coordinates = Vec::new();
        if self.fits(field) {
            terms(self.params.kind).add_coordinates(self, at, field, &mut coordinates);
            if self.params.lambda > 0.0 {
                self.add_regulariser_coordinates(at, field, &mut coordinates);
            }
        }
        coordinates
    }

    /// (ΔK_p)² of a pair of poses, per vertex; empty unless the metric is quasi-conformal.
    pub fn frozen_weights(&self, a: &PreparedPose, b: &PreparedPose) -> Vec<f64> {
        (a.curvature.iter().zip(&b.curvature))
            .map(|(before, after)| (after - before).powi(2))
            .collect()
    }
}

#[cfg(test)]
impl Metric {
    /// Σ_f a_f Σ_c w_c t_c(X) t_c(Y) + λ Σ_p a_p X_p·Y_p with weights w per vertex, such as
    /// those of [`Self::frozen_weights`]: an inner product at every pose.
    pub(super) fn frozen_inner_product(
        &self,
        at: &PreparedPose,
        weights: &[f64],
        x: &[Vector3],
        y: &[Vector3],
    ) -> f64 {
        if !self.fits(x) || !self.fits(y) || weights.len() != self.mesh.vertex_count {
            return f64::NAN;
        }
        let terms = self
            .corner_terms(at, x)
            .into_iter()
            .zip(self.corner_terms(at, y));
        let faces = self.mesh.triangles.iter().zip(&at.face_weight);
        let sum: f64 = terms
            .zip(faces)
            .map(|((tx, ty), (triangle, face_weight))| {
                let corner = |c: usize| weights[triangle[c] as usize] * tx[c] * ty[c];
                face_weight * (0..3).map(corner).sum::<f64>()
            })
            .sum();
        sum + self.regulariser(at, x, y)
    }
}
