//! The way down the tree to the nearest face.

use super::faces::{FacesOfPose, Facing, Nearest};
use super::node::{Node, Search};
use super::plan::TreePlan;
use super::scaled_coordinates::{ScaledCoordinates, above};
use super::triangle::nearest_on_triangle;
use crate::mesh::{Point3, Vector3};

/// A tree of so many levels, four times as many nodes on each, holds more faces than there are numbers.
const MAX_LEVELS: usize = 16;

/// Cylinders and cones of normals around the faces of a pose.
///
/// Patches of a surface are flat, and mostly lie across the axes: a cylinder about the mean normal is far closer to one than a
/// box. All is in 32 bits, about the middle of all faces and in units of their extent, so that any coordinates fit.
#[derive(Clone, Debug)]
pub(in crate::analysis::medial) struct FaceTree<'a> {
    pub(super) plan: &'a TreePlan,
    pub(super) faces: FacesOfPose<'a>,
    pub(super) coordinates: ScaledCoordinates,
    /// The nodes that are not leaves: the root, and so on level by level. Node i lies around nodes 4i + 1 to 4i + 4.
    pub(super) nodes: Vec<Node>,
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
        let [from_face, to_face] = facing.faces.unwrap_or([0, u32::MAX]);
        let mut try_face = |face: u32, least: &mut f64| {
            let normal = faces.normals[face as usize];
            let allowed = (from_face..to_face).contains(&face)
                && normal.dot(&facing.direction) <= facing.cos_min_angle
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
        // A good guess first: most of the tree is then out of reach.
        if let Some(hint) = hint {
            try_face(hint, &mut least);
        }
        let search = Search::new(self.coordinates.of(point), facing);
        // Rounded up, so that no face is missed that is nearer by less than 32 bits tell.
        let in_units =
            |squared: f64| above(squared * self.coordinates.scale * self.coordinates.scale);
        let mut min_in_units = in_units(least);
        let mut open = [(0, 0.0); 3 * MAX_LEVELS + 1];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (place, distance) = open[count];
            if distance >= min_in_units {
                continue;
            }
            let Some(node) = self.nodes.get(place) else {
                for &face in self.plan.leaf(place - self.nodes.len()) {
                    try_face(face, &mut least);
                }
                min_in_units = in_units(least);
                continue;
            };
            let distances = node.distances(&search);
            let first = count;
            for entry in (4 * place + 1..).zip(distances) {
                if entry.1 < min_in_units {
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
