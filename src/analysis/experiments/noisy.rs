//! Any study with noise on every vertex.

use std::sync::Arc;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::mesh::{Point3, TriMesh};
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

use super::ExperimentError;
use super::noise::{NoiseFamily, NoiseReference, noise_sigma};

/// Noise on every vertex, coordinate and pose, independent of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Its distribution.
    pub family: NoiseFamily,
    /// Its variance in percent of `reference`.
    pub percent: f64,
    /// What that is a share of.
    pub reference: NoiseReference,
    /// Of the draw.
    pub seed: u64,
}

/// The study with noise on all surfaces of all subjects; each subject's noise depends on the seed and its
/// place in the study alone. Variances are those of all surfaces of a subject together, at rest at
/// end-diastole as stated, else frame 0. 0 % gives the study as it is.
///
/// # Errors
/// If a level is not a share, or a coordinate leaves the range of numbers.
pub fn noisy_study(study: &Study, noise: &Noise) -> Result<Study, ExperimentError> {
    if !(noise.percent.is_finite() && noise.percent >= 0.0) {
        return Err(ExperimentError::Level {
            percent: noise.percent,
        });
    }
    // Without noise not even round-off may differ.
    if noise.percent == 0.0 {
        return Ok(study.clone());
    }
    let subjects = (study.subjects.iter().enumerate())
        .map(|(index, subject)| {
            Ok(Arc::new(Subject {
                sequence: noisy_sequence(subject, noise, index)?,
                ..(**subject).clone()
            }))
        })
        .collect::<Result<_, ExperimentError>>()?;
    Ok(Study {
        subjects,
        ..study.clone()
    })
}

fn noisy_sequence(
    subject: &Subject,
    noise: &Noise,
    index: usize,
) -> Result<MeshSequence, ExperimentError> {
    let sequence = &subject.sequence;
    let count = sequence.frame_count();
    // Levels relative to displacement count from here.
    let begin = subject.start_frame();
    let from_rest: Vec<Vec<Point3>> = (0..count)
        .filter_map(|step| sequence.pose((begin + step) % count))
        .collect();
    // One level for all frames: noise of a measurement does not follow the cycle.
    let sigma = noise_sigma(&from_rest, noise.percent, noise.reference);
    let mut random = ChaCha8Rng::seed_from_u64(noise.seed);
    // A stream per subject: leaving one out changes no noise of the others.
    random.set_stream(index as u64);
    let surfaces = (sequence.surfaces().iter())
        .map(|surface| {
            let frames = (surface.frames().iter())
                .map(|mesh| {
                    let points = noise.family.added(mesh.vertices(), sigma, &mut random);
                    TriMesh::new(points, Arc::clone(surface.faces()))
                })
                .collect::<Result<Vec<_>, _>>()?;
            Ok(SurfaceSequence::new(surface.kind(), frames)?)
        })
        .collect::<Result<Vec<_>, ExperimentError>>()?;
    Ok(MeshSequence::new(surfaces)?)
}
