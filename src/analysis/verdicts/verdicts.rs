//! All steps in order: features, the classifier of the cohort, its answer for each subject, and its accuracy.

use crate::analysis::thickening::AKINETIC_PT;
use crate::progress::Progress;
use crate::study::Study;

use super::classification::Classification;
use super::cohort::Cohort;
use super::error::VerdictError;
use super::features::{Features, VerdictInput, wall_volume_ratio};
use super::params::CheckedVerdictParams;
use super::result::{ClassifierSource, Examined, NotAssessed, Verdicts};
use super::rule::CheckedRule;
use super::whole_heart::with_whole_hearts;

/// Thickening of remote myocardium, in standard deviations of averaged noise, or of the least that counts as
/// thickening: nearer to noise nothing is reported.
const SURE: f64 = 3.0;

/// Finding and probability of each subject.
///
/// 1. A subject is not assessed where it has no thickening, where its surfaces are those of no wall, where its wall loses volume that myocardium cannot lose, and where
///    noise of thickening is a third of what remote myocardium does or more.
/// 2. The rest is classified by a logistic classifier on [`super::Feature::MODEL_FEATURES`], standardised, both classes
///    weighing alike, trained on the subjects whose label is of class normal or abnormal. The verdict on a labelled
///    subject comes from a classifier trained without it, calibrated by the scores of the others. With too few labels
///    a default threshold stands in: an akinetic share of the wall of 5.5 %.
/// 3. An abnormal subject has a patch where thickening found one, unless its [`super::Feature::UpperRange`] is small: then
///    hypokinesia is global.
///
/// # Measured
/// Accuracy, AUC, kinds and the finding of each label on `acdc_walls` (100 subjects at end-diastole and end-systole; normal:
/// NOR; abnormal: MINF, DCM and HCM; RV takes no part), each labelled subject left out in turn, are printed by
/// `cargo test --release --test it infarctions_are_told -- --nocapture`; those of rules that are learnt on one half and applied to the other by
/// `tests/bench/rule_halves.py`.
///
/// For regional against global hypokinesia (MINF against DCM) 49 single numbers were tried: spread of thickening has AUC
/// 0.96, the upper range 0.95, the akinetic share 0.49, EF 0.88. The spread alone would call a small patch in an otherwise
/// normal wall a global hypokinesia; the upper range does not. The choice was made on these subjects, of which 20 make a
/// group: on others expect somewhat less.
///
/// # Errors
/// If the subjects are not those of the study, or on "stop".
pub fn verdicts(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<Verdicts, VerdictError> {
    progress.expect_steps(params.permutations as usize + 1);
    let told = examined;
    let examined = with_whole_hearts(study, examined)?;
    let cohort = Cohort::new(study, &examined);
    let trained = cohort.train(params, progress)?;
    let classified = Classification::new(&cohort, trained.as_ref(), None);
    let subjects = (examined.iter().zip(told).enumerate())
        .map(|(index, (subject, told))| match (subject, told) {
            // Default thresholds are about walls alone.
            (Ok(_), Err(reason)) if trained.is_none() => Err(reason.clone()),
            (Ok(subject), _) => Ok(classified.verdict(index, subject)),
            (Err(reason), _) => Err(reason.clone()),
        })
        .collect();
    let (normal, abnormal) = cohort.counts();
    Ok(Verdicts {
        subjects,
        classifier: match trained {
            Some(_) => ClassifierSource::Cohort { normal, abnormal },
            None => ClassifierSource::Uncalibrated { normal, abnormal },
        },
        quality: trained.and_then(|trained| trained.quality),
    })
}

/// The verdicts of a rule on all subjects of a study, whatever their labels.
///
/// # Errors
/// If the subjects are not those of the study.
pub fn verdicts_by_rule(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    rule: &CheckedRule,
) -> Result<Verdicts, VerdictError> {
    let examined: Vec<_> = (study.subjects.iter())
        .zip(with_whole_hearts(study, examined)?)
        .map(|(subject, examined)| match rule.not_comparable(subject) {
            Some(reason) if examined.is_ok() => Err(reason),
            _ => examined,
        })
        .collect();
    let cohort = Cohort::new(study, &examined);
    let classified = Classification::new(&cohort, Some(rule.trained()), Some(rule));
    let training = &rule.rule().training;
    Ok(Verdicts {
        subjects: (examined.iter().enumerate())
            .map(|(index, subject)| match subject {
                Ok(subject) => Ok(classified.verdict(index, subject)),
                Err(reason) => Err(reason.clone()),
            })
            .collect(),
        classifier: ClassifierSource::Rule {
            normal: training.normal,
            abnormal: training.abnormal,
        },
        quality: None,
    })
}

/// What [`verdicts`] reads of one subject; no atoms are needed any more, so that a cohort of any size can be classified.
///
/// # Errors
/// If the wall is not resolved, or a feature is not a number.
pub fn examine(
    heart: &VerdictInput<'_>,
    params: &CheckedVerdictParams,
) -> Result<Examined, NotAssessed> {
    let share = wall_volume_ratio(heart.beat, heart.thickening);
    // A wall without volume has no share of it, either.
    // Myocardium is incompressible: a wall that loses volume is not resolved, and its thickening is an artefact.
    if share.is_nan() || share < params.min_wall_volume {
        return Err(NotAssessed::WallNotResolved { share });
    }
    let (noise, remote) = (heart.thickening.averaged_noise, heart.thickening.remote);
    // With noise this large a normal wall looks uneven and an akinetic one may look normal.
    if SURE * noise > remote.max(AKINETIC_PT.ln()) {
        return Err(NotAssessed::Noise { noise, remote });
    }
    let features = Features::new(heart);
    match features.not_finite() {
        Some(feature) => Err(NotAssessed::NotFinite {
            feature: feature.name(),
        }),
        None => Ok(Examined {
            features,
            wall_thickening: Some(heart.thickening.wall_thickening),
            patched: (heart.thickening.patches.iter()).fold(0.0, |sum, patch| sum + patch.share),
        }),
    }
}
