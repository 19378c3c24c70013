//! Turns every sheet so that its normals point into the myocardium, and tells about how thick the myocardium is.

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::face_tree::{FaceTree, Facing};
use crate::mesh::{Point3, Vector3, area, signed_volume};

/// Faces of a sheet that say where the other side is; a majority of these settles it.
const VOTES: usize = 24;

/// A second sheet of this share of the first one's area is its other side; a smaller one is debris.
const MIN_SHARE: f64 = 0.2;

/// Vertices that tell about how thick a wall is. The wall's thickness differs by a fifth from place to place, so that the
/// median is about one percent off.
const SAMPLE: usize = 600;

/// The golden ratio's fraction: its multiples fall evenly between 0 and 1, in step with no row of a grid.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Two ranges of faces between which the myocardium lies; of a wall that is one closed sheet there are none.
pub(super) type Opposite = Option<[[u32; 2]; 2]>;

/// Turns sheets so that normals point into the myocardium, by the shape at one pose.
///
/// Of two surfaces, or a surface of two large sheets, each looks to the other: a sample of its faces has its nearest
/// vertices of the other side in front. A closed sheet holds the myocardium inside.
pub(super) fn turn_into_muscle(connectivity: &mut Connectivity, points: &[Point3]) -> Opposite {
    let opposite = opposite_sides(connectivity, points);
    for sheet in 0..connectivity.sheet_count() {
        let starts = [0, 1].map(|end| connectivity.sheet_starts[sheet + end] as u32);
        let across = opposite.and_then(|sides| {
            let own = |&[from, to]: &[u32; 2]| from <= starts[0] && starts[1] <= to;
            let side = sides.iter().position(own)?;
            Some(sides[1 - side])
        });
        // A sheet without a counterpart encloses the myocardium itself, so that its normals point inwards where its
        // volume is negative.
        let triangles = connectivity.sheet(sheet);
        let score = match across {
            Some([from, to]) => {
                let others = &connectivity.triangles[from as usize..to as usize];
                score_towards(points, triangles, others)
            }
            None => -volume(points, triangles),
        };
        if score < 0.0 {
            connectivity.turn(sheet);
        }
    }
    opposite
}

/// Of one closed sheet, about how far its sides are apart: 2 V / A, in coordinates.
///
/// Areas count as they are seen along unit normals of the vertices that noise has turned little, for those of the faces
/// themselves grow with it.
pub(super) fn thickness_of_closed(
    connectivity: &Connectivity,
    points: &[Point3],
    normals: &[Vector3],
) -> f64 {
    let triangles = &connectivity.triangles;
    let seen = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        let steady: Vector3 = triangle.iter().map(|&v| normals[v as usize]).sum();
        let steady = steady.try_normalize(0.0).unwrap_or_default();
        0.5 * (b - a).cross(&(c - a)).dot(&steady).abs()
    };
    let area: f64 = triangles.iter().map(seen).sum();
    2.0 * volume(points, triangles).abs() / area.max(f64::MIN_POSITIVE)
}

/// Median distance from vertices of one side to the other, in coordinates. Of many vertices it is the median of a sample.
pub(super) fn distance_across(
    connectivity: &Connectivity,
    [[from, to], across]: [[u32; 2]; 2],
    tree: &FaceTree<'_>,
    points: &[Point3],
) -> f64 {
    let own = &connectivity.triangles[from as usize..to as usize];
    let mut used = vec![false; points.len()];
    own.iter().flatten().for_each(|&v| used[v as usize] = true);
    let mut vertices: Vec<u32> = (0..)
        .zip(used)
        .filter_map(|(v, used)| used.then_some(v))
        .collect();
    // Past this number the median hardly changes, and time grows with every vertex.
    if vertices.len() > SAMPLE {
        vertices = (0..SAMPLE)
            .map(|k| vertices[((k as f64 * GOLDEN).fract() * vertices.len() as f64) as usize])
            .collect();
        // In order, neighbours mostly follow each other, and each search begins at the face that the one before it
        // found.
        vertices.sort_unstable();
    }
    let facing = Facing::any(Some(across));
    let mut distances: Vec<f64> = vertices
        .par_chunks(64)
        .flat_map_iter(|chunk| {
            let mut hint = None;
            chunk
                .iter()
                .filter_map(|&vertex| {
                    let point = points[vertex as usize];
                    let found = tree.nearest(point, &facing, f64::INFINITY, hint)?;
                    hint = Some(found.face);
                    Some(found.squared.sqrt())
                })
                .collect::<Vec<f64>>()
        })
        .collect();
    let middle = distances.len() / 2;
    if distances.is_empty() {
        return 0.0;
    }
    *distances.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Template against the other surfaces, or the two large sheets of one surface.
fn opposite_sides(connectivity: &Connectivity, points: &[Point3]) -> Opposite {
    let surfaces = &connectivity.sheet_surfaces;
    let faces = connectivity.triangles.len() as u32;
    if let Some(sheet) = surfaces.iter().position(|&surface| surface > 0) {
        let start = connectivity.sheet_starts[sheet] as u32;
        return (start > 0).then_some([[0, start], [start, faces]]);
    }
    let mut sheets: Vec<(f64, usize)> = (0..connectivity.sheet_count())
        .map(|sheet| (area(points, connectivity.sheet(sheet)), sheet))
        .collect();
    // By area, since debris of a segmentation has as many sheets as it likes.
    sheets.sort_by(|a, b| b.0.total_cmp(&a.0));
    let [(largest, first), (next, second)] = *sheets.get(..2)?.as_array::<2>()?;
    let range = |sheet: usize| [0, 1].map(|end| connectivity.sheet_starts[sheet + end] as u32);
    (next >= MIN_SHARE * largest).then(|| [range(first), range(second)])
}

/// Positive where the faces have the nearest of the others in front of them.
fn score_towards(points: &[Point3], triangles: &[[u32; 3]], others: &[[u32; 3]]) -> f64 {
    let stride = triangles.len().div_ceil(VOTES).max(1);
    let sample: Vec<&[u32; 3]> = triangles.iter().step_by(stride).collect();
    let votes: Vec<f64> = (sample.par_iter())
        .map(|triangle| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            let centre = Point3::from((a.coords + b.coords + c.coords) / 3.0);
            let mut least = (f64::INFINITY, Vector3::zeros());
            for other in others {
                let away = points[other[0] as usize] - centre;
                let squared = away.norm_squared();
                if squared < least.0 {
                    least = (squared, away);
                }
            }
            // Divided by the distance, so that a far vertex does not outvote near ones.
            let length = least.0.sqrt().max(f64::MIN_POSITIVE);
            (b - a).cross(&(c - a)).dot(&least.1) / length
        })
        .collect();
    votes.iter().sum()
}

/// Volume enclosed by triangles, about one of their vertices.
fn volume(points: &[Point3], triangles: &[[u32; 3]]) -> f64 {
    let Some(first) = triangles.first() else {
        return 0.0;
    };
    let corners = triangles.iter().map(|t| t.map(|v| points[v as usize]));
    signed_volume(corners, points[first[0] as usize])
}
