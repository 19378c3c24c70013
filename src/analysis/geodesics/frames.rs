//! How each place of the surface is turned along a path.

use nalgebra::{Matrix3, Rotation3};

use crate::mesh::{Edge, Point3, Vector3, vertex_normals};

/// Rotations that take the surroundings of each vertex at a reference pose to those at each pose
/// of a path, pose after pose.
///
/// A surface is stiff along itself and soft across. In frames that turn with it the energy is nearly
/// the same quadratic form at every pose: with e_k the edges at pose k, the two stretches
/// of a step add up to about (|e_{k+1}|² − |e_k|²) / |e|², whose slope is e_{k+1}·δe_{k+1} − e_k·δe_k.
/// Without frames, edges of one pose are charged across those of another, and the search takes
/// ten times as many iterations on hearts.
#[derive(Clone, Debug)]
pub(super) struct Frames {
    rotations: Vec<Matrix3<f64>>,
}

/// Iterations of the nearest rotation, begun at that of the pose before; 1e-3 rad is plenty.
const ITERATIONS: usize = 12;

impl Frames {
    /// From the reference to poses given flat.
    pub fn new(
        reference: &[Point3],
        edges: &[Edge],
        triangles: &[[u32; 3]],
        poses: &[f64],
    ) -> Self {
        let count = reference.len();
        let mut rotations = Vec::with_capacity(poses.len() / 3);
        let own_normals = vertex_normals(reference, triangles);
        for pose in poses.chunks_exact((3 * count).max(1)) {
            let points: Vec<Point3> = (pose.chunks_exact(3))
                .map(|p| Point3::new(p[0], p[1], p[2]))
                .collect();
            let normals = vertex_normals(&points, triangles);
            let mut fits: Vec<Matrix3<f64>> = (normals.iter().zip(&own_normals))
                .map(|(there, here)| there * here.transpose())
                .collect();
            for &[i, j] in edges {
                let [i, j] = [i as usize, j as usize];
                let (here, there) = (reference[i] - reference[j], points[i] - points[j]);
                let length2 = here.norm_squared();
                if length2 > 0.0 {
                    let fit = there * here.transpose() / length2;
                    fits[i] += fit;
                    fits[j] += fit;
                }
            }
            for fit in &fits {
                let before = rotations
                    .len()
                    .checked_sub(count)
                    .map_or_else(Rotation3::identity, |at: usize| {
                        Rotation3::from_matrix_unchecked(rotations[at])
                    });
                let nearest = Rotation3::from_matrix_eps(fit, 1e-6, ITERATIONS, before);
                let matrix = nearest.into_inner();
                let sound = matrix.iter().all(|x| x.is_finite());
                rotations.push(if sound { matrix } else { Matrix3::identity() });
            }
        }
        Self { rotations }
    }

    /// Turns vectors into the frames of the reference.
    pub fn turn_back(&self, vectors: &mut [f64]) {
        for (x, rotation) in vectors.chunks_exact_mut(3).zip(&self.rotations) {
            let turned = rotation.tr_mul(&Vector3::new(x[0], x[1], x[2]));
            x.copy_from_slice(turned.as_slice());
        }
    }

    /// Turns vectors out of the frames of the reference.
    pub fn turn(&self, vectors: &mut [f64]) {
        for (x, rotation) in vectors.chunks_exact_mut(3).zip(&self.rotations) {
            let turned = rotation * Vector3::new(x[0], x[1], x[2]);
            x.copy_from_slice(turned.as_slice());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn frames_of_a_turned_surface_are_its_turn() {
        let bowl = phantom::bowl(1.0, 5, 12);
        let turns =
            [0.4, 1.1].map(|angle| Rotation3::from_euler_angles(angle, -0.5 * angle, 0.8 * angle));
        let flat: Vec<f64> = (turns.iter())
            .flat_map(|turn| bowl.vertices().iter().map(move |p| turn * p))
            .flat_map(|p| [p.x, p.y, p.z])
            .collect();
        let edges = bowl.faces().edges();
        let frames = Frames::new(bowl.vertices(), &edges, bowl.triangles(), &flat);
        let count = bowl.vertices().len();
        for (at, rotation) in frames.rotations.iter().enumerate() {
            assert!((rotation - turns[at / count].matrix()).amax() < 1e-5);
        }
        let mut vectors = flat.clone();
        frames.turn_back(&mut vectors);
        let own: Vec<f64> = bowl
            .vertices()
            .iter()
            .flat_map(|p| [p.x, p.y, p.z])
            .collect();
        for (found, expected) in vectors.iter().zip(own.iter().chain(&own)) {
            assert!((found - expected).abs() < 1e-5);
        }
        frames.turn(&mut vectors);
        for (found, expected) in vectors.iter().zip(&flat) {
            assert!((found - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn squeezed_surroundings_have_some_frame() {
        let ball = phantom::sphere(1, 1.0);
        let squeezed = vec![0.0; 3 * 42];
        let frames = Frames::new(
            ball.vertices(),
            &ball.faces().edges(),
            ball.triangles(),
            &squeezed,
        );
        for rotation in &frames.rotations {
            assert!((rotation.determinant() - 1.0).abs() < 1e-6);
        }
    }
}
