//! Settings of the study of noise on medial surfaces, and what one draw of it yields.

use crate::analysis::embedding::MapMethod;
use crate::analysis::thickening::ThickeningParams;

use super::{ExperimentError, MedialMethod, NoiseFamily, SheetParams};

/// What is deformed, disturbed and classified, and how often.
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
    /// Random starts of k-means, the best of which counts.
    pub restarts: u16,
    /// Permutations of the labels of each draw, for the baseline.
    pub permutations: u16,
    /// Seed of every random number that is drawn.
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
            thickening: without_redraws(),
            map: MapMethod::ClassicalMds,
            restarts: 50,
            permutations: 100,
            seed: 1,
        }
    }
}

/// The defaults of the search for patches; its redraws tell how sure a patch is, which is not asked here.
pub(super) fn without_redraws() -> ThickeningParams {
    ThickeningParams {
        // Stability takes most of the time, and no number of these tables reads it.
        redraws: 0,
        ..ThickeningParams::default()
    }
}

impl MedialNoiseParams {
    pub(super) fn check(&self) -> Result<(), ExperimentError> {
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
    // Without noise first: every other condition is read against it.
    std::iter::once(None).chain(noisy).collect()
}

/// What one way did in one draw.
#[derive(Clone, Copy, Debug)]
pub(super) struct MedialDraw {
    pub tau: f64,
    pub baseline: f64,
    /// Shares of normal sheets called normal and of abnormal ones called abnormal.
    pub right: [f64; 2],
}
