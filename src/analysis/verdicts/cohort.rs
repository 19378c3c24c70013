//! The labelled subjects of a study, the classifier that they give, and how good it is.

use std::sync::Arc;

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::classification::Accuracy;
use crate::progress::{Progress, Stopped};
use crate::study::checks::Copies;
use crate::study::{LabelClass, Study, plain_label};

use super::classifier::{LeftOut, Model, Row, leave_one_out};
use super::params::CheckedVerdictParams;
use super::result::{ClassifierQuality, Examined, LabelQuality, NotAssessed};
use super::score::auc;

/// The subjects that can be classified, and which of them have labels that count.
pub(super) struct Cohort {
    /// What the classifier reads of each subject; empty where it is not assessed.
    pub rows: Vec<Vec<Option<f64>>>,
    /// Assessed subjects with a normal label, ascending.
    pub normal: Vec<usize>,
    /// And with an abnormal one.
    pub abnormal: Vec<usize>,
    /// Label of each of them.
    pub labels: Vec<Option<String>>,
    /// Which subjects have the same meshes: the classifier is trained on the first of them alone.
    pub copies: Arc<Copies>,
}

/// The classifiers of a cohort, with their leave-one-out results on the subjects that they were trained on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Trained {
    /// Abnormal or not.
    pub abnormal: Model,
    /// One label against the rest, for each label with enough subjects; empty where that is the same question.
    pub label_models: Vec<(String, Model)>,
    /// Subjects of the training set, ascending.
    pub training_set: Vec<usize>,
    /// `None` of a classifier that is read, which has none of the subjects that it was trained on.
    pub quality: Option<ClassifierQuality>,
}

/// Fewest labels: between two there is nothing to tell but normal and abnormal.
const MIN_LABELS: usize = 3;

impl Cohort {
    pub fn new(study: &Study, examined: &[Result<Examined, NotAssessed>]) -> Self {
        let copies = Copies::of(&study.subjects);
        let labels = copies.labels_once(&study.subjects);
        let with_class = |class: LabelClass| -> Vec<usize> {
            (examined.iter().enumerate())
                .filter(|(index, subject)| {
                    // A copy would be in the training set of its twin.
                    let counts = labels[*index].is_some();
                    counts && subject.is_ok() && study.class_of(&study.subjects[*index]) == class
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
            normal: with_class(LabelClass::Normal),
            abnormal: with_class(LabelClass::Abnormal),
            labels: (study.subjects.iter())
                .map(|subject| subject.label.clone())
                .collect(),
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
        let rows: Vec<&Row> = training_set
            .iter()
            .map(|&index| self.rows[index].as_slice())
            .collect();
        let labels: Vec<bool> = training_set
            .iter()
            .map(|index| self.abnormal.binary_search(index).is_ok())
            .collect();
        let abnormal = Model::new(&rows, &labels, progress)?;
        let label_models = self.label_models(&rows, &training_set, min_count, progress)?;
        progress.step()?;
        let mut quality = quality(&rows, &labels, &abnormal.left_out, params, progress)?;
        quality.labels = self.label_quality(&label_models, &training_set);
        Ok(Some(Trained {
            abnormal,
            label_models,
            training_set,
            quality: Some(quality),
        }))
    }

    /// A model for each label that enough subjects of the training set have.
    fn label_models(
        &self,
        rows: &[&Row],
        training_set: &[usize],
        min_count: usize,
        progress: &Progress,
    ) -> Result<Vec<(String, Model)>, Stopped> {
        let of = |place: usize| self.labels[training_set[place]].as_deref().map(plain_label);
        let own: Vec<Option<String>> = (0..rows.len()).map(of).collect();
        let mut labels: Vec<String> = Vec::new();
        for &index in training_set {
            let label = self.labels[index].clone().unwrap_or_default();
            let known = |other: &String| plain_label(other) == plain_label(&label);
            if !labels.iter().any(known) {
                labels.push(label);
            }
        }
        labels.sort();
        let positive = |label: &str| -> Vec<bool> {
            let label = Some(plain_label(label));
            own.iter().map(|own| *own == label).collect()
        };
        labels.retain(|label| positive(label).iter().filter(|own| **own).count() >= min_count);
        if labels.len() < MIN_LABELS {
            return Ok(Vec::new());
        }
        (labels.into_iter())
            .map(|label| {
                let model = Model::new(rows, &positive(&label), progress)?;
                Ok((label, model))
            })
            .collect()
    }

    fn label_quality(
        &self,
        label_models: &[(String, Model)],
        training_set: &[usize],
    ) -> Option<LabelQuality> {
        let is = |place: usize, model: usize| {
            let own = self.labels[training_set[place]].as_deref().map(plain_label);
            own == Some(plain_label(&label_models[model].0))
        };
        let of: Vec<usize> = (0..training_set.len())
            .filter(|&place| (0..label_models.len()).any(|model| is(place, model)))
            .collect();
        let predicted = |place: usize| {
            let of = |model: &usize| label_models[*model].1.left_out.probabilities[place];
            // Of equals the first.
            (0..label_models.len())
                .rev()
                .max_by(|a, b| of(a).total_cmp(&of(b)))
        };
        let count = |model: usize| of.iter().filter(|&&place| is(place, model)).count();
        Some(LabelQuality {
            correct: (of.iter())
                .filter(|&&place| predicted(place).is_some_and(|model| is(place, model)))
                .count(),
            of: of.len(),
            largest_label: (0..label_models.len()).map(count).max()?,
        })
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
    rows: &[&Row],
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
            let left_out = leave_one_out(rows, &labels, progress)?;
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
        labels: None,
    })
}
