//! The largest ball that touches one vertex of a wall and holds no point of the side across.

use super::face_tree::{FaceTree, FacesOfPose, Facing, Nearest};
use crate::mesh::{Point3, Vector3};

/// Relative difference between a ball's radius and the distance from its centre to the side across at which it counts as touching.
/// Distances are exact to some 1e-15 of the coordinates, which are some hundred times larger than radii at most.
const TOUCHING: f64 = 1e-10;

/// Halving alone comes from the largest ball to one that touches in fewer.
const MOST_STEPS: usize = 64;

/// Cosine of 25°, by which normals of a face's corners differ on meshes of some hundred vertices.
const COS_MOST_TURN: f64 = 0.906;

/// A wall at one pose, ready for balls.
#[derive(Clone, Copy, Debug)]
pub(super) struct WallOfPose<'a> {
    pub faces: FacesOfPose<'a>,
    pub tree: &'a FaceTree,
    /// Unit normals of vertices, into the muscle; zero where a vertex has no face.
    pub normals: &'a [Vector3],
    /// Whether vertices lie on an open boundary.
    pub boundary: &'a [bool],
    /// Cosine of the least angle of separation.
    pub cos_separation: f64,
    /// Radius of balls that no wall holds.
    pub most_radius: f64,
}

/// How a ball ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    /// It touches the side across.
    Touches,
    /// It touches the side across at its open boundary.
    TouchesBoundary,
    /// Nothing holds it.
    Leaks,
    /// The side across lies behind the vertex.
    NoRoom,
}

/// A ball that touches a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub radius: f64,
    /// Unit vector from its centre to where it touches the side across, or away from the vertex if it does not.
    pub across: Vector3,
    pub fit: Fit,
    /// The face that it touches.
    pub face: Option<u32>,
}

impl WallOfPose<'_> {
    /// The largest ball that touches `vertex` from within and has no face in it whose normal is at least the angle of
    /// separation away from the vertex's.
    ///
    /// With p the vertex and n its normal, centres are c = p + r n; d(r), the distance of c to those faces, less r, falls
    /// with r, so that there is one root. From a ball that is too large the next one touches p and the nearest point q,
    /// r = |q − p|² / (2 n·(q − p)), where q is a corner or on an edge; on a flat face the next one touches p and its plane,
    /// by Newton's step r + (d − r) / (1 − n·u), u = (c − q) / d.
    ///
    /// Since normals of touching points differ by the angle between the spokes, leaving out faces that are turned less is
    /// the test of the separation angle, made before the search instead of during it.
    ///
    /// Source: shrinking balls, Ma, Bae and Choi (2012), The Visual Computer 28(1), 7–19, there among points.
    pub fn ball(&self, vertex: u32, radius: f64, hint: Option<u32>) -> Ball {
        let point = self.faces.points[vertex as usize];
        let normal = self.normals[vertex as usize];
        let facing = self.facing(normal);
        let [mut low, mut high] = [0.0, self.most_radius];
        // Only a ball that was seen not to fit, or one that a point allows, is known to be too large.
        let mut high_known = false;
        let mut radius = radius.clamp(0.0, high);
        let mut nearest: Option<Nearest> = None;
        for _ in 0..MOST_STEPS {
            let centre = point + radius * normal;
            let hint = nearest.as_ref().map(|n| n.face).or(hint);
            let Some(found) = self
                .tree
                .nearest(self.faces, centre, &facing, f64::INFINITY, hint)
            else {
                return self.without_foot(vertex, Fit::Leaks);
            };
            nearest = Some(found);
            let distance = found.squared.sqrt();
            let miss = distance - radius;
            if miss.abs() <= TOUCHING * radius {
                return self.touching(vertex, radius, &found);
            }
            let to_foot = found.point - point;
            if miss < 0.0 {
                high = radius;
                let through = to_foot.norm_squared() / (2.0 * normal.dot(&to_foot));
                if through.is_finite() && through > 0.0 {
                    high = high.min(through);
                }
                high_known = true;
            } else {
                low = radius;
            }
            if low >= self.most_radius * (1.0 - TOUCHING) {
                break;
            }
            if high - low <= TOUCHING * high {
                return self.touching(vertex, radius, &found);
            }
            let slope = 1.0 - normal.dot(&(centre - found.point)) / distance.max(f64::MIN_POSITIVE);
            let plane = radius + miss / slope;
            let on_face = found.weights.iter().all(|&weight| weight > 0.0);
            radius = if miss < 0.0 && !on_face {
                high
            } else if plane > low && plane < high {
                plane
            } else if high_known {
                0.5 * (low + high)
            } else {
                high
            };
        }
        let crossing = self.behind(point, normal, &facing);
        self.without_foot(vertex, if crossing { Fit::NoRoom } else { Fit::Leaks })
    }

    fn facing(&self, normal: Vector3) -> Facing {
        Facing {
            direction: normal,
            cos_least: self.cos_separation,
            faces: [0, self.faces.triangles.len() as u32],
        }
    }

    fn touching(&self, vertex: u32, radius: f64, found: &Nearest) -> Ball {
        let corners = self.faces.triangles[found.face as usize];
        let carriers = (corners.iter().zip(found.weights)).filter(|&(_, weight)| weight > 0.0);
        let at_boundary = found.weights.contains(&0.0)
            && carriers.map(|(&v, _)| v).all(|v| self.boundary[v as usize]);
        let fit = match (radius <= 0.0, at_boundary) {
            (true, _) => Fit::NoRoom,
            (false, true) => Fit::TouchesBoundary,
            (false, false) => Fit::Touches,
        };
        let Fit::NoRoom = fit else {
            return Ball {
                radius,
                across: self.across(vertex, radius, found),
                fit,
                face: Some(found.face),
            };
        };
        self.without_foot(vertex, fit)
    }

    fn without_foot(&self, vertex: u32, fit: Fit) -> Ball {
        let radius = match fit {
            Fit::NoRoom => 0.0,
            _ => self.most_radius,
        };
        Ball {
            radius,
            across: self.normals[vertex as usize],
            fit,
            face: None,
        }
    }

    /// Against the normal of the side across, which a ball's radius is by nature; the normals of the corners are weighted
    /// as the place where it touches is, so that flat faces do not turn it by half their angles. Where that is far from the direction to
    /// the touching point, on a rim, this direction.
    fn across(&self, vertex: u32, radius: f64, found: &Nearest) -> Vector3 {
        let normal = self.normals[vertex as usize];
        let centre = self.faces.points[vertex as usize] + radius * normal;
        let to_foot = (found.point - centre).try_normalize(0.0).unwrap_or(normal);
        let outwards = -self.interpolated_normal(found);
        match outwards.try_normalize(0.0) {
            Some(outwards) if outwards.dot(&to_foot) > COS_MOST_TURN => outwards,
            _ => to_foot,
        }
    }

    fn interpolated_normal(&self, found: &Nearest) -> Vector3 {
        let corners = self.faces.triangles[found.face as usize];
        (corners.iter().zip(found.weights))
            .map(|(&v, weight)| weight * self.normals[v as usize])
            .sum()
    }

    /// Whether the nearest point of the side across is seen from its outer side: the sides cross.
    fn behind(&self, point: Point3, normal: Vector3, facing: &Facing) -> bool {
        let most = self.most_radius * self.most_radius;
        let Some(found) = self.tree.nearest(self.faces, point, facing, most, None) else {
            return normal == Vector3::zeros();
        };
        let corners = self.faces.triangles[found.face as usize];
        let weighted = corners.iter().zip(found.weights);
        let inwards = self.interpolated_normal(&found);
        let at_boundary = found.weights.contains(&0.0)
            && weighted
                .filter(|&(_, weight)| weight > 0.0)
                .all(|(&v, _)| self.boundary[v as usize]);
        !at_boundary && inwards.dot(&(point - found.point)) <= 0.0
    }
}
