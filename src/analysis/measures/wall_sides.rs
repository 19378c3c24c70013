//! The inner and the outer side of a subject's wall, whichever surfaces it is given as.

use std::collections::HashSet;
use std::sync::Arc;

use crate::mesh::{Faces, MeshError, Point3, TriMesh};
use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};

use super::volumes::{UnknownVolume, wall_inner_side};

/// One side of a wall: some or all faces of a surface.
#[derive(Clone, Debug)]
pub struct Side<'a> {
    surface: &'a SurfaceSequence,
    faces: Arc<Faces>,
}

impl<'a> Side<'a> {
    /// All of a surface.
    fn whole(surface: &'a SurfaceSequence) -> Self {
        Self {
            surface,
            faces: Arc::clone(surface.faces()),
        }
    }

    /// The surface that it is part of.
    pub fn surface(&self) -> &'a SurfaceSequence {
        self.surface
    }

    /// Its faces, over the vertices of that surface.
    pub fn faces(&self) -> &Arc<Faces> {
        &self.faces
    }

    /// Positions of all vertices of that surface at a frame; none past the last frame.
    pub fn vertices(&self, frame: usize) -> &'a [Point3] {
        self.surface
            .frames()
            .get(frame)
            .map_or(&[], |mesh| mesh.vertices())
    }

    /// This side at a frame; vertices that are not part of it are kept, so that numbers agree.
    /// `None` past the last frame.
    pub fn mesh(&self, frame: usize) -> Option<TriMesh> {
        let mesh = self.surface.frames().get(frame)?;
        TriMesh::new(mesh.shared_vertices(), Arc::clone(&self.faces)).ok()
    }

    /// Whether each vertex of the surface is part of this side.
    pub fn members(&self) -> Vec<bool> {
        let mut members = vec![false; self.faces.vertex_count()];
        for &vertex in self.faces.triangles().iter().flatten() {
            members[vertex as usize] = true;
        }
        members
    }
}

/// Both sides of a wall, as far as there are any.
#[derive(Clone, Debug)]
pub struct WallSides<'a> {
    /// The endocardium, the surface of the cavity, or the side of a wall that looks to its cavity.
    pub inner: Option<Side<'a>>,
    /// The epicardium, or the other side of a wall; of a closed one with the ring at its base.
    pub outer: Option<Side<'a>>,
    /// Why a wall given as one surface was not split; it counts as outer side then.
    pub unsplit: Option<UnknownVolume>,
}

/// The sides of a subject's wall. Which face of a wall is which is known at the first frame.
pub fn wall_sides(sequence: &MeshSequence) -> WallSides<'_> {
    let whole = |kind| sequence.surface(kind).map(Side::whole);
    let mut sides = WallSides {
        // The endocardium where both are given, as for volumes.
        inner: whole(SurfaceKind::Endocardium).or_else(|| whole(SurfaceKind::Cavity)),
        outer: whole(SurfaceKind::Epicardium),
        unsplit: None,
    };
    if let Some(wall) = sequence.surface(SurfaceKind::Wall) {
        match split_wall(wall) {
            Ok([inner, outer]) => {
                sides.inner = sides.inner.or(Some(inner));
                sides.outer = sides.outer.or(Some(outer));
            }
            Err(reason) => {
                // Unsplit it is still outside, which is what the long axis needs of it.
                sides.outer = sides.outer.or_else(|| Some(Side::whole(wall)));
                sides.unsplit = Some(reason);
            }
        }
    }
    sides
}

/// The inner and the outer side of a wall given as one surface, determined at its first frame.
///
/// # Errors
/// If the wall is open, of more than two sheets, or its inner side cannot be determined.
pub fn split_wall(wall: &SurfaceSequence) -> Result<[Side<'_>; 2], UnknownVolume> {
    let inner = wall_inner_side(wall)?.triangles().to_vec();
    // Sheets are oriented anew, so corners may stand in another order than in the file.
    let sorted = |mut triangle: [u32; 3]| {
        triangle.sort_unstable();
        triangle
    };
    let inside: HashSet<[u32; 3]> = inner.iter().map(|&t| sorted(t)).collect();
    let outer = (wall.faces().triangles().iter())
        .filter(|&&triangle| !inside.contains(&sorted(triangle)))
        .copied()
        .collect();
    let side = |triangles| -> Result<Side<'_>, MeshError> {
        Ok(Side {
            surface: wall,
            faces: Arc::new(Faces::new(wall.faces().vertex_count(), triangles)?),
        })
    };
    let broken = |reason| UnknownVolume::Broken {
        kind: wall.kind().name(),
        reason,
    };
    Ok([side(inner).map_err(broken)?, side(outer).map_err(broken)?])
}
