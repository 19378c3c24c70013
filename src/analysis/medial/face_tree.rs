//! The nearest face that faces a direction: cylinders and cones of normals around faces, four at a time.

use glam::{BVec4A, Vec4};
use rayon::prelude::*;

use crate::mesh::{Point3, Vector3};

/// Most faces of a leaf; more cost more tests of faces, fewer more cylinders.
const LEAF: usize = 3;

/// A tree of so many levels, four times as many nodes on each, holds more faces than there are numbers.
const MOST_LEVELS: usize = 16;

/// Faces from which a part is handed to another thread.
const WORTH_HANDING: usize = 2048;

/// More than coordinates of 32 bits and cosines of angles between directions are off by, in extents of all faces …
const ROUNDING: f32 = 1e-6;

/// … and more than squares of distances are, as a share of them.
const SHORTER: f32 = 1.0 - 1e-5;

/// In which order a tree holds faces, made once for all poses.
#[derive(Clone, Debug)]
pub(super) struct TreePlan {
    /// Faces in the order of the leaves.
    order: Vec<u32>,
    /// Leaves are four to the power of this.
    levels: usize,
}

/// Cylinders and cones of normals around the faces of a pose.
///
/// Patches of a surface are flat, and mostly lie across the axes: a cylinder about the mean normal is far closer to one than a
/// box. All is in 32 bits, about the middle of all faces and in units of their extent, so that any coordinates fit.
#[derive(Clone, Debug)]
pub(super) struct FaceTree<'a> {
    plan: &'a TreePlan,
    faces: FacesOfPose<'a>,
    unit: Unit,
    /// The nodes that are not leaves: the root, and so on level by level. Node i lies around nodes 4i + 1 to 4i + 4.
    nodes: Vec<Node>,
}

/// What lies around each of the four nodes below a node.
#[derive(Clone, Copy, Debug)]
struct Node {
    centre: [Vec4; 3],
    axis: [Vec4; 3],
    begin: Vec4,
    end: Vec4,
    radius: Vec4,
    cos: Vec4,
    sin: Vec4,
    ranges: [[u32; 2]; 4],
}

/// What lies around some faces.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    /// A point on the axis of the cylinder.
    centre: [f32; 3],
    /// That of the cylinder, and of the cone.
    axis: [f32; 3],
    /// Where the cylinder begins and ends, from the centre along the axis.
    along: [f32; 2],
    radius: f32,
    /// Cosine and sine of the angle between the axis and the farthest normal.
    spread: [f32; 2],
    /// Least number of a face, and greatest.
    range: [u32; 2],
}

/// What of some faces is known from their parts.
#[derive(Clone, Copy, Debug)]
struct Summary {
    low: Point3,
    high: Point3,
    normals: Vector3,
    /// Least number of a face, and greatest.
    range: [u32; 2],
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
        while triangles.len().div_ceil(1 << (2 * levels)) > LEAF {
            levels += 1;
        }
        let mut centres: Vec<(u32, Point3)> = (0..)
            .zip(triangles)
            .map(|(face, triangle)| {
                let [a, b, c] = triangle.map(|vertex| points[vertex as usize].coords);
                (face, Point3::from((a + b + c) / 3.0))
            })
            .collect();
        halve(&mut centres, 2 * levels);
        Self {
            order: centres.into_iter().map(|(face, _)| face).collect(),
            levels,
        }
    }

    /// Faces in an order in which neighbours mostly follow each other.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The faces of a node, by its level and its place there.
    fn members(&self, level: usize, place: usize) -> &[u32] {
        let [from, to] = [place, place + 1].map(|k| (k * self.order.len()) >> (2 * level));
        &self.order[from..to]
    }

    /// Lays cylinders and cones around the faces of a pose.
    pub fn around<'a>(&'a self, faces: FacesOfPose<'a>) -> FaceTree<'a> {
        let unit = Unit::new(faces.points);
        let points: Vec<Point3> = faces.points.iter().map(|&point| unit.of(point)).collect();
        let scaled = FacesOfPose {
            points: &points,
            ..faces
        };
        let mut levels = Vec::with_capacity(self.levels);
        let mut summaries: Vec<Summary> = Vec::new();
        for level in (1..=self.levels).rev() {
            let nodes = 1 << (2 * level);
            let least = WORTH_HANDING * nodes / (self.order.len() + 1);
            let made: Vec<(Summary, Bounds)> = (0..nodes)
                .into_par_iter()
                .with_min_len(least.max(1))
                .map(|place| {
                    let members = self.members(level, place);
                    let summary = match summaries.as_chunks::<4>().0.get(place) {
                        Some(parts) => Summary::joined(parts),
                        None => Summary::new(scaled, members),
                    };
                    (summary, Bounds::new(scaled, members, &summary))
                })
                .collect();
            let (fours, _) = made.as_chunks::<4>();
            levels.push(
                fours
                    .iter()
                    .map(|four| Node::new(&four.map(|(_, bounds)| bounds)))
                    .collect(),
            );
            summaries = made.into_iter().map(|(summary, _)| summary).collect();
        }
        let levels: Vec<Vec<Node>> = levels;
        FaceTree {
            plan: self,
            faces,
            unit,
            nodes: levels.into_iter().rev().flatten().collect(),
        }
    }
}

/// Coordinates about the middle of all points, in units of their extent.
#[derive(Clone, Copy, Debug)]
struct Unit {
    middle: Point3,
    /// One over the extent.
    scale: f64,
}

impl Unit {
    fn new(points: &[Point3]) -> Self {
        let first = points.first().copied().unwrap_or_default();
        let (low, high) = (points.iter()).fold((first, first), |(low, high), point| {
            (low.inf(point), high.sup(point))
        });
        let extent = (high - low).amax();
        Self {
            middle: low + 0.5 * (high - low),
            scale: if extent > 0.0 { extent.recip() } else { 1.0 },
        }
    }

    fn of(&self, point: Point3) -> Point3 {
        Point3::from(self.scale * (point - self.middle))
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
        let search = Search::new(self.unit.of(point), facing);
        let in_units = |squared: f64| above(squared * self.unit.scale * self.unit.scale);
        let mut least_in_units = in_units(least);
        let mut open = [(0, 0.0); 3 * MOST_LEVELS + 1];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (place, distance) = open[count];
            if distance >= least_in_units {
                continue;
            }
            let Some(node) = self.nodes.get(place) else {
                for &face in self
                    .plan
                    .members(self.plan.levels, place - self.nodes.len())
                {
                    try_face(face, &mut least);
                }
                least_in_units = in_units(least);
                continue;
            };
            let distances = node.distances(&search);
            let first = count;
            for entry in (4 * place + 1..).zip(distances) {
                if entry.1 < least_in_units {
                    open[count] = entry;
                    // The nearest of the four stays last, to be looked at first.
                    if count > first && entry.1 > open[count - 1].1 {
                        open.swap(count - 1, count);
                    }
                    count += 1;
                }
            }
        }
        best
    }
}

impl Summary {
    const NOTHING: Self = Self {
        low: Point3::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        high: Point3::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
        normals: Vector3::new(0.0, 0.0, 0.0),
        range: [u32::MAX, 0],
    };

    fn new(faces: FacesOfPose<'_>, members: &[u32]) -> Self {
        members.iter().fold(Self::NOTHING, |all, &face| {
            let [a, b, c] = faces.corners(face);
            all.with(&Self {
                low: a.inf(&b).inf(&c),
                high: a.sup(&b).sup(&c),
                normals: faces.normals[face as usize],
                range: [face, face],
            })
        })
    }

    fn joined(parts: &[Self]) -> Self {
        parts.iter().fold(Self::NOTHING, |all, part| all.with(part))
    }

    fn with(&self, other: &Self) -> Self {
        Self {
            low: self.low.inf(&other.low),
            high: self.high.sup(&other.high),
            normals: self.normals + other.normals,
            range: [
                self.range[0].min(other.range[0]),
                self.range[1].max(other.range[1]),
            ],
        }
    }
}

impl Bounds {
    /// What is around nothing is infinitely far.
    const NOWHERE: Self = Self {
        centre: [0.0; 3],
        axis: [0.0; 3],
        along: [f32::INFINITY, f32::NEG_INFINITY],
        radius: 0.0,
        spread: [-1.0, 0.0],
        range: [u32::MAX, 0],
    };

    fn new(faces: FacesOfPose<'_>, members: &[u32], summary: &Summary) -> Self {
        if members.is_empty() {
            return Self::NOWHERE;
        }
        let middle = summary.low + 0.5 * (summary.high - summary.low);
        let axis = summary
            .normals
            .try_normalize(1e-3)
            .unwrap_or_else(Vector3::z);
        let [centre, axis] = [middle.coords, axis].map(|v| <[f64; 3]>::from(v).map(|x| x as f32));
        let middle = Point3::from(centre.map(f64::from));
        let along = Vector3::from(axis.map(f64::from));
        let (mut begin, mut end) = (f64::INFINITY, f64::NEG_INFINITY);
        let (mut beside, mut cos) = (0.0_f64, 1.0_f64);
        for &face in members {
            for corner in faces.corners(face) {
                let away = corner - middle;
                let height = along.dot(&away);
                begin = begin.min(height);
                end = end.max(height);
                beside = beside.max(away.norm_squared() - height * height);
            }
            let normal = faces.normals[face as usize];
            if normal != Vector3::zeros() {
                cos = cos.min(along.dot(&normal));
            }
        }
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        Self {
            centre,
            axis,
            along: [begin as f32 - ROUNDING, end as f32 + ROUNDING],
            radius: beside.max(0.0).sqrt() as f32 + ROUNDING,
            spread: [cos as f32, sin as f32],
            range: summary.range,
        }
    }
}

/// What is looked for, in 32 bits.
struct Search {
    point: [f32; 3],
    direction: [f32; 3],
    cos_least: f32,
    sin_least: f32,
    faces: [u32; 2],
}

impl Search {
    fn new(point: Point3, facing: &Facing) -> Self {
        let [point, direction] =
            [point.coords, facing.direction].map(|v| <[f64; 3]>::from(v).map(|x| x as f32));
        let cos = facing.cos_least;
        Self {
            point,
            direction,
            cos_least: cos as f32,
            sin_least: (1.0 - cos * cos).max(0.0).sqrt() as f32,
            faces: facing.faces,
        }
    }
}

impl Node {
    fn new(four: &[Bounds; 4]) -> Self {
        let each = |what: &dyn Fn(&Bounds) -> f32| Vec4::from(four.each_ref().map(what));
        let axes = [0, 1, 2];
        Self {
            centre: axes.map(|axis| each(&|bounds| bounds.centre[axis])),
            axis: axes.map(|axis| each(&|bounds| bounds.axis[axis])),
            begin: each(&|bounds| bounds.along[0]),
            end: each(&|bounds| bounds.along[1]),
            radius: each(&|bounds| bounds.radius),
            cos: each(&|bounds| bounds.spread[0]),
            sin: each(&|bounds| bounds.spread[1]),
            ranges: four.map(|bounds| bounds.range),
        }
    }

    /// Squared distances to the cylinders, at most; infinite where nothing in one can be found.
    #[inline]
    fn distances(&self, search: &Search) -> [f32; 4] {
        let dot = |a: [Vec4; 3], b: [Vec4; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let [x, y, z] = search.point.map(Vec4::splat);
        let away = [x - self.centre[0], y - self.centre[1], z - self.centre[2]];
        let height = dot(away, self.axis);
        let above = (self.begin - height).max(height - self.end).max(Vec4::ZERO);
        let across = (SHORTER * dot(away, away) - height * height).max(Vec4::ZERO);
        let beside = (Vec4::sqrt(across) - self.radius).max(Vec4::ZERO);
        let squared = SHORTER * (above * above + beside * beside);
        // Every normal in a cone is nearer than the angle where θ + spread < angle, which is θ < angle − spread.
        let cos = dot(self.axis, search.direction.map(Vec4::splat));
        let limit = search.cos_least * self.cos + search.sin_least * self.sin;
        let within = self.cos.cmpgt(Vec4::splat(search.cos_least))
            & cos.cmpgt(limit + Vec4::splat(ROUNDING));
        let [from, to] = search.faces;
        let others =
            BVec4A::from_array(self.ranges.map(|[least, most]| most < from || least >= to));
        Vec4::select(within | others, Vec4::INFINITY, squared).to_array()
    }
}

/// The least number of 32 bits that is not below.
fn above(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) < value {
        near.next_up()
    } else {
        near
    }
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
