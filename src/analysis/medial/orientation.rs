//! Turns every sheet so that its normals point into the muscle, and tells about how thick the muscle is.

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::face_tree::{FaceTree, FacesOfPose, Facing};
use crate::mesh::{Point3, Vector3, area, signed_volume};

/// Faces of a sheet that say where the other side is; a majority of these settles it.
const VOTES: usize = 24;

/// A second sheet of this share of the first one's area is its other side; a smaller one is debris.
const LEAST_SHARE: f64 = 0.2;

/// Two ranges of faces between which the muscle lies; of a wall that is one closed sheet there are none.
pub(super) type Opposite = Option<[[u32; 2]; 2]>;

/// Turns sheets so that normals point into the muscle, by the shape at one pose.
///
/// Of two surfaces, or a surface of two large sheets, each looks to the other: a sample of its faces has its nearest
/// vertices of the other side in front. A closed sheet holds the muscle inside.
pub(super) fn turn_into_muscle(connectivity: &mut Connectivity, points: &[Point3]) -> Opposite {
    let opposite = opposite_sides(connectivity, points);
    for sheet in 0..connectivity.sheet_count() {
        let starts = [0, 1].map(|end| connectivity.sheet_starts[sheet + end] as u32);
        let across = opposite.and_then(|sides| {
            let own = |&[from, to]: &[u32; 2]| from <= starts[0] && starts[1] <= to;
            let side = sides.iter().position(own)?;
            Some(sides[1 - side])
        });
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

/// Median distance from the vertices of one side to the other, or of one closed sheet 2 V / A, in coordinates.
pub(super) fn typical_thickness(
    connectivity: &Connectivity,
    opposite: Opposite,
    tree: &FaceTree,
    faces: FacesOfPose<'_>,
) -> f64 {
    let Some([[from, to], across]) = opposite else {
        let area = area(faces.points, faces.triangles);
        return 2.0 * volume(faces.points, faces.triangles).abs() / area.max(f64::MIN_POSITIVE);
    };
    let own = &connectivity.triangles[from as usize..to as usize];
    let mut vertices: Vec<u32> = own.iter().flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let facing = Facing::any(across);
    let mut distances: Vec<f64> = vertices
        .par_chunks(256)
        .flat_map_iter(|chunk| {
            let mut hint = None;
            chunk
                .iter()
                .filter_map(|&vertex| {
                    let point = faces.points[vertex as usize];
                    let found = tree.nearest(faces, point, &facing, f64::INFINITY, hint)?;
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
    sheets.sort_by(|a, b| b.0.total_cmp(&a.0));
    let [(largest, first), (next, second)] = *sheets.get(..2)?.as_array::<2>()?;
    let range = |sheet: usize| [0, 1].map(|end| connectivity.sheet_starts[sheet + end] as u32);
    (next >= LEAST_SHARE * largest).then(|| [range(first), range(second)])
}

/// Positive where the faces have the nearest of the others in front of them.
fn score_towards(points: &[Point3], triangles: &[[u32; 3]], others: &[[u32; 3]]) -> f64 {
    let stride = triangles.len().div_ceil(VOTES).max(1);
    triangles
        .iter()
        .step_by(stride)
        .filter_map(|triangle| {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            let centre = Point3::from((a.coords + b.coords + c.coords) / 3.0);
            let nearest: Vector3 = others
                .iter()
                .map(|other| points[other[0] as usize] - centre)
                .min_by(|p, q| p.norm_squared().total_cmp(&q.norm_squared()))?;
            let length = nearest.norm().max(f64::MIN_POSITIVE);
            Some((b - a).cross(&(c - a)).dot(&nearest) / length)
        })
        .sum()
}

/// Volume enclosed by triangles, about one of their vertices.
fn volume(points: &[Point3], triangles: &[[u32; 3]]) -> f64 {
    let Some(first) = triangles.first() else {
        return 0.0;
    };
    let corners = triangles.iter().map(|t| t.map(|v| points[v as usize]));
    signed_volume(corners, points[first[0] as usize])
}
