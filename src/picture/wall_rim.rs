//! The cut through the wall at its base: a ring of faces between the rims of the inner and outer
//! side. Only drawn, never measured.

use crate::mesh::Point3;
use crate::picture::openings::{Opening, openings};
use crate::study::SurfaceSequence;

/// Rings between the rims of two surfaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WallRim {
    /// Vertices of the inner side's rims, in order, ring after ring.
    pub inner: Vec<u32>,
    /// Vertices of the outer side's rims, each in the direction of its partner.
    pub outer: Vec<u32>,
    /// Faces over the inner vertices followed by the outer ones.
    pub triangles: Vec<[u32; 3]>,
}

/// The rings between the two sides' rims at frame 0; `None` unless both sides have equally many
/// openings. Openings that lie next to each other belong together.
///
/// Rims are laced: from the nearest pair of vertices on, the side whose next vertex is nearer goes
/// ahead, so the sides need not have equally many vertices.
pub(crate) fn wall_rim(inner: &SurfaceSequence, outer: &SurfaceSequence) -> Option<WallRim> {
    let (inner_openings, mut outer_openings) = (openings(inner), openings(outer));
    if inner_openings.is_empty() || inner_openings.len() != outer_openings.len() {
        return None;
    }
    let mut rings = Vec::new();
    for opening in inner_openings {
        let distance = |other: &Opening| (other.centre - opening.centre).norm_squared();
        let nearest = (0..outer_openings.len()).min_by(|&a, &b| {
            distance(&outer_openings[a]).total_cmp(&distance(&outer_openings[b]))
        })?;
        let other = outer_openings.swap_remove(nearest);
        rings.push(ring(inner, &opening.rim, outer, &other.rim));
    }
    Some(joined(rings))
}

fn ring(
    inner: &SurfaceSequence,
    inner_rim: &[u32],
    outer: &SurfaceSequence,
    outer_rim: &[u32],
) -> WallRim {
    let place = |rim: &[u32], surface: &SurfaceSequence| -> Vec<Point3> {
        let vertices = surface.frames()[0].vertices();
        rim.iter().map(|&v| vertices[v as usize]).collect()
    };
    let inner_points = place(inner_rim, inner);
    let outer_points = place(outer_rim, outer);
    let order = matching_order(&inner_points, &outer_points);
    let outer_points: Vec<Point3> = order.iter().map(|&i| outer_points[i]).collect();
    WallRim {
        triangles: laced(&inner_points, &outer_points),
        inner: inner_rim.to_vec(),
        outer: order.iter().map(|&i| outer_rim[i]).collect(),
    }
}

/// One rim of several rings: all inner vertices first, then all outer ones.
fn joined(rings: Vec<WallRim>) -> WallRim {
    let inner_count: usize = rings.iter().map(|ring| ring.inner.len()).sum();
    let mut all = WallRim {
        inner: Vec::new(),
        outer: Vec::new(),
        triangles: Vec::new(),
    };
    for ring in rings {
        let (inner_start, outer_start) = (all.inner.len(), inner_count + all.outer.len());
        let own_inner = ring.inner.len();
        let moved = |vertex: u32| {
            let vertex = vertex as usize;
            let place = if vertex < own_inner {
                inner_start + vertex
            } else {
                outer_start + vertex - own_inner
            };
            place as u32
        };
        all.triangles
            .extend(ring.triangles.iter().map(|face| face.map(moved)));
        all.inner.extend(ring.inner);
        all.outer.extend(ring.outer);
    }
    all
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
    fn two_valves_make_two_rings() {
        // A sphere that is cut open at both poles.
        let open = |radius: f64| {
            let sphere = phantom::sphere(3, radius);
            let kept: Vec<[u32; 3]> = sphere
                .triangles()
                .iter()
                .filter(|face| {
                    let low = |v: u32| sphere.vertices()[v as usize].z.abs() < 0.8 * radius;
                    face.iter().all(|&v| low(v))
                })
                .copied()
                .collect();
            let faces = Faces::new(sphere.vertices().len(), kept).unwrap();
            let mesh = TriMesh::new(sphere.shared_vertices(), faces).unwrap();
            SurfaceSequence::new(SurfaceKind::Endocardium, vec![mesh]).unwrap()
        };
        let (inner, outer) = (open(20.0), open(30.0));
        let rim = wall_rim(&inner, &outer).unwrap();
        let count = rim.inner.len() + rim.outer.len();
        let faces = Faces::new(count, rim.triangles.clone()).unwrap();
        assert_eq!(faces.boundary_loops().len(), 4);
        let (a, b) = (inner.frames()[0].vertices(), outer.frames()[0].vertices());
        for face in &rim.triangles {
            let heights = face.map(|v| match rim.inner.get(v as usize) {
                Some(&vertex) => a[vertex as usize].z,
                None => b[rim.outer[v as usize - rim.inner.len()] as usize].z,
            });
            assert!(heights.iter().all(|z| z.signum() == heights[0].signum()));
        }
    }

    #[test]
    fn closed_sides_have_no_rim() {
        let closed =
            SurfaceSequence::new(SurfaceKind::Epicardium, vec![phantom::sphere(2, 30.0)]).unwrap();
        assert!(wall_rim(&bowl(20.0, 16), &closed).is_none());
    }
}
