//! One table: every metric and form on a labelled study and on its noisy copies, beside EF alone and
//! displacement.

use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::classification::{Accuracy, Classes, ClassesParams, classify};
use crate::analysis::deformations::{DeformationMapParams, map_of_distances};
use crate::analysis::embedding::Embedding;
use crate::analysis::measures::measure_study;
use crate::analysis::metrics::{METRICS, MetricParams};
use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams};
use crate::analysis::transport::CohortTransportParams;
use crate::progress::Progress;
use crate::study::Study;
use crate::study::checks::Copies;

use super::noise_result::mean_and_error;
use super::{ExperimentError, Method, Noise, NoiseFamily, NoiseReference, noisy_study};

/// What is compared, on which copies.
#[derive(Clone, Debug, PartialEq)]
pub struct MetricComparisonParams {
    /// Ways of comparing poses; EF alone is always added.
    pub methods: Vec<Method>,
    /// Levels of noise in percent of the variance of the mesh at rest; 0 is the study itself.
    pub percents: Vec<f64>,
    /// Its distribution.
    pub family: NoiseFamily,
    /// Noisy copies at each level above 0.
    pub redraws: u16,
    /// How distances become a plane.
    pub deformations: DeformationMapParams,
    /// Settings of the classifiers.
    pub classes: ClassesParams,
    /// Of the noise.
    pub seed: u64,
}

impl MetricComparisonParams {
    /// Poses by all kinds and forms with the default smoothing and this transport, and by Procrustes distance as they are;
    /// displacement from end-diastole, deformation, and deformation with shape; 0, 1, 2.5 and 5 % of Gaussian noise, three copies each.
    pub fn all_metrics(transport: Option<CohortTransportParams>) -> Self {
        let methods = METRICS.into_iter().flat_map(|kind| {
            kind.words().forms.iter().map(move |&(name, form)| {
                let metric = MetricParams {
                    form,
                    ..MetricParams::of(kind)
                };
                let poses = PoseDistanceParams {
                    metric,
                    transport,
                    ..PoseDistanceParams::default()
                };
                Method::of_poses(name, poses)
            })
        });
        let beside = [
            Method {
                name: "Procrustes of poses",
                ..Method::procrustes()
            },
            Method::displacement(),
            Method::deformation(),
            Method::deformation_and_shape(),
        ];
        Self {
            methods: methods.chain(beside).collect(),
            percents: vec![0.0, 1.0, 2.5, 5.0],
            family: NoiseFamily::Gaussian,
            redraws: 3,
            deformations: DeformationMapParams::default(),
            classes: ClassesParams {
                permutations: 200,
                ..ClassesParams::default()
            },
            seed: 1,
        }
    }
}

/// Accuracy of a classifier over the copies of a level.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeanAccuracy {
    /// Mean accuracy, in `0.0..=1.0`.
    pub share: f64,
    /// Standard error of that mean from the scatter between copies; 0 for one.
    pub standard_error: f64,
    /// The same with permuted labels.
    pub baseline: f64,
}

/// One method at one level.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparisonRow {
    /// What the method is called.
    pub method: &'static str,
    /// Level of noise in percent.
    pub percent: f64,
    /// Copies that were drawn.
    pub copies: usize,
    /// Subjects with a label that took part in the first copy.
    pub labelled: usize,
    /// Nearest neighbour, each subject left out in turn.
    pub nearest_neighbour: MeanAccuracy,
    /// Linear classifier on the distances, each left out in turn.
    pub linear_classifier: MeanAccuracy,
    /// Linear classifier in the LLE plane, each left out in turn; for EF alone, on EF.
    pub plane_classifier: MeanAccuracy,
    /// k-means in the LLE plane; for EF alone, on EF.
    pub tau: MeanAccuracy,
}

/// By level, then by method, EF alone last.
#[derive(Clone, Debug, PartialEq)]
pub struct MetricComparison {
    /// The settings with which it was run.
    pub params: MetricComparisonParams,
    /// The table.
    pub rows: Vec<ComparisonRow>,
}

/// What the row of EF is called.
const EF_ALONE: &str = "EF alone";

/// Tells the labels of a study apart by every method, on the study and on its noisy copies; all
/// methods see the same copies. The same bits for any number of threads.
///
#[doc = include_str!("COMPARISON.md")]
///
/// # Errors
/// If settings are out of range, it was stopped, or a method has no answer.
pub fn metric_comparison(
    study: &Study,
    params: &MetricComparisonParams,
    progress: &Progress,
) -> Result<MetricComparison, ExperimentError> {
    for (name, value) in [
        ("redraws", usize::from(params.redraws)),
        ("levels", params.percents.len()),
    ] {
        if value == 0 {
            return Err(ExperimentError::TooFew {
                name,
                value,
                least: 1,
            });
        }
    }
    // Before noise makes copies differ: a subject that is listed twice would be tested on itself.
    let once = labelled_once(study);
    let mut tasks = Vec::new();
    for &percent in &params.percents {
        // Without noise all copies would be the same.
        let copies = if percent > 0.0 { params.redraws } else { 1 };
        for method in 0..=params.methods.len() {
            tasks.extend((0..copies).map(|copy| (percent, method, copy)));
        }
    }
    progress.expect_steps(tasks.len());
    let answers: Vec<Classes> = tasks
        .par_iter()
        .map(|&(percent, method, copy)| {
            progress.step()?;
            let noise = Noise {
                family: params.family,
                percent,
                reference: NoiseReference::Shape,
                // By copy alone: every method sees the same noise.
                seed: params.seed.wrapping_add(u64::from(copy)),
            };
            let copy = noisy_study(&once, &noise)?;
            match params.methods.get(method) {
                Some(method) => by_method(&copy, method, params, &progress.within()),
                None => by_ejection_fraction(&copy, params, &progress.within()),
            }
        })
        .collect::<Result<_, ExperimentError>>()?;
    let cases: Vec<_> = tasks.iter().zip(&answers).collect();
    let rows = cases
        .chunk_by(|(a, _), (b, _)| (a.0, a.1) == (b.0, b.1))
        .map(|copies| {
            let (&(percent, method, _), first) = copies[0];
            let name = params.methods.get(method).map_or(EF_ALONE, |m| m.name);
            let over = |accuracy: fn(&Classes) -> Option<Accuracy>| {
                let accuracies = copies.iter().filter_map(|(_, classes)| accuracy(classes));
                let accuracies: Vec<Accuracy> = accuracies.collect();
                let shares: Vec<f64> = accuracies.iter().map(Accuracy::share).collect();
                // Between copies; how far the accuracy is from chance is for the permutation mean to say.
                let (share, standard_error) = mean_and_error(&shares);
                let baselines: Vec<f64> = accuracies.iter().map(|a| a.baseline).collect();
                MeanAccuracy {
                    share,
                    standard_error,
                    baseline: mean_and_error(&baselines).0,
                }
            };
            ComparisonRow {
                method: name,
                percent,
                copies: copies.len(),
                labelled: first.of_row.iter().flatten().count(),
                nearest_neighbour: over(|c| c.nearest_neighbour),
                linear_classifier: over(|c| c.linear_classifier),
                plane_classifier: over(|c| c.plane_classifier),
                tau: over(|c| c.tau),
            }
        })
        .collect();
    Ok(MetricComparison {
        params: params.clone(),
        rows,
    })
}

/// The study with the label of each subject once, however often its meshes are listed.
fn labelled_once(study: &Study) -> Study {
    let mut once = study.clone();
    let labels = Copies::of(&study.subjects).labels_once(&study.subjects);
    for (subject, label) in once.subjects.iter_mut().zip(labels) {
        if subject.label.as_deref() != label {
            Arc::make_mut(subject).label = label.map(str::to_owned);
        }
    }
    once
}

fn by_method(
    study: &Study,
    method: &Method,
    params: &MetricComparisonParams,
    progress: &Progress,
) -> Result<Classes, ExperimentError> {
    let whole = method.whole(study, progress)?;
    let plane = map_of_distances(&whole.distances, &params.deformations.check()?, progress)?;
    let labels = labels_of(study, &whole.subjects);
    let classes = params.classes.check()?;
    Ok(classify(
        &whole.distances,
        &plane,
        &labels,
        &classes,
        progress,
    )?)
}

/// The same classifiers on the one number; subjects without it take no part.
fn by_ejection_fraction(
    study: &Study,
    params: &MetricComparisonParams,
    progress: &Progress,
) -> Result<Classes, ExperimentError> {
    let measures = measure_study(study, progress)?;
    let (subjects, fractions): (Vec<usize>, Vec<f64>) = (measures.iter().enumerate())
        .filter_map(|(subject, measured)| Some((subject, measured.ef?)))
        .unzip();
    // Differences of EF, so that the same classifiers can read them.
    let distances = DistanceMatrix::of_points(&fractions, fractions.len())
        .unwrap_or_else(DistanceMatrix::empty);
    // EF is one number: its line takes the place of the plane.
    let line = Embedding {
        dimensions: 1,
        coordinates: fractions,
        ..Embedding::default()
    };
    let labels = labels_of(study, &subjects);
    let classes = params.classes.check()?;
    Ok(classify(&distances, &line, &labels, &classes, progress)?)
}

fn labels_of<'a>(study: &'a Study, subjects: &[usize]) -> Vec<Option<&'a str>> {
    (subjects.iter())
        .map(|&subject| study.subjects[subject].label.as_deref())
        .collect()
}
