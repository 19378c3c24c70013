//! A classifier that travels: learnt on one study, applied to subjects of another; it holds no subject.

use serde::{Deserialize, Serialize};

use crate::analysis::measures::wall_sides;
use crate::progress::Progress;
use crate::study::{Study, Subject, SurfaceKind};

use super::classifier::{Calibration, Classifier, LeftOut, Model};
use super::cohort::{Cohort, Trained};
use super::design::{Design, Standard};
use super::error::{LearnError, RuleError, VerdictError};
use super::feature::Feature;
use super::params::CheckedVerdictParams;
use super::result::{ClassifierQuality, Examined, NotAssessed, TrainingSetDistance};
use super::similarity::{distance_among, distance_from_mean, quantiles};
use super::whole_heart::with_whole_hearts;

/// What a file of a rule calls itself.
const FORMAT: &str = "cardiomorph rule";
/// Version of the form of a rule; others are refused.
const VERSION: u32 = 1;
/// Meshes of up to so many times the vertices or poses of those of the training set, or as many times fewer, are comparable:
/// features are area-weighted, but spheres in coarse walls are larger, and two poses hide what thirty average out.
const COMPARABLE: usize = 4;

/// A classifier with its training figures and the ranges of what it has seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rule {
    /// Says that it is a rule.
    pub format: String,
    /// Of this form.
    pub version: u32,
    /// What it was learnt on, and how good it is, leave-one-out.
    pub training: RuleTraining,
    /// The meshes that it was learnt on.
    pub meshes: RuleMeshes,
    /// What it reads, in the order of all weights.
    pub features: Vec<RuleFeature>,
    /// How far its training subjects lie from their mean, in standard deviations of a feature: the quantiles 0, 5 … 100 %.
    pub distances: Vec<f64>,
    /// Abnormal against normal.
    pub abnormal: RuleModel,
    /// One label against the rest, for each that could be told; empty with fewer than three.
    pub kinds: Vec<RuleKind>,
}

/// Training figures, leave-one-out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleTraining {
    /// Subjects of class normal.
    pub normal: usize,
    /// Of class abnormal.
    pub abnormal: usize,
    /// Share of them that is classified correctly.
    pub accuracy: Option<f64>,
    /// Area under the ROC curve.
    pub auc: Option<f64>,
    /// Normal subjects classified as abnormal.
    pub false_positives: Option<usize>,
    /// Abnormal subjects classified as normal.
    pub false_negatives: Option<usize>,
    /// Share whose most probable label is their own.
    pub kind_accuracy: Option<f64>,
}

/// The meshes of a training set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleMeshes {
    /// Whether they are those of walls, with an inner and an outer side, and not of cavities alone.
    pub walls: bool,
    /// Least and greatest number of vertices of a subject.
    pub vertices: [usize; 2],
    /// Least and greatest number of poses.
    pub poses: [usize; 2],
}

/// One feature, and how it is brought to a common scale.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleFeature {
    /// In words.
    pub name: String,
    /// What it is counted in; empty for a ratio.
    pub unit: String,
    /// Least and greatest value in the training set; null where no subject had one.
    pub range: Option<[f64; 2]>,
    /// What stands in where it is not known; null where no subject had one.
    pub median: Option<f64>,
    /// Mean over the training set, which is subtracted to standardise a value.
    pub mean: f64,
    /// Standard deviation over the training set, by which the difference from the mean is divided.
    pub deviation: f64,
    /// Mean and deviation of the flag of its absence, 0 or 1, if there is one.
    pub absence: Option<[f64; 2]>,
}

/// Log odds = intercept + Σ weight × standardised feature + Σ weight × standardised flag; probability =
/// 1 / (1 + exp(−slope × log odds − shift)).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleModel {
    /// Penalty on squared weights that was chosen.
    pub penalty: f64,
    /// Intercept.
    pub intercept: f64,
    /// One per feature.
    pub weights: Vec<f64>,
    /// One per feature that has a flag of absence, in their order.
    pub absence_weights: Vec<f64>,
    /// Slope of the calibration.
    pub slope: f64,
    /// Shift of the calibration.
    pub shift: f64,
}

/// The model of one label.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleKind {
    /// The label.
    pub label: String,
    /// It against the rest.
    pub model: RuleModel,
}

/// Learns a rule from the labelled subjects of a study.
///
/// # Errors
/// If fewer than the least number of either class can be assessed, subjects do not belong to the study, or on "stop".
pub fn learn(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<Rule, LearnError> {
    let examined = with_whole_hearts(study, examined)?;
    let cohort = Cohort::new(study, &examined);
    let (normal, abnormal) = cohort.counts();
    progress.expect_steps(params.permutations as usize + 1);
    let trained = cohort.train(params, progress).map_err(VerdictError::from)?;
    let trained = trained.ok_or(LearnError::TooFew {
        normal,
        abnormal,
        least: params.min_labelled as usize,
    })?;
    let rows = || (trained.training_set.iter()).map(|&index| &cohort.rows[index]);
    let ranges: Vec<_> = (0..Feature::MODEL_FEATURES.len())
        .map(|j| range(rows().filter_map(|row| row[j])))
        .collect();
    let subjects = || (trained.training_set.iter()).map(|&index| &*study.subjects[index]);
    Ok(Rule {
        format: FORMAT.to_owned(),
        version: VERSION,
        training: training(trained.quality.as_ref(), normal, abnormal),
        meshes: RuleMeshes {
            walls: subjects().all(is_wall),
            vertices: range(subjects().map(vertex_count)).unwrap_or_default(),
            poses: range(subjects().map(|s| s.sequence.frame_count())).unwrap_or_default(),
        },
        features: features(&trained.abnormal.classifier.design, &ranges),
        distances: quantiles(
            (rows().map(|row| distance_from_mean(&trained.abnormal.classifier.design.of(row))))
                .collect(),
        ),
        abnormal: model(&trained.abnormal),
        kinds: (trained.kinds.iter())
            .map(|(label, kind)| RuleKind {
                label: label.clone(),
                model: model(kind),
            })
            .collect(),
    })
}

fn range<T: PartialOrd + Copy>(values: impl Iterator<Item = T>) -> Option<[T; 2]> {
    values.fold(None, |range, value| match range {
        None => Some([value; 2]),
        Some([low, high]) => Some([
            if value < low { value } else { low },
            if value > high { value } else { high },
        ]),
    })
}

fn training(quality: Option<&ClassifierQuality>, normal: usize, abnormal: usize) -> RuleTraining {
    RuleTraining {
        normal,
        abnormal,
        accuracy: quality.map(|quality| quality.accuracy.share()),
        auc: quality.map(|quality| quality.auc),
        false_positives: quality.map(|quality| quality.false_positives),
        false_negatives: quality.map(|quality| quality.false_negatives),
        kind_accuracy: (quality.and_then(|quality| quality.kinds))
            .map(|kinds| kinds.correct as f64 / kinds.of as f64),
    }
}

fn features(design: &Design, ranges: &[Option<[f64; 2]>]) -> Vec<RuleFeature> {
    let Standard { means, deviations } = &design.standard;
    let count = Feature::MODEL_FEATURES.len();
    (Feature::MODEL_FEATURES.into_iter().enumerate())
        .map(|(j, feature)| RuleFeature {
            name: feature.name().to_owned(),
            unit: feature.unit().symbol().to_owned(),
            range: ranges[j],
            median: design.medians[j],
            mean: means[j],
            deviation: deviations[j],
            absence: (design.flags.iter().position(|&flag| flag == j))
                .map(|place| [means[count + place], deviations[count + place]]),
        })
        .collect()
}

fn model(model: &Model) -> RuleModel {
    let coefficients = &model.classifier.coefficients;
    let (weights, absences) = coefficients[1..].split_at(Feature::MODEL_FEATURES.len());
    RuleModel {
        penalty: model.classifier.ridge,
        intercept: coefficients[0],
        weights: weights.to_vec(),
        absence_weights: absences.to_vec(),
        slope: model.calibration.slope,
        shift: model.calibration.shift,
    }
}

/// A rule that can be applied.
#[derive(Debug)]
pub struct CheckedRule {
    rule: Rule,
    trained: Trained,
}

impl Rule {
    /// Checks once that the rule is of this version, reads the features of this program, and holds numbers alone.
    ///
    /// # Errors
    /// What of that does not hold.
    pub fn check(self) -> Result<CheckedRule, RuleError> {
        if self.format != FORMAT || self.version != VERSION {
            return Err(RuleError::Form {
                format: self.format,
                version: self.version,
            });
        }
        let own = Feature::MODEL_FEATURES.map(|feature| (feature.name(), feature.unit().symbol()));
        let read: Vec<_> = (self.features.iter())
            .map(|feature| (feature.name.as_str(), feature.unit.as_str()))
            .collect();
        if read != own {
            return Err(RuleError::Features);
        }
        let flags: Vec<usize> = (self.features.iter().enumerate())
            .filter_map(|(j, feature)| feature.absence.map(|_| j))
            .collect();
        let absences = || self.features.iter().filter_map(|feature| feature.absence);
        let design = Design {
            medians: self.features.iter().map(|f| f.median).collect(),
            standard: Standard {
                means: (self.features.iter().map(|f| f.mean))
                    .chain(absences().map(|[mean, _]| mean))
                    .collect(),
                deviations: (self.features.iter().map(|f| f.deviation))
                    .chain(absences().map(|[_, deviation]| deviation))
                    .collect(),
            },
            flags,
        };
        let models = || (self.kinds.iter().map(|kind| &kind.model)).chain([&self.abnormal]);
        let whole = models().all(|model| {
            let numbers = [model.penalty, model.intercept, model.slope, model.shift];
            model.weights.len() == own.len()
                && model.absence_weights.len() == design.flags.len()
                && (model.weights.iter().chain(&model.absence_weights))
                    .chain(&numbers)
                    .all(|x| x.is_finite())
                && model.slope >= 0.0
        });
        let Standard { means, deviations } = &design.standard;
        let scaled = deviations.iter().all(|x| *x > 0.0 && x.is_finite());
        let known = (design.medians.iter().flatten()).all(|x| x.is_finite());
        let seen = self.distances.len() > 1
            && self.distances.iter().all(|x| x.is_finite() && *x >= 0.0)
            && self.distances.is_sorted();
        if !(whole && scaled && known && seen && means.iter().all(|x| x.is_finite())) {
            return Err(RuleError::Numbers);
        }
        let model = |model: &RuleModel| Model {
            classifier: Classifier {
                design: design.clone(),
                coefficients: [
                    &[model.intercept][..],
                    &model.weights,
                    &model.absence_weights,
                ]
                .concat(),
                ridge: model.penalty,
            },
            calibration: Calibration {
                slope: model.slope,
                shift: model.shift,
            },
            // Nobody here was in the training set.
            left_out: LeftOut::default(),
        };
        let trained = Trained {
            abnormal: model(&self.abnormal),
            kinds: (self.kinds.iter())
                .map(|kind| (kind.label.clone(), model(&kind.model)))
                .collect(),
            training_set: Vec::new(),
            quality: None,
        };
        Ok(CheckedRule {
            rule: self,
            trained,
        })
    }
}

impl CheckedRule {
    /// The rule as it was written.
    pub fn rule(&self) -> &Rule {
        &self.rule
    }

    pub(super) fn trained(&self) -> &Trained {
        &self.trained
    }

    /// Why a subject cannot be compared with those that the rule was learnt on, if it cannot.
    pub(super) fn not_comparable(&self, subject: &Subject) -> Option<NotAssessed> {
        let RuleMeshes {
            walls,
            vertices,
            poses,
        } = self.rule.meshes;
        let far = |own: usize, [low, high]: [usize; 2]| {
            own.saturating_mul(COMPARABLE) < low || own > high.saturating_mul(COMPARABLE)
        };
        let kind = |wall: bool| if wall { "walls" } else { "cavities" };
        let own = (is_wall(subject), vertex_count(subject));
        let frames = subject.sequence.frame_count();
        (own.0 != walls || far(own.1, vertices) || far(frames, poses)).then(|| {
            NotAssessed::NotComparable(format!(
                "the classifier was trained on {} of {} to {} vertices and {} to {} poses, this subject is one of {}, \
                 {} vertices and {frames} poses",
                kind(walls),
                vertices[0],
                vertices[1],
                poses[0],
                poses[1],
                kind(own.0),
                own.1,
            ))
        })
    }

    /// How far a subject lies from the mean of the training set, beside the subjects of that.
    pub(super) fn distance(&self, standardised: &[f64]) -> Option<TrainingSetDistance> {
        distance_among(&self.rule.distances, distance_from_mean(standardised))
    }

    /// Model features of a subject outside the range of the training set.
    pub(super) fn outside(&self, row: &[Option<f64>]) -> Vec<Feature> {
        (Feature::MODEL_FEATURES.into_iter().zip(row))
            .zip(&self.rule.features)
            .filter(|((_, value), seen)| match (value, seen.range) {
                (Some(value), Some([low, high])) => *value < low || *value > high,
                _ => false,
            })
            .map(|((feature, _), _)| feature)
            .collect()
    }
}

fn is_wall(subject: &Subject) -> bool {
    let sides = wall_sides(&subject.sequence);
    sides.outer.is_some()
        && (sides.inner.is_some() || sides.unsplit.is_none())
        && !subject
            .sequence
            .surfaces()
            .iter()
            .all(|s| s.kind() == SurfaceKind::Cavity)
}

fn vertex_count(subject: &Subject) -> usize {
    (subject.sequence.surfaces().iter())
        .map(|surface| surface.faces().vertex_count())
        .sum()
}
