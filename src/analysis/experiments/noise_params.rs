//! Settings of the study of noise on deformations, and what one draw of it yields.

use crate::analysis::deformations::{Comparison, DeformationMapParams};
use crate::analysis::embedding::MapMethod;

use super::{ExperimentError, Method, NoiseFamily, NoiseReference, ObjectKind, SyntheticParams};

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
    /// Random starts of k-means, the best of which counts.
    pub restarts: u16,
    /// Permutations of the labels of each draw, for the baseline.
    pub permutations: u16,
    /// Seed of every random number that is drawn.
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
                Method::quasi_conformal(),
                Method::quasi_conformal_unsmoothed(),
            ],
            map: MapMethod::default(),
            deformations: DeformationMapParams {
                comparison: Comparison::Poses,
                ..DeformationMapParams::default()
            },
            restarts: 50,
            permutations: 100,
            seed: 1,
        }
    }
}

impl NoiseDeformationParams {
    pub(super) fn check(&self) -> Result<(), ExperimentError> {
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
    pub(super) fn conditions(&self) -> Vec<Condition> {
        // Clean once: both readings of a level of zero are the same.
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

/// Under which noise a draw is made.
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
