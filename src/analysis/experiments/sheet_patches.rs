//! Where on a synthetic medial surface its patches of constant thickness lie.

use std::f64::consts::TAU;

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::mesh::{Point3, Vector3, vertex_areas};

/// Half the width of the border of a patch in radians of the hemisphere: some 3 mm, one or two atoms. Not tuned.
const HALF_BORDER_RAD: f64 = 0.08;
/// And at most this share of the patch's radius, so that a small patch keeps a middle without thickening. Not tuned.
const BORDER_SHARE: f64 = 0.35;
/// Least remote myocardium between two patches, in radians: 10 to 20 mm.
const APART_RAD: f64 = 0.4;
/// Centres that are tried for patches that lie apart.
const TRIES: usize = 100;

/// A round patch on the hemisphere of directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct PatchPlace {
    centre: Vector3,
    radius_rad: f64,
}

impl PatchPlace {
    /// How much a direction belongs to the patch, from 0 to 1: ½ at its radius, even across its border.
    pub fn membership(&self, d: &Vector3) -> f64 {
        // A border as wide as the patch would leave nothing that is fully akinetic.
        let half = HALF_BORDER_RAD.min(BORDER_SHARE * self.radius_rad);
        let inside = self.radius_rad - d.angle(&self.centre);
        (0.5 + 0.5 * inside / half).clamp(0.0, 1.0)
    }

    fn gap_rad(&self, other: &Self) -> f64 {
        self.centre.angle(&other.centre) - self.radius_rad - other.radius_rad
    }
}

/// A patch for each share of the regular area, anywhere, but apart from those before it: the first of some
/// centres that is far enough, or else the farthest.
pub(super) fn patches(
    directions: &[Vector3],
    at_end_diastole: &[Point3],
    triangles: &[[u32; 3]],
    regular: &[bool],
    shares: &[f64],
    random: &mut ChaCha8Rng,
) -> Vec<PatchPlace> {
    let areas = regular_areas(at_end_diastole, triangles, regular);
    let mut places: Vec<PatchPlace> = Vec::new();
    for &share in shares {
        let mut best: Option<(f64, PatchPlace)> = None;
        for _ in 0..TRIES {
            let place = sized(direction(random), share, directions, &areas);
            let gap = (places.iter().map(|other| place.gap_rad(other))).fold(f64::MAX, f64::min);
            // Large patches may have no room to be apart; the widest gap that was drawn is taken then.
            if best.is_none_or(|(least, _)| gap > least) {
                best = Some((gap, place));
            }
            if gap >= APART_RAD {
                break;
            }
        }
        places.extend(best.map(|(_, place)| place));
    }
    places
}

/// The patch around a centre that takes a share of the area.
fn sized(centre: Vector3, share: f64, directions: &[Vector3], areas: &[f64]) -> PatchPlace {
    let mut order: Vec<(f64, f64)> = (directions.iter().zip(areas))
        .filter(|(_, area)| **area > 0.0)
        .map(|(d, &area)| (d.angle(&centre), area))
        .collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    // Of the regular area, since that is what the detection reports shares of.
    let wanted = share * order.iter().map(|(_, area)| area).sum::<f64>();
    let mut within = 0.0;
    let reached = order.iter().find(|(_, area)| {
        within += area;
        within >= wanted
    });
    PatchPlace {
        centre,
        radius_rad: reached.or(order.last()).map_or(0.0, |(angle, _)| *angle),
    }
}

/// A third of the area of the faces around each atom, of faces whose atoms are all regular.
pub(super) fn regular_areas(
    points: &[Point3],
    triangles: &[[u32; 3]],
    regular: &[bool],
) -> Vec<f64> {
    // As the detection does: a face with a vertex that takes no part has no area.
    let counted = |triangle: &&[u32; 3]| triangle.iter().all(|&vertex| regular[vertex as usize]);
    vertex_areas(points, triangles.iter().filter(counted))
}

/// A direction of the lower hemisphere, away from the base, evenly over its area.
fn direction(random: &mut ChaCha8Rng) -> Vector3 {
    // Evenly in height is evenly in area on a sphere; the base is left free of patch centres.
    let z: f64 = random.random_range(-1.0..-0.15);
    let around = random.random_range(0.0..TAU);
    let across = (1.0 - z * z).sqrt();
    Vector3::new(across * around.cos(), across * around.sin(), z)
}
