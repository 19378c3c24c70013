//! Sixteen places of a ventricular surface, six of them on its rim.

use serde::{Deserialize, Serialize};

use crate::mesh::{Point3, Vector3};

use super::axis::VentricleAxis;
use super::{TargetError, target_surface::TargetSurface};

/// How many landmarks a surface has, as in section 3.6.2.
pub const LANDMARK_COUNT: usize = 16;

/// A place of a ventricular surface that is found on every one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LandmarkPlace {
    /// The word on screen.
    pub name: &'static str,
    /// Share of the way, along the long axis, from the rim (0) to the apex (1).
    pub depth: f64,
    /// Angle around the long axis from the middle of the septum towards the anterior wall, in degrees.
    pub around_deg: f64,
}

const fn place(name: &'static str, depth: f64, around_deg: f64) -> LandmarkPlace {
    LandmarkPlace {
        name,
        depth,
        around_deg,
    }
}

/// Depths of the landmarks inside: so that rings and apex are evenly apart along the wall of a usual ventricle.
const MIDDLE: f64 = 0.4;
const LOW: f64 = 0.75;

/// The landmarks: six on the rim and six at the middle, in the directions of the AHA segments, three near the apex, and it.
///
/// The method sets 16 by hand, on the boundary and inside (section 3.6.2, fig. 3.21), and does not say where; these cover
/// the surface evenly.
pub const LANDMARK_PLACES: [LandmarkPlace; LANDMARK_COUNT] = [
    place("basal anteroseptal", 0.0, 30.0),
    place("basal anterior", 0.0, 90.0),
    place("basal anterolateral", 0.0, 150.0),
    place("basal inferolateral", 0.0, 210.0),
    place("basal inferior", 0.0, 270.0),
    place("basal inferoseptal", 0.0, 330.0),
    place("mid anteroseptal", MIDDLE, 30.0),
    place("mid anterior", MIDDLE, 90.0),
    place("mid anterolateral", MIDDLE, 150.0),
    place("mid inferolateral", MIDDLE, 210.0),
    place("mid inferior", MIDDLE, 270.0),
    place("mid inferoseptal", MIDDLE, 330.0),
    place("apical septal", LOW, 0.0),
    place("apical anterolateral", LOW, 120.0),
    place("apical inferolateral", LOW, 240.0),
    place("apex", 1.0, 0.0),
];

/// The positions of the landmarks on one surface at one instant, in the order of [`LANDMARK_PLACES`]. Plain numbers: they
/// can be moved by hand and stored.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    from = "[[f64; 3]; LANDMARK_COUNT]",
    into = "[[f64; 3]; LANDMARK_COUNT]"
)]
pub struct SurfaceLandmarks {
    /// One for each place.
    pub points: [Point3; LANDMARK_COUNT],
}

impl From<[[f64; 3]; LANDMARK_COUNT]> for SurfaceLandmarks {
    fn from(points: [[f64; 3]; LANDMARK_COUNT]) -> Self {
        Self {
            points: points.map(Point3::from),
        }
    }
}

impl From<SurfaceLandmarks> for [[f64; 3]; LANDMARK_COUNT] {
    fn from(landmarks: SurfaceLandmarks) -> Self {
        landmarks.points.map(Into::into)
    }
}

impl SurfaceLandmarks {
    /// Whether every coordinate is a finite number.
    ///
    /// # Errors
    /// At the first landmark with one that is not.
    pub fn check(&self) -> Result<(), TargetError> {
        let finite = |p: &Point3| p.iter().all(|x| x.is_finite());
        match self.points.iter().position(|p| !finite(p)) {
            Some(index) => Err(TargetError::LandmarkNotFinite {
                landmark: LANDMARK_PLACES[index].name,
            }),
            None => Ok(()),
        }
    }

    /// Where the landmarks are on a surface with this axis.
    pub(super) fn propose(
        surface: &TargetSurface,
        axis: &VentricleAxis,
    ) -> Result<Self, TargetError> {
        let rim = surface.rim();
        let apex = axis.apex_of(surface);
        let apex_depth = axis.depth(&apex);
        let mut points = [apex; LANDMARK_COUNT];
        for (point, place) in points.iter_mut().zip(&LANDMARK_PLACES) {
            if place.depth >= 1.0 {
                continue;
            }
            let missing = || TargetError::NoLandmark {
                landmark: place.name,
            };
            let angle = place.around_deg.to_radians();
            let out = axis.direction(angle);
            let on_rim = rim_at(&rim, axis, out).ok_or_else(missing)?;
            *point = on_rim;
            if place.depth > 0.0 {
                let start = axis.depth(&on_rim);
                let depth = start + place.depth * (apex_depth - start);
                let from = axis.base + axis.down * depth;
                let radius = (on_rim - axis.base).dot(&out);
                // In a hole the nearest place of the surface stands in.
                *point = (surface.last_hit(from, out))
                    .unwrap_or_else(|| surface.nearest(from + out * radius).point);
            }
        }
        Ok(Self { points })
    }
}

/// Where the rim passes through the half plane from the axis in a direction; the outermost place.
fn rim_at(rim: &[Point3], axis: &VentricleAxis, out: Vector3) -> Option<Point3> {
    let beside = axis.down.cross(&out);
    let crossing = |index: usize| {
        let [from, to] = [rim[index], rim[(index + 1) % rim.len()]];
        let [a, b] = [from, to].map(|p| (p - axis.base).dot(&beside));
        // Half open, so that a vertex in the plane counts once.
        if (a < 0.0) == (b < 0.0) {
            return None;
        }
        let point = from + (to - from) * (a / (a - b));
        let radius = (point - axis.base).dot(&out);
        (radius > 0.0).then_some((radius, point))
    };
    let found = (0..rim.len()).filter_map(crossing);
    found
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, point)| point)
}
