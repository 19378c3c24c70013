//! Terms of displacement fields at a pose, of which metrics make their inner products.

use crate::mesh::{Vector3, angle_deficits_rad};

use super::compared_curvature::{Areas, curvature_density, deficit_rates, density_rates};
use super::corner::{corner_terms, raw_units, times};
use super::metric::Metric;
use super::params::{Corners, Form, Regulariser};
use super::pose::PreparedPose;

impl Metric {
    /// Terms of eq. 3.3 at the corners of each face abc, p = a with q = b and r = c, and so round:
    /// T = ⟨p − q, X_p − X_q⟩|p − r|² − ⟨p − r, X_p − X_r⟩|p − q|², over |p − q|²|p − r|² where
    /// corners are scale-free. A field of another length than the pose yields nothing.
    pub fn corner_terms(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<[f64; 3]> {
        if !self.fits(field) {
            return Vec::new();
        }
        let stretch = self.field_stretch(at, field);
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

    /// Whether a field has one displacement per vertex.
    pub(super) fn fits(&self, field: &[Vector3]) -> bool {
        field.len() == self.mesh.vertex_count
    }

    /// ⟨X_p − X_q, p − q⟩ / |p − q|² of each edge.
    pub(super) fn field_stretch(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        (self.mesh.edges.iter().enumerate())
            .map(|(e, &[p, q])| {
                let difference = field[p as usize] - field[q as usize];
                let side = Vector3::new(at.edge_axes[0][e], at.edge_axes[1][e], at.edge_axes[2][e]);
                // The rate of the logarithm of length, to first order in the field.
                difference.dot(&side) * at.inverse_length2[e]
            })
            .collect()
    }

    /// Σ_f a_f of products of corner terms, or of their sums of magnitudes in the printed form; `change`, one per vertex,
    /// multiplies the terms of each field.
    pub(super) fn corner_product(
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
                    // The factor of a corner is the curvature change at its vertex.
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

    /// Σ_f a_f Σ_c of the products XX, XY and YY of corner terms, which are computed once for each field.
    pub(super) fn corner_products(
        &self,
        at: &PreparedPose,
        x: &[Vector3],
        y: &[Vector3],
    ) -> [f64; 3] {
        let mut sums = [0.0; 3];
        let terms = self
            .corner_terms(at, x)
            .into_iter()
            .zip(self.corner_terms(at, y));
        for ((x, y), weight) in terms.zip(&at.face_weight) {
            for (x, y) in x.into_iter().zip(y) {
                for (sum, product) in sums.iter_mut().zip([x * x, x * y, y * y]) {
                    *sum += weight * product;
                }
            }
        }
        sums
    }

    /// Appends √a_f t_c(X) of all corners: their products are Σ_f a_f Σ_c t_c(X) t_c(Y).
    pub(super) fn add_corner_coordinates(
        &self,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        let terms = self.corner_terms(at, field).into_iter();
        coordinates.extend((terms.zip(&at.face_weight)).flat_map(|(t, weight)| {
            let root = weight.sqrt();
            t.map(|t| root * t)
        }));
    }

    /// Rate of curvature along a field, per vertex.
    pub(super) fn curvature_rates(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        if self.params.area_weights {
            density_rates(&self.mesh, &at.points(), field, self.rings())
        } else {
            deficit_rates(&self.mesh, &at.points(), field)
        }
    }

    /// K(M + X) − K(M) of each vertex.
    pub(super) fn curvature_change(&self, at: &PreparedPose, field: &[Vector3]) -> Vec<f64> {
        // The true change, not its rate: the printed form multiplies by K(M + X) − K(M).
        let moved: Vec<_> = (at.points().into_iter().zip(field))
            .map(|(p, x)| p + x)
            .collect();
        let after = if self.params.area_weights {
            let areas = Areas::new(&self.mesh, &moved);
            curvature_density(&self.mesh, &moved, &areas, self.rings())
        } else {
            angle_deficits_rad(&moved, &self.mesh.triangles, &self.mesh.flat_rad)
        };
        (after.iter().zip(&at.curvature))
            .map(|(after, before)| after - before)
            .collect()
    }

    /// λ Σ_p a_p X_p·Y_p.
    pub(super) fn regulariser(&self, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        let by_area = self.params.regulariser == Regulariser::Area;
        let sum: f64 = (at.vertex_share.iter().zip(x.iter().zip(y)))
            .map(|(share, (x, y))| if by_area { share * x.dot(y) } else { x.dot(y) })
            .sum();
        at.regulariser_factor * sum
    }

    /// Appends √(λ a_p) X_p: their products are the regulariser.
    pub(super) fn add_regulariser_coordinates(
        &self,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        let by_area = self.params.regulariser == Regulariser::Area;
        for (share, x) in at.vertex_share.iter().zip(field) {
            let weight = at.regulariser_factor * if by_area { *share } else { 1.0 };
            coordinates.extend((x * weight.sqrt()).iter());
        }
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
