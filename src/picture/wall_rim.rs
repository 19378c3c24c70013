//! The cut through the wall at its base: a ring of faces between the rims of the inner and outer
//! side. Only drawn, never measured.

use crate::mesh::Point3;
use crate::study::SurfaceSequence;

/// A ring between two rims.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WallRim {
    /// Vertices of the inner side's rim, in order.
    pub inner: Vec<u32>,
    /// Vertices of the outer side's rim, in order and in the same direction.
    pub outer: Vec<u32>,
    /// Faces over the inner vertices followed by the outer ones.
    pub triangles: Vec<[u32; 3]>,
}

/// The ring between the two sides' rims at frame 0; `None` unless each side has exactly one.
///
/// Rims that have equally many vertices are joined vertex by vertex; others are laced: from the
/// nearest pair on, the side whose next vertex is nearer goes ahead.
pub(crate) fn wall_rim(inner: &SurfaceSequence, outer: &SurfaceSequence) -> Option<WallRim> {
    let (inner_mesh, outer_mesh) = (&inner.frames()[0], &outer.frames()[0]);
    let inner_rim = only_loop(inner)?;
    let outer_rim = only_loop(outer)?;
    let place = |rim: &[u32], vertices: &[Point3]| -> Vec<Point3> {
        rim.iter().map(|&v| vertices[v as usize]).collect()
    };
    let inner_points = place(&inner_rim, inner_mesh.vertices());
    let outer_points = place(&outer_rim, outer_mesh.vertices());
    let order = matching_order(&inner_points, &outer_points);
    let outer_rim: Vec<u32> = order.iter().map(|&i| outer_rim[i]).collect();
    let outer_points: Vec<Point3> = order.iter().map(|&i| outer_points[i]).collect();
    Some(WallRim {
        triangles: laced(&inner_points, &outer_points),
        inner: inner_rim,
        outer: outer_rim,
    })
}

fn only_loop(surface: &SurfaceSequence) -> Option<Vec<u32>> {
    let mut loops = surface.faces().boundary_loops();
    (loops.len() == 1).then(|| loops.remove(0))
}

/// Indices into `outer` that start at the point nearest to `inner[0]` and run the way `inner`
/// does: the direction with the smaller sum of squared distances.
fn matching_order(inner: &[Point3], outer: &[Point3]) -> Vec<usize> {
    let n = outer.len();
    let start = (0..n)
        .min_by(|&a, &b| {
            let distance = |i: usize| (outer[i] - inner[0]).norm_squared();
            distance(a).total_cmp(&distance(b))
        })
        .unwrap_or(0);
    let forward: Vec<usize> = (0..n).map(|i| (start + i) % n).collect();
    let backward: Vec<usize> = (0..n).map(|i| (start + n - i) % n).collect();
    let cost = |order: &[usize]| -> f64 {
        inner
            .iter()
            .enumerate()
            .map(|(i, point)| (outer[order[i * n / inner.len()]] - point).norm_squared())
            .sum()
    };
    if cost(&forward) <= cost(&backward) {
        forward
    } else {
        backward
    }
}

/// Faces between two rings that start side by side; inner vertices are numbered first.
fn laced(inner: &[Point3], outer: &[Point3]) -> Vec<[u32; 3]> {
    let (n, m) = (inner.len(), outer.len());
    let outer_index = |j: usize| (n + j % m) as u32;
    let (mut i, mut j) = (0, 0);
    let mut triangles = Vec::with_capacity(n + m);
    while i < n || j < m {
        let next_inner = (inner[(i + 1) % n] - outer[j % m]).norm_squared();
        let next_outer = (outer[(j + 1) % m] - inner[i % n]).norm_squared();
        // Neither side may fall behind by more than the other has left.
        if j == m || (i < n && next_inner <= next_outer) {
            triangles.push([(i % n) as u32, ((i + 1) % n) as u32, outer_index(j)]);
            i += 1;
        } else {
            triangles.push([(i % n) as u32, outer_index(j + 1), outer_index(j)]);
            j += 1;
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, TriMesh, phantom};
    use crate::study::SurfaceKind;

    fn bowl(radius: f64, around: u32) -> SurfaceSequence {
        let mesh = phantom::bowl(radius, 3, around);
        SurfaceSequence::new(SurfaceKind::Endocardium, vec![mesh]).unwrap()
    }

    fn ring_is_whole(rim: &WallRim) {
        let count = rim.inner.len() + rim.outer.len();
        assert_eq!(rim.triangles.len(), count);
        let faces = Faces::new(count, rim.triangles.clone()).unwrap();
        let mut lengths: Vec<usize> = faces.boundary_loops().iter().map(Vec::len).collect();
        lengths.sort_unstable();
        let mut expected = [rim.inner.len(), rim.outer.len()];
        expected.sort_unstable();
        assert_eq!(lengths, expected, "two rims and no hole between");
    }

    #[test]
    fn equal_rims_are_joined_by_two_faces_a_step() {
        let rim = wall_rim(&bowl(20.0, 16), &bowl(30.0, 16)).unwrap();
        ring_is_whole(&rim);
        assert_eq!(rim.triangles.len(), 32);
    }

    #[test]
    fn rims_that_run_against_each_other_are_joined_without_twist() {
        let inner = bowl(20.0, 16);
        let outer = phantom::bowl(30.0, 3, 16);
        let flipped: Vec<[u32; 3]> = outer
            .triangles()
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect();
        let faces = Faces::new(outer.vertices().len(), flipped).unwrap();
        let outer = TriMesh::new(outer.shared_vertices(), faces).unwrap();
        let outer = SurfaceSequence::new(SurfaceKind::Epicardium, vec![outer]).unwrap();
        let rim = wall_rim(&inner, &outer).unwrap();
        ring_is_whole(&rim);
        let (a, b) = (inner.frames()[0].vertices(), outer.frames()[0].vertices());
        for (&i, &o) in rim.inner.iter().zip(&rim.outer) {
            let thickness = (a[i as usize] - b[o as usize]).norm();
            assert!((thickness - 10.0).abs() < 1e-9, "{thickness}");
        }
    }

    #[test]
    fn rims_of_different_counts_are_laced() {
        ring_is_whole(&wall_rim(&bowl(20.0, 13), &bowl(30.0, 32)).unwrap());
    }

    #[test]
    fn closed_sides_have_no_rim() {
        let closed =
            SurfaceSequence::new(SurfaceKind::Epicardium, vec![phantom::sphere(2, 30.0)]).unwrap();
        assert!(wall_rim(&bowl(20.0, 16), &closed).is_none());
    }
}
