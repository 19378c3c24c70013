//! The surfaces of a subject that a template is laid onto, frame by frame.

use rayon::prelude::*;

use crate::analysis::measures::split_wall;
use crate::mesh::{Faces, TriMesh, Vector3, face_normals};
use crate::progress::Progress;
use crate::study::{Anatomy, Notice, SurfaceKind, SurfaceSequence};

use super::axis::VentricleAxis;
use super::cut::Opening;
use super::septum::best_turn;
use super::surface_frames::{SurfaceFrames, TargetFrames};
use super::target_surface::TargetSurface;
use super::{CorrespondenceError, TargetError, Template};

/// What a template is laid onto: one open sheet for each surface and frame.
#[derive(Clone, Debug)]
pub struct Targets {
    /// Those that the template has, in its order.
    pub(super) surfaces: Vec<TargetFrames>,
    /// Where the ventricle lies at each frame.
    pub(super) axes: Vec<VentricleAxis>,
    /// Whether the septum was said; it is turned to where the template fits best otherwise.
    pub(super) knows_septum: bool,
    /// What was found and assumed.
    pub(super) notices: Vec<Notice>,
}

impl Targets {
    /// Looks at all frames. Of the blood pool (`Cavity`), and of a surface that is not said to be any, the surface is taken for
    /// the endocardium; of a wall in one surface its two sides. What is closed is opened at the base that `anatomy` names, or at
    /// its wider end.
    ///
    /// # Errors
    /// If there is no surface that the template has, numbers of frames differ, or a frame shows no ventricle.
    pub fn new(
        template: &Template,
        surfaces: &[SurfaceFrames],
        anatomy: Option<&Anatomy>,
        progress: &Progress,
    ) -> Result<Self, CorrespondenceError> {
        let mut notices = Vec::new();
        let chosen = chosen(template, surfaces, &mut notices, progress)?;
        let Some(first) = chosen.first() else {
            return Err(CorrespondenceError::NoSurface);
        };
        let frames = first.frames.len();
        if let Some(other) = chosen.iter().find(|s| s.frames.len() != frames) {
            return Err(CorrespondenceError::FrameCounts {
                kind: other.kind.name(),
                frames: other.frames.len(),
                first_kind: first.kind.name(),
                first_frames: frames,
            });
        }
        if frames == 0 {
            return Err(CorrespondenceError::NoSurface);
        }
        let mut targets = Vec::new();
        for surface in &chosen {
            let sheets = (surface.frames.par_iter().enumerate()).map(|(frame, mesh)| {
                progress.check()?;
                TargetSurface::new(mesh)
                    .map_err(|reason| CorrespondenceError::at(surface.kind, frame, reason))
            });
            targets.push(TargetFrames {
                kind: surface.kind,
                frames: sheets.collect::<Result<_, CorrespondenceError>>()?,
            });
        }
        open_all(&mut targets, anatomy)?;
        let mut axes = axes(&targets, anatomy)?;
        if anatomy.is_none() {
            turn(template, &targets, &mut axes, &mut notices);
        }
        for surface in &targets {
            notices.extend(notes_of(surface).into_iter().map(Notice::info));
        }
        Ok(Self {
            surfaces: targets,
            axes,
            knows_septum: anatomy.is_some(),
            notices,
        })
    }

    /// How many frames there are, at least one.
    pub fn frame_count(&self) -> usize {
        self.axes.len()
    }

    /// The surfaces that the template is laid onto.
    pub fn kinds(&self) -> impl Iterator<Item = SurfaceKind> {
        self.surfaces.iter().map(|surface| surface.kind)
    }
}

/// The surfaces that the template has, in its order.
fn chosen(
    template: &Template,
    surfaces: &[SurfaceFrames],
    notices: &mut Vec<Notice>,
    progress: &Progress,
) -> Result<Vec<SurfaceFrames>, CorrespondenceError> {
    let of = |kind| surfaces.iter().find(|surface| surface.kind == kind);
    let mut inner = of(SurfaceKind::Endocardium)
        .or(of(SurfaceKind::Cavity))
        .cloned();
    let mut outer = of(SurfaceKind::Epicardium).cloned();
    if let (Some(wall), true) = (of(SurfaceKind::Wall), inner.is_none() || outer.is_none()) {
        let [inside, outside] = sides(wall, progress)?;
        notices.push(Notice::info(
            "the wall in one surface was split into its two sides",
        ));
        inner = inner.or(Some(inside));
        outer = outer.or(Some(outside));
    }
    if let (None, None, Some(other)) = (&inner, &outer, of(SurfaceKind::Other)) {
        notices.push(Notice::warning(
            "nothing says which surface it is: it was taken for the endocardium",
        ));
        inner = Some(other.clone());
    }
    let named = |kind, surface: Option<SurfaceFrames>| {
        let surface = surface.filter(|_| template.surface(kind).is_some());
        surface.map(|surface| SurfaceFrames { kind, ..surface })
    };
    let inner = named(SurfaceKind::Endocardium, inner);
    Ok(inner
        .into_iter()
        .chain(named(SurfaceKind::Epicardium, outer))
        .collect())
}

/// Cosine beyond which a face of the outer side of a wall looks out of the base: it is part of the ring between both rims.
const RING: f64 = 0.6;

/// The two sides of a wall at each frame.
fn sides(
    wall: &SurfaceFrames,
    progress: &Progress,
) -> Result<[SurfaceFrames; 2], CorrespondenceError> {
    let split = (wall.frames.par_iter().enumerate()).map(|(frame, mesh)| {
        progress.check()?;
        let at = |reason: String| {
            CorrespondenceError::at(SurfaceKind::Wall, frame, TargetError::Wall(reason))
        };
        let alone = SurfaceSequence::new(SurfaceKind::Wall, vec![mesh.clone()])?;
        let both = split_wall(&alone).map_err(|error| at(error.to_string()))?;
        let [inner, outer] = both.each_ref().map(|side| side.mesh(0));
        let [Some(inner), Some(outer)] = [inner, outer] else {
            return Err(at("it has no faces".to_owned()));
        };
        let outer = without_ring(&inner, outer).map_err(|reason| at(reason.to_string()))?;
        Ok([inner, outer])
    });
    let split: Vec<[TriMesh; 2]> = split.collect::<Result<_, CorrespondenceError>>()?;
    let (inner, outer) = split
        .into_iter()
        .map(|[inner, outer]| (inner, outer))
        .unzip();
    Ok([inner, outer].map(|frames| SurfaceFrames {
        kind: SurfaceKind::Wall,
        frames,
    }))
}

/// The outer side of a wall up to its edge at the base: without the ring that joins it with the inner side.
fn without_ring(inner: &TriMesh, outer: TriMesh) -> Result<TriMesh, TargetError> {
    let sheet = TargetSurface::new(inner)?;
    if sheet.rim().is_empty() {
        return Ok(outer);
    }
    let axis = VentricleAxis::found(&sheet, &sheet, None)?;
    let normals = face_normals(outer.vertices(), outer.triangles());
    let depth = |t: &[u32; 3]| {
        let mean = t.iter().map(|&v| axis.depth(&outer.vertices()[v as usize]));
        mean.sum::<f64>() / 3.0
    };
    let deepest = axis.depth(&axis.apex_of(&sheet));
    let is_ring = |triangle: &[u32; 3], normal: &Vector3| {
        depth(triangle) < 0.25 * deepest && axis.down.dot(normal).abs() > RING
    };
    let kept = (outer.triangles().iter().zip(&normals)).filter(|(t, n)| !is_ring(t, n));
    let faces = Faces::new(outer.vertices().len(), kept.map(|(t, _)| *t).collect())?;
    Ok(TriMesh::new(outer.shared_vertices(), faces)?)
}

/// Opens what is closed; where the base is, is known at the first frame and holds for all.
fn open_all(
    targets: &mut [TargetFrames],
    anatomy: Option<&Anatomy>,
) -> Result<(), CorrespondenceError> {
    for surface in targets {
        let mut opening = None;
        for (frame, sheet) in surface.frames.iter_mut().enumerate() {
            if !sheet.rim().is_empty() {
                continue;
            }
            let at = |reason| CorrespondenceError::at(surface.kind, frame, reason);
            let here = match (opening, anatomy) {
                (Some(known), _) => known,
                (None, Some(a)) => Opening::marked(sheet, a.base, a.apex).map_err(at)?,
                (None, None) => Opening::found(sheet).map_err(at)?,
            };
            *sheet = here.cut(sheet).map_err(at)?;
            opening = Some(here);
        }
    }
    Ok(())
}

/// Where the ventricle lies at each frame; the septum is as near to where it was as it can be.
fn axes(
    targets: &[TargetFrames],
    anatomy: Option<&Anatomy>,
) -> Result<Vec<VentricleAxis>, CorrespondenceError> {
    let [Some(opening), Some(tip)] = [targets.first(), targets.last()] else {
        return Err(CorrespondenceError::NoSurface);
    };
    let mut towards = anatomy.map(|anatomy| anatomy.septal);
    let mut axes = Vec::with_capacity(opening.frames.len());
    for (frame, (opened, tipped)) in opening.frames.iter().zip(&tip.frames).enumerate() {
        let axis = VentricleAxis::found(opened, tipped, towards)
            .map_err(|reason| CorrespondenceError::at(opening.kind, frame, reason))?;
        // What the file says stays; what was assumed is carried on.
        towards = towards.or(Some(axis.septal));
        axes.push(axis);
    }
    Ok(axes)
}

/// Turns the septum to where the template fits best at the first frame, the same way at all frames.
fn turn(
    template: &Template,
    targets: &[TargetFrames],
    axes: &mut [VentricleAxis],
    notices: &mut Vec<Notice>,
) {
    let Some(first) = axes.first() else {
        return;
    };
    let angle = best_turn(template, targets, first);
    for axis in axes {
        *axis = axis.turned(angle);
    }
    notices.push(Notice::warning(format!(
        "nothing says where the septum is: {} was turned around the long axis to where it fits best, which may be anywhere of a round ventricle",
        template.name()
    )));
}

/// What was done to the frames of one surface, each once with its frames.
fn notes_of(surface: &TargetFrames) -> Vec<String> {
    let mut found: Vec<(&str, usize)> = Vec::new();
    for note in surface.frames.iter().flat_map(|sheet| &sheet.notes) {
        match found.iter_mut().find(|(known, _)| known == note) {
            Some((_, count)) => *count += 1,
            None => found.push((note, 1)),
        }
    }
    let count = surface.frames.len();
    let text = |(note, frames): (&str, usize)| match frames == count {
        true => format!("{}: {note}", surface.kind.name()),
        false => format!(
            "{}, {frames} of {count} frames: {note}",
            surface.kind.name()
        ),
    };
    found.into_iter().map(text).collect()
}
