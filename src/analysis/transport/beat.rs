//! The motion of one subject on another.

use std::sync::Arc;

use crate::analysis::alignment::{SizeScale, rigid_motion};
use crate::mesh::{Point3, TriMesh};
use crate::progress::Progress;
use crate::study::{MeshSequence, Subject, SurfaceSequence};

use super::{CheckedTransportParams, TransportAccount, TransportError, transport_deformation};

/// The motion of one subject on another.
#[derive(Clone, Debug, PartialEq)]
pub struct TransportedMotion {
    /// As many frames as the motion has, surfaces of the subject that it was transported onto.
    pub sequence: MeshSequence,
    /// How they were made.
    pub account: TransportAccount,
}

/// The beat of `from` on the subject `onto`, in the coordinates of `onto`: its end-diastolic pose is
/// that of `onto`, the frames are those of `from`.
///
/// Coordinates of each subject are divided by its [`SizeScale`] and `from` is aligned with `onto` by the
/// rigid motion of their end-diastolic poses; the displacements are transported from end-diastole on,
/// through the last frame into the first, and multiplied by the scale of `onto`. End-diastole
/// is the stated frame, else 0.
///
/// # Errors
/// If stopped, vertices do not correspond, an end-diastole is not there or has no size, or squares
/// of lengths overflow.
pub fn transported_motion(
    from: &Subject,
    onto: &Subject,
    params: &CheckedTransportParams,
    progress: &Progress,
) -> Result<TransportedMotion, TransportError> {
    if from.sequence.correspondence() != onto.sequence.correspondence() {
        return Err(TransportError::NoCorrespondence {
            from: from.id.clone(),
            from_vertices: from.sequence.vertex_count(),
            from_faces: from.sequence.face_count(),
            onto: onto.id.clone(),
            onto_vertices: onto.sequence.vertex_count(),
            onto_faces: onto.sequence.face_count(),
        });
    }
    let (source, target) = (Rest::of(from)?, Rest::of(onto)?);
    let beat = source.beat_laid_onto(from, &target.pose);
    let faces = onto.sequence.joined_faces();
    let transported = transport_deformation(&faces, &beat, &target.pose, params, progress)?;
    let restored: Vec<Vec<Point3>> = (transported.poses.iter())
        .map(|pose| pose.iter().map(|p| target.scale.restored(p)).collect())
        .collect();
    let mut frames = in_order_of_frames(restored, source.frame);
    // The own pose itself: scaled down and up again it would differ by rounding.
    if let Some(pose) = onto.sequence.pose(target.frame) {
        frames[source.frame] = pose;
    }
    Ok(TransportedMotion {
        sequence: sequence_like(&onto.sequence, &frames)?,
        account: transported.account,
    })
}

/// A subject at end-diastole, its size normalised.
pub(super) struct Rest {
    pub(super) frame: usize,
    pub(super) scale: SizeScale,
    pub(super) pose: Vec<Point3>,
}

impl Rest {
    fn of(subject: &Subject) -> Result<Self, TransportError> {
        let frame = subject.start_frame();
        let pose = subject.sequence.pose(frame).unwrap_or_default();
        let scale = SizeScale::of_end_diastole(&pose).ok_or_else(|| TransportError::NoSize {
            subject: subject.id.clone(),
            frame,
        })?;
        Ok(Self::new(&pose, frame, scale))
    }

    pub(super) fn new(pose: &[Point3], frame: usize, scale: SizeScale) -> Self {
        Self {
            frame,
            scale,
            pose: pose.iter().map(|p| scale.normalised(p)).collect(),
        }
    }

    /// All poses from end-diastole on, normalised, moved as one by the rigid motion that lays the
    /// first onto `target`.
    pub(super) fn beat_laid_onto(&self, subject: &Subject, target: &[Point3]) -> Vec<Vec<Point3>> {
        // Only an empty or mismatched pose has none, and counts were compared before.
        let Ok(motion) = rigid_motion(&self.pose, target) else {
            return Vec::new();
        };
        let frames = subject.sequence.frame_count();
        (0..frames)
            .filter_map(|step| subject.sequence.pose((self.frame + step) % frames))
            .map(|pose| {
                pose.iter()
                    .map(|p| motion.apply(&self.scale.normalised(p)))
                    .collect()
            })
            .collect()
    }
}

/// Poses that begin with frame `first` of a beat, put in the order of its frames.
pub(super) fn in_order_of_frames(mut poses: Vec<Vec<Point3>>, first: usize) -> Vec<Vec<Point3>> {
    let count = poses.len().max(1);
    // They were transported from end-diastole on; frames of a sequence count from its first.
    poses.rotate_right(first % count);
    poses
}

/// Poses as a sequence with the surfaces of another: vertices of all its surfaces, one surface after the other.
///
/// # Errors
/// If a pose has other vertices than `like`, or one that is not finite.
pub fn sequence_like(
    like: &MeshSequence,
    frames: &[Vec<Point3>],
) -> Result<MeshSequence, TransportError> {
    let mut offset = 0;
    let mut surfaces = Vec::new();
    for surface in like.surfaces() {
        let faces = surface.faces();
        let part = offset..offset + faces.vertex_count();
        offset = part.end;
        let meshes = (frames.iter().enumerate())
            .map(|(pose, points)| {
                let points = points.get(part.clone()).unwrap_or_default().to_vec();
                TriMesh::new(points, Arc::clone(faces)).map_err(|_| TransportError::NotFinite {
                    pose,
                    norm2: f64::NAN,
                })
            })
            .collect::<Result<Vec<_>, _>>()?;
        surfaces.push(SurfaceSequence::new(surface.kind(), meshes)?);
    }
    Ok(MeshSequence::new(surfaces)?)
}
