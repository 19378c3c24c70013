//! The surface that is laid onto all others.

use std::sync::Arc;

use crate::mesh::{Faces, TriMesh};
use crate::study::{Anatomy, Subject, SurfaceKind};

use super::axis::VentricleAxis;
use super::surface_frames::SurfaceFrames;
use super::target_surface::TargetSurface;
use super::{CorrespondenceError, SurfaceLandmarks, TargetError};

/// Endocardium, epicardium or both at one instant, open at the base, with their landmarks.
#[derive(Clone, Debug)]
pub struct Template {
    pub(super) name: String,
    pub(super) surfaces: Vec<TemplateSurface>,
    pub(super) axis: VentricleAxis,
    /// Whether somebody said where the septum is.
    pub(super) knows_septum: bool,
}

/// One surface of it.
#[derive(Clone, Debug)]
pub(super) struct TemplateSurface {
    pub kind: SurfaceKind,
    pub mesh: TriMesh,
    pub landmarks: SurfaceLandmarks,
}

impl Template {
    /// A subject at the frame at which it starts.
    ///
    /// # Errors
    /// If it has neither an endocardium nor an epicardium, or one of them is closed, no single sheet, or shows no axis.
    pub fn of_subject(subject: &Subject) -> Result<Self, CorrespondenceError> {
        let frame = subject.start_frame();
        let surfaces = subject.sequence.surfaces().iter().map(|surface| {
            let frames = surface.frames().get(frame).cloned();
            SurfaceFrames {
                kind: surface.kind(),
                frames: frames.into_iter().collect(),
            }
        });
        Self::new(&subject.id, surfaces.collect(), subject.anatomy.as_ref())
    }

    /// Of meshes, one for each surface; all other kinds than endocardium and epicardium are left out.
    ///
    /// # Errors
    /// As [`Self::of_subject`].
    pub fn new(
        name: &str,
        surfaces: Vec<SurfaceFrames>,
        anatomy: Option<&Anatomy>,
    ) -> Result<Self, CorrespondenceError> {
        let is_part = |kind| matches!(kind, SurfaceKind::Endocardium | SurfaceKind::Epicardium);
        let meshes: Vec<(SurfaceKind, TriMesh)> = (surfaces.into_iter())
            .filter(|surface| is_part(surface.kind))
            .filter_map(|surface| Some((surface.kind, surface.frames.into_iter().next()?)))
            .collect();
        let mut targets = Vec::new();
        for (kind, mesh) in &meshes {
            let wrong = |reason| CorrespondenceError::Template {
                surface: kind.name(),
                reason,
            };
            let target = TargetSurface::new(mesh).map_err(wrong)?;
            if target.rim().is_empty() {
                return Err(wrong(TargetError::NoAxis));
            }
            targets.push(target);
        }
        let [Some(opening), Some(tip)] = [targets.first(), targets.last()] else {
            return Err(CorrespondenceError::NoTemplate);
        };
        let axis = VentricleAxis::found(opening, tip, anatomy.map(|a| a.septal));
        let axis = axis.map_err(|reason| CorrespondenceError::Template {
            surface: meshes[0].0.name(),
            reason,
        })?;
        let mut made = Vec::new();
        for ((kind, mesh), target) in meshes.into_iter().zip(&targets) {
            let landmarks = SurfaceLandmarks::propose(target, &axis);
            let landmarks = landmarks.map_err(|reason| CorrespondenceError::Template {
                surface: kind.name(),
                reason,
            })?;
            made.push(TemplateSurface {
                kind,
                mesh,
                landmarks,
            });
        }
        Ok(Self {
            name: name.to_owned(),
            surfaces: made,
            axis,
            knows_septum: anatomy.is_some(),
        })
    }

    /// What it is called: the id of its subject.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The kinds of its surfaces with their faces, which all that is made with it has.
    pub fn surfaces(&self) -> impl Iterator<Item = (SurfaceKind, &Arc<Faces>)> {
        self.surfaces.iter().map(|s| (s.kind, s.mesh.faces()))
    }

    /// The landmarks of one of its surfaces.
    pub fn landmarks(&self, kind: SurfaceKind) -> Option<&SurfaceLandmarks> {
        self.surface(kind).map(|surface| &surface.landmarks)
    }

    pub(super) fn surface(&self, kind: SurfaceKind) -> Option<&TemplateSurface> {
        self.surfaces.iter().find(|surface| surface.kind == kind)
    }
}
