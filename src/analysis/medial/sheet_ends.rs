//! Where the medial surface ends, and the third spoke of its atoms there.

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::face_tree::Facing;
use super::params::CheckedMedialParams;
use super::result::{Atom, EndSpoke};
use super::spheres::{Fit, MedialSphere, WallOfPose};
use super::wall_atlas::WallAtlas;
use crate::mesh::{Point3, Vector3, face_normals};

/// Half length of S₀ + S₁ below which it gives no direction: spokes within 6° of opposite.
const MIN_BEND: f64 = 0.05;

/// Longest third spoke in radii, where 1/cos θ is no limit.
const MAX_ETA: f64 = 10.0;

/// Distance to the surface, in radii, at which a third spoke has come to it.
const AT_SURFACE: f64 = 1e-3;

/// Steps along a third spoke; each goes as far as no face can be.
const MAX_MARCHES: usize = 32;

impl MedialSphere {
    /// Whether it is held by the side across.
    pub(super) fn touches(&self) -> bool {
        matches!(self.fit, Fit::Touches | Fit::TouchesBoundary)
    }
}

/// The third spoke of every atom at which the sheet ends: at the template's own open boundary, where the sphere touches
/// the other side's, leaks or has no room, and where the angle between the spokes is small or the surface has a crease, as on a rim.
pub(super) fn end_spokes(
    wall: &WallOfPose<'_>,
    atlas: &WallAtlas,
    spheres: &[MedialSphere],
    atoms: &[Atom],
    normals: &[Vector3],
    params: &CheckedMedialParams,
) -> Vec<Option<EndSpoke>> {
    let cos_end = params.end_rad.cos();
    let creased = creased(&atlas.connectivity, wall.faces.points, wall.cos_separation);
    let ends: Vec<usize> = (0..atoms.len())
        .filter(|&probe| {
            wall.boundary[atlas.vertex(probe) as usize]
                || creased[atlas.vertex(probe) as usize]
                || spheres[probe].fit != Fit::Touches
                || spheres[probe].cos_separation > cos_end
        })
        .collect();
    let mut spokes = vec![None; atoms.len()];
    // Nothing ends, so that no neighbours need be looked up.
    if ends.is_empty() {
        return spokes;
    }
    let mut position_of: Vec<Option<Point3>> = vec![None; atlas.connectivity.vertex_count()];
    for (probe, atom) in atoms.iter().enumerate() {
        position_of[atlas.vertex(probe) as usize] = Some(atom.position);
    }
    let found: Vec<EndSpoke> = (ends.par_iter())
        .map(|&probe| {
            let atom = &atoms[probe];
            let away = away_from_neighbours(atlas, &position_of, probe, atom.position);
            end_spoke(wall, atom, normals[probe], away)
        })
        .collect();
    for (probe, spoke) in ends.into_iter().zip(found) {
        spokes[probe] = Some(spoke);
    }
    spokes
}

/// Whether vertices lie on an edge whose faces' normals are farther apart than the angle of this cosine.
fn creased(connectivity: &Connectivity, points: &[Point3], cos_max_angle: f64) -> Vec<bool> {
    let normals = face_normals(points, &connectivity.triangles);
    let mut first_face = vec![u32::MAX; connectivity.rows.neighbours.len()];
    let mut creased = vec![false; connectivity.vertex_count()];
    for (face, (triangle, sides)) in
        (connectivity.triangles.iter().zip(&connectivity.rows.sides)).enumerate()
    {
        for (k, [there, back]) in sides.iter().enumerate() {
            let first = &mut first_face[*there.min(back) as usize];
            if *first == u32::MAX {
                *first = face as u32;
            } else if normals[*first as usize].dot(&normals[face]) < cos_max_angle
                && normals[*first as usize] != Vector3::zeros()
                && normals[face] != Vector3::zeros()
            {
                creased[triangle[k] as usize] = true;
                creased[triangle[(k + 1) % 3] as usize] = true;
            }
        }
    }
    creased
}

/// Sum of the directions from the neighbouring atoms.
fn away_from_neighbours(
    atlas: &WallAtlas,
    position_of: &[Option<Point3>],
    probe: usize,
    position: Point3,
) -> Vector3 {
    let rows = &atlas.connectivity.rows;
    rows.neighbours[rows.of(atlas.vertex(probe) as usize)]
        .iter()
        .filter_map(|&other| Some(position - position_of[other as usize]?))
        .sum()
}

/// b halves the angle between the spokes; where they are opposite, it leads in the sheet away from the neighbours.
/// η is how far the surface is along b, in radii.
fn end_spoke(wall: &WallOfPose<'_>, atom: &Atom, normal: Vector3, away: Vector3) -> EndSpoke {
    let half = 0.5 * (atom.spokes[0] + atom.spokes[1]);
    let cos = half.norm();
    // Opposite spokes have no half-way direction; the sheet then ends away from where its atoms are.
    let in_sheet = away - normal.dot(&away) * normal;
    let direction = if cos > MIN_BEND {
        half / cos
    } else {
        let any = || {
            let axis = Vector3::ith(normal.iamin(), 1.0);
            (axis - normal.dot(&axis) * normal).normalize()
        };
        in_sheet.try_normalize(0.0).unwrap_or_else(any)
    };
    // Rounding may leave the half sum of equal spokes a little longer than they are.
    let most = (1.0 / cos.clamp(1.0 / MAX_ETA, 1.0)).max(1.0);
    EndSpoke {
        direction,
        eta: marched(wall, atom, direction, most)
            .unwrap_or(1.0)
            .clamp(1.0, most),
    }
}

/// Distance to the surface along a direction in radii, if it is met within `most`.
fn marched(wall: &WallOfPose<'_>, atom: &Atom, direction: Vector3, most: f64) -> Option<f64> {
    if atom.radius <= 0.0 {
        return None;
    }
    let facing = Facing::any(None);
    let mut along = 0.0;
    for _ in 0..MAX_MARCHES {
        let point = atom.position + along * atom.radius * direction;
        let found = wall.tree.nearest(point, &facing, f64::INFINITY, None)?;
        let step = found.squared.sqrt() / atom.radius;
        // No face is nearer than this, so that the step cannot pass through the surface (sphere tracing).
        along += step;
        if step <= AT_SURFACE {
            return Some(along);
        }
        if along > most {
            return None;
        }
    }
    Some(along)
}
