//! Pairs of faces of one surface that cross each other.

use super::{Point3, Vector3, bounding_box};

/// Faces of a leaf; more cost more tests of pairs, fewer more boxes.
const LEAF: usize = 4;

/// Faces between two questions whether to go on: some 0.1 ms.
const ASK_EVERY: usize = 256;

/// Share of the product of lengths below which a volume counts as zero: rounding of the volume of
/// a tetrahedron is some 1e-15 of it, and touching sheets must not count as crossing.
const FLAT: f64 = 1e-12;

/// Number of pairs of faces of which one pierces the other; `None` if `go_on` says no.
///
/// A pair that shares a vertex is not looked at: neighbours touch by nature. Touching without
/// piercing (a rim stated twice, two coplanar faces on each other) does not count. Boxes in a
/// tree keep the work near n log n.
pub fn crossing_faces(
    points: &[Point3],
    triangles: &[[u32; 3]],
    mut go_on: impl FnMut() -> bool,
) -> Option<usize> {
    let tree = Tree::new(points, triangles);
    let mut crossing = 0;
    let mut open = Vec::new();
    for (first, triangle) in triangles.iter().enumerate() {
        if first % ASK_EVERY == 0 && !go_on() {
            return None;
        }
        let corners = triangle.map(|v| points[v as usize]);
        let Some(own) = bounding_box(&corners) else {
            continue;
        };
        open.clear();
        open.extend(tree.root());
        while let Some(node) = open.pop() {
            let node = &tree.nodes[node];
            if !overlap(&node.bounds, &own) {
                continue;
            }
            match node.inside {
                Inside::Nodes(both) => open.extend(both),
                Inside::Faces { from, to } => {
                    crossing += (tree.order[from..to].iter())
                        .filter(|&&second| {
                            let other = &triangles[second as usize];
                            second as usize > first
                                && !triangle.iter().any(|v| other.contains(v))
                                && cross(&corners, &other.map(|v| points[v as usize]))
                        })
                        .count();
                }
            }
        }
    }
    Some(crossing)
}

/// Whether one triangle pierces the other: an edge of one passes through the inside of the other.
fn cross(a: &[Point3; 3], b: &[Point3; 3]) -> bool {
    let pierces = |of: &[Point3; 3], other: &[Point3; 3]| {
        (0..3).any(|k| pierced(other, &of[k], &of[(k + 1) % 3]))
    };
    pierces(a, b) || pierces(b, a)
}

fn pierced([a, b, c]: &[Point3; 3], from: &Point3, to: &Point3) -> bool {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(&ac);
    let (above, below) = (from - a, to - a);
    let size = ab.norm() * ac.norm();
    let side = |p: &Vector3| {
        let volume = normal.dot(p);
        let zero = volume.abs() <= FLAT * size * (p.norm() + ab.norm() + ac.norm());
        if zero { 0.0 } else { volume }
    };
    if side(&above) * side(&below) >= 0.0 {
        return false;
    }
    let along = to - from;
    let turns = [[a, b], [b, c], [c, a]].map(|[p, q]| along.dot(&(p - from).cross(&(q - from))));
    turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
}

type Bounds = [Point3; 2];

fn overlap(a: &Bounds, b: &Bounds) -> bool {
    (0..3).all(|axis| a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis])
}

/// A tree of boxes around faces, halved along the longest side.
struct Tree {
    nodes: Vec<Node>,
    /// Faces in the order of the leaves.
    order: Vec<u32>,
}

struct Node {
    bounds: Bounds,
    inside: Inside,
}

enum Inside {
    Nodes([usize; 2]),
    Faces { from: usize, to: usize },
}

impl Tree {
    fn new(points: &[Point3], triangles: &[[u32; 3]]) -> Self {
        let corners = |face: u32| triangles[face as usize].map(|v| points[v as usize]);
        let boxes: Vec<Bounds> = (0..triangles.len() as u32)
            .map(|face| bounding_box(&corners(face)).unwrap_or([Point3::origin(); 2]))
            .collect();
        let mut tree = Self {
            nodes: Vec::new(),
            order: (0..triangles.len() as u32).collect(),
        };
        if !triangles.is_empty() {
            tree.grow(&boxes, 0, triangles.len());
        }
        tree
    }

    fn root(&self) -> Option<usize> {
        self.nodes.len().checked_sub(1)
    }

    /// Adds a node around these places in the order, after the nodes inside it.
    fn grow(&mut self, boxes: &[Bounds], from: usize, to: usize) -> usize {
        let faces = &mut self.order[from..to];
        let first = boxes[faces[0] as usize];
        let bounds = (faces.iter().map(|&face| boxes[face as usize]))
            .fold(first, |[low, high], [l, h]| [low.inf(&l), high.sup(&h)]);
        let inside = if faces.len() <= LEAF {
            Inside::Faces { from, to }
        } else {
            let axis = (bounds[1] - bounds[0]).imax();
            let doubled_middle = |face: u32| {
                let [low, high] = boxes[face as usize];
                low[axis] + high[axis]
            };
            let half = faces.len() / 2;
            faces.select_nth_unstable_by(half, |&a, &b| {
                doubled_middle(a)
                    .total_cmp(&doubled_middle(b))
                    .then(a.cmp(&b))
            });
            Inside::Nodes([
                self.grow(boxes, from, from + half),
                self.grow(boxes, from + half, to),
            ])
        };
        self.nodes.push(Node { bounds, inside });
        self.nodes.len() - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, phantom};

    fn count(points: &[Point3], triangles: &[[u32; 3]]) -> usize {
        crossing_faces(points, triangles, || true).unwrap()
    }

    fn every_pair(points: &[Point3], triangles: &[[u32; 3]]) -> usize {
        let corners = |t: &[u32; 3]| t.map(|v| points[v as usize]);
        let mut found = 0;
        for (i, a) in triangles.iter().enumerate() {
            for b in &triangles[i + 1..] {
                let apart = !a.iter().any(|v| b.contains(v));
                found += usize::from(apart && cross(&corners(a), &corners(b)));
            }
        }
        found
    }

    #[test]
    fn round_surfaces_do_not_cross_themselves() {
        for mesh in [
            phantom::sphere(3, 1.0),
            phantom::torus(2.0, 0.6, 30, 15),
            phantom::bowl(1.0, 6, 20),
        ] {
            assert_eq!(count(mesh.vertices(), mesh.triangles()), 0);
        }
    }

    #[test]
    fn a_vertex_pulled_through_the_far_side_is_seen() {
        let ball = phantom::sphere(2, 1.0);
        let mut points = ball.vertices().to_vec();
        points[0] = Point3::from(points[0].coords * -1.5);
        let found = count(&points, ball.triangles());
        assert!(found >= 5);
        assert_eq!(found, every_pair(&points, ball.triangles()));
    }

    #[test]
    fn the_tree_finds_what_trying_every_pair_finds() {
        let (a, b) = (phantom::sphere(2, 1.0), phantom::torus(1.0, 0.3, 14, 9));
        let faces = Faces::joined(&[a.faces(), b.faces()]);
        let shift = Vector3::new(0.31, 0.17, 0.05);
        let points: Vec<Point3> = (a.vertices().iter().copied())
            .chain(b.vertices().iter().map(|p| p + shift))
            .collect();
        let found = count(&points, faces.triangles());
        assert!(found > 50);
        assert_eq!(found, every_pair(&points, faces.triangles()));
    }

    #[test]
    fn two_sheets_with_a_common_rim_touch_but_do_not_cross() {
        let bowl = phantom::bowl(1.0, 5, 17);
        let faces = Faces::joined(&[bowl.faces(), bowl.faces()]);
        let lower = bowl
            .vertices()
            .iter()
            .map(|p| Point3::new(p.x, p.y, 0.8 * p.z));
        let points: Vec<Point3> = bowl.vertices().iter().copied().chain(lower).collect();
        assert_eq!(count(&points, faces.triangles()), 0);
    }

    #[test]
    fn damaged_coordinates_and_no_faces_are_survived() {
        let ball = phantom::sphere(1, 1.0);
        let mut points = ball.vertices().to_vec();
        points[3].x = f64::NAN;
        points[5].y = f64::INFINITY;
        let _ = count(&points, ball.triangles());
        assert_eq!(count(&[], &[]), 0);
    }

    #[test]
    fn a_count_that_may_not_go_on_ends() {
        let ball = phantom::sphere(1, 1.0);
        assert_eq!(
            crossing_faces(ball.vertices(), ball.triangles(), || false),
            None
        );
    }
}
