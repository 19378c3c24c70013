//! Is a surface closed, and if not, where is it open?

use std::collections::HashMap;

use super::words::counted;
use crate::mesh::Point3;
use crate::study::{Notice, SurfaceKind, SurfaceSequence};

/// The rims of a surface.
///
/// Why it matters: volumes are those of closed surfaces. An endocardium or epicardium with one
/// rim is open at the base and is closed there by a cap; a second rim is a hole, and its cap is a guess.
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary {
    /// Vertices of each closed rim, largest first.
    pub loop_sizes: Vec<usize>,
    /// Boundary edges that lie on no closed rim; only where winding is inconsistent.
    pub stray_edges: usize,
    /// Length of the shortest rim over that of the longest, in frame 0.
    pub shortest_share: f64,
    /// Whether every rim lies on another rim, point by point, in frame 0: closed in shape, but cut.
    pub sealed: bool,
}

impl Boundary {
    /// Finds the rims.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let faces = surface.faces();
        let loops = faces.boundary_loops();
        let mut loop_sizes: Vec<usize> = loops.iter().map(Vec::len).collect();
        loop_sizes.sort_unstable_by(|a, b| b.cmp(a));
        let boundary_edges = faces.borders().rims.len();
        let on_loops: usize = loop_sizes.iter().sum();
        let vertices = surface.frames()[0].vertices();
        Self {
            loop_sizes,
            stray_edges: boundary_edges.saturating_sub(on_loops),
            shortest_share: shortest_share(&loops, vertices),
            sealed: sealed(&loops, vertices),
        }
    }

    /// What the load report says.
    pub fn notice(&self, surface: &SurfaceSequence) -> Notice {
        let name = surface.kind().name();
        let is_sheet = matches!(
            surface.kind(),
            SurfaceKind::Endocardium | SurfaceKind::Epicardium
        );
        if self.stray_edges > 0 {
            return Notice::warning(format!(
                "{name}: open along {} that form no closed loop; its volume is unreliable",
                counted(self.stray_edges, "edge", "edges")
            ));
        }
        // A surface that is no part of a subject has no volume that could be wrong.
        let caps = match surface.kind() {
            SurfaceKind::Other => "",
            _ => "; volumes use a flat cap there",
        };
        match (self.loop_sizes.as_slice(), is_sheet) {
            ([], _) => Notice::info(format!("{name}: closed")),
            (rims, _) if self.sealed => Notice::info(format!(
                "{name}: closed in shape, but cut: its {} boundary loops of {} vertices coincide",
                rims.len(),
                listed(rims)
            )),
            ([rim], true) => Notice::info(format!(
                "{name}: open at the base, one boundary loop of {rim} vertices"
            )),
            ([rim], false) => Notice::warning(format!(
                "{name}: not closed, one boundary loop of {rim} vertices{caps}"
            )),
            ([first, second], true) if self.shortest_share >= VALVE => Notice::info(format!(
                "{name}: open in two places, as at mitral and aortic valve: boundary loops of {first} and {second} vertices; volumes use a flat cap in each"
            )),
            (rims, _) => Notice::warning(format!(
                "{name}: open in {} places, boundary loops of {} vertices{caps}",
                rims.len(),
                listed(rims)
            )),
        }
    }
}

/// A second opening of at least this share of the first's length may be the aortic valve beside the
/// mitral valve (rings of some 70 and 100 mm); a hole of missing faces is much shorter.
const VALVE: f64 = 0.3;

fn shortest_share(loops: &[Vec<u32>], vertices: &[Point3]) -> f64 {
    let lengths = loops.iter().map(|ring| {
        let next = ring.iter().cycle().skip(1);
        ring.iter()
            .zip(next)
            .map(|(&a, &b)| (vertices[b as usize] - vertices[a as usize]).norm())
            .sum::<f64>()
    });
    let (shortest, longest) = lengths.fold((f64::INFINITY, 0.0_f64), |(low, high), length| {
        (low.min(length), high.max(length))
    });
    if longest > 0.0 {
        shortest / longest
    } else {
        0.0
    }
}

/// Whether each point of the rims belongs to at least two vertices of them; not for no rims.
fn sealed(loops: &[Vec<u32>], vertices: &[Point3]) -> bool {
    let mut counts: HashMap<[u64; 3], usize> = HashMap::new();
    for &vertex in loops.iter().flatten() {
        let point = vertices[vertex as usize];
        let place = [point.x + 0.0, point.y + 0.0, point.z + 0.0].map(f64::to_bits);
        *counts.entry(place).or_default() += 1;
    }
    !counts.is_empty() && counts.values().all(|&count| count > 1)
}

/// The largest three of some sizes.
fn listed(sizes: &[usize]) -> String {
    let shown: Vec<String> = sizes.iter().take(3).map(ToString::to_string).collect();
    if sizes.len() > 3 {
        format!("{}, …", shown.join(", "))
    } else {
        shown.join(" and ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, TriMesh, phantom};

    fn sequence(kind: SurfaceKind, mesh: TriMesh) -> SurfaceSequence {
        SurfaceSequence::new(kind, vec![mesh]).unwrap()
    }

    #[test]
    fn an_open_endocardium_is_open_at_the_base() {
        let surface = sequence(SurfaceKind::Endocardium, phantom::bowl(1.0, 6, 12));
        assert_eq!(
            Boundary::of(&surface).notice(&surface),
            Notice::info("endocardium: open at the base, one boundary loop of 12 vertices")
        );
    }

    #[test]
    fn an_open_cavity_is_a_warning() {
        let surface = sequence(SurfaceKind::Cavity, phantom::bowl(1.0, 6, 12));
        assert_eq!(
            Boundary::of(&surface).notice(&surface).text,
            "cavity: not closed, one boundary loop of 12 vertices; volumes use a flat cap there"
        );
    }

    /// A band with a wide rim above and a rim of `share` of its length below.
    fn band(share: f64) -> SurfaceSequence {
        let bowl = phantom::bowl(1.0, 6, 12);
        // Without the fan around the pole, whose ring is then drawn to the size asked for.
        let open: Vec<[u32; 3]> = bowl.triangles()[12..].to_vec();
        let mut points = bowl.vertices().to_vec();
        for point in &mut points[1..13] {
            let ring = point.x.hypot(point.y);
            point.x *= share / ring;
            point.y *= share / ring;
        }
        let faces = Faces::new(points.len(), open).unwrap();
        sequence(
            SurfaceKind::Epicardium,
            TriMesh::new(points, faces).unwrap(),
        )
    }

    #[test]
    fn a_hole_is_a_warning() {
        let surface = band(0.1);
        assert_eq!(
            Boundary::of(&surface).notice(&surface),
            Notice::warning(
                "epicardium: open in 2 places, boundary loops of 12 and 12 vertices; volumes use a flat cap there"
            )
        );
    }

    #[test]
    fn a_second_opening_of_a_valves_size_is_a_remark() {
        let surface = band(0.7);
        let found = Boundary::of(&surface);
        assert!((found.shortest_share - 0.7).abs() < 1e-9);
        assert_eq!(
            found.notice(&surface),
            Notice::info(
                "epicardium: open in two places, as at mitral and aortic valve: boundary loops of 12 and 12 vertices; volumes use a flat cap in each"
            )
        );
    }

    #[test]
    fn two_halves_that_touch_along_their_rims_are_closed_in_shape() {
        let lower = phantom::bowl(1.0, 6, 12);
        let upper: Vec<Point3> = lower
            .vertices()
            .iter()
            .map(|p| Point3::new(p.x, p.y, if p.z.abs() < 1e-9 { p.z } else { -p.z }))
            .collect();
        let turned = lower.triangles().iter().map(|&[a, b, c]| [a, c, b]);
        let turned = Faces::new(upper.len(), turned.collect()).unwrap();
        let faces = Faces::joined(&[lower.faces(), &turned]);
        let points = [lower.vertices(), upper.as_slice()].concat();
        let surface = sequence(SurfaceKind::Wall, TriMesh::new(points, faces).unwrap());
        assert_eq!(
            Boundary::of(&surface).notice(&surface),
            Notice::info(
                "wall: closed in shape, but cut: its 2 boundary loops of 12 and 12 vertices coincide"
            )
        );
    }
}
