//! Bounds of sets of faces, from those of their parts.

use super::faces::FacesOfPose;
use crate::mesh::{Point3, Vector3};

/// More than coordinates of 32 bits are off by, in extents of all faces.
const ROUNDING: f32 = 1e-6;

/// What lies around some faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// A point on the axis of the cylinder.
    pub centre: [f32; 3],
    /// That of the cylinder, and of the cone.
    pub axis: [f32; 3],
    /// Where the cylinder begins and ends, from the centre along the axis.
    pub along: [f32; 2],
    pub radius: f32,
    /// Cosine and sine of the angle between the axis and the farthest normal.
    pub spread: [f32; 2],
    /// Least number of a face, and greatest.
    pub range: [u32; 2],
}

/// What of some faces is known from their parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Summary {
    low: Point3,
    high: Point3,
    normals: Vector3,
    /// Least number of a face, and greatest.
    range: [u32; 2],
}

impl Summary {
    const NOTHING: Self = Self {
        low: Point3::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        high: Point3::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
        normals: Vector3::new(0.0, 0.0, 0.0),
        range: [u32::MAX, 0],
    };

    pub fn new(faces: FacesOfPose<'_>, members: &[u32]) -> Self {
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

    pub fn joined(parts: &[Self]) -> Self {
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

    pub fn new(faces: FacesOfPose<'_>, members: &[u32], summary: &Summary) -> Self {
        if members.is_empty() {
            return Self::NOWHERE;
        }
        let middle = summary.low + 0.5 * (summary.high - summary.low);
        let axis = summary
            .normals
            // Normals that cancel, as on a sphere, give no axis; any will do then.
            .try_normalize(1e-3)
            .unwrap_or_else(Vector3::z);
        let [centre, axis] = [middle.coords, axis].map(|v| <[f64; 3]>::from(v).map(|x| x as f32));
        // Measured from the rounded centre, so that rounding it costs nothing in safety.
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
                // Squared distance from the axis by Pythagoras; the root is taken once at the end.
                beside = beside.max(away.norm_squared() - height * height);
            }
            let normal = faces.normals[face as usize];
            if normal != Vector3::zeros() {
                cos = cos.min(along.dot(&normal));
            }
        }
        // Kept beside the cosine: comparing angles of cones needs both, and no arc cosine.
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
