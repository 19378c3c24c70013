//! The largest sphere that touches one vertex of a wall and holds no point of the side across.

use super::face_tree::{FaceTree, FacesOfPose, Facing, Nearest};
use crate::mesh::{Point3, Vector3};

/// Relative difference between a sphere's radius and the distance from its centre to the side across at which one more step of
/// Newton, whose error is the square of it, ends the search.
const NEARLY: f64 = 1e-5;

/// Relative width of a bracket of radii that no step narrows further.
const CLOSED: f64 = 1e-12;

/// Halving alone comes from the largest sphere to one that touches in fewer.
const MAX_STEPS: usize = 64;

/// Cosine of 25°, by which normals of a face's corners differ on meshes of some hundred vertices.
const COS_MOST_TURN: f64 = 0.906;

/// A wall at one pose, ready for spheres.
#[derive(Clone, Copy, Debug)]
pub(super) struct WallOfPose<'a> {
    pub faces: FacesOfPose<'a>,
    pub tree: &'a FaceTree<'a>,
    /// Unit normals of vertices, into the myocardium; zero where a vertex has no face.
    pub normals: &'a [Vector3],
    /// Whether vertices lie on an open boundary.
    pub boundary: &'a [bool],
    /// Cosine of the least angle of separation.
    pub cos_separation: f64,
    /// Radius of spheres that no wall holds.
    pub max_radius: f64,
}

/// How a sphere ended.
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

/// A sphere that touches a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct MedialSphere {
    pub radius: f64,
    /// Cosine of the angle at its centre between the points at which it touches.
    pub cos_separation: f64,
    /// Unit vector from its centre to where it touches the side across, or away from the vertex if it does not.
    pub across: Vector3,
    pub fit: Fit,
    /// The face that it touches.
    pub face: Option<u32>,
}

impl WallOfPose<'_> {
    /// The largest sphere that touches `vertex` from within and has no face in it whose normal is at least the angle of
    /// separation away from the vertex's.
    ///
    /// With p the vertex and n its normal, centres are c = p + r n; d(r) − r, d being the distance of c to those faces, falls
    /// with r, so that there is one root. The sphere that touches p and the nearest point q, r = |q − p|² / (2 n·(q − p)), is never too small;
    /// Newton's step r + (d − r) / (1 − n·u), u = (c − q) / d, lands on the root where a flat face holds the sphere.
    ///
    /// Since normals of touching points differ by the angle between the spokes, leaving out faces that are turned less is
    /// the test of the separation angle, made before the search instead of during it.
    ///
    /// Source: shrinking spheres, Ma, Bae and Choi (2012), The Visual Computer 28(1), 7–19, there among points.
    pub fn sphere(&self, vertex: u32, radius: f64, hint: Option<u32>) -> MedialSphere {
        let point = self.faces.points[vertex as usize];
        let normal = self.normals[vertex as usize];
        let facing = self.facing(normal);
        // d(r) − r falls with r, so that the root stays between the two.
        let [mut low, mut high] = [0.0, self.max_radius];
        // Only a sphere that was seen not to fit, or one that a point allows, is known to be too large.
        let mut high_known = false;
        // A neighbour's face, taken as a plane, gives a good first radius; without one the caller's does.
        let mut radius = hint
            .and_then(|face| self.radius_to_plane(point, normal, face))
            .unwrap_or(radius)
            .clamp(0.0, high);
        let mut hint = hint;
        for _ in 0..MAX_STEPS {
            let centre = point + radius * normal;
            let Some(found) = self.nearest(centre, &facing, hint) else {
                break;
            };
            // The next centre is near, and so is its nearest face: the tree search then prunes at once.
            hint = Some(found.face);
            let distance = found.squared.sqrt();
            let miss = distance - radius;
            // `MIN_POSITIVE` keeps a centre that lies on the surface from dividing 0 by 0.
            let slope = 1.0 - normal.dot(&(centre - found.point)) / distance.max(f64::MIN_POSITIVE);
            let newton = radius + miss / slope;
            if miss.abs() <= NEARLY * radius && newton.is_finite() {
                // One Newton step more than the test asks for costs nothing: its foot is known.
                return self.touching(vertex, newton, &found);
            }
            if miss < 0.0 {
                // The sphere through p and this point is never too small, and often far smaller than the radius
                // tried.
                let to_foot = found.point - point;
                let through = to_foot.norm_squared() / (2.0 * normal.dot(&to_foot));
                high = if through > 0.0 {
                    radius.min(through)
                } else {
                    radius
                };
                high_known = true;
            } else {
                low = radius;
            }
            // Even the largest sphere of a wall is free: it leaks through an opening.
            if low >= self.max_radius * (1.0 - NEARLY) {
                break;
            }
            if high - low <= CLOSED * high {
                return self.touching(vertex, radius, &found);
            }
            // Newton is quadratic near the root; where it leaves the bracket, halving is sure to end.
            radius = if newton > low && newton < high {
                newton
            // Halving towards a bound that was never tested would stop below the root.
            } else if high_known {
                0.5 * (low + high)
            } else {
                high
            };
        }
        let crossing = self.behind(point, normal, &facing);
        self.without_foot(vertex, if crossing { Fit::NoRoom } else { Fit::Leaks })
    }

    /// Nearest point that may hold a sphere.
    fn nearest(&self, centre: Point3, facing: &Facing, hint: Option<u32>) -> Option<Nearest> {
        (self.tree).nearest(centre, facing, f64::INFINITY, hint)
    }

    /// Radius of the sphere that touches the vertex and the plane of a face: m·(p + r n − a) = r.
    fn radius_to_plane(&self, point: Point3, normal: Vector3, face: u32) -> Option<f64> {
        let plane = self.faces.normals[face as usize];
        let corner = self.faces.points[self.faces.triangles[face as usize][0] as usize];
        let radius = plane.dot(&(point - corner)) / (1.0 - plane.dot(&normal));
        (radius > 0.0 && radius.is_finite()).then_some(radius)
    }

    fn facing(&self, normal: Vector3) -> Facing {
        Facing {
            direction: normal,
            cos_min_angle: self.cos_separation,
            faces: None,
        }
    }

    /// The sphere at its foot. Seen from behind, as where the sides coincide or cross, the side across leaves no room.
    fn touching(&self, vertex: u32, radius: f64, found: &Nearest) -> MedialSphere {
        let at_boundary = self.at_boundary(found);
        let normal = self.normals[vertex as usize];
        let centre = self.faces.points[vertex as usize] + radius * normal;
        // A vertex that lies beyond the other side sees its outer face: there is no myocardium between them.
        let from_behind = self.interpolated_normal(found).dot(&(centre - found.point)) <= 0.0;
        let fit = match (radius <= 0.0 || from_behind, at_boundary) {
            (true, false) => Fit::NoRoom,
            // At an open rim the nearest point is the edge of the data, not of the myocardium: the atom ends the sheet.
            (_, true) => Fit::TouchesBoundary,
            (false, false) => Fit::Touches,
        };
        let Fit::NoRoom = fit else {
            let to_foot = (found.point - centre).try_normalize(0.0).unwrap_or(normal);
            return MedialSphere {
                radius,
                cos_separation: -normal.dot(&to_foot),
                across: self.across(to_foot, found),
                fit,
                face: Some(found.face),
            };
        };
        self.without_foot(vertex, fit)
    }

    fn without_foot(&self, vertex: u32, fit: Fit) -> MedialSphere {
        let radius = match fit {
            // No room is thickness 0; a leak keeps the largest radius until its neighbours lend theirs.
            Fit::NoRoom => 0.0,
            _ => self.max_radius,
        };
        MedialSphere {
            radius,
            cos_separation: -1.0,
            across: self.normals[vertex as usize],
            fit,
            face: None,
        }
    }

    /// Against the normal of the side across, which the radius to a touching point is by nature; the normals of the corners are
    /// weighted as the place where it touches is, so that flat faces do not turn it by half their angles. Where that
    /// is far from the direction to the touching point, on a rim, this direction.
    fn across(&self, to_foot: Vector3, found: &Nearest) -> Vector3 {
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

    /// Whether a point lies on an edge or a vertex whose ends are all of the open boundary.
    fn at_boundary(&self, found: &Nearest) -> bool {
        let corners = self.faces.triangles[found.face as usize];
        let mut carriers = (corners.iter().zip(found.weights)).filter(|&(_, weight)| weight > 0.0);
        found.weights.contains(&0.0) && carriers.all(|(&v, _)| self.boundary[v as usize])
    }

    /// Whether the nearest point of the side across is seen from its outer side: the sides cross.
    fn behind(&self, point: Point3, normal: Vector3, facing: &Facing) -> bool {
        // Farther than a wall is thick there is no other side to be behind.
        let most = self.max_radius * self.max_radius;
        let Some(found) = self.tree.nearest(point, facing, most, None) else {
            return normal == Vector3::zeros();
        };
        let inwards = self.interpolated_normal(&found);
        !self.at_boundary(&found) && inwards.dot(&(point - found.point)) <= 0.0
    }
}
