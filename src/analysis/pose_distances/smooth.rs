//! A study whose surfaces have lost what is finer than a radius.

use std::collections::HashMap;
use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::metrics::Smoother;
use crate::mesh::{Faces, TriMesh};
use crate::numeric::in_waves;
use crate::progress::{Progress, Stopped};
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

/// The study with every surface at every frame smoothed by itself, see [`Smoother`]; the study as it is
/// for radius 0. Surfaces that cannot be smoothed stay as they are.
///
/// # Errors
/// If stopped; the flag is heard once per frame.
pub fn smoothed_study(study: &Study, radius: f64, progress: &Progress) -> Result<Study, Stopped> {
    if radius <= 0.0 {
        return Ok(study.clone());
    }
    let mut smoothers: HashMap<usize, Smoother> = HashMap::new();
    let mut known: Vec<(Arc<Faces>, Smoother)> = Vec::new();
    for surface in (study.subjects.iter()).flat_map(|subject| subject.sequence.surfaces()) {
        progress.check()?;
        let faces = surface.faces();
        if smoothers.contains_key(&address(faces)) {
            continue;
        }
        // Meshes read from separate files have equal faces that are not shared; factorising is dear.
        let made = known.iter().find(|(other, _)| **other == **faces);
        let smoother = match made {
            Some((_, smoother)) => Some(smoother.clone()),
            None => Smoother::new(faces, radius).ok(),
        };
        if let Some(smoother) = smoother {
            known.push((Arc::clone(faces), smoother.clone()));
            smoothers.insert(address(faces), smoother);
        }
    }
    let smoothed = |subject: &Arc<Subject>| -> Result<Arc<Subject>, Stopped> {
        let sequence = smoothed_sequence(&subject.sequence, &smoothers, progress)?;
        Ok(match sequence {
            Some(sequence) => Arc::new(Subject {
                sequence,
                ..(**subject).clone()
            }),
            None => Arc::clone(subject),
        })
    };
    let subjects = in_waves(&study.subjects, 1, |wave| {
        wave.par_iter().map(smoothed).collect()
    })?;
    Ok(Study {
        subjects,
        ..study.clone()
    })
}

/// `None` where the smoothed surfaces make no sequence.
fn smoothed_sequence(
    sequence: &MeshSequence,
    smoothers: &HashMap<usize, Smoother>,
    progress: &Progress,
) -> Result<Option<MeshSequence>, Stopped> {
    let mut surfaces = Vec::with_capacity(sequence.surfaces().len());
    for surface in sequence.surfaces() {
        let smoother = smoothers.get(&address(surface.faces()));
        let mut frames = Vec::with_capacity(surface.frames().len());
        for mesh in surface.frames() {
            progress.check()?;
            let smoothed = smoother.and_then(|smoother| {
                let points = smoother.smoothed(mesh.vertices());
                TriMesh::new(points, Arc::clone(surface.faces())).ok()
            });
            // A surface that cannot be smoothed still has distances, only noisier ones.
            frames.push(smoothed.unwrap_or_else(|| mesh.clone()));
        }
        match SurfaceSequence::new(surface.kind(), frames) {
            Ok(surface) => surfaces.push(surface),
            Err(_) => return Ok(None),
        }
    }
    Ok(MeshSequence::new(surfaces).ok())
}

/// Names faces while somebody holds them.
fn address(faces: &Arc<Faces>) -> usize {
    Arc::as_ptr(faces) as usize
}
