//! How many deformations with a patch are told from those without when medial surfaces are noisy (4.6, 4.6.1).

use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::embedding::MapMethod;
use crate::analysis::thickening::ThickeningParams;
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;

use super::medial_methods::{Clusters, groups, judged};
use super::noise_medial_result::{MedialNoiseCell, MedialNoiseResult};
use super::sheets::{PHASES, Sheet, sheet};
use super::{ExperimentError, MedialMethod, NoiseFamily, SheetParams};

/// What is deformed, disturbed and told apart, and how often.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialNoiseParams {
    /// The medial surfaces.
    pub sheets: SheetParams,
    /// Deformations of each of the two classes, normal and with one patch.
    pub per_class: u16,
    /// Least and greatest share of the regular area that a patch takes.
    pub patch_shares: [f64; 2],
    /// Distributions of noise.
    pub families: Vec<NoiseFamily>,
    /// Levels in percent; 0 is always run as well.
    pub percents: Vec<f64>,
    /// Draws of sheets, patches and noise, all anew.
    pub redraws: u16,
    /// Ways of telling; all see the same data.
    pub methods: Vec<MedialMethod>,
    /// The search for patches.
    pub thickening: ThickeningParams,
    /// How pose distances become a plane.
    pub map: MapMethod,
    /// Starts of k-means.
    pub restarts: u16,
    /// Permutations of the labels of each draw, for the baseline.
    pub permutations: u16,
    /// Of everything random.
    pub seed: u64,
}

impl Default for MedialNoiseParams {
    /// Table 4.2: two classes of 20, patches of 4 to 30 % of the sheet, two families at four levels, ten redraws.
    fn default() -> Self {
        Self {
            sheets: SheetParams::default(),
            per_class: 20,
            patch_shares: [0.04, 0.3],
            families: vec![NoiseFamily::Uniform, NoiseFamily::Gaussian],
            percents: vec![1.0, 2.5, 5.0, 10.0],
            redraws: 10,
            methods: MedialMethod::ALL.to_vec(),
            thickening: without_confidence(),
            map: MapMethod::ClassicalMds,
            restarts: 50,
            permutations: 100,
            seed: 1,
        }
    }
}

/// The defaults of the search for patches; its redraws tell how sure a patch is, which is not asked here.
pub(super) fn without_confidence() -> ThickeningParams {
    ThickeningParams {
        redraws: 0,
        ..ThickeningParams::default()
    }
}

impl MedialNoiseParams {
    fn check(&self) -> Result<(), ExperimentError> {
        for (name, value) in [
            ("deformations per class", usize::from(self.per_class)),
            ("families", self.families.len()),
            ("methods", self.methods.len()),
            ("redraws", usize::from(self.redraws)),
            ("starts of k-means", usize::from(self.restarts)),
            ("permutations", usize::from(self.permutations)),
        ] {
            at_least_one(name, value)?;
        }
        let [least, most] = self.patch_shares;
        if !(least > 0.0 && least <= most && most < 0.9) {
            let share = if least > 0.0 { most } else { least };
            return Err(ExperimentError::PatchShare { share });
        }
        check_levels(&self.percents)?;
        self.thickening.check()?;
        Ok(())
    }
}

pub(super) fn at_least_one(name: &'static str, value: usize) -> Result<(), ExperimentError> {
    let least = 1;
    if value >= least {
        return Ok(());
    }
    Err(ExperimentError::TooFew { name, value, least })
}

pub(super) fn check_levels(percents: &[f64]) -> Result<(), ExperimentError> {
    let unfit = |percent: &&f64| !(percent.is_finite() && **percent > 0.0);
    match percents.iter().find(unfit) {
        Some(&percent) => Err(ExperimentError::Level { percent }),
        None => Ok(()),
    }
}

/// Distribution and level of noise; `None` for clean data.
pub(super) type Condition = Option<(NoiseFamily, f64)>;

/// The clean condition, then family by family.
pub(super) fn conditions(families: &[NoiseFamily], percents: &[f64]) -> Vec<Condition> {
    let noisy = (families.iter())
        .flat_map(|&family| percents.iter().map(move |&percent| Some((family, percent))));
    std::iter::once(None).chain(noisy).collect()
}

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

/// What one way did in one draw.
#[derive(Clone, Copy, Debug)]
pub(super) struct MedialDraw {
    pub tau: f64,
    pub baseline: f64,
    /// Shares of normal sheets called normal and of abnormal ones called abnormal.
    pub right: [f64; 2],
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
            let stream = (class as u64) << 32 | u64::from(member);
            let clean = sheet(
                &params.sheets,
                &shares(params, class, seed, stream),
                seed,
                stream,
            )?;
            let noisy = disturbed(&clean, condition, seed, stream);
            centres.push(centre(&noisy.positions[PHASES[0]]));
            sheets.push(judged(
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
            Ok(told(params, method, &groups, &labels, seed))
        })
        .collect()
}

/// None for a normal sheet, one share for one with a patch.
fn shares(params: &MedialNoiseParams, class: usize, seed: u64, stream: u64) -> Vec<f64> {
    let [least, most] = params.patch_shares;
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
fn told(
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
