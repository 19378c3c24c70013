//! Chords across the centre line between the contours of short-axis slices.

use std::f64::consts::TAU;

use rayon::prelude::*;

use crate::analysis::segments::{CAP_SHARE, LongAxis};
use crate::mesh::{Point3, TriMesh, plane_section};
use crate::progress::{Progress, Stopped};

use super::contour::{Point2, Vector2, area_and_centroid, crossings, nearest_place, resampled};

/// Rounds in which the centre line is put back into the middle of its chords. Each leaves a tenth of
/// the distance or less on contours of subjects; 8 leave nothing that could be measured.
const ROUNDS: usize = 8;

/// Chords longer than this multiple of the thickness along the ray do not count: they have missed
/// the wall across a notch.
const LONGEST: f64 = 3.0;

/// One slice: feet of chords on the inner contour, and their lengths.
struct Slice {
    feet: Vec<Point2>,
    lengths: Vec<f64>,
}

/// Plane of a slice: x to the left of the bull's-eye, y up.
struct Frame {
    origin: Point3,
    x: crate::mesh::Vector3,
    y: crate::mesh::Vector3,
}

impl Frame {
    fn flat(&self, point: Point3) -> Point2 {
        let offset = point - self.origin;
        Point2::new(self.x.dot(&offset), self.y.dot(&offset))
    }
}

/// Thickness at each vertex of the inner side: linear between the chords of the two slices around it.
///
/// Slices lie evenly between base and end of the cavity, across the long axis. In each the centre line is the curve
/// whose `chords` perpendiculars, evenly spaced, it halves between the two contours. Slices in which a contour
/// is not closed (where the rim is tilted) say nothing, and so do vertices that lie more than
/// half a slice away from one that does, or over the end of the cavity ([`CAP_SHARE`]), to which slices are
/// tangent. Towards it chords become longer than the wall is thick, because the wall leans.
///
/// Source: Sheehan et al. (1986), Circulation 74(2), 293–305.
pub(super) fn centreline(
    inner: &TriMesh,
    outer: &TriMesh,
    axis: &LongAxis,
    [slices, chords]: [usize; 2],
    progress: &Progress,
) -> Result<Vec<Option<f64>>, Stopped> {
    progress.expect_steps(slices);
    let up = axis.up();
    let x = up.cross(&axis.direction());
    let frame = Frame {
        origin: axis.base,
        x,
        y: up,
    };
    let length = axis.length() * axis.cavity_share;
    let found: Vec<Option<Slice>> = (0..slices)
        .into_par_iter()
        .map(|slice| {
            progress.step()?;
            // In the middle of each slab, so that no slice lies in the plane of the rim or in the tip.
            let depth = length * (slice as f64 + 0.5) / slices as f64;
            let origin = axis.base - axis.direction() * depth;
            let contour = |mesh: &TriMesh| {
                let cut =
                    plane_section(mesh.vertices(), mesh.triangles(), origin, axis.direction());
                largest(
                    cut.into_iter()
                        // Above a tilted rim a slice is open, and a chord might leave through the gap.
                        .filter(|c| c.closed)
                        .map(|contour| contour.points.iter().map(|&p| frame.flat(p)).collect()),
                )
            };
            let contours = contour(inner).zip(contour(outer));
            Ok(contours.and_then(|(inner, outer)| slice_of(&inner, &outer, chords)))
        })
        .collect::<Result<_, Stopped>>()?;
    let at = |vertex: Point3| {
        let depth = axis.depth(vertex);
        let place = depth * slices as f64 - 0.5;
        // In the cap slices run along the wall, and chords are no thickness.
        let local = (depth < 1.0 - CAP_SHARE).then(|| between(&found, place, frame.flat(vertex)));
        local.flatten()
    };
    Ok(inner
        .vertices()
        .par_iter()
        .map(|&vertex| at(vertex))
        .collect())
}

/// The contour with the greatest area, wound against the clock.
fn largest(contours: impl Iterator<Item = Vec<Point2>>) -> Option<Vec<Point2>> {
    let area = |contour: &Vec<Point2>| area_and_centroid(contour).map_or(0.0, |(area, _)| area);
    let mut best = contours.max_by(|a, b| area(a).abs().total_cmp(&area(b).abs()))?;
    let signed = area(&best);
    if signed < 0.0 {
        // Counter-clockwise, so that outward is always to the right of the way round.
        best.reverse();
    }
    (signed != 0.0).then_some(best)
}

fn slice_of(inner: &[Point2], outer: &[Point2], chords: usize) -> Option<Slice> {
    let (_, centre) = area_and_centroid(inner)?;
    let mut longest = 0.0_f64;
    let mut line = Vec::with_capacity(chords);
    for step in 0..chords {
        let (sin, cos) = (TAU * step as f64 / chords as f64).sin_cos();
        let direction = Vector2::new(cos, sin);
        // The last crossing: a papillary muscle may cross the ray before the wall does.
        let last = |contour| crossings(contour, centre, direction).fold(0.0, f64::max);
        let [near, far] = [last(inner), last(outer)];
        if near > 0.0 && far > near {
            longest = longest.max(LONGEST * (far - near));
            line.push(centre + direction * (0.5 * (near + far)));
        }
    }
    // A centre line from less than half of the rays would be a guess.
    if 2 * line.len() < chords {
        return None;
    }
    let mut found = Vec::new();
    for _ in 0..ROUNDS {
        // Middles of chords bunch where the wall bends; even steps keep the next directions steady.
        line = resampled(&line, chords);
        found = across(&line, inner, outer, longest);
        let middles: Vec<Point2> = (found.iter())
            .map(|(foot, chord)| foot + 0.5 * chord)
            .collect();
        if 2 * middles.len() < chords {
            return None;
        }
        line = middles;
    }
    Some(Slice {
        feet: found.iter().map(|(foot, _)| *foot).collect(),
        lengths: found.iter().map(|(_, chord)| chord.norm()).collect(),
    })
}

/// Chords across a closed line, wound against the clock: foot on the inner contour, and the way from
/// there to the outer one. Chords that miss a contour are left out.
fn across(
    line: &[Point2],
    inner: &[Point2],
    outer: &[Point2],
    longest: f64,
) -> Vec<(Point2, Vector2)> {
    let count = line.len();
    (0..count)
        .filter_map(|i| {
            // Central difference: one-sided ones would tilt every chord the same way.
            let along = line[(i + 1) % count] - line[(i + count - 1) % count];
            let outward = Vector2::new(along.y, -along.x).try_normalize(0.0)?;
            let nearest = |contour| {
                crossings(contour, line[i], outward)
                    // Beyond that a chord has missed its wall and hit the opposite one.
                    .filter(|way| way.abs() <= longest)
                    .min_by(|a, b| a.abs().total_cmp(&b.abs()))
            };
            let (near, far) = (nearest(inner)?, nearest(outer)?);
            (far > near && far - near <= longest)
                .then(|| (line[i] + outward * near, outward * (far - near)))
        })
        .collect()
}

/// Linear between the slices below and above a place, counted in slices from the first one's middle; that
/// of one slice up to half a slice beyond the last that says something.
fn between(slices: &[Option<Slice>], place: f64, point: Point2) -> Option<f64> {
    let at = |slice: f64| {
        let slice = (slice >= 0.0).then(|| slices.get(slice as usize)?.as_ref())??;
        let (side, share) = nearest_place(&slice.feet, point)?;
        let next = (side + 1) % slice.lengths.len();
        Some(slice.lengths[side] * (1.0 - share) + slice.lengths[next] * share)
    };
    let low = place.floor();
    let part = place - low;
    match (at(low), at(low + 1.0)) {
        (Some(a), Some(b)) => Some(a * (1.0 - part) + b * part),
        // At the ends the nearer slice alone, but no extrapolation past half a slab.
        (Some(a), None) if part <= 0.5 => Some(a),
        (None, Some(b)) if part >= 0.5 => Some(b),
        _ => None,
    }
}
