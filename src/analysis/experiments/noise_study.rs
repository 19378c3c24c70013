//! How many deformations are still classified when their meshes are noisy (section 3.4.4).

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::classification::{k_means, tau};
use crate::progress::Progress;
use crate::study::Study;

use super::noise_params::{Condition, Draw};
use super::noise_result::{NoiseCell, NoiseDeformationResult};
use super::{
    ExperimentError, Method, Motion, Noise, NoiseDeformationParams, SyntheticParams, noisy_study,
    synthetic_cohort,
};

/// Runs the study: for each kind of object, redraw, condition and method, the whole pipeline of the
/// program (size, alignment, distances of poses, their plane, curves in time, the LLE plane), k-means
/// with as many clusters as classes, and τ with the best matching of clusters to classes.
///
/// The same bits for any number of threads.
///
/// # Errors
/// If settings are out of range, it was stopped, or a map cannot be computed.
pub fn noise_deformation(
    params: &NoiseDeformationParams,
    progress: &Progress,
) -> Result<NoiseDeformationResult, ExperimentError> {
    params.check()?;
    let conditions = params.conditions();
    let tasks: Vec<[usize; 3]> = (0..params.objects.len())
        .flat_map(|object| (0..usize::from(params.redraws)).map(move |redraw| [object, redraw]))
        .flat_map(|[object, redraw]| (0..conditions.len()).map(move |c| [object, redraw, c]))
        .collect();
    progress.expect_steps(tasks.len() * params.methods.len());
    let draws: Vec<Vec<Draw>> = tasks
        .par_iter()
        .map(|&[object, redraw, condition]| {
            one_draw(params, object, redraw, &conditions[condition], progress)
        })
        .collect::<Result<_, ExperimentError>>()?;
    let mut cells = Vec::new();
    for (method, _) in params.methods.iter().enumerate() {
        for (c, condition) in conditions.iter().enumerate() {
            let of_redraw = |object: usize, redraw: usize| {
                let task = (object * usize::from(params.redraws) + redraw) * conditions.len() + c;
                draws[task][method]
            };
            cells.push(NoiseCell::new(params, method, condition, of_redraw));
        }
    }
    Ok(NoiseDeformationResult {
        params: params.clone(),
        cells,
    })
}

/// One draw through all methods, so that all see the same data.
fn one_draw(
    params: &NoiseDeformationParams,
    object: usize,
    redraw: usize,
    condition: &Condition,
    progress: &Progress,
) -> Result<Vec<Draw>, ExperimentError> {
    let seed = params.seed.wrapping_add(redraw as u64);
    let cohort = synthetic_cohort(&SyntheticParams {
        object: params.objects[object],
        seed,
        ..params.cohort
    })?;
    let mut study = cohort.study()?;
    if let &Condition::Noisy {
        family,
        percent,
        reference,
    } = condition
    {
        let noise = Noise {
            family,
            percent,
            reference,
            // Another stream of numbers than that of the objects.
            seed: seed ^ 0x6e6f_6973_6500_0000,
        };
        study = noisy_study(&study, &noise)?;
    }
    let labels: Vec<Option<usize>> = cohort.labels().into_iter().map(Some).collect();
    (params.methods.iter())
        .map(|method| {
            progress.step()?;
            classified(params, &study, &labels, method, seed, &progress.within())
        })
        .collect()
}

/// τ of a study by one method, of all of its deformations.
pub(super) fn classified(
    params: &NoiseDeformationParams,
    study: &Study,
    labels: &[Option<usize>],
    method: &Method,
    seed: u64,
    progress: &Progress,
) -> Result<Draw, ExperimentError> {
    let whole = method.curves_compared(study, params.map, &params.deformations, progress)?;
    // Rows are the subjects that could be compared, in their order.
    let labels: Vec<Option<usize>> = whole.subjects.iter().map(|&s| labels[s]).collect();
    let clusters = k_means(
        &whole.plane.coordinates,
        whole.plane.dimensions,
        // As many clusters as classes, or τ could not reach 1.
        Motion::ALL.len(),
        usize::from(params.restarts),
        seed,
        progress,
    )?;
    // Deformations that a method cannot compare count as wrong.
    let share = |correct: usize| correct as f64 / study.subjects.len().max(1) as f64;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut permuted = labels.clone();
    let mut sum = 0.0;
    for _ in 0..params.permutations {
        permuted.shuffle(&mut random);
        sum += share(tau(&clusters.clusters, &permuted).correct);
    }
    Ok(Draw {
        tau: share(tau(&clusters.clusters, &labels).correct),
        baseline: sum / f64::from(params.permutations),
    })
}
