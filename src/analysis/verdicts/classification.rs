//! What a classifier says of one subject.

use crate::analysis::measures::EF_RANGE;
use crate::analysis::thickening::WallThickening;

use super::checked_classifier::CheckedClassifier;
use super::classifier::Model;
use super::cohort::{Cohort, Trained};
use super::feature::Feature;
use super::features::Features;
use super::result::{Examined, Finding, LabelProbability, Reason, Verdict};
use super::similarity::{nearest_distances, nearest_rows, training_set_distance};

/// [`Feature::UpperRange`] below which an abnormal subject's hypokinesia is global: it is above in all 20 normal subjects, as in
/// 19 of 20 with infarction and all built-in subjects with a patch, and below in 15 of 20 dilated ones.
const REGIONAL_REACH: f64 = 0.65;
/// Most similar subjects that are shown.
const ALIKE: usize = 3;
/// Most features that are given as reasons.
const REASONS: usize = 3;

/// What is needed for the verdict on each subject.
pub(super) struct Classification<'a> {
    cohort: &'a Cohort,
    trained: &'a Trained,
    /// Where it comes from, if not from this study.
    rule: Option<&'a CheckedClassifier>,
    /// Standardised rows; empty where not assessed.
    standardised: Vec<Vec<f64>>,
    nearest_distances: Vec<f64>,
}

impl<'a> Classification<'a> {
    pub fn new(
        cohort: &'a Cohort,
        trained: &'a Trained,
        rule: Option<&'a CheckedClassifier>,
    ) -> Self {
        let design = &trained.abnormal.classifier.design;
        // In standard deviations, or the feature of the largest numbers would decide who is similar.
        let standardised: Vec<Vec<f64>> = (cohort.rows.iter())
            .map(|row| {
                if row.is_empty() {
                    Vec::new()
                } else {
                    design.of(row)
                }
            })
            .collect();
        let nearest_distances = nearest_distances(&standardised, &trained.training_set);
        Self {
            cohort,
            trained,
            rule,
            standardised,
            nearest_distances,
        }
    }

    /// What a model says of a subject. A subject in the training set, or a copy of one, gets the leave-one-out result; the
    /// classifier of all subjects was trained with its label.
    fn probability_by(&self, model: &Model, index: usize) -> f64 {
        match self.place(index) {
            Some(place) => model.left_out.probabilities[place],
            None => {
                let score = model.classifier.score(&self.cohort.rows[index]);
                model.calibration.probability(score)
            }
        }
    }

    /// Where a subject, or the first of its copies, is in the training set.
    fn place(&self, index: usize) -> Option<usize> {
        let first = self.cohort.copies.first_of(index);
        self.trained.training_set.binary_search(&first).ok()
    }

    /// Labels with their probabilities, the most probable first.
    fn labels(&self, index: usize) -> Vec<LabelProbability> {
        let mut labels: Vec<LabelProbability> = (self.trained.label_models.iter())
            .map(|(label, model)| LabelProbability {
                label: label.clone(),
                probability: self.probability_by(model, index),
            })
            .collect();
        let sum: f64 = labels.iter().map(|label| label.probability).sum();
        for label in &mut labels {
            // Each is one against the rest: nothing else makes their sum 1.
            label.probability /= sum.max(f64::MIN_POSITIVE);
        }
        labels.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        labels
    }

    /// The features of a subject that speak most for what it is called.
    fn reasons(&self, index: usize, abnormal: bool) -> Vec<Reason> {
        let model = &self.trained.abnormal;
        let classifier = (self.place(index)).map_or(&model.classifier, |place| {
            &model.left_out.classifiers[place]
        });
        let row = &self.cohort.rows[index];
        let sign = if abnormal { 1.0 } else { -1.0 };
        let parts = Feature::MODEL_FEATURES
            .into_iter()
            .zip(classifier.contributions(row));
        let mut reasons: Vec<Reason> = (parts.zip(row))
            // What is not known is no reason, whatever its absence tells.
            .filter(|((_, log_odds), value)| value.is_some() && sign * log_odds > 0.0)
            .map(|((feature, log_odds), _)| Reason { feature, log_odds })
            .collect();
        reasons.sort_by(|a, b| b.log_odds.abs().total_cmp(&a.log_odds.abs()));
        reasons.truncate(REASONS);
        reasons
    }

    /// The verdict on one subject that is assessed.
    pub fn verdict(&self, index: usize, subject: &Examined) -> Verdict {
        let features = &subject.features;
        let probability = self.probability_by(&self.trained.abnormal, index);
        // At one half the subject counts as normal.
        let abnormal = probability > 0.5;
        let nearest_rows = |among: &[usize]| {
            let copies = &self.cohort.copies;
            let others: Vec<usize> = (among.iter().copied())
                .filter(|&other| other == index || !copies.are_copies(other, index))
                .collect();
            nearest_rows(&self.standardised, index, &others, ALIKE)
        };
        Verdict {
            finding: match (abnormal, failure(features, subject.wall_thickening)) {
                (false, _) => Finding::Nothing,
                (true, finding) => finding,
            },
            wall: subject.wall_thickening.is_some(),
            labels: self.labels(index),
            reasons: self.reasons(index, abnormal),
            outside: (self.rule)
                .map_or_else(Vec::new, |rule| rule.outside(&self.cohort.rows[index])),
            abnormal,
            probability,
            similar_normal: nearest_rows(&self.cohort.normal),
            similar_abnormal: nearest_rows(&self.cohort.abnormal),
            training_set_distance: match self.rule {
                Some(rule) => rule.distance(&self.standardised[index]),
                None => training_set_distance(
                    &self.standardised,
                    self.cohort.copies.first_of(index),
                    &self.trained.training_set,
                    &self.nearest_distances,
                ),
            },
            features: features.clone(),
            patched: subject.patched,
        }
    }
}

/// What fails in an abnormal subject.
fn failure(features: &Features, wall_thickening: Option<WallThickening>) -> Finding {
    let Some(wall_thickening) = wall_thickening else {
        return Finding::WithoutPatch;
    };
    let reach = features.get(Feature::UpperRange).unwrap_or(0.0);
    // A thick wall thickens by little in relation to itself: what ejects as healthy hearts do is not hypokinetic.
    let ejects = features.get(Feature::EjectionFraction);
    let ejects = ejects.is_some_and(|share| 100.0 * share >= EF_RANGE.low);
    match wall_thickening {
        // Nothing thickens: there is no remote myocardium that a region could be compared with.
        WallThickening::HardlyAnywhere => Finding::GlobalHypokinesia,
        // Before patches: a wall that fails as a whole often has a weakest part, which is no regional finding.
        _ if reach < REGIONAL_REACH && !ejects => Finding::GlobalHypokinesia,
        WallThickening::AllButPatches => Finding::AbnormalPatch,
        WallThickening::Everywhere => Finding::WithoutPatch,
    }
}
