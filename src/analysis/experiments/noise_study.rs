//! How many deformations are still told apart when their meshes are noisy (section 3.4.4).

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::classification::{k_means, tau};
use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::MapMethod;
use crate::progress::Progress;
use crate::study::Study;

use super::noise_result::{NoiseCell, NoiseDeformationResult};
use super::{
    ExperimentError, Method, Motion, Noise, NoiseFamily, NoiseReference, ObjectKind,
    SyntheticParams, noisy_study, synthetic_cohort,
};

/// What is deformed, disturbed and compared, and how often.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseDeformationParams {
    /// Kinds of objects; each is a study of its own, since only equal meshes correspond.
    pub objects: Vec<ObjectKind>,
    /// Deformations of each; its object is replaced by each of `objects` in turn, and its seed by one
    /// of each redraw.
    pub cohort: SyntheticParams,
    /// Distributions of noise.
    pub families: Vec<NoiseFamily>,
    /// Levels in percent; 0 is always run as well.
    pub percents: Vec<f64>,
    /// What levels are shares of; each reading is run.
    pub references: Vec<NoiseReference>,
    /// Draws of objects, amplitudes and noise, all anew.
    pub redraws: u16,
    /// Ways of comparing poses; all see the same data.
    pub methods: Vec<Method>,
    /// How pose distances become a plane.
    pub map: MapMethod,
    /// How curves become a plane.
    pub deformations: DeformationMapParams,
    /// Starts of k-means.
    pub restarts: u16,
    /// Permutations of the labels of each draw, for the baseline.
    pub permutations: u16,
    /// Of everything random.
    pub seed: u64,
}

impl Default for NoiseDeformationParams {
    /// Table 3.1: six kinds of objects of genus 0 and 1 with 0 to 2 boundaries, 60 deformations each, three
    /// families at five levels, ten redraws.
    fn default() -> Self {
        Self {
            objects: ObjectKind::ALL.to_vec(),
            cohort: SyntheticParams::default(),
            families: NoiseFamily::ALL.to_vec(),
            percents: vec![1.0, 2.5, 5.0, 10.0, 20.0],
            references: vec![NoiseReference::Shape, NoiseReference::Displacement],
            redraws: 10,
            methods: vec![
                Method::default_metric(),
                Method::procrustes(),
                Method::printed(),
                Method::default_unsmoothed(),
                Method::procrustes_smoothed(),
            ],
            map: MapMethod::default(),
            deformations: DeformationMapParams::default(),
            restarts: 50,
            permutations: 100,
            seed: 1,
        }
    }
}

impl NoiseDeformationParams {
    fn check(&self) -> Result<(), ExperimentError> {
        for (name, value) in [
            ("objects", self.objects.len()),
            ("families", self.families.len()),
            ("readings of the level", self.references.len()),
            ("methods", self.methods.len()),
            ("redraws", usize::from(self.redraws)),
            ("starts of k-means", usize::from(self.restarts)),
            ("permutations", usize::from(self.permutations)),
        ] {
            if value == 0 {
                return Err(ExperimentError::TooFew {
                    name,
                    value,
                    least: 1,
                });
            }
        }
        let shares = |percent: &&f64| !(percent.is_finite() && **percent > 0.0);
        if let Some(&percent) = self.percents.iter().find(shares) {
            return Err(ExperimentError::Level { percent });
        }
        for method in &self.methods {
            method.distances.check()?;
        }
        self.deformations.check()?;
        Ok(())
    }

    /// Every draw of every condition, the clean one first; in the order of the result.
    fn conditions(&self) -> Vec<Condition> {
        let mut conditions = vec![Condition::Clean];
        for &reference in &self.references {
            for &family in &self.families {
                conditions.extend((self.percents.iter()).map(|&percent| Condition::Noisy {
                    family,
                    percent,
                    reference,
                }));
            }
        }
        conditions
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Condition {
    Clean,
    Noisy {
        family: NoiseFamily,
        percent: f64,
        reference: NoiseReference,
    },
}

/// τ of one draw and that of permuted labels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Draw {
    pub(super) tau: f64,
    pub(super) baseline: f64,
}

/// Runs the study: for each kind of object, redraw, condition and method, the whole pipeline of the
/// program (size, alignment, distances of poses, their plane, curves in time, the LLE plane), k-means
/// with as many clusters as classes, and τ with the best matching of clusters to classes.
///
/// The same bits for any number of threads.
///
/// # Errors
/// If settings are out of range, it was stopped, or a map cannot be laid out.
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
            told_apart(params, &study, &labels, method, seed, &progress.within())
        })
        .collect()
}

/// τ of a study by one method, of all of its deformations.
pub(super) fn told_apart(
    params: &NoiseDeformationParams,
    study: &Study,
    labels: &[Option<usize>],
    method: &Method,
    seed: u64,
    progress: &Progress,
) -> Result<Draw, ExperimentError> {
    let whole = method.compared(study, params.map, &params.deformations, progress)?;
    let labels: Vec<Option<usize>> = whole.subjects.iter().map(|&s| labels[s]).collect();
    let clusters = k_means(
        &whole.plane.coordinates,
        whole.plane.dimensions,
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
