//! The long axis of a subject at a frame, and the places of its vertices.

use crate::analysis::measures::{Side, WallSides, wall_sides};
use crate::mesh::{Point3, Vector3, vertex_areas};
use crate::study::{Anatomy, Subject};

use super::{LongAxis, Places, SegmentError, places};

/// Rims shorter than this share of the longest are holes, not openings of the subject: a valve is
/// longer than a fourth of the other's ring.
const MIN_RIM: f64 = 0.25;

/// The long axis of a subject at a frame.
///
/// With landmarks, which are stated for the first frame: the apex moves with the vertex nearest to
/// it, the base with the rim, and the directions of septum and anterior wall stay as square to the axis
/// as they can. Without landmarks: the base is the centre of the inner side's rims by length, the apex
/// the point of the outer side that is farthest from it in the direction of that side's centroid (by distance
/// alone the rim would win where a ventricle is as wide as long), and septum and anterior wall are unknown.
/// The outer side counts where there is one, and the cavity ends where the inner side does.
///
/// # Errors
/// If there is no such frame, nothing is said to be a subject, or a closed surface has no landmarks.
pub fn long_axis(subject: &Subject, frame: usize) -> Result<LongAxis, SegmentError> {
    let frames = subject.sequence.frame_count();
    if frame >= frames {
        return Err(SegmentError::NoFrame { frame, frames });
    }
    let sides = wall_sides(&subject.sequence);
    let (Some(rim_side), Some(tip_side)) = (
        sides.inner.as_ref().or(sides.outer.as_ref()),
        // The tip of the ventricle is on its outside; the wall at the apex belongs to it.
        sides.outer.as_ref().or(sides.inner.as_ref()),
    ) else {
        return Err(SegmentError::NoHeart);
    };
    let rims = rims(rim_side, frame);
    let axis = match &subject.anatomy {
        Some(anatomy) => moved_anatomy(anatomy, &rims, [rim_side, tip_side], frame)?,
        None => found(&rims, [rim_side, tip_side], frame)?,
    };
    Ok(with_cavity(axis, &sides, frame))
}

/// Where the vertices of the surface of the inner side lie, determined at one frame, end-diastole.
///
/// # Errors
/// As [`long_axis`].
pub fn inner_places(subject: &Subject, frame: usize) -> Result<Places, SegmentError> {
    let axis = long_axis(subject, frame)?;
    let sides = wall_sides(&subject.sequence);
    let side = sides.inner.as_ref().or(sides.outer.as_ref());
    let vertices = side.map_or(&[][..], |side| side.vertices(frame));
    Ok(places(&axis, vertices))
}

fn with_cavity(axis: LongAxis, sides: &WallSides<'_>, frame: usize) -> LongAxis {
    let side = sides.inner.as_ref().or(sides.outer.as_ref());
    let members = side.map_or_else(Vec::new, |side| member_points(side, frame));
    axis.with_cavity(&members)
}

fn member_points(side: &Side<'_>, frame: usize) -> Vec<Point3> {
    (side.vertices(frame).iter())
        .zip(side.members())
        .filter_map(|(&point, member)| member.then_some(point))
        .collect()
}

/// The openings of a side.
fn rims(side: &Side<'_>, frame: usize) -> Vec<Vec<u32>> {
    let vertices = side.vertices(frame);
    let loops = side.faces().boundary_loops();
    // By length, not by number of vertices: a finely cut hole is still a small one.
    let lengths: Vec<f64> = (loops.iter())
        .map(|rim| sides_of(rim, vertices).map(|[a, b]| (b - a).norm()).sum())
        .collect();
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    loops
        .into_iter()
        .zip(lengths)
        .filter_map(|(rim, length)| (length > 0.0 && length >= MIN_RIM * longest).then_some(rim))
        .collect()
}

fn sides_of<'a>(rim: &'a [u32], vertices: &'a [Point3]) -> impl Iterator<Item = [Point3; 2]> + 'a {
    (0..rim.len()).map(move |i| [rim[i], rim[(i + 1) % rim.len()]].map(|v| vertices[v as usize]))
}

/// Mean of rims by length; `None` without any.
fn rim_centre(rims: &[Vec<u32>], vertices: &[Point3]) -> Option<Point3> {
    let mut sum = Vector3::zeros();
    let mut whole = 0.0;
    for [a, b] in rims.iter().flat_map(|rim| sides_of(rim, vertices)) {
        let length = (b - a).norm();
        // By length, so that a rim sampled more densely on one side keeps its centre.
        sum += 0.5 * length * (a.coords + b.coords);
        whole += length;
    }
    (whole > 0.0).then(|| Point3::from(sum / whole))
}

fn found(
    rims: &[Vec<u32>],
    [rim_side, tip_side]: [&Side<'_>; 2],
    frame: usize,
) -> Result<LongAxis, SegmentError> {
    let vertices = rim_side.vertices(frame);
    let (Some(base), Some(first)) = (
        rim_centre(rims, vertices),
        rims.first().and_then(|rim| rim.first()),
    ) else {
        return Err(SegmentError::NoRim {
            kind: rim_side.surface().kind().name(),
        });
    };
    let tip_vertices = tip_side.vertices(frame);
    // Along the direction of the centroid: the farthest point in space may lie on the rim itself.
    let towards = area_centroid(tip_vertices, tip_side.faces().triangles()) - base;
    let apex = (member_points(tip_side, frame).into_iter())
        .max_by(|a, b| {
            towards
                .dot(&(a - base))
                .total_cmp(&towards.dot(&(b - base)))
        })
        .unwrap_or(base);
    let none = SegmentError::NoLength {
        length: (apex - base).norm(),
    };
    LongAxis::new(apex, base, vertices[*first as usize] - base).ok_or(none)
}

/// Area-weighted centroid of triangles; the origin of no area.
fn area_centroid(vertices: &[Point3], triangles: &[[u32; 3]]) -> Point3 {
    let areas = vertex_areas(vertices, triangles);
    let whole: f64 = areas.iter().sum();
    let sum: Vector3 = (vertices.iter().zip(&areas))
        .map(|(point, &area)| point.coords * area)
        .sum();
    Point3::from(sum / whole.max(f64::MIN_POSITIVE))
}

fn moved_anatomy(
    anatomy: &Anatomy,
    rims: &[Vec<u32>],
    [rim_side, tip_side]: [&Side<'_>; 2],
    frame: usize,
) -> Result<LongAxis, SegmentError> {
    let apex = anatomy.apex + displacement(tip_side, anatomy.apex, frame);
    let rim_at = |frame| rim_centre(rims, rim_side.vertices(frame));
    // The whole rim is steadier than the one vertex nearest to the landmark.
    let base = match (rim_at(0), rim_at(frame)) {
        (Some(first), Some(now)) => anatomy.base + (now - first),
        _ => anatomy.base + displacement(rim_side, anatomy.base, frame),
    };
    LongAxis::oriented(apex, base, anatomy.septal, anatomy.anterior).ok_or(SegmentError::NoLength {
        length: (apex - base).norm(),
    })
}

/// How far the vertex nearest to a landmark of the first frame has moved.
fn displacement(side: &Side<'_>, landmark: Point3, frame: usize) -> Vector3 {
    let first = side.vertices(0);
    let nearest = (0..first.len()).min_by(|&a, &b| {
        let away = |v: usize| (first[v] - landmark).norm_squared();
        away(a).total_cmp(&away(b))
    });
    nearest.map_or_else(Vector3::zeros, |v| side.vertices(frame)[v] - first[v])
}
