//! A template laid onto all frames of a subject.

use rayon::prelude::*;

use crate::mesh::{Point3, TriMesh};
use crate::progress::Progress;
use crate::study::{Anatomy, MeshSequence, Notice, SurfaceSequence};

use super::carrying::Carrier;
use super::subject_landmarks::APEX;
use super::surface_frames::TargetFrames;
use super::target_surface::TargetSurface;
use super::targets::Targets;
use super::template::{Template, TemplateSurface};
use super::{
    CheckedCorrespondenceParams, CorrespondenceError, FrameFit, SubjectLandmarks, SurfaceLandmarks,
};

/// A subject in correspondence with a template.
#[derive(Clone, Debug)]
pub struct Corresponding {
    /// The template's surfaces on those of the subject, with its faces.
    pub sequence: MeshSequence,
    /// Where apex, base and septum lie at the first frame; only where the septum was said.
    pub anatomy: Option<Anatomy>,
    /// How each surface lies at each frame, surface by surface.
    pub fits: Vec<FrameFit>,
    /// What was found and assumed.
    pub notices: Vec<Notice>,
}

/// Lays the template onto the first frame and carries it on from frame to frame.
///
/// Each step: a thin-plate spline brings the landmarks of the surface (the template, then the frame before) onto `landmarks`,
/// with smoothing; moves to the nearest places, smoothed over the surface less and less, bring it onto the frame, the rim onto
/// the rim; faces that fold over are relaxed; what chords cut off from the volume is made up for.
///
/// # Errors
/// If landmarks are those of other frames or give no map, a frame fits worse than it may, or stopped.
pub fn correspond(
    template: &Template,
    targets: &Targets,
    landmarks: &SubjectLandmarks,
    params: &CheckedCorrespondenceParams,
    progress: &Progress,
) -> Result<Corresponding, CorrespondenceError> {
    landmarks.check(targets)?;
    progress.expect_steps(targets.surfaces.len() * targets.frame_count());
    let of_template = |target: &TargetFrames| {
        let surface = template.surface(target.kind);
        surface.ok_or(CorrespondenceError::NoSurface)
    };
    let carried = (targets.surfaces.par_iter())
        .zip(&landmarks.surfaces)
        .map(|(target, (_, own))| carried(of_template(target)?, target, own, params, progress));
    let carried: Vec<(SurfaceSequence, Vec<FrameFit>)> =
        carried.collect::<Result<_, CorrespondenceError>>()?;
    let (surfaces, fits): (Vec<_>, Vec<_>) = carried.into_iter().unzip();
    Ok(Corresponding {
        sequence: MeshSequence::new(surfaces)?,
        anatomy: anatomy(template, targets, landmarks),
        fits: fits.into_iter().flatten().collect(),
        notices: targets.notices.clone(),
    })
}

/// One surface at all frames.
fn carried(
    template: &TemplateSurface,
    target: &TargetFrames,
    landmarks: &[SurfaceLandmarks],
    params: &CheckedCorrespondenceParams,
    progress: &Progress,
) -> Result<(SurfaceSequence, Vec<FrameFit>), CorrespondenceError> {
    let (kind, params) = (target.kind, params.0);
    let faces = template.mesh.faces();
    let carrier = Carrier::new(template.mesh.vertices(), faces);
    let carrier = carrier.map_err(|reason| CorrespondenceError::Template {
        surface: kind.name(),
        reason,
    })?;
    let mut points: Vec<Point3> = template.mesh.vertices().to_vec();
    let mut from = &template.landmarks;
    let mut frames = Vec::with_capacity(landmarks.len());
    let mut fits = Vec::with_capacity(landmarks.len());
    for (frame, (sheet, onto)) in target.frames.iter().zip(landmarks).enumerate() {
        let step = |points: &[Point3], sheet: &TargetSurface| {
            let points = carrier.carry(points, [from, onto], sheet, params.smoothing, progress)?;
            let fit = FrameFit::of((kind, frame), &carrier, &points, sheet, progress)?;
            fit.check(&params, sheet, faces.triangles().len())?;
            Ok((TriMesh::new(points.as_slice(), faces.clone())?, points, fit))
        };
        let done = step(&points, sheet);
        let (mesh, carried, fit) =
            done.map_err(|reason| CorrespondenceError::at(kind, frame, reason))?;
        points = carried;
        from = onto;
        frames.push(mesh);
        fits.push(fit);
        progress.step()?;
    }
    Ok((SurfaceSequence::new(kind, frames)?, fits))
}

/// Where the ventricle lies at the first frame.
fn anatomy(
    template: &Template,
    targets: &Targets,
    landmarks: &SubjectLandmarks,
) -> Option<Anatomy> {
    let axis = targets.axes.first()?;
    let (_, outermost) = landmarks.surfaces.last()?;
    let said = targets.knows_septum && template.knows_septum;
    said.then(|| Anatomy {
        apex: outermost[0].points[APEX],
        base: axis.base,
        septal: axis.septal,
        anterior: axis.anterior,
    })
}
