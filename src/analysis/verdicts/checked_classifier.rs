//! A rule that was checked, so that it can be applied: how its numbers make a classifier, and whom that can classify.

use crate::analysis::measures::wall_sides;
use crate::study::{Subject, SurfaceKind};

use super::classifier::{Calibration, Classifier, LeftOut, Model};
use super::classifier_file::{ClassifierFile, ClassifierMeshes, ClassifierModel, FORMAT, VERSION};
use super::cohort::Trained;
use super::design::{Design, Standard};
use super::error::ClassifierError;
use super::feature::Feature;
use super::result::{NotAssessed, TrainingSetDistance};
use super::similarity::{distance_among, distance_from_mean};

/// Meshes of as many times fewer vertices or poses than those of the training set are not comparable. Finer ones are: four
/// times the faces change the akinetic share of 12 hearts of `acdc_walls` by at most 0.04, 25 poses in the place of two that of
/// `cine_mri` patient 1 by 0.01, eight in the place of two those of the built-in cohort by at most 0.01.
const COARSER: usize = 4;
/// So many times as far from the mean of the training set as the farthest of that, nothing is comparable: there a linear
/// classifier is an extrapolation.
const TOO_FAR: f64 = 2.0;

/// A rule that can be applied.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedClassifier {
    name: String,
    rule: ClassifierFile,
    /// Places of what it reads among [`Feature::MODEL_FEATURES`].
    reads: Vec<usize>,
    trained: Trained,
}

impl ClassifierFile {
    /// Checks once that the classifier is of this version, reads features of this program, and holds numbers alone. From now on it
    /// is called `name`.
    ///
    /// # Errors
    /// What of that does not hold.
    pub fn check(self, name: &str) -> Result<CheckedClassifier, ClassifierError> {
        if self.format != FORMAT || self.version != VERSION {
            return Err(ClassifierError::Form {
                format: self.format,
                version: self.version,
            });
        }
        let place = |name: &str, unit: &str| {
            let mut all = Feature::MODEL_FEATURES.iter();
            let place = all.position(|own| (own.name(), own.unit().symbol()) == (name, unit));
            place
                .ok_or_else(|| ClassifierError::Feature(format!("{name} {unit}").trim().to_owned()))
        };
        let reads = (self.features.iter())
            .map(|feature| place(&feature.name, &feature.unit))
            .collect::<Result<Vec<usize>, _>>()?;
        if reads.is_empty() || !reads.is_sorted_by(|a, b| a < b) {
            return Err(ClassifierError::Order);
        }
        let design = design(&self, &reads);
        let models = || (self.labels.iter().map(|label| &label.model)).chain([&self.abnormal]);
        let whole = models().all(|model| {
            let numbers = [model.penalty, model.intercept, model.slope, model.shift];
            model.weights.len() == reads.len()
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
            return Err(ClassifierError::Numbers);
        }
        let model = |model: &ClassifierModel| Model {
            classifier: Classifier {
                design: design.clone(),
                coefficients: [
                    &[model.intercept][..],
                    &spread(&reads, 0.0, model.weights.iter().copied()),
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
            label_models: (self.labels.iter())
                .map(|label| (label.label.clone(), model(&label.model)))
                .collect(),
            training_set: Vec::new(),
            quality: None,
        };
        Ok(CheckedClassifier {
            name: name.to_owned(),
            rule: self,
            reads,
            trained,
        })
    }
}

/// How the features are brought to a common scale; one that the classifier does not read is 0.
fn design(rule: &ClassifierFile, reads: &[usize]) -> Design {
    let features = || rule.features.iter();
    let absences = || features().filter_map(|feature| feature.absence);
    let mut means = spread(reads, 0.0, features().map(|f| f.mean));
    let mut deviations = spread(reads, 1.0, features().map(|f| f.deviation));
    means.extend(absences().map(|[mean, _]| mean));
    deviations.extend(absences().map(|[_, deviation]| deviation));
    Design {
        medians: spread(reads, None, features().map(|f| f.median)),
        standard: Standard { means, deviations },
        flags: (reads.iter().zip(features()))
            .filter_map(|(&j, feature)| feature.absence.map(|_| j))
            .collect(),
    }
}

/// Values at their places among all model features, `none` elsewhere.
fn spread<T: Copy>(reads: &[usize], none: T, values: impl Iterator<Item = T>) -> Vec<T> {
    let mut all = vec![none; Feature::MODEL_FEATURES.len()];
    for (&j, value) in reads.iter().zip(values) {
        all[j] = value;
    }
    all
}

impl CheckedClassifier {
    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The classifier as it was written.
    pub fn rule(&self) -> &ClassifierFile {
        &self.rule
    }

    /// The features that it reads.
    pub fn features(&self) -> Vec<Feature> {
        (self.reads.iter())
            .map(|&j| Feature::MODEL_FEATURES[j])
            .collect()
    }

    pub(super) fn trained(&self) -> &Trained {
        &self.trained
    }

    /// Why a subject cannot be compared with those that the classifier was trained on, if it cannot: its meshes are of another kind or
    /// too coarse, or what the classifier reads of it lies too far out.
    pub(super) fn not_comparable(
        &self,
        subject: &Subject,
        row: &[Option<f64>],
    ) -> Option<NotAssessed> {
        let ClassifierMeshes {
            walls,
            vertices,
            poses,
        } = self.rule.meshes;
        let coarse = |own: usize, least: usize| own.saturating_mul(COARSER) < least;
        let kind = |wall: bool| if wall { "walls" } else { "cavities" };
        let own = (is_wall(subject), vertex_count(subject));
        let frames = subject.sequence.frame_count();
        if own.0 != walls || coarse(own.1, vertices[0]) || coarse(frames, poses[0]) {
            return Some(NotAssessed::NotComparable(format!(
                "the classifier was trained on {} of {} to {} vertices and {} to {} poses, this subject is one of {}, \
                 {} vertices and {frames} poses",
                kind(walls),
                vertices[0],
                vertices[1],
                poses[0],
                poses[1],
                kind(own.0),
                own.1,
            )));
        }
        let always_known: Vec<usize> = (self.reads.iter().zip(&self.rule.features))
            .filter(|(_, read)| read.median.is_some() && read.absence.is_none())
            .map(|(&j, _)| j)
            .collect();
        let unknown: Vec<&str> = (always_known.iter())
            .filter(|&&j| row.get(j).copied().flatten().is_none())
            .map(|&j| Feature::MODEL_FEATURES[j].name())
            .collect();
        // Medians that stand in for half of what was known of everybody would be a verdict on nobody.
        if !unknown.is_empty() && 2 * unknown.len() >= always_known.len() {
            return Some(NotAssessed::NotComparable(format!(
                "the classifier reads what is not known of this subject: {}",
                unknown.join(", ")
            )));
        }
        let distance = self.distance_from_mean(&self.trained.abnormal.classifier.design.of(row));
        let farthest = *self.rule.distances.last()?;
        (distance > TOO_FAR * farthest).then(|| {
            let names = self.outside(row).into_iter().map(Feature::name);
            NotAssessed::NotComparable(format!(
                "this subject lies {:.1} × as far from the mean of the training set as the farthest of that ({})",
                distance / farthest.max(f64::MIN_POSITIVE),
                names.collect::<Vec<_>>().join(", ")
            ))
        })
    }

    fn distance_from_mean(&self, standardised: &[f64]) -> f64 {
        let flags = self.trained.abnormal.classifier.design.flags.len();
        distance_from_mean(standardised, self.reads.len() + flags)
    }

    /// How far a subject lies from the mean of the training set, beside the subjects of that.
    pub(super) fn distance(&self, standardised: &[f64]) -> Option<TrainingSetDistance> {
        distance_among(&self.rule.distances, self.distance_from_mean(standardised))
    }

    /// What the classifier reads of a subject and is outside the range of the training set.
    pub(super) fn outside(&self, row: &[Option<f64>]) -> Vec<Feature> {
        (self.reads.iter().zip(&self.rule.features))
            .filter(
                |(j, seen)| match (row.get(**j).copied().flatten(), seen.range) {
                    (Some(value), Some([low, high])) => value < low || value > high,
                    _ => false,
                },
            )
            .map(|(&j, _)| Feature::MODEL_FEATURES[j])
            .collect()
    }
}

/// Whether a subject has an inner and an outer side.
pub(super) fn is_wall(subject: &Subject) -> bool {
    let sides = wall_sides(&subject.sequence);
    sides.outer.is_some()
        && (sides.inner.is_some() || sides.unsplit.is_none())
        && !subject
            .sequence
            .surfaces()
            .iter()
            .all(|s| s.kind() == SurfaceKind::Cavity)
}

/// Vertices of all its surfaces.
pub(super) fn vertex_count(subject: &Subject) -> usize {
    (subject.sequence.surfaces().iter())
        .map(|surface| surface.faces().vertex_count())
        .sum()
}
