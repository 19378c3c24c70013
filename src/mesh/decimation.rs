//! A coarser mesh made of some of a finer one's vertices, and the way back.

mod collapse;

use super::{Faces, Point3};
use collapse::Collapsing;

/// A coarse mesh whose vertices are vertices of a fine one, so that every pose of the fine mesh
/// is a pose of the coarse one: correspondence is kept.
///
/// What lives on coarse vertices is prolonged linearly: a fine vertex that was removed takes
/// barycentric weights of the coarse face that it lay nearest to when it, or the face that held it,
/// was removed. So values never jump to another sheet that happens to be close.
#[derive(Clone, Debug)]
pub struct Decimation {
    kept: Vec<u32>,
    faces: Faces,
    /// Coarse vertices and weights of each fine vertex.
    supports: Vec<([u32; 3], [f64; 3])>,
}

impl Decimation {
    /// Removes vertices by collapsing short edges where the surface is flat, until at most
    /// `max_vertices` are left or nothing can be removed; `None` if `go_on` says no.
    ///
    /// Boundaries stay boundaries and every piece keeps its topology. Vertices at edges of more
    /// than two faces, and those without a face, all stay. `points` is the template: one
    /// decimation serves all poses.
    pub fn new(
        points: &[Point3],
        faces: &Faces,
        max_vertices: usize,
        go_on: impl FnMut() -> bool,
    ) -> Option<Self> {
        let (kept, triangles, supports) =
            collapsed(points, faces, max_vertices, true, go_on)?.finished();
        let faces = Faces::new(kept.len(), triangles).ok()?;
        Some(Self {
            kept,
            faces,
            supports,
        })
    }

    /// The kept vertices and the faces over them that [`Self::new`] finds, without the way back, in half the time.
    pub fn one_way(
        points: &[Point3],
        faces: &Faces,
        max_vertices: usize,
        go_on: impl FnMut() -> bool,
    ) -> Option<(Vec<u32>, Faces)> {
        let state = collapsed(points, faces, max_vertices, false, go_on)?;
        let (kept, triangles, _) = state.finished();
        let faces = Faces::new(kept.len(), triangles).ok()?;
        Some((kept, faces))
    }

    /// Connectivity of the coarse mesh.
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// The fine vertex that each coarse vertex is, ascending.
    pub fn kept(&self) -> &[u32] {
        &self.kept
    }

    /// What coarse vertices have of values on the fine ones.
    pub fn restricted<T: Copy>(&self, fine: &[T]) -> Vec<T> {
        self.kept.iter().map(|&v| fine[v as usize]).collect()
    }

    /// Values on fine vertices from three numbers on each coarse one, both flat.
    pub fn prolonged(&self, coarse: &[f64]) -> Vec<f64> {
        let mut fine = Vec::with_capacity(3 * self.supports.len());
        for (vertices, weights) in &self.supports {
            for axis in 0..3 {
                let part = |k: usize| weights[k] * coarse[3 * vertices[k] as usize + axis];
                fine.push(part(0) + part(1) + part(2));
            }
        }
        fine
    }
}

/// The mesh after as many collapses as are needed; `None` if `go_on` says no.
fn collapsed<'a>(
    points: &'a [Point3],
    faces: &Faces,
    max_vertices: usize,
    places: bool,
    mut go_on: impl FnMut() -> bool,
) -> Option<Collapsing<'a>> {
    let mut state = Collapsing::new(points, faces, places);
    let mut left = faces.vertex_count();
    while left > max_vertices && state.collapse_cheapest() {
        left -= 1;
        if left.is_multiple_of(64) && !go_on() {
            return None;
        }
    }
    Some(state)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, area, crossing_faces, phantom};

    fn decimated(mesh: &TriMesh, most: usize) -> Decimation {
        Decimation::new(mesh.vertices(), mesh.faces(), most, || true).unwrap()
    }

    fn euler(faces: &Faces) -> i64 {
        faces.vertex_count() as i64 - faces.edges().len() as i64 + faces.triangles().len() as i64
    }

    fn flat(points: &[Point3]) -> Vec<f64> {
        points.iter().flat_map(|p| [p.x, p.y, p.z]).collect()
    }

    #[test]
    fn topology_and_boundary_stay() {
        for (mesh, number, loops) in [
            (phantom::sphere(4, 1.0), 2, 0),
            (phantom::torus(2.0, 0.7, 60, 30), 0, 0),
            (phantom::bowl(1.0, 20, 60), 1, 1),
        ] {
            let coarse = decimated(&mesh, 200);
            assert!(coarse.kept().len() <= 200, "{}", coarse.kept().len());
            assert_eq!(euler(coarse.faces()), number);
            assert_eq!(coarse.faces().boundary_loops().len(), loops);
            assert!(coarse.faces().edge_valences().iter().all(|&(_, n)| n <= 2));
        }
    }

    #[test]
    fn the_coarse_surface_keeps_its_area_and_does_not_cross_itself() {
        let ball = phantom::sphere(4, 1.0);
        let mut last = f64::INFINITY;
        for most in [150, 600, 1_500] {
            let coarse = decimated(&ball, most);
            let points = coarse.restricted(ball.vertices());
            let found = area(&points, coarse.faces().triangles());
            let lost = 1.0 - found / area(ball.vertices(), ball.triangles());
            assert!((0.0..0.1).contains(&lost) && lost < last, "{most}: {lost}");
            last = lost;
            let crossing = crossing_faces(&points, coarse.faces().triangles(), || true);
            assert_eq!(crossing, Some(0));
        }
    }

    #[test]
    fn positions_prolonged_come_back_close_and_kept_ones_exactly() {
        let ball = phantom::sphere(4, 1.0);
        let coarse = decimated(&ball, 600);
        let back = coarse.prolonged(&flat(&coarse.restricted(ball.vertices())));
        for (v, p) in ball.vertices().iter().enumerate() {
            let found = Point3::new(back[3 * v], back[3 * v + 1], back[3 * v + 2]);
            let bound = if coarse.kept().contains(&(v as u32)) {
                1e-15
            } else {
                0.06
            };
            assert!((found - p).norm() <= bound, "{v}: {}", (found - p).norm());
        }
    }

    #[test]
    fn weights_are_positive_and_sum_to_one() {
        let bowl = phantom::bowl(1.0, 20, 60);
        for (_, weights) in &decimated(&bowl, 100).supports {
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(weights.iter().all(|&w| w >= 0.0));
        }
    }

    #[test]
    fn values_stay_on_their_sheet() {
        let outer = phantom::sphere(3, 1.0);
        let inner = phantom::sphere(3, 0.97);
        let faces = Faces::joined(&[outer.faces(), inner.faces()]);
        let points: Vec<Point3> = outer
            .vertices()
            .iter()
            .chain(inner.vertices())
            .copied()
            .collect();
        let coarse = Decimation::new(&points, &faces, 160, || true).unwrap();
        let marks: Vec<f64> = (coarse.kept().iter())
            .flat_map(|&v| [if v < 642 { 0.0 } else { 1.0 }; 3])
            .collect();
        let back = coarse.prolonged(&marks);
        for v in 0..1_284 {
            let mark = if v < 642 { 0.0 } else { 1.0 };
            assert!((back[3 * v] - mark).abs() < 1e-12);
        }
    }

    #[test]
    fn nothing_is_removed_where_nothing_may_be() {
        let nothing = Faces::new(3, Vec::new()).unwrap();
        let coarse = Decimation::new(&[Point3::origin(); 3], &nothing, 1, || true).unwrap();
        assert_eq!(coarse.kept(), [0, 1, 2]);
        // A point fan of three faces on one edge, and a mesh squeezed to a point.
        let fan = Faces::new(5, vec![[0, 1, 2], [0, 1, 3], [1, 0, 4]]).unwrap();
        let coarse = Decimation::new(&[Point3::origin(); 5], &fan, 1, || true).unwrap();
        assert!(
            coarse
                .prolonged(&[1.0; 15])
                .iter()
                .all(|x| (x - 1.0).abs() < 1e-12)
        );
        let ball = phantom::sphere(2, 1.0);
        let squeezed = vec![Point3::origin(); 162];
        assert!(Decimation::new(&squeezed, ball.faces(), 20, || true).is_some());
    }

    #[test]
    fn without_the_way_back_the_coarse_mesh_is_the_same() {
        let torus = phantom::torus(2.0, 0.7, 60, 30);
        let both = decimated(&torus, 300);
        let one = Decimation::one_way(torus.vertices(), torus.faces(), 300, || true).unwrap();
        assert_eq!((one.0.as_slice(), &one.1), (both.kept(), both.faces()));
        assert!(Decimation::one_way(torus.vertices(), torus.faces(), 300, || false).is_none());
    }

    #[test]
    fn it_ends_when_it_may_not_go_on() {
        let ball = phantom::sphere(3, 1.0);
        assert!(Decimation::new(ball.vertices(), ball.faces(), 100, || false).is_none());
    }
}
