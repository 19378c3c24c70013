//! Patches on the bull's-eye: closed outlines, a hatch inside and a place for the number, from the faces that are
//! drawn.
//!
//! The border of a patch on the wall may run through atoms that the flat map leaves out, such as those that fold over
//! the rim of the base: drawn as it is, it crosses the disc. Outlines here go around faces of the flat map alone.

use std::collections::BTreeMap;

use crate::mesh::Faces;
use crate::picture::medial::rounded;

/// Distance of the lines of a hatch, in radii of the disc.
const HATCH_STEP: f64 = 0.07;
/// Outlines around less than this share of the disc are single triangles with noise: the hatch shows them.
const MIN_OUTLINE: f64 = 0.003;

/// A line of a hatch: its number, counted from the middle of the disc, and its ends.
type HatchLine = (i32, [[f64; 2]; 2]);

/// One patch in the unit disc, x to the right and y up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolarPatch {
    /// Closed outlines; more than one where the patch has holes or parts that the map leaves apart.
    pub borders: Vec<Vec<[f64; 2]>>,
    /// Parallel lines over the inside, in pieces from edge to edge: number of the line, counted from the middle of the
    /// disc, and ends.
    pub hatch: Vec<(i32, [[f64; 2]; 2])>,
    /// The place inside that is farthest from the outlines; `None` where no face of the map is in the patch.
    pub middle: Option<[f64; 2]>,
}

/// A patch of these atoms on a map with these faces, which turn the same way round.
pub fn polar_patch(points: &[[f64; 2]], faces: &[[u32; 3]], atoms: &[u32]) -> PolarPatch {
    let mut inside = vec![false; points.len()];
    for &atom in atoms {
        if let Some(inside) = inside.get_mut(atom as usize) {
            *inside = true;
        }
    }
    let within = |vertex: &u32| inside.get(*vertex as usize) == Some(&true);
    let faces: Vec<[u32; 3]> = (faces.iter().copied())
        .filter(|face| face.iter().all(within))
        .collect();
    let corners = |face: &[u32; 3]| face.map(|vertex| points[vertex as usize]);
    // Faces of a mesh are faces, so that this never fails.
    let loops = Faces::new(points.len(), faces.clone())
        .map_or_else(|_| Vec::new(), |faces| faces.boundary_loops());
    let on_plot = |border: &Vec<u32>| -> Vec<[f64; 2]> {
        border.iter().map(|&atom| points[atom as usize]).collect()
    };
    let outlines: Vec<Vec<[f64; 2]>> = loops.iter().map(on_plot).collect();
    let smooth: Vec<Vec<[f64; 2]>> = outlines.iter().map(|outline| rounded(outline)).collect();
    let mut borders: Vec<Vec<[f64; 2]>> = (outlines.iter().zip(&smooth))
        .filter(|(outline, _)| enclosed_area(outline) >= MIN_OUTLINE * std::f64::consts::PI)
        .map(|(_, smooth)| smooth.clone())
        .collect();
    if borders.is_empty() {
        let largest = outlines
            .iter()
            .max_by(|a, b| enclosed_area(a).total_cmp(&enclosed_area(b)));
        borders.extend(largest.map(|outline| rounded(outline)));
    }
    PolarPatch {
        middle: middle(faces.iter().map(corners), &outlines),
        hatch: hatch(&smooth),
        borders,
    }
}

fn enclosed_area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let sum: f64 = (outline.iter().zip(next))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    0.5 * sum.abs()
}

/// The centre of a face that is farthest from all corners of the outlines.
fn middle(
    faces: impl Iterator<Item = [[f64; 2]; 3]>,
    outlines: &[Vec<[f64; 2]>],
) -> Option<[f64; 2]> {
    let room = |at: [f64; 2]| {
        let corners = outlines.iter().flatten();
        corners
            .map(|corner| (corner[0] - at[0]).hypot(corner[1] - at[1]))
            .fold(f64::INFINITY, f64::min)
    };
    let centres = faces.map(|[a, b, c]| [0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0));
    let roomy = centres.map(|at| (room(at), at));
    let widest = roomy.max_by(|a, b| a.0.total_cmp(&b.0));
    widest.map(|(_, at)| at)
}

/// Lines up to the right, `HATCH_STEP` from each other, over what closed outlines enclose; holes are left out.
fn hatch(outlines: &[Vec<[f64; 2]>]) -> Vec<HatchLine> {
    let across = |at: [f64; 2]| (at[1] - at[0]) * std::f64::consts::FRAC_1_SQRT_2 / HATCH_STEP;
    let along = |at: [f64; 2]| at[0] + at[1];
    let mut crossings: BTreeMap<i32, Vec<[f64; 2]>> = BTreeMap::new();
    for outline in outlines {
        for (from, to) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let (a, b) = (across(*from), across(*to));
            if !(a.is_finite() && b.is_finite()) {
                return Vec::new();
            }
            // Half open: a line through a corner meets one of its two sides.
            for line in a.min(b).ceil() as i32..=a.max(b).floor() as i32 {
                let depth = f64::from(line);
                if (a <= depth) != (b <= depth) {
                    let share = (depth - a) / (b - a);
                    let at = [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
                    crossings.entry(line).or_default().push(at);
                }
            }
        }
    }
    let pieces = crossings.into_iter().flat_map(|(line, mut crossings)| {
        crossings.sort_by(|a, b| along(*a).total_cmp(&along(*b)));
        let pairs = crossings.chunks_exact(2);
        pairs
            .map(|ends| (line, [ends[0], ends[1]]))
            .collect::<Vec<_>>()
    });
    pieces.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of points at each radius, with faces between neighbouring rings.
    fn rings(radii: &[f64], around: usize) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
        let mut points = Vec::new();
        for radius in radii {
            for step in 0..around {
                let (sin, cos) = (std::f64::consts::TAU * step as f64 / around as f64).sin_cos();
                points.push([radius * cos, radius * sin]);
            }
        }
        let mut faces = Vec::new();
        for ring in 1..radii.len() {
            for step in 0..around {
                let at = |ring: usize, step: usize| (ring * around + step % around) as u32;
                let [a, b] = [at(ring - 1, step), at(ring - 1, step + 1)];
                let [c, d] = [at(ring, step), at(ring, step + 1)];
                faces.extend([[a, c, d], [a, d, b]]);
            }
        }
        (points, faces)
    }

    fn longest_side(border: &[[f64; 2]]) -> f64 {
        let sides = border.iter().zip(border.iter().cycle().skip(1));
        sides
            .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
            .fold(0.0, f64::max)
    }

    #[test]
    fn no_line_crosses_the_disc_where_the_patch_has_atoms_that_the_map_leaves_out() {
        let (mut points, faces) = rings(&[0.3, 0.5, 0.7, 0.9], 24);
        // The left side of the two outer rings, and an atom far away that no face of the map reaches.
        let mut atoms: Vec<u32> = (24..96)
            .filter(|atom| (9..16).contains(&(atom % 24)))
            .collect();
        points.push([0.95, 0.05]);
        atoms.push(96);
        let patch = polar_patch(&points, &faces, &atoms);
        assert_eq!(patch.borders.len(), 1);
        assert!(longest_side(&patch.borders[0]) < 0.3);
        assert!(patch.borders[0].iter().all(|corner| corner[0] < 0.1));
        assert_eq!(patch.borders[0].first(), patch.borders[0].last(), "closed");
    }

    #[test]
    fn hatch_and_number_lie_inside_the_patch() {
        let (points, faces) = rings(&[0.3, 0.5, 0.7, 0.9], 24);
        let atoms: Vec<u32> = (0..96)
            .filter(|atom| (9..16).contains(&(atom % 24)))
            .collect();
        let patch = polar_patch(&points, &faces, &atoms);
        let inside = |at: [f64; 2]| at[0] < 0.0 && (0.28..0.92).contains(&at[0].hypot(at[1]));
        assert!(patch.middle.is_some_and(inside));
        let lines: std::collections::HashSet<i32> =
            patch.hatch.iter().map(|(line, _)| *line).collect();
        assert!(lines.len() > 8, "{lines:?}");
        // A line leaves this patch once or twice; it crosses many more faces.
        assert!(patch.hatch.len() <= 3 * lines.len(), "{:?}", patch.hatch);
        assert!(
            patch
                .hatch
                .iter()
                .flat_map(|(_, ends)| ends)
                .all(|end| inside(*end))
        );
    }

    #[test]
    fn a_hole_of_one_vertex_has_no_outline_and_a_patch_of_one_face_keeps_its_own() {
        let (points, faces) = rings(&[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9], 96);
        let hole = 96 + 48;
        let atoms: Vec<u32> = (0..points.len() as u32)
            .filter(|atom| (30..66).contains(&(atom % 96)) && *atom != hole)
            .collect();
        assert_eq!(polar_patch(&points, &faces, &atoms).borders.len(), 1);
        let single = polar_patch(&points, &faces, &faces[0]);
        assert_eq!(single.borders.len(), 1);
        assert_eq!(polar_patch(&points, &faces, &[]), PolarPatch::default());
    }
}
