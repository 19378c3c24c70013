//! Is a surface closed, and if not, where is it open?

use super::words::counted;
use crate::study::{Notice, SurfaceKind, SurfaceSequence};

/// The rims of a surface.
///
/// Why it matters: volumes are those of closed surfaces. An endocardium or epicardium with one
/// rim is open at the base and is closed there by a cap; a second rim is a hole, and its cap is a guess.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// Vertices of each closed rim, largest first.
    pub loop_sizes: Vec<usize>,
    /// Boundary edges that lie on no closed rim; only where winding is inconsistent.
    pub stray_edges: usize,
}

impl Boundary {
    /// Finds the rims.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let faces = surface.faces();
        let mut loop_sizes: Vec<usize> = faces.boundary_loops().iter().map(Vec::len).collect();
        loop_sizes.sort_unstable_by(|a, b| b.cmp(a));
        let boundary_edges = faces.edge_valences().iter().filter(|(_, n)| *n == 1).count();
        let on_loops: usize = loop_sizes.iter().sum();
        Self {
            loop_sizes,
            stray_edges: boundary_edges.saturating_sub(on_loops),
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
        match (self.loop_sizes.as_slice(), is_sheet) {
            ([], _) => Notice::info(format!("{name}: closed")),
            ([rim], true) => Notice::info(format!(
                "{name}: open at the base, one boundary loop of {rim} vertices"
            )),
            ([rim], false) => Notice::warning(format!(
                "{name}: not closed, one boundary loop of {rim} vertices; volumes use a flat cap there"
            )),
            (rims, _) => Notice::warning(format!(
                "{name}: open in {} places, boundary loops of {} vertices; volumes use a flat cap in each",
                rims.len(),
                listed(rims)
            )),
        }
    }
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

    #[test]
    fn a_second_hole_is_a_warning_and_counted() {
        let bowl = phantom::bowl(1.0, 6, 12);
        // Without the fan around the pole.
        let open: Vec<[u32; 3]> = bowl.triangles()[12..].to_vec();
        let faces = Faces::new(bowl.vertices().len(), open).unwrap();
        let mesh = TriMesh::new(bowl.shared_vertices(), faces).unwrap();
        let surface = sequence(SurfaceKind::Epicardium, mesh);
        assert_eq!(
            Boundary::of(&surface).notice(&surface),
            Notice::warning(
                "epicardium: open in 2 places, boundary loops of 12 and 12 vertices; volumes use a flat cap in each"
            )
        );
    }
}
