//! Triangles over a ventricle: rings of 6, 12, 18 … vertices around the apex, then a staggered tube to the base.
//!
//! Rings that grow by six keep triangles near the apex as round as those of the tube, where a
//! polar grid would have needles.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::mesh::{Faces, MeshError};

/// Half-width and half-length in millimetres of the reference ellipse along which rings are
/// spaced evenly; near the mean of the cohort, so that every subject gets nearly even rings.
const REFERENCE_ELLIPSE_MM: [f64; 2] = [29.0, 68.0];
/// Eccentric angle of the base on the reference ellipse, from the apex: 0.61 π.
const REFERENCE_BASE_RAD: f64 = 1.92;
/// Straight pieces by which the arc length of the reference ellipse is summed; its error is
/// below 1e-5 of the length.
const ARC_PIECES: usize = 256;

/// Place of a vertex on a surface of the wall, the same in every subject, layer and frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPoint {
    /// Share of the eccentric angle from the apex (0) to the base (1).
    pub eccentric_share: f64,
    /// Angle around the long axis from the middle of the septum towards the anterior wall.
    pub around_rad: f64,
}

impl GridPoint {
    /// Share of the long axis from the apex (0) to the base (1) at which the reference ellipse has the vertex.
    pub fn length_share(&self) -> f64 {
        let below = |share: f64| 1.0 - (REFERENCE_BASE_RAD * share).cos();
        below(self.eccentric_share) / below(1.0)
    }
}

/// Vertices of one surface and their triangles, wound so that normals point away from the axis.
#[derive(Clone, Debug)]
pub struct WallGrid {
    /// Places of the vertices, from the apex to the base, ring by ring.
    pub points: Vec<GridPoint>,
    /// The triangles.
    pub faces: Arc<Faces>,
    /// Vertices of the rim, the last ones of `points`.
    pub rim: usize,
}

impl WallGrid {
    /// The finest grid of at most `vertices` vertices, at least 55.
    ///
    /// # Errors
    /// None for a count that fits into memory: the faces refer to the vertices made here.
    pub fn new(vertices: usize) -> Result<Self, MeshError> {
        // The tube is about 2.5 times as long as the cap is deep, so that a grid whose cap has
        // m rings has near 3m² + 2.5m · 6m = 18m² vertices.
        let cap = ((vertices as f64 / 18.0).sqrt() as usize).max(3);
        let around = 6 * cap;
        let in_cap = 1 + 3 * cap * (cap + 1);
        let tube = (vertices.saturating_sub(in_cap) / around).max(1);
        let rings = cap + tube;
        let shares = even_rings(rings);
        let mut points = vec![GridPoint {
            eccentric_share: 0.0,
            around_rad: 0.0,
        }];
        for (ring, &eccentric_share) in shares.iter().enumerate().skip(1) {
            let count = 6 * ring.min(cap);
            let stagger = if ring > cap && (ring - cap) % 2 == 1 {
                0.5
            } else {
                0.0
            };
            points.extend((0..count).map(|step| GridPoint {
                eccentric_share,
                around_rad: TAU * (step as f64 + stagger) / count as f64,
            }));
        }
        let faces = Arc::new(Faces::new(points.len(), triangles(cap, tube))?);
        Ok(Self {
            points,
            faces,
            rim: around,
        })
    }
}

/// Eccentric shares of rings 0 … `rings` at even arc lengths of the reference ellipse.
fn even_rings(rings: usize) -> Vec<f64> {
    let [wide, long] = REFERENCE_ELLIPSE_MM;
    let at = |piece: usize| {
        let angle = REFERENCE_BASE_RAD * piece as f64 / ARC_PIECES as f64;
        [wide * angle.sin(), long * angle.cos()]
    };
    let mut lengths = vec![0.0];
    for piece in 0..ARC_PIECES {
        let ([x0, z0], [x1, z1]) = (at(piece), at(piece + 1));
        lengths.push(lengths[piece] + (x1 - x0).hypot(z1 - z0));
    }
    let whole = lengths[ARC_PIECES];
    (0..=rings)
        .map(|ring| {
            let wanted = whole * ring as f64 / rings as f64;
            let after = lengths
                .partition_point(|&l| l < wanted)
                .clamp(1, ARC_PIECES);
            let part = (wanted - lengths[after - 1]) / (lengths[after] - lengths[after - 1]);
            (after as f64 - 1.0 + part) / ARC_PIECES as f64
        })
        .collect()
}

fn triangles(cap: usize, tube: usize) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for ring in 0..cap {
        cap_ring(ring, &mut triangles);
    }
    let around = 6 * cap;
    let first_of = |ring: usize| 1 + 3 * cap * (cap - 1) + (ring - cap) * around;
    for ring in cap..cap + tube {
        let (inner, outer) = (first_of(ring), first_of(ring + 1));
        let staggered_outside = (ring - cap).is_multiple_of(2);
        for step in 0..around {
            let next = (step + 1) % around;
            let [a, b] = [inner + step, inner + next].map(|v| v as u32);
            let [c, d] = [outer + step, outer + next].map(|v| v as u32);
            if staggered_outside {
                triangles.extend([[a, b, c], [b, d, c]]);
            } else {
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
    }
    triangles
}

/// Joins ring `ring` with the next in each of six sectors, as a hexagonal disc grows.
fn cap_ring(ring: usize, triangles: &mut Vec<[u32; 3]>) {
    let first_of = |ring: usize| {
        if ring == 0 {
            0
        } else {
            1 + 3 * ring * (ring - 1)
        }
    };
    let vertex = |ring: usize, step: usize| {
        let count = (6 * ring).max(1);
        (first_of(ring) + step % count) as u32
    };
    for sector in 0..6 {
        for step in 0..=ring {
            let inner = sector * ring + step;
            let outer = sector * (ring + 1) + step;
            let [a, c, d] = [
                vertex(ring, inner),
                vertex(ring + 1, outer),
                vertex(ring + 1, outer + 1),
            ];
            triangles.push([a, d, c]);
            if step < ring {
                triangles.push([a, vertex(ring, inner + 1), d]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_a_disc_with_one_rim_at_every_resolution() {
        for vertices in [100, 317, 1_250, 5_000, 20_000] {
            let grid = WallGrid::new(vertices).unwrap();
            let count = grid.points.len();
            assert!(count <= vertices && count + grid.rim > vertices, "{count}");
            let edges = grid.faces.edge_valences();
            assert!(edges.iter().all(|&(_, faces)| faces <= 2));
            assert_eq!(count + grid.faces.triangles().len() - edges.len(), 1);
            let loops = grid.faces.boundary_loops();
            assert_eq!(loops.len(), 1);
            let mut rim = loops[0].clone();
            rim.sort_unstable();
            let last: Vec<u32> = (count - grid.rim..count).map(|v| v as u32).collect();
            assert_eq!(rim, last);
        }
    }

    #[test]
    fn rings_climb_from_the_apex_to_the_base() {
        let shares = even_rings(30);
        assert_eq!(shares[0], 0.0);
        assert!((shares[30] - 1.0).abs() < 1e-12);
        assert!(shares.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
