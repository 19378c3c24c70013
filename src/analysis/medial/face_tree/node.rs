//! Four parts of a tree at once.

use glam::{BVec4A, Vec4};

use super::bounds::Bounds;
use super::faces::Facing;
use crate::mesh::Point3;

/// Squares of distances are off by less than what is missing here to one.
const SHORTER: f32 = 1.0 - 1e-5;

/// Cosines and sines of 32 bits are off by less, even those of small angles.
const ROUNDING: f32 = 1e-3;

/// What lies around each of the four nodes below a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    centre: [Vec4; 3],
    axis: [Vec4; 3],
    begin: Vec4,
    end: Vec4,
    radius: Vec4,
    cos: Vec4,
    sin: Vec4,
    ranges: [[u32; 2]; 4],
}

impl Node {
    pub fn new(four: &[Bounds; 4]) -> Self {
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
    pub fn distances(&self, search: &Search) -> [f32; 4] {
        let dot = |a: [Vec4; 3], b: [Vec4; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let away = |k: usize| Vec4::splat(search.point[k]) - self.centre[k];
        let away = [away(0), away(1), away(2)];
        let height = dot(away, self.axis);
        let above = (self.begin - height).max(height - self.end).max(Vec4::ZERO);
        let across = (SHORTER * dot(away, away) - height * height).max(Vec4::ZERO);
        let beside = (Vec4::sqrt(across) - self.radius).max(Vec4::ZERO);
        let squared = SHORTER * (above * above + beside * beside);
        // Every normal in a cone is nearer than the angle where θ + spread < angle, which is θ < angle − spread.
        let direction = |k: usize| Vec4::splat(search.direction[k]);
        let cos = dot(self.axis, [direction(0), direction(1), direction(2)]);
        let limit = search.cos_min_angle * self.cos + search.sin_min_angle * self.sin;
        // Half-angles beyond the limit would make the comparison of cosines wrong; such a cone is searched.
        let within = self.cos.cmpgt(Vec4::splat(search.cos_min_angle))
            & cos.cmpgt(limit + Vec4::splat(ROUNDING));
        let squared = Vec4::select(within, Vec4::INFINITY, squared);
        let Some([from, to]) = search.faces else {
            return squared.to_array();
        };
        let others = self.ranges.map(|[least, most]| most < from || least >= to);
        Vec4::select(BVec4A::from_array(others), Vec4::INFINITY, squared).to_array()
    }
}

/// What is looked for, in 32 bits.
pub(super) struct Search {
    point: [f32; 3],
    direction: [f32; 3],
    cos_min_angle: f32,
    sin_min_angle: f32,
    faces: Option<[u32; 2]>,
}

impl Search {
    pub fn new(point: Point3, facing: &Facing) -> Self {
        let cos = facing.cos_min_angle;
        Self {
            point: [point.x as f32, point.y as f32, point.z as f32],
            direction: [
                facing.direction.x as f32,
                facing.direction.y as f32,
                facing.direction.z as f32,
            ],
            cos_min_angle: cos as f32,
            sin_min_angle: (1.0 - cos * cos).max(0.0).sqrt() as f32,
            faces: facing.faces,
        }
    }
}
