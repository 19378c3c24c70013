//! The labelled subjects of a study, the classifier that they give, and how good it is.

use std::sync::Arc;

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::classification::Accuracy;
use crate::progress::{Progress, Stopped};
use crate::study::checks::Copies;
use crate::study::{LabelRole, Study};

use super::classifier::{Calibration, Classifier, LeftOut, leave_one_out};
use super::params::CheckedVerdictParams;
use super::result::{ClassifierQuality, Examined, NotAssessed};
use super::score::auc;

/// The subjects that can be classified, and which of them have labels that count.
pub(super) struct Cohort {
    /// What the classifier reads of each subject; empty where it is not assessed.
    pub rows: Vec<Vec<f64>>,
    /// Assessed subjects with a normal label, ascending.
    pub normal: Vec<usize>,
    /// And with an abnormal one.
    pub abnormal: Vec<usize>,
    /// Which subjects have the same meshes: the classifier is trained on the first of them alone.
    pub copies: Arc<Copies>,
}

/// A classifier with its leave-one-out results on the subjects that it was trained on.
pub(super) struct Trained {
    pub classifier: Classifier,
    pub calibration: Calibration,
    /// Subjects of the training set, ascending.
    pub training_set: Vec<usize>,
    pub left_out: LeftOut,
    pub quality: ClassifierQuality,
}

impl Cohort {
    pub fn new(study: &Study, examined: &[Result<Examined, NotAssessed>]) -> Self {
        let copies = Copies::of(&study.subjects);
        let labels = copies.labels_once(&study.subjects);
        let with_role = |role: LabelRole| -> Vec<usize> {
            (examined.iter().enumerate())
                .filter(|(index, subject)| {
                    // A copy would be in the training set of its twin.
                    let counts = labels[*index].is_some();
                    counts && subject.is_ok() && study.role(&study.subjects[*index]) == role
                })
                .map(|(index, _)| index)
                .collect()
        };
        Self {
            rows: (examined.iter())
                .map(|subject| match subject {
                    Ok(subject) => subject.features.model_features(),
                    Err(_) => Vec::new(),
                })
                .collect(),
            normal: with_role(LabelRole::Normal),
            abnormal: with_role(LabelRole::Abnormal),
            copies,
        }
    }

    pub fn counts(&self) -> (usize, usize) {
        (self.normal.len(), self.abnormal.len())
    }

    /// The classifier of the labelled subjects; `None` if they are too few.
    pub fn train(
        &self,
        params: &CheckedVerdictParams,
        progress: &Progress,
    ) -> Result<Option<Trained>, Stopped> {
        let min_count = params.min_labelled as usize;
        // With fewer labels a classifier would be fitted to single subjects.
        if self.normal.len().min(self.abnormal.len()) < min_count {
            return Ok(None);
        }
        let mut training_set = [self.normal.as_slice(), &self.abnormal].concat();
        // Ascending, for the binary searches and for an order that labels do not decide.
        training_set.sort_unstable();
        let rows: Vec<&[f64]> = training_set
            .iter()
            .map(|&index| self.rows[index].as_slice())
            .collect();
        let labels: Vec<bool> = training_set
            .iter()
            .map(|index| self.abnormal.binary_search(index).is_ok())
            .collect();
        let left_out = leave_one_out(&rows, &labels, params.ridge, progress)?;
        progress.step()?;
        let quality = quality(&rows, &labels, &left_out, params, progress)?;
        Ok(Some(Trained {
            classifier: Classifier::new(&rows, &labels, params.ridge, None),
            calibration: Calibration::new(&left_out.scores, &labels),
            training_set,
            left_out,
            quality,
        }))
    }
}

fn correct_count(probabilities: &[f64], labels: &[bool]) -> usize {
    (probabilities.iter().zip(labels))
        // At one half the subject counts as normal, as in a verdict.
        .filter(|(p, label)| (**p > 0.5) == **label)
        .count()
}

/// How good a classifier is beside the same with permuted labels.
fn quality(
    rows: &[&[f64]],
    labels: &[bool],
    left_out: &LeftOut,
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<ClassifierQuality, Stopped> {
    let measured = |labels: &[bool], left_out: &LeftOut| {
        (
            correct_count(&left_out.probabilities, labels),
            auc(&left_out.scores, labels),
        )
    };
    let (correct, area) = measured(labels, left_out);
    let permuted: Vec<(usize, f64)> = (0..params.permutations)
        .into_par_iter()
        .map(|permutation| {
            progress.step()?;
            let mut random = ChaCha8Rng::seed_from_u64(params.seed);
            random.set_stream(u64::from(permutation));
            let mut labels = labels.to_vec();
            labels.shuffle(&mut random);
            // The whole procedure again, leave-one-out included: its optimism is part of the permutation mean.
            let left_out = leave_one_out(rows, &labels, params.ridge, progress)?;
            Ok(measured(&labels, &left_out))
        })
        .collect::<Result<_, Stopped>>()?;
    let count = f64::from(params.permutations);
    let at_least = |good: &dyn Fn(&(usize, f64)) -> bool| {
        // The labels as they are count as one permutation, so that no p-value is zero.
        (1.0 + permuted.iter().filter(|found| good(found)).count() as f64) / (1.0 + count)
    };
    let wrong = |label: bool| {
        (left_out.probabilities.iter().zip(labels))
            .filter(|(p, own)| **own == label && (**p > 0.5) != label)
            .count()
    };
    let mean_correct = permuted
        .iter()
        .map(|(correct, _)| *correct as f64)
        .sum::<f64>()
        / count;
    Ok(ClassifierQuality {
        accuracy: Accuracy {
            correct,
            of: labels.len(),
            baseline: mean_correct / labels.len() as f64,
            p_value: at_least(&|found| found.0 >= correct),
        },
        false_positives: wrong(false),
        false_negatives: wrong(true),
        auc: area,
        auc_baseline: permuted.iter().map(|(_, area)| area).sum::<f64>() / count,
        auc_p_value: at_least(&|found| found.1 >= area),
    })
}
