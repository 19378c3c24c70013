//! Sums over faces and vertices, kept apart by face.

use crate::mesh::Point3;

use super::compared_curvature::Areas;
use super::connectivity::Connectivity;
use super::metric::Metric;
use super::pair_sums::Both;
use super::params::Corners;
use super::pose::PreparedPose;

/// Adds to each face half its energy at both poses; `energy` gets the face, the stretches of its sides and, where
/// corners are raw, their squared lengths.
pub(super) fn add_face_shares(
    metric: &Metric,
    poses: [&PreparedPose; 2],
    stretch: &[Both],
    shares: &mut [f64],
    energy: impl Fn(usize, [f64; 3], Option<[f64; 3]>) -> f64,
) {
    let raw = metric.params.corners == Corners::Raw;
    for (f, edges) in metric.mesh.face_edges.iter().enumerate() {
        for (side, pose) in poses.into_iter().enumerate() {
            // Half at either pose: the shares add up to half the energy, the square of the distance.
            let s = edges.map(|e| stretch[e as usize][side]);
            let l = raw.then(|| edges.map(|e| pose.length2[e as usize]));
            shares[f] += 0.5 * pose.face_weight[f] * energy(f, s, l);
        }
    }
}

/// Area of each face over that of all.
pub(super) struct RelativeAreas(Vec<f64>);

impl RelativeAreas {
    pub fn new(mesh: &Connectivity, points: &[Point3]) -> Self {
        let areas = Areas::new(mesh, points);
        // A pose without area has no shares; zero adds nothing instead of not-a-number.
        let over = if areas.total > 0.0 {
            1.0 / areas.total
        } else {
            0.0
        };
        Self(areas.of_faces.iter().map(|area| area * over).collect())
    }

    /// Gives terms of vertices to the faces around them: by area, or in equal parts.
    pub fn spread(&self, mesh: &Connectivity, terms: &[f64], by_area: bool, shares: &mut [f64]) {
        if by_area {
            for ((triangle, area), share) in mesh.triangles.iter().zip(&self.0).zip(shares) {
                let sum: f64 = triangle.iter().map(|&v| terms[v as usize]).sum();
                *share += area / 3.0 * sum;
            }
            return;
        }
        // Without area weights each vertex counts once, however many faces share it.
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
