//! What all poses of a wall share, found once.

use super::connectivity::Connectivity;
use super::error::MedialError;
use super::face_tree::{FacesOfPose, TreePlan};
use super::orientation::{Opposite, distance_across, thickness_of_closed, turn_into_muscle};
use super::roughness::{Roughness, steady_normals};
use crate::analysis::measures::UnknownVolume;
use crate::mesh::{Point3, TriMesh, face_normals};

/// Vertices of all surfaces, one after the other.
pub(super) fn joined_points(meshes: &[&TriMesh]) -> Vec<Point3> {
    meshes
        .iter()
        .flat_map(|mesh| mesh.vertices())
        .copied()
        .collect()
}

/// What all frames of a wall share: connectivity, sides, the plan of the tree, and of which vertices there are atoms.
#[derive(Clone, Debug)]
pub(super) struct WallAtlas {
    pub connectivity: Connectivity,
    pub opposite: Opposite,
    pub tree: TreePlan,
    pub roughness: Roughness,
    /// Vertices of which there are atoms.
    pub probes: Vec<u32>,
    /// Places in `probes`, so that neighbours mostly follow each other.
    pub order: Vec<u32>,
    /// Whether probes lie on both sides, so that each atom must be told which of its spokes is the inner one.
    pub both_sides: bool,
}

impl WallAtlas {
    /// Prepares a wall by all its frames.
    ///
    /// # Errors
    /// If a surface has no area at frame 0, or a wall without another side is open.
    pub fn new(
        frames: &[Vec<&TriMesh>],
        probes: Vec<u32>,
        both_sides: bool,
    ) -> Result<Self, MedialError> {
        let mut connectivity = Connectivity::new(frames)?;
        let first = frames.first().map_or(&[][..], Vec::as_slice);
        for (surface, mesh) in first.iter().enumerate() {
            if crate::mesh::area(mesh.vertices(), mesh.triangles()) <= 0.0 {
                return Err(MedialError::NoArea {
                    frame: 0,
                    surface,
                    faces: mesh.triangles().len(),
                });
            }
        }
        let points = joined_points(first);
        // Before anything reads a normal: files wind their faces either way.
        let opposite = turn_into_muscle(&mut connectivity, &points);
        if opposite.is_none() && connectivity.boundary.contains(&true) {
            let loops = first.iter().map(|m| m.faces().boundary_loops().len()).sum();
            return Err(UnknownVolume::OpenWall { loops }.into());
        }
        // Neither needs the other.
        let ((tree, order), roughness) = rayon::join(
            || {
                let tree = TreePlan::new(&points, &connectivity.triangles);
                let order = probe_order(&connectivity, &tree, &probes);
                (tree, order)
            },
            || Roughness::new(&connectivity),
        );
        Ok(Self {
            roughness,
            connectivity,
            opposite,
            tree,
            probes,
            order,
            both_sides,
        })
    }

    /// About how thick the wall is at a pose, in coordinates.
    pub fn thickness(&self, points: &[Point3]) -> f64 {
        let Some(sides) = self.opposite else {
            // One closed sheet has no other side to measure to: 2 V / A needs normals that noise has not turned.
            let normals = steady_normals(&self.connectivity, points);
            return thickness_of_closed(&self.connectivity, points, &normals);
        };
        let normals = face_normals(points, &self.connectivity.triangles);
        let faces = FacesOfPose {
            points,
            triangles: &self.connectivity.triangles,
            normals: &normals,
        };
        let tree = self.tree.around(faces);
        distance_across(&self.connectivity, sides, &tree, points)
    }

    /// The vertex that stands for a probe.
    pub fn vertex(&self, probe: usize) -> u32 {
        self.connectivity.representative[self.probes[probe] as usize]
    }
}

/// Places of probes in the order in which the tree holds their faces; those without a face last.
fn probe_order(connectivity: &Connectivity, tree: &TreePlan, probes: &[u32]) -> Vec<u32> {
    let mut rank = vec![u32::MAX; connectivity.vertex_count()];
    let mut next = 0;
    for &face in tree.order() {
        for vertex in connectivity.triangles[face as usize] {
            let rank = &mut rank[vertex as usize];
            if *rank == u32::MAX {
                *rank = next;
                next += 1;
            }
        }
    }
    let mut order: Vec<u32> = (0..probes.len() as u32).collect();
    // Spheres of neighbours have nearly the same radius and face: each is the next one's first guess.
    order.sort_by_key(|&probe| {
        rank[connectivity.representative[probes[probe as usize] as usize] as usize]
    });
    order
}
