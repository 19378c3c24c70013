//! Inner products of two fields at a pose: the metric as a form on displacements.

use crate::mesh::{Vector3, angle_deficits_rad};

use super::corner::{corner_terms, raw_units, times};
use super::curvature::{Areas, curvature_density, deficit_rates, density_rates};
use super::metric::Metric;
use super::params::{Corners, Form, MetricKind, Regulariser};
use super::pose::PreparedPose;
use super::rigid::rigid_product;

impl Metric {
    /// ⟨⟨X, Y⟩⟩ at a pose, for fields with one displacement per vertex.
    ///
    /// - Isometric: Σ_e ⟨X_p − X_q, p − q⟩⟨Y_p − Y_q, p − q⟩, each factor over |p − q|² where
    ///   corners are scale-free.
    /// - Rigid: Σ_p X'·Y', X' and Y' freed of their own rigid parts.
    /// - Angle-preserving: printed Σ_f (Σ_c |t_c(X)|)(Σ_c |t_c(Y)|) (eq. 3.4), else
    ///   Σ_f Σ_c t_c(X) t_c(Y).
    /// - Quasi-conformal, printed (eq. 3.5) and bilinear: as before with t_c(X) ΔK_c(X), where
    ///   ΔK(X) = K(M + X) − K(M); frozen: like bilinear, use
    ///   [`Self::frozen_inner_product`] for stated weights; additive: with
    ///   + μ Σ_p dK_p(X) dK_p(Y), dK the rate of curvature along the field.
    ///
    /// Only the printed forms, and the bilinear quasi-conformal one, are no inner products.
    /// Pairs of poses use ΔK = K(B) − K(A) also in the additive form, which agrees with dK to first
    /// order in B − A. Fields of another length than the pose yield NaN.
    pub fn inner_product(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        if !self.fits(x) || !self.fits(y) {
            return f64::NAN;
        }
        let own = match self.params.kind {
            MetricKind::Isometric => self.isometric(at, x, y),
            MetricKind::Rigid => {
                let weights = self.vertex_weights(at);
                rigid_product(&at.points(), &weights, x, y)
            }
            MetricKind::AnglePreserving => self.angles(at, x, y, None),
            MetricKind::QuasiConformal => self.quasi_conformal(at, x, y),
        };
        own + self.regulariser(at, x, y)
    }

    /// Squared norm ⟨⟨X, X⟩⟩ at a pose.
    pub fn norm2(&self, at: &PreparedPose, x: &[Vector3]) -> f64 {
        self.inner_product(at, x, x)
    }

    /// Σ_f a_f Σ_c w_c t_c(X) t_c(Y) + λ Σ_p a_p X_p·Y_p with weights w per vertex, such as
    /// those of [`Self::frozen_weights`]: an inner product at every pose.
    pub fn frozen_inner_product(
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

    /// (ΔK_p)² of a pair of poses, per vertex; empty unless the metric is quasi-conformal.
    pub fn frozen_weights(&self, a: &PreparedPose, b: &PreparedPose) -> Vec<f64> {
        (a.curvature.iter().zip(&b.curvature))
            .map(|(before, after)| (after - before).powi(2))
            .collect()
    }

    /// Terms of eq. 3.3 at the corners of each face abc, p = a with q = b and r = c, and so round:
    /// T = ⟨p − q, X_p − X_q⟩|p − r|² − ⟨p − r, X_p − X_r⟩|p − q|², over |p − q|²|p − r|² where
    /// corners are scale-free. A field of another length than the pose yields nothing.
    pub fn corner_terms(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<[f64; 3]> {
        if !self.fits(field) {
            return Vec::new();
        }
        let stretch = self.stretch(at, field);
        let raw = self.params.corners == Corners::Raw;
        self.mesh
            .face_edges
            .iter()
            .map(|edges| {
                let s = edges.map(|e| stretch[e as usize]);
                let t = corner_terms(s);
                if raw {
                    times(t, raw_units(edges.map(|e| at.length2[e as usize])))
                } else {
                    t
                }
            })
            .collect()
    }

    /// K of each vertex as this metric compares it: averaged density where areas count, else the
    /// angle deficit in radians. Empty unless the metric is quasi-conformal.
    pub fn curvature<'a>(&self, at: &'a PreparedPose) -> &'a [f64] {
        &at.curvature
    }

    fn fits(&self, field: &[Vector3]) -> bool {
        field.len() == self.mesh.vertex_count
    }

    /// ⟨X_p − X_q, p − q⟩ / |p − q|² of each edge.
    fn stretch(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        (self.mesh.edges.iter().enumerate())
            .map(|(e, &[p, q])| {
                let difference = field[p as usize] - field[q as usize];
                let side = Vector3::new(at.edge_axes[0][e], at.edge_axes[1][e], at.edge_axes[2][e]);
                difference.dot(&side) * at.inverse_length2[e]
            })
            .collect()
    }

    fn isometric(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        let weights = self.edge_weights(at);
        let rates = self.stretch(at, x).into_iter().zip(self.stretch(at, y));
        let raw = self.params.corners == Corners::Raw;
        (rates.zip(weights).enumerate())
            .map(|(e, ((x, y), weight))| {
                let unit = if raw { at.length2[e] } else { 1.0 };
                weight * (x * unit) * (y * unit)
            })
            .sum()
    }

    fn angles(
        &self,
        at: &PreparedPose,
        x: &[Vector3],
        y: &[Vector3],
        change: Option<[&[f64]; 2]>,
    ) -> f64 {
        let terms = self
            .corner_terms(at, x)
            .into_iter()
            .zip(self.corner_terms(at, y));
        let faces = self.mesh.triangles.iter().zip(&at.face_weight);
        let printed = self.params.form == Form::Printed;
        terms
            .zip(faces)
            .map(|((mut tx, mut ty), (triangle, weight))| {
                if let Some([of_x, of_y]) = change {
                    for (c, &vertex) in triangle.iter().enumerate() {
                        tx[c] *= of_x[vertex as usize];
                        ty[c] *= of_y[vertex as usize];
                    }
                }
                let sum = |t: [f64; 3]| t.iter().map(|v| v.abs()).sum::<f64>();
                let product = if printed {
                    sum(tx) * sum(ty)
                } else {
                    (0..3).map(|c| tx[c] * ty[c]).sum()
                };
                weight * product
            })
            .sum()
    }

    fn quasi_conformal(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        if self.params.form != Form::Additive {
            let (of_x, of_y) = (self.curvature_change(at, x), self.curvature_change(at, y));
            return self.angles(at, x, y, Some([&of_x, &of_y]));
        }
        let rates = |field: &[Vector3]| {
            if self.params.area_weights {
                density_rates(&self.mesh, &at.points(), field, self.params.curvature_rings)
            } else {
                deficit_rates(&self.mesh, &at.points(), field)
            }
        };
        let curvature: f64 = (self.vertex_weights(at).iter())
            .zip(rates(x).into_iter().zip(rates(y)))
            .map(|(weight, (x, y))| weight * x * y)
            .sum();
        self.angles(at, x, y, None) + self.params.mu * curvature
    }

    /// K(M + X) − K(M) of each vertex.
    fn curvature_change(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        let moved: Vec<_> = (at.points().into_iter().zip(field))
            .map(|(p, x)| p + x)
            .collect();
        let after = if self.params.area_weights {
            let areas = Areas::new(&self.mesh, &moved);
            curvature_density(&self.mesh, &moved, &areas, self.params.curvature_rings)
        } else {
            angle_deficits_rad(&moved, &self.mesh.triangles, &self.mesh.flat_rad)
        };
        (after.iter().zip(&at.curvature))
            .map(|(after, before)| after - before)
            .collect()
    }

    pub(super) fn regulariser(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        let by_area = self.params.regulariser == Regulariser::Area;
        let sum: f64 = (at.vertex_share.iter().zip(x.iter().zip(y)))
            .map(|(share, (x, y))| if by_area { share * x.dot(y) } else { x.dot(y) })
            .sum();
        at.regulariser_factor * sum
    }

    /// Weight of each vertex in sums over vertices: its share of the area, or 1.
    pub(super) fn vertex_weights(&self, at: &PreparedPose) -> Vec<f64> {
        if self.params.area_weights {
            at.vertex_share.clone()
        } else {
            vec![1.0; self.mesh.vertex_count]
        }
    }

    /// Weight of each edge: a third of the weights of its faces, or 1.
    pub(super) fn edge_weights(&self, at: &PreparedPose) -> Vec<f64> {
        let mut weights = vec![0.0; self.mesh.edges.len()];
        let parts = self.mesh.side_parts(self.params.area_weights);
        let faces = self.mesh.face_edges.iter().zip(&at.face_weight);
        for ((edges, weight), parts) in faces.zip(parts) {
            for (&edge, part) in edges.iter().zip(parts) {
                weights[edge as usize] += weight * part;
            }
        }
        weights
    }
}
