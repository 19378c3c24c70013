//! Where two poses differ: the share of every face in their squared distance.

use nalgebra::Matrix3;

use crate::mesh::{Point3, Vector3};

use super::face_shares::RelativeAreas;
use super::kinds::terms;
use super::metric::{Metric, PairScratch};
use super::params::Regulariser;
use super::pose::PreparedPose;

impl Metric {
    /// Share of each face in the squared distance of A and of B aligned with it, in the units of the metric; they
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
        let kind = terms(self.params.kind);
        kind.add_face_shares(self, [a, b], rotation, scratch, &mut shares);
        let before = a.points();
        let after: Vec<Point3> = (b.points().iter())
            .map(|p| Point3::from(rotation * p.coords + translation))
            .collect();
        let field: Vec<Vector3> = after.iter().zip(&before).map(|(q, p)| q - p).collect();
        for (pose, points) in [(a, &before), (b, &after)] {
            let areas = RelativeAreas::new(&self.mesh, points);
            if let Some(own) = kind.vertex_terms(self, [a, b], pose, points, &field) {
                areas.spread(&self.mesh, &own, self.params.area_weights, &mut shares);
            }
            // Half at either pose, as for the terms of faces.
            let rest: Vec<f64> = (field.iter())
                .map(|x| 0.5 * pose.regulariser_factor * x.norm_squared())
                .collect();
            let by_area = self.params.regulariser == Regulariser::Area;
            areas.spread(&self.mesh, &rest, by_area, &mut shares);
        }
        shares
    }
}

#[cfg(test)]
mod tests;
