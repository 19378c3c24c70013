//! One subject over the beat: surfaces in correspondence over frames.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::mesh::{FaceOrder, Faces, Point3, TriMesh};

/// Which sheet of the subject a surface is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SurfaceKind {
    /// The wall's inner sheet, open or closed at the base.
    Endocardium,
    /// The wall's outer sheet.
    Epicardium,
    /// The whole wall as one surface, inner and outer side joined.
    Wall,
    /// The blood pool alone; counts as endocardium for volumes.
    Cavity,
    /// A surface that is not said to be part of a subject.
    Other,
}

impl SurfaceKind {
    /// The word used on screen and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Endocardium => "endocardium",
            Self::Epicardium => "epicardium",
            Self::Wall => "wall",
            Self::Cavity => "cavity",
            Self::Other => "surface",
        }
    }
}

/// One surface at every frame, on one connectivity.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSequence {
    kind: SurfaceKind,
    frames: Vec<TriMesh>,
}

/// Why frames do not make a sequence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SequenceError {
    /// There is nothing to show.
    #[error("the sequence has no frames")]
    NoFrames,
    /// There is no surface.
    #[error("the sequence has no surfaces")]
    NoSurfaces,
    /// A frame's connectivity is not frame 0's.
    #[error(
        "frame {frame} has {vertices} vertices and {faces} faces, not connected as frame 0, \
         which has {first_vertices} and {first_faces}"
    )]
    TopologyChanges {
        /// The first frame that differs.
        frame: usize,
        /// Its number of vertices.
        vertices: usize,
        /// Its number of faces.
        faces: usize,
        /// Vertices of frame 0.
        first_vertices: usize,
        /// Faces of frame 0.
        first_faces: usize,
    },
    /// Two surfaces were read for a different number of frames.
    #[error("{kind} has {frames} frames, but {first_kind} has {first_frames}")]
    FrameCounts {
        /// The word for the second surface.
        kind: &'static str,
        /// Its frames.
        frames: usize,
        /// The word for the first surface.
        first_kind: &'static str,
        /// Frames of the first surface.
        first_frames: usize,
    },
    /// One kind of surface stands twice.
    #[error("the sequence has two surfaces that are {kind}")]
    RepeatedKind {
        /// The word for the surface.
        kind: &'static str,
    },
}

impl SurfaceSequence {
    /// Joins frames of equal connectivity; afterwards all share frame 0's [`Faces`]. A frame may list the same
    /// faces in another way: [`FaceListing`](super::checks::FaceListing) tells it.
    ///
    /// # Errors
    /// If there is no frame, or one whose connectivity is not frame 0's.
    pub fn new(kind: SurfaceKind, frames: Vec<TriMesh>) -> Result<Self, SequenceError> {
        let Some(first) = frames.first() else {
            return Err(SequenceError::NoFrames);
        };
        let faces = Arc::clone(first.faces());
        let mut shared = Vec::with_capacity(frames.len());
        for (frame, mesh) in frames.into_iter().enumerate() {
            let differs = || SequenceError::TopologyChanges {
                frame,
                vertices: mesh.vertices().len(),
                faces: mesh.triangles().len(),
                first_vertices: faces.vertex_count(),
                first_faces: faces.triangles().len(),
            };
            // Vertices correspond by their numbers, whichever way a file lists the faces.
            if !Arc::ptr_eq(mesh.faces(), &faces)
                && !FaceOrder::of(&faces, mesh.faces()).is_same_surface()
            {
                return Err(differs());
            }
            let mesh =
                TriMesh::new(mesh.shared_vertices(), Arc::clone(&faces)).map_err(|_| differs())?;
            shared.push(mesh);
        }
        Ok(Self {
            kind,
            frames: shared,
        })
    }

    /// Which sheet this is.
    pub fn kind(&self) -> SurfaceKind {
        self.kind
    }

    /// The mesh at each frame; at least one.
    pub fn frames(&self) -> &[TriMesh] {
        &self.frames
    }

    /// The connectivity that all frames share.
    pub fn faces(&self) -> &Arc<Faces> {
        self.frames[0].faces()
    }
}

/// Identifies connectivity: sequences with equal keys have corresponding vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CorrespondenceKey(u64);

/// Names one sequence in this run of the program: clones share it, no two that were made do. So
/// whatever was computed of a sequence is found again when only what is said of the subject changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SequenceId(u64);

static NEXT_SEQUENCE: AtomicU64 = AtomicU64::new(0);

/// All surfaces of one subject, with as many frames each; at least one surface and one frame.
#[derive(Clone, Debug)]
pub struct MeshSequence {
    surfaces: Vec<SurfaceSequence>,
    correspondence: CorrespondenceKey,
    id: SequenceId,
}

impl PartialEq for MeshSequence {
    /// Whether the surfaces are equal, whoever made them.
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id || self.surfaces == other.surfaces
    }
}

impl MeshSequence {
    /// Joins surfaces, sorted by kind.
    ///
    /// # Errors
    /// If there is none, one kind stands twice, or frame counts differ.
    pub fn new(mut surfaces: Vec<SurfaceSequence>) -> Result<Self, SequenceError> {
        surfaces.sort_by_key(SurfaceSequence::kind);
        let Some(first) = surfaces.first() else {
            return Err(SequenceError::NoSurfaces);
        };
        for surface in &surfaces {
            if surface.frames.len() != first.frames.len() {
                return Err(SequenceError::FrameCounts {
                    kind: surface.kind.name(),
                    frames: surface.frames.len(),
                    first_kind: first.kind.name(),
                    first_frames: first.frames.len(),
                });
            }
        }
        if let Some(pair) = surfaces
            .windows(2)
            .find(|pair| pair[0].kind == pair[1].kind)
        {
            return Err(SequenceError::RepeatedKind {
                kind: pair[0].kind.name(),
            });
        }
        let mut hasher = DefaultHasher::new();
        for surface in &surfaces {
            surface.kind.hash(&mut hasher);
            surface.faces().vertex_count().hash(&mut hasher);
            surface.faces().in_one_order().hash(&mut hasher);
        }
        Ok(Self {
            surfaces,
            correspondence: CorrespondenceKey(hasher.finish()),
            id: SequenceId(NEXT_SEQUENCE.fetch_add(1, Ordering::Relaxed)),
        })
    }

    /// All coordinates times a factor; the connectivity stays shared.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let surfaces: Option<Vec<SurfaceSequence>> = self
            .surfaces
            .iter()
            .map(|surface| {
                let frames: Option<Vec<TriMesh>> = surface
                    .frames()
                    .iter()
                    .map(|mesh| {
                        let points: Vec<Point3> =
                            mesh.vertices().iter().map(|p| p * factor).collect();
                        TriMesh::new(points, Arc::clone(mesh.faces())).ok()
                    })
                    .collect();
                SurfaceSequence::new(surface.kind(), frames?).ok()
            })
            .collect();
        // Only coordinates near the end of `f64` overflow, and are then no heart's.
        surfaces
            .and_then(|surfaces| Self::new(surfaces).ok())
            .unwrap_or_else(|| self.clone())
    }

    /// The surfaces, sorted by kind.
    pub fn surfaces(&self) -> &[SurfaceSequence] {
        &self.surfaces
    }

    /// The surface of one kind, if the subject has it.
    pub fn surface(&self, kind: SurfaceKind) -> Option<&SurfaceSequence> {
        self.surfaces.iter().find(|surface| surface.kind == kind)
    }

    /// Endocardium and epicardium, if the subject has both.
    pub fn wall_pair(&self) -> Option<[&SurfaceSequence; 2]> {
        let inner = self.surface(SurfaceKind::Endocardium)?;
        Some([inner, self.surface(SurfaceKind::Epicardium)?])
    }

    /// Number of frames, at least one.
    pub fn frame_count(&self) -> usize {
        self.surfaces[0].frames.len()
    }

    /// Vertices of all surfaces together.
    pub fn vertex_count(&self) -> usize {
        self.surfaces.iter().map(|s| s.faces().vertex_count()).sum()
    }

    /// Faces of all surfaces together.
    pub fn face_count(&self) -> usize {
        self.surfaces
            .iter()
            .map(|s| s.faces().triangles().len())
            .sum()
    }

    /// Which sequence this is; equal for clones only.
    pub fn id(&self) -> SequenceId {
        self.id
    }

    /// Equal for subjects whose vertices correspond: the same kinds, counts and faces, in whichever order.
    pub fn correspondence(&self) -> CorrespondenceKey {
        self.correspondence
    }

    /// Connectivity of all surfaces as one, in the order of [`Self::pose`].
    pub fn joined_faces(&self) -> Faces {
        let parts: Vec<&Faces> = self.surfaces.iter().map(|s| &**s.faces()).collect();
        Faces::joined(&parts)
    }

    /// Vertices of all surfaces at one frame, one surface after the other: a point of the
    /// space of poses. `None` past the last frame.
    pub fn pose(&self, frame: usize) -> Option<Vec<Point3>> {
        let mut points = Vec::with_capacity(self.vertex_count());
        for surface in &self.surfaces {
            points.extend_from_slice(surface.frames.get(frame)?.vertices());
        }
        Some(points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    fn surface(kind: SurfaceKind, frames: usize) -> SurfaceSequence {
        SurfaceSequence::new(kind, vec![phantom::sphere(1, 1.0); frames]).unwrap()
    }

    #[test]
    fn frames_of_another_connectivity_are_refused_by_number() {
        let frames = vec![phantom::sphere(1, 1.0), phantom::sphere(2, 1.0)];
        let error = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap_err();
        assert!(error.to_string().starts_with("frame 1 has 162 vertices"));
    }

    #[test]
    fn surfaces_must_have_the_same_number_of_frames() {
        let error = MeshSequence::new(vec![
            surface(SurfaceKind::Epicardium, 3),
            surface(SurfaceKind::Endocardium, 2),
        ])
        .unwrap_err();
        assert_eq!(
            error.to_string(),
            "epicardium has 3 frames, but endocardium has 2"
        );
    }

    #[test]
    fn clones_are_one_sequence_and_equal_ones_made_twice_are_two() {
        let make = || MeshSequence::new(vec![surface(SurfaceKind::Cavity, 2)]).unwrap();
        let (first, second) = (make(), make());
        assert_eq!(first.clone().id(), first.id());
        assert_ne!(first.id(), second.id());
        assert_eq!(first, second);
        let longer = MeshSequence::new(vec![surface(SurfaceKind::Cavity, 3)]).unwrap();
        assert_ne!(first, longer);
    }

    #[test]
    fn a_pose_joins_the_surfaces_in_order_of_kind() {
        let heart = MeshSequence::new(vec![
            surface(SurfaceKind::Epicardium, 2),
            surface(SurfaceKind::Endocardium, 2),
        ])
        .unwrap();
        assert_eq!(heart.surfaces()[0].kind(), SurfaceKind::Endocardium);
        assert_eq!(heart.pose(1).unwrap().len(), 84);
        assert_eq!(heart.joined_faces().vertex_count(), 84);
        assert!(heart.pose(2).is_none());
    }
}
