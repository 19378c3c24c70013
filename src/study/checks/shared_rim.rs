//! Do endocardium and epicardium meet in the same points?

use std::collections::HashSet;

use super::words::counted;
use crate::mesh::TriMesh;
use crate::study::{MeshSequence, Notice};

/// Vertices of the epicardium that lie exactly on vertices of the endocardium.
///
/// Why it matters: where the two sheets share their rim, the epicardium includes the cut through
/// the wall at the base; its area is then more than the outside of the subject, and the wall has no thickness there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SharedRim {
    /// The smallest number of shared points over the frames.
    pub vertices: usize,
}

impl SharedRim {
    /// Counts at each frame, where there are both surfaces.
    pub fn of(sequence: &MeshSequence) -> Self {
        let Some([endo, epi]) = sequence.wall_pair() else {
            return Self::default();
        };
        let vertices = endo
            .frames()
            .iter()
            .zip(epi.frames())
            .map(|(inner, outer)| shared(inner, outer))
            .min()
            .unwrap_or(0);
        Self { vertices }
    }

    /// What the load report says, if points are shared in every frame.
    pub fn notice(&self) -> Option<Notice> {
        (self.vertices > 0).then(|| {
            Notice::info(format!(
                "endocardium and epicardium meet in {}: the epicardium includes a strip through the wall",
                counted(self.vertices, "shared point", "shared points")
            ))
        })
    }
}

fn shared(inner: &TriMesh, outer: &TriMesh) -> usize {
    let place = |p: &crate::mesh::Point3| [p.x + 0.0, p.y + 0.0, p.z + 0.0].map(f64::to_bits);
    let places: HashSet<[u64; 3]> = inner.vertices().iter().map(place).collect();
    outer
        .vertices()
        .iter()
        .filter(|p| places.contains(&place(p)))
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{SurfaceKind, SurfaceSequence};

    #[test]
    fn sheets_with_a_common_rim_are_told_with_its_size() {
        let inner = phantom::bowl(25.0, 6, 12);
        let rim: Vec<usize> = (61..73).collect();
        let mut points: Vec<_> = inner.vertices().iter().map(|p| p * 1.4).collect();
        for &vertex in &rim {
            points[vertex] = inner.vertices()[vertex];
        }
        let outer = TriMesh::new(points, inner.faces().clone()).unwrap();
        let heart = MeshSequence::new(vec![
            SurfaceSequence::new(SurfaceKind::Endocardium, vec![inner]).unwrap(),
            SurfaceSequence::new(SurfaceKind::Epicardium, vec![outer]).unwrap(),
        ])
        .unwrap();
        assert_eq!(
            SharedRim::of(&heart).notice().unwrap().text,
            "endocardium and epicardium meet in 12 shared points: the epicardium includes a strip through the wall"
        );
    }
}
