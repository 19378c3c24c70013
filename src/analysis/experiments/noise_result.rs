//! The table of the noise study, with its protocol in words.

use super::noise_params::{Condition, Draw};
use super::{Motion, NoiseDeformationParams, NoiseFamily, NoiseReference, ObjectKind};

/// All cells of the study, and the settings that they came from.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseDeformationResult {
    /// The settings with which it was run.
    pub params: NoiseDeformationParams,
    /// By method; for each the clean data first, then by reading, family and level.
    pub cells: Vec<NoiseCell>,
}

/// τ of one method under one condition.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseCell {
    /// What the method is called.
    pub method: &'static str,
    /// The distribution of the noise; `None` for clean data.
    pub family: Option<NoiseFamily>,
    /// The level; 0 for clean data.
    pub percent: f64,
    /// What the level is a share of.
    pub reference: NoiseReference,
    /// Mean of τ over redraws and objects, in `0.0..=1.0`.
    pub tau: f64,
    /// Standard error of that mean from the scatter between redraws; 0 for a single one.
    pub standard_error: f64,
    /// Mean of τ with permuted labels.
    pub baseline: f64,
    /// Mean of τ of each kind of object.
    pub by_object: Vec<(ObjectKind, f64)>,
    /// The figure of table 3.1, where it has this level.
    pub published: Option<f64>,
}

/// Table 3.1: level and τ in percent for uniform, Gaussian and Poisson noise.
const PUBLISHED: [(f64, [f64; 3]); 5] = [
    (1.0, [99.6, 99.4, 99.2]),
    (2.5, [99.3, 97.3, 97.2]),
    (5.0, [96.0, 94.4, 95.1]),
    (10.0, [90.1, 88.8, 89.0]),
    (20.0, [74.7, 72.9, 73.2]),
];

/// The figure of table 3.1 as a share, where it has this level.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, table 3.1.
pub fn published_tau(family: NoiseFamily, percent: f64) -> Option<f64> {
    let column = NoiseFamily::ALL.iter().position(|f| *f == family)?;
    // Levels are typed, not computed, so that equality is meant.
    let (_, row) = PUBLISHED.iter().find(|(level, _)| *level == percent)?;
    Some(row[column] / 100.0)
}

impl NoiseCell {
    pub(super) fn new(
        params: &NoiseDeformationParams,
        method: usize,
        condition: &Condition,
        draw: impl Fn(usize, usize) -> Draw,
    ) -> Self {
        let redraws = usize::from(params.redraws);
        let objects = params.objects.len();
        let over_objects = |value: &dyn Fn(Draw) -> f64, redraw: usize| {
            // Over objects first: they are a choice, not a draw, and their differences are no error.
            (0..objects).map(|o| value(draw(o, redraw))).sum::<f64>() / objects as f64
        };
        let mean_of = |value: &dyn Fn(Draw) -> f64| -> Vec<f64> {
            (0..redraws)
                .map(|redraw| over_objects(value, redraw))
                .collect()
        };
        let (tau, standard_error) = mean_and_error(&mean_of(&|draw| draw.tau));
        let (baseline, _) = mean_and_error(&mean_of(&|draw| draw.baseline));
        let (family, percent, reference) = match *condition {
            Condition::Clean => (None, 0.0, NoiseReference::default()),
            Condition::Noisy {
                family,
                percent,
                reference,
            } => (Some(family), percent, reference),
        };
        // Over redraws alone: tables show objects beside each other.
        let of_object =
            |object: usize| (0..redraws).map(|r| draw(object, r).tau).sum::<f64>() / redraws as f64;
        Self {
            method: params.methods[method].name,
            family,
            percent,
            reference,
            tau,
            standard_error,
            baseline,
            by_object: (params
                .objects
                .iter()
                .copied()
                .zip((0..objects).map(of_object)))
            .collect(),
            published: family.and_then(|family| published_tau(family, percent)),
        }
    }
}

/// Mean, and s / √n.
pub(super) fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count.max(1.0);
    // One value has no scatter.
    if values.len() < 2 {
        return (mean, 0.0);
    }
    let spread: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    (mean, (spread / (count - 1.0) / count).sqrt())
}

impl NoiseDeformationResult {
    /// The cell of a method; `None` as family for clean data.
    pub fn cell(
        &self,
        method: &str,
        family: Option<NoiseFamily>,
        percent: f64,
        reference: NoiseReference,
    ) -> Option<&NoiseCell> {
        self.cells.iter().find(|cell| {
            cell.method == method
                && cell.family == family
                && cell.percent == percent
                && (family.is_none() || cell.reference == reference)
        })
    }

    /// What was done, a sentence a line, to stand beside every table.
    pub fn protocol(&self) -> Vec<String> {
        let params = &self.params;
        let cohort = &params.cohort;
        let names = |names: Vec<&str>| names.join("; ");
        let per_object = usize::from(cohort.per_class) * Motion::ALL.len();
        vec![
            format!(
                "Objects, each a study of its own: {}.",
                names(params.objects.iter().map(|o| o.name()).collect())
            ),
            format!(
                "{per_object} deformations of each: {} of {}, {} poses, the first at rest; amplitudes \
                 vary by ±{} %, axes of objects by ±{} %, and all lie anywhere in space.",
                cohort.per_class,
                names(Motion::ALL.iter().map(|m| m.name()).collect()),
                cohort.poses,
                100.0 * cohort.amplitude_jitter,
                100.0 * cohort.object_jitter,
            ),
            "Noise is independent for every vertex, coordinate and pose; uniform noise has half-width \
             √3 σ, Poisson noise is σ (k − 10) / √10."
                .to_owned(),
            "σ² is the level times the variance per coordinate of the clean mesh at rest (shape), or \
             times the mean square per coordinate of the clean displacement (displacement)."
                .to_owned(),
            "Pipeline: one size per deformation, rigid alignment of each pair of poses, distances, their \
             plane, curves in plane and time, LLE plane of whole deformations."
                .to_owned(),
            format!(
                "τ: share of deformations whose cluster of k-means in the LLE plane ({} clusters, {} \
                 starts) stands for their class, by the best matching of clusters to classes.",
                Motion::ALL.len(),
                params.restarts
            ),
            format!(
                "{} redraws of objects, amplitudes and noise, seed {}; mean over objects and redraws ± \
                 standard error from the scatter between redraws; baseline: τ of permuted labels.",
                params.redraws, params.seed
            ),
        ]
    }
}
