//! Where two poses differ: the share of every face in their squared distance.

use nalgebra::Matrix3;

use crate::mesh::{Point3, Vector3};

use super::connectivity::Connectivity;
use super::curvature::Areas;
use super::face_charge::{of_corners, of_sides};
use super::metric::{Metric, PairScratch};
use super::pair::stretches;
use super::params::{Corners, Form, MetricKind, Regulariser};
use super::pose::PreparedPose;
use super::rigid::rigid_part;

impl Metric {
    /// Share of each face in the squared distance of A and of B laid onto it, in the units of the metric; they
    /// add up to [`super::PairNorms::energy`] / 2.
    ///
    /// Terms of corners belong to their face. Terms of edges belong to the faces beside them, terms of vertices
    /// (curvature change, regulariser, the rigid metric) to the faces around them: by area where areas count,
    /// else in equal parts. A vertex of no face gives its terms to none; only where vertices count the same
    /// is there any.
    pub fn face_contributions(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        rotation: &Matrix3<f64>,
        translation: &Vector3,
        scratch: &mut PairScratch,
    ) -> Vec<f64> {
        let mut shares = vec![0.0; self.mesh.triangles.len()];
        if self.params.kind != MetricKind::Rigid {
            stretches(a, b, rotation, &mut scratch.stretch);
            self.add_face_terms(a, b, &scratch.stretch, &mut shares);
        }
        let before = a.points();
        let after: Vec<Point3> = (b.points().iter())
            .map(|p| Point3::from(rotation * p.coords + translation))
            .collect();
        let field: Vec<Vector3> = after.iter().zip(&before).map(|(q, p)| q - p).collect();
        for (pose, points) in [(a, &before), (b, &after)] {
            let areas = FaceShares::new(&self.mesh, points);
            self.add_own_vertex_terms(a, b, pose, (points, &field), &areas, &mut shares);
            let terms: Vec<f64> = (field.iter())
                .map(|x| 0.5 * pose.regulariser_factor * x.norm_squared())
                .collect();
            let by_area = self.params.regulariser == Regulariser::Area;
            areas.spread(&self.mesh, &terms, by_area, &mut shares);
        }
        shares
    }

    /// Half the terms of corners, or of edges, at both poses.
    fn add_face_terms(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        stretch: &[[f64; 2]],
        shares: &mut [f64],
    ) {
        let factors = match (self.params.kind, self.params.form) {
            (MetricKind::QuasiConformal, Form::Additive) => None,
            (MetricKind::QuasiConformal, _) => Some(change(a, b)),
            _ => None,
        };
        let printed = self.params.form == Form::Printed;
        let parts = self.mesh.side_parts(self.params.area_weights);
        let faces = self.mesh.triangles.iter().zip(&self.mesh.face_edges);
        for (f, ((triangle, edges), parts)) in faces.zip(parts).enumerate() {
            for (side, pose) in [a, b].into_iter().enumerate() {
                let s = edges.map(|e| stretch[e as usize][side]);
                let l = (self.params.corners == Corners::Raw)
                    .then(|| edges.map(|e| pose.length2[e as usize]));
                let found = if self.params.kind == MetricKind::Isometric {
                    of_sides(s, l, parts)
                } else {
                    let k = factors
                        .as_ref()
                        .map(|factors| triangle.map(|v| factors[v as usize]));
                    of_corners(s, l, k, printed)
                };
                shares[f] += 0.5 * pose.face_weight[f] * found.charge;
            }
        }
    }

    /// Half the terms that the metric itself has at vertices, at one of the poses.
    fn add_own_vertex_terms(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        at: &PreparedPose,
        (points, field): (&[Point3], &[Vector3]),
        areas: &FaceShares,
        shares: &mut [f64],
    ) {
        let terms: Vec<f64> = match (self.params.kind, self.params.form) {
            (MetricKind::QuasiConformal, Form::Additive) => (change(a, b).into_iter())
                .map(|change| 0.5 * self.params.mu * change * change)
                .collect(),
            (MetricKind::Rigid, _) => {
                let rigid = rigid_part(points, &self.vertex_weights(at), field);
                (points.iter().zip(field))
                    .map(|(p, x)| 0.5 * (x - rigid.at(p)).norm_squared())
                    .collect()
            }
            _ => return,
        };
        areas.spread(&self.mesh, &terms, self.params.area_weights, shares);
    }
}

/// K(B) − K(A) of each vertex.
fn change(a: &PreparedPose, b: &PreparedPose) -> Vec<f64> {
    (a.curvature.iter().zip(&b.curvature))
        .map(|(before, after)| after - before)
        .collect()
}

/// Area of each face over that of all.
struct FaceShares(Vec<f64>);

impl FaceShares {
    fn new(mesh: &Connectivity, points: &[Point3]) -> Self {
        let areas = Areas::new(mesh, points);
        let over = if areas.total > 0.0 {
            1.0 / areas.total
        } else {
            0.0
        };
        Self(areas.of_faces.iter().map(|area| area * over).collect())
    }

    /// Gives terms of vertices to the faces around them.
    fn spread(&self, mesh: &Connectivity, terms: &[f64], by_area: bool, shares: &mut [f64]) {
        if by_area {
            for ((triangle, area), share) in mesh.triangles.iter().zip(&self.0).zip(shares) {
                let sum: f64 = triangle.iter().map(|&v| terms[v as usize]).sum();
                *share += area / 3.0 * sum;
            }
            return;
        }
        let mut faces_around = vec![0_u32; terms.len()];
        for &vertex in mesh.triangles.iter().flatten() {
            faces_around[vertex as usize] += 1;
        }
        for (triangle, share) in mesh.triangles.iter().zip(shares) {
            *share += (triangle.iter())
                .map(|&v| terms[v as usize] / f64::from(faces_around[v as usize]))
                .sum::<f64>();
        }
    }
}

#[cfg(test)]
mod tests;
