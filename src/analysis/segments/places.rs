//! Where points lie on the ventricle: level, segment and place on the bull's-eye.

use crate::mesh::Point3;

use super::{Level, LongAxis, Segment};

/// Share of the cavity's length, at its end, that counts as the apex.
///
/// The standard's segment 17 is the myocardium beyond the end of the cavity, of which a surface along the
/// cavity has nothing. Over a rounded end 6 % of the length are near the seventeenth part of the area
/// that the standard means the cap to have.
pub const CAP_SHARE: f64 = 0.06;

/// Share of the cavity's length above the middle of the rim up to which a place is still basal: a
/// rim of half the length across that is tilted by 30° reaches 0.13 above its middle.
const ABOVE_BASE: f64 = 0.2;

/// Place on the bull's-eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar {
    /// Height over the end of the cavity as a share of its length: 0 at the apex, 1 at the base;
    /// above 1 where a tilted rim reaches past the middle of the base.
    pub radius: f64,
    /// Angle in radians: 0 right (lateral), π/2 up (anterior), ±π left (septum).
    pub angle_rad: f64,
}

/// Place of a point on the bull's-eye.
pub fn polar(axis: &LongAxis, point: Point3) -> Polar {
    Polar {
        // What lies beyond the end of the cavity is drawn in the middle, not mirrored.
        radius: (1.0 - axis.depth(point)).max(0.0),
        angle_rad: axis.angle_rad(point),
    }
}

/// Level of a point; `None` if it lies far above the base. Needs no directions across the axis.
///
/// The last [`CAP_SHARE`] of the cavity and what is beyond it is the apex.
pub fn level(axis: &LongAxis, point: Point3) -> Option<Level> {
    Some(Level::at_depth(wall_depth(axis, point)?))
}

/// Segment of a point; `None` if it lies far above the base, or where septum and anterior wall are
/// not known.
pub fn segment(axis: &LongAxis, point: Point3) -> Option<Segment> {
    if !axis.is_oriented() {
        return None;
    }
    Some(Segment::at(wall_depth(axis, point)?, axis.angle_rad(point)))
}

/// Depth with the end of the cavity counted as beyond it.
fn wall_depth(axis: &LongAxis, point: Point3) -> Option<f64> {
    let depth = axis.depth(point);
    if depth < -ABOVE_BASE {
        None
    // Exactly 1 is the apex for levels and segments.
    } else if depth >= 1.0 - CAP_SHARE {
        Some(1.0)
    } else {
        Some(depth)
    }
}

/// Places of the vertices of one surface. Told once, at end-diastole, and kept over the beat: a
/// vertex stays in its segment wherever it moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    /// The axis by which they were determined.
    pub axis: LongAxis,
    /// Per vertex, where it is drawn.
    pub polar: Vec<Polar>,
    /// Per vertex, which ring.
    pub levels: Vec<Option<Level>>,
    /// Per vertex, which segment; all `None` where septum and anterior wall are not known.
    pub segments: Vec<Option<Segment>>,
}

/// Places of points.
pub fn places(axis: &LongAxis, points: &[Point3]) -> Places {
    Places {
        axis: *axis,
        polar: points.iter().map(|&point| polar(axis, point)).collect(),
        levels: points.iter().map(|&point| level(axis, point)).collect(),
        segments: points.iter().map(|&point| segment(axis, point)).collect(),
    }
}
