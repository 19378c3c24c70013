//! The point of a surface that is closest to a given one.

use super::{Point3, bounding_box};

/// Faces of a leaf; more cost more tests of faces, fewer more boxes.
const LEAF: usize = 4;

/// Faces in a tree of boxes. Made once, answers often.
#[derive(Clone, Debug)]
pub struct ClosestPoint {
    /// Faces in the order of the leaves.
    faces: Vec<Face>,
    /// The root is the last one.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Face {
    corners: [Point3; 3],
    /// Its place among the triangles that were given.
    number: u32,
}

/// The closest point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Where it is.
    pub point: Point3,
    /// A face that holds it, by its place among the triangles.
    pub face: usize,
    /// How far away it is.
    pub distance: f64,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: [Point3; 2],
    inside: Inside,
}

#[derive(Clone, Copy, Debug)]
enum Inside {
    Nodes([usize; 2]),
    Faces { from: usize, to: usize },
}

impl ClosestPoint {
    /// Sorts triangles into boxes; `None` without any.
    pub fn new(points: &[Point3], triangles: &[[u32; 3]]) -> Option<Self> {
        let mut tree = Self {
            faces: (triangles.iter().zip(0_u32..))
                .map(|(triangle, number)| Face {
                    corners: triangle.map(|v| points[v as usize]),
                    number,
                })
                .collect(),
            nodes: Vec::with_capacity(triangles.len()),
        };
        if tree.faces.is_empty() {
            return None;
        }
        let all = tree.faces.len();
        tree.split(0, all);
        Some(tree)
    }

    /// The closest point of any face. Of several equally close ones, the same for the same tree.
    pub fn closest(&self, point: Point3) -> Point3 {
        self.nearest(point).point
    }

    /// The same, with its face.
    pub fn nearest(&self, point: Point3) -> Nearest {
        let mut best = (f64::INFINITY, point, 0);
        let mut open = vec![(0.0, self.nodes.len() - 1)];
        while let Some((away, node)) = open.pop() {
            if away >= best.0 {
                continue;
            }
            match self.nodes[node].inside {
                Inside::Faces { from, to } => {
                    for face in &self.faces[from..to] {
                        let candidate = closest_on_triangle(&face.corners, point);
                        let away = (candidate - point).norm_squared();
                        if away < best.0 {
                            best = (away, candidate, face.number);
                        }
                    }
                }
                Inside::Nodes(both) => {
                    let [a, b] = both.map(|n| (box_distance2(&self.nodes[n].bounds, point), n));
                    // The nearer box is looked into first.
                    open.extend(if a.0 < b.0 { [b, a] } else { [a, b] });
                }
            }
        }
        Nearest {
            point: best.1,
            face: best.2 as usize,
            distance: best.0.sqrt(),
        }
    }

    /// Distance to the closest point.
    pub fn distance(&self, point: Point3) -> f64 {
        (self.closest(point) - point).norm()
    }

    /// Halves faces at the median centroid of the longest side of their box; returns the node.
    fn split(&mut self, from: usize, to: usize) -> usize {
        let faces = &mut self.faces[from..to];
        let bounds = bounding_box(faces.iter().flat_map(|face| &face.corners)).unwrap_or_default();
        let inside = if faces.len() <= LEAF {
            Inside::Faces { from, to }
        } else {
            let axis = (bounds[1] - bounds[0]).imax();
            let key = |face: &Face| face.corners.iter().map(|c| c[axis]).sum::<f64>();
            let half = faces.len() / 2;
            faces.select_nth_unstable_by(half, |a, b| key(a).total_cmp(&key(b)));
            let low = self.split(from, from + half);
            Inside::Nodes([low, self.split(from + half, to)])
        };
        self.nodes.push(Node { bounds, inside });
        self.nodes.len() - 1
    }
}

fn box_distance2([low, high]: &[Point3; 2], point: Point3) -> f64 {
    (0..3)
        .map(|axis| {
            let outside = (low[axis] - point[axis])
                .max(point[axis] - high[axis])
                .max(0.0);
            outside * outside
        })
        .sum()
}

/// By the region of the triangle's plane in which the point's foot lies.
///
/// Source: Ericson (2005), Real-Time Collision Detection, 5.1.5.
fn closest_on_triangle(&[a, b, c]: &[Point3; 3], p: Point3) -> Point3 {
    let (ab, ac) = (b - a, c - a);
    let [d1, d2] = [ab, ac].map(|side| side.dot(&(p - a)));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let [d3, d4] = [ab, ac].map(|side| side.dot(&(p - b)));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * share(d1, d1 - d3);
    }
    let [d5, d6] = [ab, ac].map(|side| side.dot(&(p - c)));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * share(d2, d2 - d6);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * share(d4 - d3, (d4 - d3) + (d5 - d6));
    }
    let whole = va + vb + vc;
    a + ab * share(vb, whole) + ac * share(vc, whole)
}

/// Part over whole; 0 where a side or a face has no extent.
fn share(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn the_tree_finds_what_a_search_of_all_faces_finds() {
        let torus = phantom::torus(3.0, 1.0, 24, 12);
        let tree = ClosestPoint::new(torus.vertices(), torus.triangles()).unwrap();
        for step in 0..200 {
            let t = f64::from(step);
            let point = Point3::new(
                5.0 * (1.3 * t).sin(),
                4.0 * (0.7 * t).cos(),
                2.0 * (2.1 * t).sin(),
            );
            let all = (torus.triangles().iter())
                .map(|t| t.map(|v| torus.vertices()[v as usize]))
                .map(|corners| (closest_on_triangle(&corners, point) - point).norm())
                .fold(f64::INFINITY, f64::min);
            assert!((tree.distance(point) - all).abs() < 1e-12);
        }
    }

    #[test]
    fn regions_of_a_triangle_give_corner_side_and_foot() {
        let points = [
            Point3::origin(),
            Point3::new(4.0, 0.0, 0.0),
            Point3::new(0.0, 4.0, 0.0),
        ];
        let tree = ClosestPoint::new(&points, &[[0, 1, 2]]).unwrap();
        for (from, to) in [
            ([-1.0, -1.0, 2.0], [0.0, 0.0, 0.0]),
            ([6.0, -1.0, 0.0], [4.0, 0.0, 0.0]),
            ([-1.0, 9.0, 0.0], [0.0, 4.0, 0.0]),
            ([1.0, -3.0, 1.0], [1.0, 0.0, 0.0]),
            ([-3.0, 2.0, 1.0], [0.0, 2.0, 0.0]),
            ([4.0, 4.0, 0.0], [2.0, 2.0, 0.0]),
            ([1.0, 1.0, 5.0], [1.0, 1.0, 0.0]),
        ] {
            let found = tree.closest(Point3::from(from));
            assert!((found - Point3::from(to)).norm() < 1e-12, "{found}");
        }
    }

    #[test]
    fn faces_without_extent_are_points_and_no_faces_have_no_closest_one() {
        let points = [Point3::new(1.0, 2.0, 3.0); 3];
        let tree = ClosestPoint::new(&points, &[[0, 1, 2]]).unwrap();
        assert_eq!(tree.closest(Point3::origin()), points[0]);
        assert!(ClosestPoint::new(&points, &[]).is_none());
    }
}
