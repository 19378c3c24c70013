//! Landmarks of all surfaces of a subject at all frames: proposed, and moved by hand.

use crate::mesh::Point3;
use crate::progress::Progress;
use crate::study::SurfaceKind;

use super::targets::Targets;
use super::{CorrespondenceError, LANDMARK_COUNT, SurfaceLandmarks};

/// Landmarks of a subject, in the coordinates of its frames. A plain value: what is moved by hand is replaced in it.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectLandmarks {
    /// Each surface with its landmarks at every frame, in the order of [`Targets::kinds`].
    pub surfaces: Vec<(SurfaceKind, Vec<SurfaceLandmarks>)>,
}

impl SubjectLandmarks {
    /// Those of one surface at one frame.
    pub fn at(&self, kind: SurfaceKind, frame: usize) -> Option<&SurfaceLandmarks> {
        let (_, frames) = self.surfaces.iter().find(|(own, _)| *own == kind)?;
        frames.get(frame)
    }

    /// The same with one landmark elsewhere; `None` if there is no such surface, frame or landmark.
    #[must_use]
    pub fn moved(
        &self,
        kind: SurfaceKind,
        frame: usize,
        landmark: usize,
        to: Point3,
    ) -> Option<Self> {
        let mut moved = self.clone();
        let (_, frames) = moved.surfaces.iter_mut().find(|(own, _)| *own == kind)?;
        *frames.get_mut(frame)?.points.get_mut(landmark)? = to;
        Some(moved)
    }

    /// Whether they are those of these targets, all finite.
    pub(super) fn check(&self, targets: &Targets) -> Result<(), CorrespondenceError> {
        let frames = targets.frame_count();
        let kinds = self.surfaces.iter().map(|(kind, _)| *kind);
        let counts = self.surfaces.iter().all(|(_, own)| own.len() == frames);
        if !kinds.eq(targets.kinds()) || !counts {
            return Err(CorrespondenceError::LandmarkCounts {
                given: self.surfaces.first().map_or(0, |(_, own)| own.len()),
                given_surfaces: self.surfaces.len(),
                frames,
                surfaces: targets.surfaces.len(),
            });
        }
        for (kind, own) in &self.surfaces {
            for (frame, landmarks) in own.iter().enumerate() {
                let at = |reason| CorrespondenceError::at(*kind, frame, reason);
                landmarks.check().map_err(at)?;
            }
        }
        Ok(())
    }
}

/// Where the landmarks are by the form of the surfaces: apex and rim by the long axis, the others around it by the septum.
///
/// # Errors
/// If a surface does not go around its axis, or stopped.
pub fn propose_landmarks(
    targets: &Targets,
    progress: &Progress,
) -> Result<SubjectLandmarks, CorrespondenceError> {
    let mut surfaces = Vec::new();
    for surface in &targets.surfaces {
        let mut frames = Vec::with_capacity(surface.frames.len());
        for (frame, (sheet, axis)) in surface.frames.iter().zip(&targets.axes).enumerate() {
            progress.check()?;
            let at = |reason| CorrespondenceError::at(surface.kind, frame, reason);
            frames.push(SurfaceLandmarks::propose(sheet, axis).map_err(at)?);
        }
        surfaces.push((surface.kind, frames));
    }
    Ok(SubjectLandmarks { surfaces })
}

/// The apex stands last.
pub(super) const APEX: usize = LANDMARK_COUNT - 1;
