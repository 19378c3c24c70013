//! Atoms of a subject over its beat.

use std::sync::Arc;

use rayon::prelude::*;

use super::error::MedialError;
use super::params::CheckedMedialParams;
use super::result::{MedialBeat, MedialSurface};
use super::surface::MAX_NOISE;
use super::wall_atlas::{WallAtlas, joined_points};
use crate::analysis::measures::split_wall;
use crate::mesh::{Faces, Point3, TriMesh};
use crate::progress::Progress;
use crate::study::{MeshSequence, Subject, SurfaceKind};

/// Atoms of a subject at every frame, one per vertex of the endocardium, or of the inner side of a closed wall.
///
/// All frames are smoothed over the same length, by the median over frames of their walls' median thickness, so that a
/// ratio of radii compares equally smooth walls. Where the surfaces are rough the length is greater, as far as their noise asks for it.
///
/// # Errors
/// If there is no wall or its inner side cannot be determined, a frame cannot be used, noise leaves hardly any atom, or it was stopped.
pub fn medial_beat(
    subject: &Subject,
    params: &CheckedMedialParams,
    progress: &Progress,
) -> Result<MedialBeat, MedialError> {
    let template = Template::new(&subject.sequence)?;
    let frames: Vec<Vec<&TriMesh>> = (0..subject.sequence.frame_count())
        .map(|frame| meshes_at(&subject.sequence, &template.kinds, frame))
        .collect();
    // One atlas for all frames: connectivity and the order of the tree depend on no pose.
    let atlas = WallAtlas::new(&frames, template.vertices.clone(), false)?;
    progress.expect_steps(frames.len() * (1 + atlas.steps_per_frame()));
    let measured: Vec<(Vec<Point3>, f64)> = (frames.par_iter())
        .map(|meshes| {
            progress.step()?;
            let points = joined_points(meshes);
            let thickness = atlas.thickness(&points);
            Ok((points, thickness))
        })
        .collect::<Result<_, MedialError>>()?;
    let mut thicknesses: Vec<f64> = measured.iter().map(|&(_, thickness)| thickness).collect();
    let middle = thicknesses.len() / 2;
    // The median over frames, so that neither end-diastole nor end-systole alone decides how much is smoothed.
    let typical = *thicknesses.select_nth_unstable_by(middle, f64::total_cmp).1;
    let poses: Vec<&[Point3]> = measured
        .iter()
        .map(|(points, _)| points.as_slice())
        .collect();
    let prepared = atlas.plan(&poses, typical, params, progress)?;
    let frames: Vec<MedialSurface> = (poses.par_iter().enumerate())
        .map(|(frame, points)| atlas.surface(frame, points, &prepared, params, progress))
        .collect::<Result<_, MedialError>>()?;
    let regular: Vec<bool> = (0..template.vertices.len())
        // A ratio needs the atom at all its poses, so that ending once takes it out of the whole beat.
        .map(|atom| frames.iter().all(|frame| frame.end[atom].is_none()))
        .collect();
    let lost = regular.iter().filter(|&&regular| !regular).count();
    let (noise, thickness) = (prepared.plan.noise, prepared.thickness);
    // Either alone may be harmless: rough surfaces with all atoms, or a short sheet without noise.
    if noise > MAX_NOISE * thickness && 2 * lost > regular.len() {
        return Err(MedialError::Noise {
            noise,
            thickness,
            lost,
            atoms: regular.len(),
        });
    }
    Ok(MedialBeat {
        surface: template.kinds[0],
        vertices: template.vertices,
        faces: template.faces,
        frames,
        regular,
    })
}

/// Of which vertices there are atoms, and on which surfaces.
struct Template {
    /// Surfaces of the wall, that of the vertices first.
    kinds: Vec<SurfaceKind>,
    vertices: Vec<u32>,
    faces: Arc<Faces>,
}

impl Template {
    fn new(sequence: &MeshSequence) -> Result<Self, MedialError> {
        let has = |kind: &SurfaceKind| sequence.surface(*kind).is_some();
        let inner = [SurfaceKind::Endocardium, SurfaceKind::Cavity]
            .into_iter()
            .find(has);
        if let (Some(kind), true) = (inner, has(&SurfaceKind::Epicardium))
            && let Some(surface) = sequence.surface(kind)
        {
            let faces = Arc::clone(surface.faces());
            return Ok(Self {
                kinds: vec![kind, SurfaceKind::Epicardium],
                vertices: (0..faces.vertex_count() as u32).collect(),
                faces,
            });
        }
        let Some(wall) = sequence.surface(SurfaceKind::Wall) else {
            let found: Vec<&str> = sequence
                .surfaces()
                .iter()
                .map(|s| s.kind().name())
                .collect();
            return Err(MedialError::NoWall {
                found: found.join(" and "),
            });
        };
        let [inner, _] = split_wall(wall)?;
        let members = inner.members().into_iter().zip(0..);
        let vertices: Vec<u32> = members
            .filter_map(|(member, v)| member.then_some(v))
            .collect();
        let place = |v: &u32| vertices.partition_point(|other| other < v) as u32;
        let triangles = inner.faces().triangles().iter();
        let triangles = triangles.map(|t| t.each_ref().map(place));
        Ok(Self {
            kinds: vec![SurfaceKind::Wall],
            faces: Arc::new(Faces::new(vertices.len(), triangles.collect())?),
            vertices,
        })
    }
}

/// The meshes of these surfaces at a frame.
fn meshes_at<'a>(
    sequence: &'a MeshSequence,
    kinds: &[SurfaceKind],
    frame: usize,
) -> Vec<&'a TriMesh> {
    (kinds.iter())
        .filter_map(|&kind| sequence.surface(kind)?.frames().get(frame))
        .collect()
}
