//! The nearest face that faces a direction: boxes and cones of normals around faces.

use crate::mesh::{Point3, Vector3};

/// Faces of a leaf; more cost more tests of faces, fewer more boxes.
const LEAF: usize = 4;

/// A tree halves its faces at every level, so that this many levels hold more faces than there are numbers.
const MOST_LEVELS: usize = 64;

/// A tree over faces. Its plan is made once; [`FaceTree::fit`] lays it around the faces of a pose.
#[derive(Clone, Debug)]
pub(super) struct FaceTree {
    /// Faces in the order of the leaves.
    order: Vec<u32>,
    /// The root is the last one; children come before their parents.
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    low: Point3,
    high: Point3,
    cone: Cone,
    inside: Inside,
}

#[derive(Clone, Copy, Debug)]
enum Inside {
    Nodes([u32; 2]),
    Faces { from: u32, to: u32 },
}

/// Directions of the normals of faces: all within an angle of an axis.
#[derive(Clone, Copy, Debug)]
struct Cone {
    axis: Vector3,
    cos: f64,
    sin: f64,
}

impl Cone {
    const ANY: Self = Self {
        axis: Vector3::new(0.0, 0.0, 1.0),
        cos: -1.0,
        sin: 0.0,
    };

    /// The narrowest cone around the middle of two.
    fn around(self, other: Self) -> Self {
        let sum = self.axis + other.axis;
        let length = sum.norm();
        if length < 1e-3 {
            return Self::ANY;
        }
        let axis = sum / length;
        let spread = [self, other]
            .map(|cone| axis.dot(&cone.axis).clamp(-1.0, 1.0).acos() + cone.sin.atan2(cone.cos))
            .into_iter()
            .fold(0.0, f64::max);
        if spread >= std::f64::consts::PI {
            return Self::ANY;
        }
        Self {
            axis,
            cos: spread.cos(),
            sin: spread.sin(),
        }
    }

    /// Whether every normal in the cone is nearer to `direction` than the angle of this cosine.
    #[inline]
    fn within(&self, direction: &Vector3, cos_most: f64) -> bool {
        let cos = self.axis.dot(direction);
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        cos > -self.cos && cos * self.cos - sin * self.sin > cos_most
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

impl FaceTree {
    /// Plans a tree for faces about where they are at one pose. Faces without area are left out.
    pub fn new(faces: FacesOfPose<'_>) -> Self {
        let mut centres: Vec<(u32, Point3)> = (0..faces.triangles.len() as u32)
            .map(|face| {
                let [a, b, c] = faces.corners(face);
                (face, Point3::from((a.coords + b.coords + c.coords) / 3.0))
            })
            .collect();
        let mut nodes = Vec::with_capacity(centres.len().div_ceil(LEAF) * 3);
        if !centres.is_empty() {
            grow(&mut nodes, &mut centres, 0);
        }
        Self {
            order: centres.into_iter().map(|(face, _)| face).collect(),
            nodes,
        }
    }

    /// Faces in an order in which neighbours mostly follow each other.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Lays boxes and cones around the faces of a pose.
    pub fn fit(&mut self, faces: FacesOfPose<'_>) {
        for index in 0..self.nodes.len() {
            let (low, high, cone) = match self.nodes[index].inside {
                Inside::Nodes([left, right]) => {
                    let (left, right) = (&self.nodes[left as usize], &self.nodes[right as usize]);
                    let cone = left.cone.around(right.cone);
                    (left.low.inf(&right.low), left.high.sup(&right.high), cone)
                }
                Inside::Faces { from, to } => {
                    leaf_bounds(faces, &self.order[from as usize..to as usize])
                }
            };
            let node = &mut self.nodes[index];
            (node.low, node.high, node.cone) = (low, high, cone);
        }
    }

    /// The nearest point of the faces that `facing` allows, if there is one nearer than the root of `squared`.
    ///
    /// A good `hint`, a face that is likely near, makes the search short.
    pub fn nearest(
        &self,
        faces: FacesOfPose<'_>,
        point: Point3,
        facing: &Facing,
        squared: f64,
        hint: Option<u32>,
    ) -> Option<Nearest> {
        let mut best = None;
        let mut least = squared;
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
        let mut open = [(0_u32, 0.0_f64); 2 * MOST_LEVELS];
        let mut count = 0;
        if let Some(root) = self.nodes.len().checked_sub(1) {
            open[0] = (root as u32, 0.0);
            count = 1;
        }
        while count > 0 {
            count -= 1;
            let (node, distance) = open[count];
            if distance >= least {
                continue;
            }
            match self.nodes[node as usize].inside {
                Inside::Faces { from, to } => {
                    for &face in &self.order[from as usize..to as usize] {
                        try_face(face, &mut least);
                    }
                }
                Inside::Nodes(children) => {
                    let [left, right] = children;
                    let mut pair = [
                        (left, self.far(left, point, facing, least)),
                        (right, self.far(right, point, facing, least)),
                    ];
                    if pair[0].1 < pair[1].1 {
                        pair.swap(0, 1);
                    }
                    for entry in pair {
                        if entry.1 < least && count < open.len() {
                            open[count] = entry;
                            count += 1;
                        }
                    }
                }
            }
        }
        best
    }

    /// Squared distance from a point to the box of a node; infinite where nothing in it can be found.
    #[inline]
    fn far(&self, node: u32, point: Point3, facing: &Facing, least: f64) -> f64 {
        let node = &self.nodes[node as usize];
        let squared = node.squared_distance(point);
        // The box is told before the cone, whose angles cost a root.
        if squared >= least || node.cone.within(&facing.direction, facing.cos_least) {
            f64::INFINITY
        } else {
            squared
        }
    }
}

impl Node {
    #[inline]
    fn squared_distance(&self, point: Point3) -> f64 {
        let outside = |axis: usize| {
            (self.low[axis] - point[axis])
                .max(point[axis] - self.high[axis])
                .max(0.0)
        };
        let [x, y, z] = [outside(0), outside(1), outside(2)];
        x * x + y * y + z * z
    }
}

/// Adds the nodes around these faces, which begin at place `from` of the order.
fn grow(nodes: &mut Vec<Node>, faces: &mut [(u32, Point3)], from: usize) -> u32 {
    let inside = if faces.len() <= LEAF {
        Inside::Faces {
            from: from as u32,
            to: (from + faces.len()) as u32,
        }
    } else {
        let first = faces[0].1;
        let (low, high) = faces
            .iter()
            .fold((first, first), |(low, high), (_, centre)| {
                (low.inf(centre), high.sup(centre))
            });
        let axis = (high - low).imax();
        let half = faces.len() / 2;
        faces.select_nth_unstable_by(half, |a, b| {
            a.1[axis].total_cmp(&b.1[axis]).then(a.0.cmp(&b.0))
        });
        let (left, right) = faces.split_at_mut(half);
        let left = grow(nodes, left, from);
        Inside::Nodes([left, grow(nodes, right, from + half)])
    };
    nodes.push(Node {
        low: Point3::origin(),
        high: Point3::origin(),
        cone: Cone::ANY,
        inside,
    });
    nodes.len() as u32 - 1
}

fn leaf_bounds(faces: FacesOfPose<'_>, members: &[u32]) -> (Point3, Point3, Cone) {
    let corner = faces.corners(members[0])[0];
    let (mut low, mut high) = (corner, corner);
    let mut sum = Vector3::zeros();
    for &face in members {
        for corner in faces.corners(face) {
            low = low.inf(&corner);
            high = high.sup(&corner);
        }
        sum += faces.normals[face as usize];
    }
    let length = sum.norm();
    let mut cone = Cone::ANY;
    if length > 1e-3 {
        let axis = sum / length;
        let normals = members.iter().map(|&face| faces.normals[face as usize]);
        let real = normals.filter(|normal| *normal != Vector3::zeros());
        let cos = real.map(|normal| normal.dot(&axis)).fold(1.0, f64::min);
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        cone = Cone { axis, cos, sin };
    }
    (low, high, cone)
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
