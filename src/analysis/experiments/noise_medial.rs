//! How many deformations with a patch are distinguished from those without when medial surfaces are noisy (4.6, 4.6.1).

use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;

use super::medial_methods::{Clusters, assessed, groups};
use super::noise_medial_params::{Condition, MedialDraw, conditions};
use super::noise_medial_result::{MedialNoiseCell, MedialNoiseResult};
use super::sheets::{PHASES, Sheet, sheet};
use super::{ExperimentError, MedialMethod, MedialNoiseParams};

/// The sheet under a condition; its noise depends on seed and stream alone.
pub(super) fn disturbed(clean: &Sheet, condition: Condition, seed: u64, stream: u64) -> Sheet {
    let Some((family, percent)) = condition else {
        return clean.clone();
    };
    // Another stream of numbers than that of the sheets.
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ 0x6e6f_6973_6500_0000);
    random.set_stream(stream);
    clean.noisy(family, percent, &mut random)
}

/// Runs the study. The same bits for any number of threads.
///
/// # Errors
/// If settings are out of range, it was stopped, or a step of the method fails.
pub fn noise_medial(
    params: &MedialNoiseParams,
    progress: &Progress,
) -> Result<MedialNoiseResult, ExperimentError> {
    params.check()?;
    let conditions = conditions(&params.families, &params.percents);
    let redraws = usize::from(params.redraws);
    progress.expect_steps(conditions.len() * redraws * 2 * usize::from(params.per_class));
    let tasks: Vec<(usize, Condition)> = (0..redraws)
        .flat_map(|redraw| conditions.iter().map(move |&condition| (redraw, condition)))
        .collect();
    let draws: Vec<Vec<MedialDraw>> = tasks
        .par_iter()
        .map(|&(redraw, condition)| one_draw(params, redraw, condition, progress))
        .collect::<Result<_, ExperimentError>>()?;
    let mut cells = Vec::new();
    for (index, &method) in params.methods.iter().enumerate() {
        for (c, &condition) in conditions.iter().enumerate() {
            let of: Vec<MedialDraw> = (0..redraws)
                .map(|redraw| draws[redraw * conditions.len() + c][index])
                .collect();
            cells.push(MedialNoiseCell::new(method, condition, &of));
        }
    }
    Ok(MedialNoiseResult {
        params: params.clone(),
        cells,
    })
}

/// One cohort under one condition by all ways.
fn one_draw(
    params: &MedialNoiseParams,
    redraw: usize,
    condition: Condition,
    progress: &Progress,
) -> Result<Vec<MedialDraw>, ExperimentError> {
    let seed = params.seed.wrapping_add(redraw as u64);
    let printed = [MedialMethod::PathsPrinted, MedialMethod::PosesPrinted];
    let with_printed = params.methods.iter().any(|m| printed.contains(m));
    let (mut sheets, mut centres, mut labels) = (Vec::new(), Vec::new(), Vec::new());
    for class in 0..2_usize {
        for member in 0..params.per_class {
            progress.step()?;
            // A stream per sheet, so that threads may take sheets in any order.
            let stream = (class as u64) << 32 | u64::from(member);
            let clean = sheet(
                &params.sheets,
                &shares(params, class, seed, stream),
                seed,
                stream,
            )?;
            let noisy = disturbed(&clean, condition, seed, stream);
            // Of the noisy sheet: a method knows nothing else.
            centres.push(centre(&noisy.positions[PHASES[0]]));
            sheets.push(assessed(
                &noisy,
                &params.thickening,
                with_printed,
                &progress.within(),
            )?);
            labels.push(class);
        }
    }
    let clusters = Clusters {
        map: params.map,
        restarts: usize::from(params.restarts),
        seed,
    };
    (params.methods.iter())
        .map(|&method| {
            let groups = groups(method, &sheets, &centres, clusters, &progress.within())?;
            Ok(scored(params, method, &groups, &labels, seed))
        })
        .collect()
}

/// None for a normal sheet, one share for one with a patch.
fn shares(params: &MedialNoiseParams, class: usize, seed: u64, stream: u64) -> Vec<f64> {
    let [least, most] = params.patch_shares;
    // Another stream of numbers than that of the sheets.
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ 0x7061_7463_6800_0000);
    random.set_stream(stream);
    let share = least + (most - least) * random.random::<f64>();
    vec![share; class]
}

fn centre(points: &[Point3]) -> Point3 {
    let sum: Vector3 = points.iter().map(|p| p.coords).sum();
    Point3::from(sum / points.len().max(1) as f64)
}

/// τ of groups: as they are where they are classes, by the better of both matches where they have no names (the best
/// match of two clusters with two classes). What is in no group is wrong.
fn scored(
    params: &MedialNoiseParams,
    method: MedialMethod,
    groups: &[usize],
    labels: &[usize],
    seed: u64,
) -> MedialDraw {
    let right = |labels: &[usize], class: usize, swap: bool| -> usize {
        let wanted = if swap { 1 - class } else { class };
        (groups.iter().zip(labels))
            .filter(|(group, label)| **label == class && **group == wanted)
            .count()
    };
    let both = |labels: &[usize], swap| right(labels, 0, swap) + right(labels, 1, swap);
    let swap = |labels: &[usize]| {
        // Clusters have no names and may be swapped; a detected patch says which class it is.
        method != MedialMethod::PatchFound && both(labels, true) > both(labels, false)
    };
    let share = |labels: &[usize]| both(labels, swap(labels)) as f64 / labels.len().max(1) as f64;
    let of_class = |class| {
        labels
            .iter()
            .filter(|label| **label == class)
            .count()
            .max(1) as f64
    };
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut permuted = labels.to_vec();
    let mut sum = 0.0;
    // The same choice of names for permuted labels: its optimism is part of the baseline.
    for _ in 0..params.permutations {
        permuted.shuffle(&mut random);
        sum += share(&permuted);
    }
    let swapped = swap(labels);
    MedialDraw {
        tau: share(labels),
        baseline: sum / f64::from(params.permutations),
        right: [0, 1].map(|class| right(labels, class, swapped) as f64 / of_class(class)),
    }
}
