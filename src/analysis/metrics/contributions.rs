//! Which faces make two poses differ: the squared distance of a pair, divided over the faces.

use nalgebra::Matrix3;

use crate::mesh::{Point3, Vector3};

use super::face_charge::of_corners;
use super::metric::{Metric, PairScratch};
use super::pair::stretches;
use super::params::{Corners, Form, MetricKind, Regulariser};
use super::pose::PreparedPose;
use super::rigid::rigid_part;

impl Metric {
    /// Share of each face in the squared distance of a pair, as [`Self::pair_moved`] has it: shares
    /// sum to (⟨⟨X, X⟩⟩ at A + ⟨⟨X, X⟩⟩ at B) / 2.
    ///
    /// Terms of a face are its own. A term of an edge is divided over the faces beside it as the
    /// edge's weight is, a term of a vertex over those around it by their areas, so that where areas
    /// count each face has what lies on it.
    pub fn face_contributions(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        rotation: &Matrix3<f64>,
        translation: &Vector3,
        scratch: &mut PairScratch,
    ) -> Vec<f64> {
        let mut faces = vec![0.0; self.mesh.triangles.len()];
        let moved = Moved::new(a, b, rotation, translation);
        match self.params.kind {
            MetricKind::Rigid => self.add_rigid(&mut faces, a, b, &moved),
            MetricKind::Isometric => {
                stretches(a, b, rotation, &mut scratch.stretch);
                self.add_sides(&mut faces, a, b, &scratch.stretch);
            }
            MetricKind::AnglePreserving => {
                stretches(a, b, rotation, &mut scratch.stretch);
                self.add_corners(&mut faces, a, b, &scratch.stretch, false);
            }
            MetricKind::QuasiConformal => {
                stretches(a, b, rotation, &mut scratch.stretch);
                let additive = self.params.form == Form::Additive;
                self.add_corners(&mut faces, a, b, &scratch.stretch, !additive);
                if additive {
                    self.add_curvature(&mut faces, a, b);
                }
            }
        }
        self.add_regulariser(&mut faces, a, b, &moved);
        faces
    }

    fn add_corners(
        &self,
        faces: &mut [f64],
        a: &PreparedPose,
        b: &PreparedPose,
        stretch: &[[f64; 2]],
        by_curvature_change: bool,
    ) {
        let raw = self.params.corners == Corners::Raw;
        let printed = self.params.form == Form::Printed;
        let change = |v: u32| b.curvature[v as usize] - a.curvature[v as usize];
        for (f, share) in faces.iter_mut().enumerate() {
            let edges = self.mesh.face_edges[f];
            let factor = by_curvature_change.then(|| self.mesh.triangles[f].map(change));
            for (side, pose) in [a, b].into_iter().enumerate() {
                let s = edges.map(|e| stretch[e as usize][side]);
                let l = raw.then(|| edges.map(|e| pose.length2[e as usize]));
                *share += 0.5 * pose.face_weight[f] * of_corners(s, l, factor, printed).charge;
            }
        }
    }

    fn add_sides(
        &self,
        faces: &mut [f64],
        a: &PreparedPose,
        b: &PreparedPose,
        stretch: &[[f64; 2]],
    ) {
        let raw = self.params.corners == Corners::Raw;
        let parts = self.mesh.side_parts(self.params.area_weights);
        for ((f, share), parts) in faces.iter_mut().enumerate().zip(parts) {
            for (&edge, part) in self.mesh.face_edges[f].iter().zip(parts) {
                for (side, pose) in [a, b].into_iter().enumerate() {
                    let unit = if raw {
                        pose.length2[edge as usize]
                    } else {
                        1.0
                    };
                    let rate = stretch[edge as usize][side] * unit;
                    *share += 0.5 * pose.face_weight[f] * part * rate * rate;
                }
            }
        }
    }

    fn add_curvature(&self, faces: &mut [f64], a: &PreparedPose, b: &PreparedPose) {
        for pose in [a, b] {
            let weights = self.vertex_weights(pose);
            let changes = a.curvature.iter().zip(&b.curvature);
            let terms: Vec<f64> = (weights.iter().zip(changes))
                .map(|(weight, (before, after))| {
                    0.5 * self.params.mu * weight * (after - before).powi(2)
                })
                .collect();
            self.add_vertices(faces, pose, &terms);
        }
    }

    fn add_rigid(&self, faces: &mut [f64], a: &PreparedPose, b: &PreparedPose, moved: &Moved) {
        for (pose, points) in [(a, &moved.before), (b, &moved.after)] {
            let weights = self.vertex_weights(pose);
            let rigid = rigid_part(points, &weights, &moved.field);
            let terms: Vec<f64> = (points.iter().zip(&moved.field).zip(&weights))
                .map(|((point, x), weight)| 0.5 * weight * (x - rigid.at(point)).norm_squared())
                .collect();
            self.add_vertices(faces, pose, &terms);
        }
    }

    fn add_regulariser(
        &self,
        faces: &mut [f64],
        a: &PreparedPose,
        b: &PreparedPose,
        moved: &Moved,
    ) {
        if self.params.lambda == 0.0 {
            return;
        }
        let by_area = self.params.regulariser == Regulariser::Area;
        for pose in [a, b] {
            let weight = |v: usize| if by_area { pose.vertex_share[v] } else { 1.0 };
            let terms: Vec<f64> = (moved.field.iter().enumerate())
                .map(|(v, x)| 0.5 * pose.regulariser_factor * weight(v) * x.norm_squared())
                .collect();
            self.add_vertices(faces, pose, &terms);
        }
    }

    /// Divides a number of each vertex over the faces around it: by their weights, which are areas
    /// or all the same; evenly where the weights are zero.
    fn add_vertices(&self, faces: &mut [f64], pose: &PreparedPose, terms: &[f64]) {
        let mut around = vec![[0.0; 2]; terms.len()];
        for (triangle, weight) in self.mesh.triangles.iter().zip(&pose.face_weight) {
            for &v in triangle {
                around[v as usize][0] += weight;
                around[v as usize][1] += 1.0;
            }
        }
        let shares = faces.iter_mut().zip(&pose.face_weight);
        for ((share, weight), triangle) in shares.zip(&self.mesh.triangles) {
            for &v in triangle {
                let [weights, count] = around[v as usize];
                let part = if weights > 0.0 {
                    weight / weights
                } else {
                    1.0 / count
                };
                *share += part * terms[v as usize];
            }
        }
    }
}

/// Both poses, the second laid onto the first, and the field between them.
struct Moved {
    before: Vec<Point3>,
    after: Vec<Point3>,
    field: Vec<Vector3>,
}

impl Moved {
    fn new(
        a: &PreparedPose,
        b: &PreparedPose,
        rotation: &Matrix3<f64>,
        translation: &Vector3,
    ) -> Self {
        let before = a.points();
        let after: Vec<Point3> = (b.points().iter())
            .map(|p| Point3::from(rotation * p.coords + translation))
            .collect();
        let field = after.iter().zip(&before).map(|(q, p)| q - p).collect();
        Self {
            before,
            after,
            field,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::metrics::MetricParams;
    use crate::mesh::phantom;
    use nalgebra::Rotation3;

    fn dented(strength: f64) -> Vec<Point3> {
        let sphere = phantom::sphere(2, 1.0);
        let dent = |p: &Point3| 1.0 - strength * (4.0 * (p.z - 1.0)).exp();
        sphere.vertices().iter().map(|p| p * dent(p)).collect()
    }

    #[test]
    fn shares_of_faces_sum_to_the_squared_distance_of_every_kind_and_form() {
        let sphere = phantom::sphere(2, 1.0);
        let (start, end) = (dented(0.0), dented(0.3));
        let rotation = Rotation3::from_euler_angles(0.02, -0.03, 0.01).into_inner();
        let translation = Vector3::new(0.01, 0.0, -0.02);
        let mut scratch = PairScratch::default();
        let kinds = [
            MetricKind::Isometric,
            MetricKind::Rigid,
            MetricKind::AnglePreserving,
            MetricKind::QuasiConformal,
        ];
        let forms = [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive];
        for kind in kinds {
            for form in forms {
                for (corners, area_weights, regulariser) in [
                    (Corners::ScaleFree, true, Regulariser::Area),
                    (Corners::Raw, false, Regulariser::Uniform),
                ] {
                    let params = MetricParams {
                        kind,
                        form,
                        corners,
                        area_weights,
                        regulariser,
                        ..MetricParams::default()
                    };
                    let metric = Metric::new(sphere.faces(), params.check().unwrap());
                    let poses = [&start, &end].map(|points| metric.prepare(points).unwrap());
                    let [a, b] = &poses;
                    let norms = metric.pair_moved(a, b, &rotation, &translation, &mut scratch);
                    let shares =
                        metric.face_contributions(a, b, &rotation, &translation, &mut scratch);
                    let (sum, wanted) = (shares.iter().sum::<f64>(), 0.5 * norms.energy());
                    assert!(
                        (sum - wanted).abs() < 1e-12 * wanted,
                        "{params:?}: {sum} in place of {wanted}"
                    );
                    assert!(shares.iter().all(|share| *share >= 0.0));
                }
            }
        }
    }

    #[test]
    fn a_dent_is_found_where_it_is() {
        let sphere = phantom::sphere(3, 1.0);
        let dent = |p: &Point3| 1.0 - 0.2 * (8.0 * (p.z - 1.0)).exp();
        let end: Vec<Point3> = sphere.vertices().iter().map(|p| p * dent(p)).collect();
        let metric = Metric::new(sphere.faces(), MetricParams::default().check().unwrap());
        let a = metric.prepare(sphere.vertices()).unwrap();
        let b = metric.prepare(&end).unwrap();
        let (none, scratch) = (Vector3::zeros(), &mut PairScratch::default());
        let shares = metric.face_contributions(&a, &b, &Matrix3::identity(), &none, scratch);
        let total: f64 = shares.iter().sum();
        let above: f64 = (sphere.triangles().iter().zip(&shares))
            .filter(|(face, _)| face.iter().any(|&v| sphere.vertices()[v as usize].z > 0.5))
            .map(|(_, share)| share)
            .sum();
        assert!(above > 0.95 * total, "{above} of {total}");
    }
}
