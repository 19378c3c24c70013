//! The nearest face that faces a direction: boxes and cones of normals around faces.

use rayon::prelude::*;

use crate::mesh::{Point3, Vector3};

/// Most faces of a leaf; more cost more tests of faces, fewer more boxes.
const LEAF: usize = 4;

/// A search keeps one node open per level, and the faces of a tree of this many are more than there are numbers.
const MOST_LEVELS: usize = 32;

/// Faces, or nodes, from which a part is handed to another thread.
const WORTH_HANDING: usize = 2048;

/// More than cosines of angles between directions in 32 bits are off by …
const ROUNDING: f32 = 1e-5;

/// … and more than distances are, as a share of them.
const SHORTER: f64 = 1.0 - 1e-6;

/// In which order a tree holds faces, made once for all poses.
#[derive(Clone, Debug)]
pub(super) struct TreePlan {
    /// Faces in the order of the leaves. Leaf k of n begins at place ⌊k · faces / n⌋.
    order: Vec<u32>,
    /// Leaves are two to the power of this.
    levels: usize,
}

/// Boxes and cones of normals around the faces of a pose.
#[derive(Clone, Debug)]
pub(super) struct FaceTree<'a> {
    plan: &'a TreePlan,
    faces: FacesOfPose<'a>,
    /// The root, and so on level by level: node i lies around nodes 2i + 1 and 2i + 2. No nodes lie around no faces.
    nodes: Vec<Node>,
}

/// What lies around some faces, in 32 bits, rounded so that nothing sticks out: one line of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Node {
    /// The fourth is nothing: four are compared at once.
    low: [f32; 4],
    high: [f32; 4],
    cone: Cone,
    /// Least number of a face, and greatest.
    range: [u32; 2],
}

/// Directions of the normals of faces: all within an angle of an axis.
#[derive(Clone, Copy, Debug)]
struct Cone {
    axis: [f32; 3],
    cos: f32,
    sin: f32,
}

impl Cone {
    const ANY: Self = Self {
        axis: [0.0, 0.0, 1.0],
        cos: -1.0,
        sin: 0.0,
    };

    fn axis(&self) -> Vector3 {
        Vector3::from(self.axis.map(f64::from))
    }

    /// Cosine and sine of the angle between a unit vector and the farthest normal; cosine −1 from 180° on.
    fn farthest(&self, direction: &Vector3) -> [f64; 2] {
        let axis = self.axis();
        let [cos, sin] = [f64::from(self.cos), f64::from(self.sin)];
        let cos_axis = axis.dot(direction);
        let sin_axis = axis.cross(direction).norm();
        if cos_axis <= -cos {
            return [-1.0, 0.0];
        }
        [
            cos_axis * cos - sin_axis * sin,
            sin_axis * cos + cos_axis * sin,
        ]
    }

    /// The narrowest cone around the middle of two.
    fn around(self, other: Self) -> Self {
        let sum = self.axis() + other.axis();
        let length = sum.norm();
        if length < 1e-3 {
            return Self::ANY;
        }
        let axis = sum / length;
        let (one, two) = (self.farthest(&axis), other.farthest(&axis));
        let [cos, sin] = if one[0] < two[0] { one } else { two };
        Self::new(axis, cos, sin)
    }

    fn new(axis: Vector3, cos: f64, sin: f64) -> Self {
        Self {
            axis: [axis.x as f32, axis.y as f32, axis.z as f32],
            cos: cos as f32,
            sin: sin as f32,
        }
    }

    /// Whether a search passes over every normal in the cone: θ + spread < angle, as θ < angle − spread.
    #[inline]
    fn within(&self, search: &Search) -> bool {
        let [x, y, z] = search.direction;
        let cos = self.axis[0] * x + self.axis[1] * y + self.axis[2] * z;
        self.cos > search.cos_least
            && cos > search.cos_least * self.cos + search.sin_least * self.sin + ROUNDING
    }
}

/// Faces of a pose, as a tree is laid around them.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacesOfPose<'a> {
    pub points: &'a [Point3],
    pub triangles: &'a [[u32; 3]],
    /// Unit normals; zero for faces without area, which are never found.
    pub normals: &'a [Vector3],
}

impl FacesOfPose<'_> {
    fn corners(&self, face: u32) -> [Point3; 3] {
        self.triangles[face as usize].map(|vertex| self.points[vertex as usize])
    }
}

/// Which faces a search may find: those with numbers in a range whose normals are at least an angle away from a direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facing {
    pub direction: Vector3,
    /// Cosine of that angle; above 1 all faces are found.
    pub cos_least: f64,
    pub faces: [u32; 2],
}

impl Facing {
    /// All faces with numbers in a range.
    pub fn any(faces: [u32; 2]) -> Self {
        Self {
            direction: Vector3::zeros(),
            cos_least: 2.0,
            faces,
        }
    }
}

/// Nearest point of the faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub point: Point3,
    pub face: u32,
    pub squared: f64,
    /// Weights of the corners.
    pub weights: [f64; 3],
}

impl TreePlan {
    /// Plans a tree for faces about where they are at one pose.
    pub fn new(points: &[Point3], triangles: &[[u32; 3]]) -> Self {
        let mut levels = 0;
        while triangles.len().div_ceil(1 << levels) > LEAF {
            levels += 1;
        }
        let mut centres: Vec<(u32, Point3)> = (0..)
            .zip(triangles)
            .map(|(face, triangle)| {
                let [a, b, c] = triangle.map(|vertex| points[vertex as usize].coords);
                (face, Point3::from((a + b + c) / 3.0))
            })
            .collect();
        halve(&mut centres, levels);
        Self {
            order: centres.into_iter().map(|(face, _)| face).collect(),
            levels,
        }
    }

    /// Faces in an order in which neighbours mostly follow each other.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The faces of a leaf.
    fn leaf(&self, leaf: usize) -> &[u32] {
        let [from, to] = [leaf, leaf + 1].map(|end| (end * self.order.len()) >> self.levels);
        &self.order[from..to]
    }

    /// Lays boxes and cones around the faces of a pose.
    pub fn around<'a>(&'a self, faces: FacesOfPose<'a>) -> FaceTree<'a> {
        let mut nodes = Vec::new();
        if !self.order.is_empty() {
            let leaves = 1 << self.levels;
            nodes = vec![Node::AROUND_ALL; 2 * leaves - 1];
            (nodes[leaves - 1..].par_iter_mut().enumerate())
                .with_min_len(WORTH_HANDING / LEAF)
                .for_each(|(leaf, node)| *node = Node::around_faces(faces, self.leaf(leaf)));
            for node in (0..leaves - 1).rev() {
                nodes[node] = Node::around(&nodes[2 * node + 1], &nodes[2 * node + 2]);
            }
        }
        FaceTree {
            plan: self,
            faces,
            nodes,
        }
    }
}

/// Puts faces in order: the nearer half along the longest side of their box, then the other, and so on down.
fn halve(faces: &mut [(u32, Point3)], levels: usize) {
    let Some(levels) = levels.checked_sub(1) else {
        return;
    };
    let first = faces[0].1;
    let (low, high) = (faces.iter()).fold((first, first), |(low, high), (_, centre)| {
        (low.inf(centre), high.sup(centre))
    });
    let axis = (high - low).imax();
    let half = faces.len() / 2;
    faces.select_nth_unstable_by(half, |a, b| {
        a.1[axis].total_cmp(&b.1[axis]).then(a.0.cmp(&b.0))
    });
    let whole = faces.len();
    let (left, right) = faces.split_at_mut(half);
    if whole > WORTH_HANDING {
        rayon::join(|| halve(left, levels), || halve(right, levels));
    } else {
        halve(left, levels);
        halve(right, levels);
    }
}

impl FaceTree<'_> {
    /// The nearest point of the faces that `facing` allows, if there is one nearer than the root of `squared`.
    ///
    /// A good `hint`, a face that is likely near, makes the search short.
    pub fn nearest(
        &self,
        point: Point3,
        facing: &Facing,
        squared: f64,
        hint: Option<u32>,
    ) -> Option<Nearest> {
        let mut best = None;
        let mut least = squared;
        let faces = self.faces;
        let [from_face, to_face] = facing.faces;
        let mut try_face = |face: u32, least: &mut f64| {
            let normal = faces.normals[face as usize];
            let allowed = (from_face..to_face).contains(&face)
                && normal.dot(&facing.direction) <= facing.cos_least
                && normal != Vector3::zeros();
            if allowed {
                let (weights, nearest) = nearest_on_triangle(point, faces.corners(face));
                let squared = (nearest - point).norm_squared();
                if squared < *least {
                    *least = squared;
                    best = Some(Nearest {
                        point: nearest,
                        face,
                        squared,
                        weights,
                    });
                }
            }
        };
        if let Some(hint) = hint {
            try_face(hint, &mut least);
        }
        let search = Search::new(point, facing);
        let first_leaf = self.nodes.len() / 2;
        let mut open = [(0, 0.0); MOST_LEVELS + 1];
        let mut count = self.nodes.len().min(1);
        while count > 0 {
            count -= 1;
            let (node, distance) = open[count];
            if distance >= least {
                continue;
            }
            if node >= first_leaf {
                for &face in self.plan.leaf(node - first_leaf) {
                    try_face(face, &mut least);
                }
                continue;
            }
            let mut pair = [2 * node + 1, 2 * node + 2]
                .map(|child| (child, self.nodes[child].far(&search, least)));
            if pair[0].1 < pair[1].1 {
                pair.swap(0, 1);
            }
            for entry in pair {
                if entry.1 < least {
                    open[count] = entry;
                    count += 1;
                }
            }
        }
        best
    }
}

/// What is looked for, in 32 bits.
struct Search {
    /// The point, and the numbers next to it where it is none of 32 bits.
    low: [f32; 4],
    high: [f32; 4],
    direction: [f32; 3],
    cos_least: f32,
    sin_least: f32,
    faces: [u32; 2],
}

impl Search {
    fn new(point: Point3, facing: &Facing) -> Self {
        let [x, y, z] = point.coords.into();
        Self {
            low: [x, y, z, 0.0].map(below),
            high: [x, y, z, 0.0].map(above),
            direction: <[f64; 3]>::from(facing.direction).map(|part| part as f32),
            cos_least: facing.cos_least as f32,
            sin_least: (1.0 - facing.cos_least * facing.cos_least).max(0.0).sqrt() as f32,
            faces: facing.faces,
        }
    }
}

impl Node {
    const AROUND_ALL: Self = Self {
        low: [f32::NEG_INFINITY; 4],
        high: [f32::INFINITY; 4],
        cone: Cone::ANY,
        range: [0, u32::MAX],
    };

    fn around_faces(faces: FacesOfPose<'_>, members: &[u32]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 4], [f64::NEG_INFINITY; 4]);
        let mut range = [u32::MAX, 0];
        let mut sum = Vector3::zeros();
        for &face in members {
            for corner in faces.corners(face) {
                for axis in 0..3 {
                    low[axis] = low[axis].min(corner[axis]);
                    high[axis] = high[axis].max(corner[axis]);
                }
            }
            range = [range[0].min(face), range[1].max(face)];
            sum += faces.normals[face as usize];
        }
        let length = sum.norm();
        let mut cone = Cone::ANY;
        if length > 1e-3 {
            let axis = sum / length;
            let normals = members.iter().map(|&face| faces.normals[face as usize]);
            let real = normals.filter(|normal| *normal != Vector3::zeros());
            let cos = real.map(|normal| normal.dot(&axis)).fold(1.0, f64::min);
            cone = Cone::new(axis, cos, (1.0 - cos * cos).max(0.0).sqrt());
        }
        Self {
            low: low.map(below),
            high: high.map(above),
            cone,
            range,
        }
    }

    fn around(&self, other: &Self) -> Self {
        let axes = [0, 1, 2, 3];
        Self {
            low: axes.map(|axis| self.low[axis].min(other.low[axis])),
            high: axes.map(|axis| self.high[axis].max(other.high[axis])),
            cone: self.cone.around(other.cone),
            range: [
                self.range[0].min(other.range[0]),
                self.range[1].max(other.range[1]),
            ],
        }
    }

    /// Squared distance to the box, at most; infinite where nothing in it can be found.
    #[inline]
    fn far(&self, search: &Search, least: f64) -> f64 {
        let [from, to] = search.faces;
        if self.range[1] < from || self.range[0] >= to {
            return f64::INFINITY;
        }
        let [x, y, z, _] = std::array::from_fn(|axis| {
            let outside = greater(
                self.low[axis] - search.high[axis],
                search.low[axis] - self.high[axis],
            );
            f64::from(greater(outside, 0.0))
        });
        let squared = SHORTER * (x * x + y * y + z * z);
        if squared >= least || self.cone.within(search) {
            f64::INFINITY
        } else {
            squared
        }
    }
}

/// Of two numbers neither of which is NaN: one instruction, which `f32::max` is not.
#[inline]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The greatest number of 32 bits that is not above.
fn below(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value {
        near.next_down()
    } else {
        near
    }
}

/// The least number of 32 bits that is not below.
fn above(value: f64) -> f32 {
    -below(-value)
}

/// The nearest point of a triangle with the weights of its corners.
///
/// Source: C. Ericson, *Real-Time Collision Detection* (2005), section 5.1.5: by the regions of the corners and sides.
fn nearest_on_triangle(point: Point3, [a, b, c]: [Point3; 3]) -> ([f64; 3], Point3) {
    let (ab, ac) = (b - a, c - a);
    let ap = point - a;
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return ([1.0, 0.0, 0.0], a);
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return ([0.0, 1.0, 0.0], b);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let part = d1 / (d1 - d3);
        return ([1.0 - part, part, 0.0], a + part * ab);
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return ([0.0, 0.0, 1.0], c);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let part = d2 / (d2 - d6);
        return ([1.0 - part, 0.0, part], a + part * ac);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let part = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return ([0.0, 1.0 - part, part], b + part * (c - b));
    }
    let whole = va + vb + vc;
    let (v, w) = (vb / whole, vc / whole);
    ([1.0 - v - w, v, w], a + v * ab + w * ac)
}
