//! Learns a rule from the labelled subjects of a study.

use crate::progress::Progress;
use crate::study::Study;

use super::checked_classifier::{is_wall, vertex_count};
use super::classifier::Model;
use super::classifier_file::{
    ClassifierFeature, ClassifierFile, ClassifierLabel, ClassifierMeshes, ClassifierModel,
    ClassifierOrigin, ClassifierTraining, FORMAT, VERSION,
};
use super::cohort::Cohort;
use super::design::{Design, Standard};
use super::error::{LearnError, VerdictError};
use super::feature::Feature;
use super::params::CheckedVerdictParams;
use super::result::{ClassifierQuality, Examined, NotAssessed};
use super::similarity::{distance_from_mean, quantiles};
use super::whole_heart::with_whole_hearts;

/// Learns a rule that reads some model features, or all, from the labelled subjects of a study.
///
/// # Errors
/// If fewer than the least number of either class can be assessed, none of the features is one that a model reads, subjects
/// do not belong to the study, or on "stop".
pub fn learn(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    features: &[Feature],
    progress: &Progress,
) -> Result<ClassifierFile, LearnError> {
    let reads: Vec<usize> = (Feature::MODEL_FEATURES.iter().enumerate())
        .filter(|(_, feature)| features.contains(feature))
        .map(|(j, _)| j)
        .collect();
    if reads.is_empty() {
        return Err(LearnError::NoFeatures);
    }
    let examined = with_whole_hearts(study, examined)?;
    let mut cohort = Cohort::new(study, &examined);
    for row in &mut cohort.rows {
        // What nobody knows says nothing of anybody.
        (row.iter_mut().enumerate())
            .filter(|(j, _)| !reads.contains(j))
            .for_each(|(_, value)| *value = None);
    }
    let (normal, abnormal) = cohort.counts();
    progress.expect_steps(params.permutations as usize + 1);
    let trained = cohort.train(params, progress).map_err(VerdictError::from)?;
    let trained = trained.ok_or(LearnError::TooFew {
        normal,
        abnormal,
        least: params.min_labelled as usize,
    })?;
    let rows = || (trained.training_set.iter()).map(|&index| &cohort.rows[index]);
    let subjects = || (trained.training_set.iter()).map(|&index| &*study.subjects[index]);
    let design = &trained.abnormal.classifier.design;
    let listed: Vec<ClassifierFeature> = (reads.iter())
        .map(|&j| feature(design, j, range(rows().filter_map(|row| row[j]))))
        .collect();
    let columns = reads.len() + design.flags.len();
    let distances = rows().map(|row| distance_from_mean(&design.of(row), columns));
    Ok(ClassifierFile {
        format: FORMAT.to_owned(),
        version: VERSION,
        origin: ClassifierOrigin {
            study: study.name.clone(),
            normal: study.label_classes.normal.clone(),
            abnormal: study.label_classes.abnormal.clone(),
            program: concat!("Cardiomorph ", env!("CARGO_PKG_VERSION")).to_owned(),
            note: String::new(),
        },
        training: training(trained.quality.as_ref(), normal, abnormal),
        meshes: ClassifierMeshes {
            walls: subjects().all(is_wall),
            vertices: range(subjects().map(vertex_count)).unwrap_or_default(),
            poses: range(subjects().map(|s| s.sequence.frame_count())).unwrap_or_default(),
        },
        features: listed,
        distances: quantiles(distances.collect()),
        abnormal: model(&trained.abnormal, &reads),
        labels: (trained.label_models.iter())
            .map(|(label, of_label)| ClassifierLabel {
                label: label.clone(),
                model: model(of_label, &reads),
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

fn training(
    quality: Option<&ClassifierQuality>,
    normal: usize,
    abnormal: usize,
) -> ClassifierTraining {
    ClassifierTraining {
        normal,
        abnormal,
        accuracy: quality.map(|quality| quality.accuracy.share()),
        auc: quality.map(|quality| quality.auc),
        false_positives: quality.map(|quality| quality.false_positives),
        false_negatives: quality.map(|quality| quality.false_negatives),
        label_accuracy: (quality.and_then(|quality| quality.labels))
            .map(|labels| labels.correct as f64 / labels.of as f64),
    }
}

fn feature(design: &Design, j: usize, range: Option<[f64; 2]>) -> ClassifierFeature {
    let Standard { means, deviations } = &design.standard;
    let feature = Feature::MODEL_FEATURES[j];
    let count = Feature::MODEL_FEATURES.len();
    ClassifierFeature {
        name: feature.name().to_owned(),
        unit: feature.unit().symbol().to_owned(),
        range,
        median: design.medians[j],
        mean: means[j],
        deviation: deviations[j],
        absence: (design.flags.iter().position(|&flag| flag == j))
            .map(|place| [means[count + place], deviations[count + place]]),
    }
}

fn model(model: &Model, reads: &[usize]) -> ClassifierModel {
    let coefficients = &model.classifier.coefficients;
    let (weights, absences) = coefficients[1..].split_at(Feature::MODEL_FEATURES.len());
    ClassifierModel {
        penalty: model.classifier.ridge,
        intercept: coefficients[0],
        weights: reads.iter().map(|&j| weights[j]).collect(),
        absence_weights: absences.to_vec(),
        slope: model.calibration.slope,
        shift: model.calibration.shift,
    }
}
