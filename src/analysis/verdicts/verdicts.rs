//! All steps in order: features, the classifier of the cohort, its answer for each subject, and its accuracy.

use crate::analysis::thickening::Extent;
use crate::progress::Progress;
use crate::study::checks::WallDoubt;
use crate::study::{Study, Subject};

use super::classifier::Standard;
use super::cohort::{Cohort, Trained};
use super::error::VerdictError;
use super::features::{Feature, Features, VerdictInput, wall_volume_ratio};
use super::logistic::sigmoid;
use super::params::CheckedVerdictParams;
use super::result::{ClassifierSource, Examined, Finding, NotAssessed, Verdict, Verdicts};
use super::similarity::{nearest_distances, nearest_rows, training_set_distance};

/// Thickening of remote myocardium, in standard deviations of averaged noise, or of the least that counts as
/// thickening: nearer to noise nothing is reported.
const SURE: f64 = 3.0;
/// ln PT that counts as thickening at all, PT = 1.1.
const MIN_THICKENING: f64 = 0.095_310_179_804_324_87;
/// Akinetic share at which the uncalibrated classifier is undecided: between the most of 20 normal subjects (5.0 %) and the
/// least of the built-in patches (5.9 %).
const AKINETIC_LIMIT: f64 = 0.055;
/// How far from there it is for odds of e to one.
const AKINETIC_SCALE: f64 = 0.01;
/// [`Feature::UpperRange`] below which an abnormal subject's hypokinesia is global: it is above in all 20 normal subjects, as in
/// 19 of 20 with infarction and all built-in subjects with a patch, and below in 15 of 20 dilated ones.
const REGIONAL_REACH: f64 = 0.65;
/// Most similar subjects that are shown.
const ALIKE: usize = 3;

/// Finding and probability of each subject.
///
/// 1. A subject is not assessed where it has no thickening, where its surfaces are those of no wall, where its wall loses volume that myocardium cannot lose, and where
///    noise of thickening is a third of what remote myocardium does or more.
/// 2. The rest is classified by a logistic classifier on [`Feature::MODEL_FEATURES`], standardised, both classes
///    weighing alike, trained on the subjects whose label is of class normal or abnormal. The verdict on a labelled
///    subject comes from a classifier trained without it, calibrated by the scores of the others. With too few labels
///    a default threshold stands in: an akinetic share of the wall of 5.5 %.
/// 3. An abnormal subject has a patch where thickening found one, unless its [`Feature::UpperRange`] is small: then
///    hypokinesia is global.
///
/// # Measured
/// On `acdc_walls`: 100 subjects at end-diastole and end-systole; normal: NOR; abnormal: MINF, DCM and HCM; RV takes no
/// part and is classified by the classifier of the others. Each labelled subject left out in turn; printed by the test `real_verdicts`.
///
/// | 20 subjects each | median PT | no patch | patch | global hypokinesia |
/// |---|---|---|---|---|
/// | HCM | 1.78 | 13 | 7 | 0 |
/// | NOR | 1.74 | 19 | 1 | 0 |
/// | RV | 1.61 | 11 | 8 | 1 |
/// | MINF | 1.26 | 0 | 19 | 1 |
/// | DCM | 1.19 | 1 | 5 | 14 |
///
/// Probability separates MINF from NOR with AUC 1.00; all abnormal labels from NOR with 0.91 (permuted labels: 0.46),
/// since most walls of HCM thicken well. 65 of 80 are classified correctly (permuted labels: 32, since an uninformative
/// classifier calls nobody abnormal; always saying abnormal: 60). Fifteen sets of features were tried for the classifier. All with the akinetic share have AUC 0.99 and more for MINF against NOR; compactness,
/// closeness, ANV and MP (4.4–4.7) alone have 0.88 and call 5 of 20 normal subjects abnormal: with two poses
/// there is no path to be steady. For regional against global hypokinesia (MINF against DCM) 49 single numbers were tried:
/// spread of thickening has AUC 0.96, the upper range 0.95, the akinetic share 0.49, EF 0.88. The spread alone
/// would call a small patch in an otherwise normal wall a global hypokinesia; the upper range does not.
/// Both choices were made on these subjects, of which 20 make a group: on others expect somewhat less.
///
/// # Errors
/// If the subjects are not those of the study, or on "stop".
pub fn verdicts(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<Verdicts, VerdictError> {
    if examined.len() != study.subjects.len() {
        return Err(VerdictError::Count {
            examined: examined.len(),
            subjects: study.subjects.len(),
        });
    }
    progress.expect_steps(params.permutations as usize + 1);
    let examined: Vec<Result<Examined, NotAssessed>> = (study.subjects.iter().zip(examined))
        .map(|(subject, examined)| match wall_in_doubt(subject) {
            Some(reason) if examined.is_ok() => Err(reason),
            _ => examined.clone(),
        })
        .collect();
    let cohort = Cohort::new(study, &examined);
    let trained = cohort.train(params, progress)?;
    let classified = Classification::new(&cohort, trained.as_ref());
    let subjects = (examined.iter().enumerate())
        .map(|(index, subject)| match subject {
            Ok(subject) => Ok(classified.verdict(index, subject)),
            Err(reason) => Err(reason.clone()),
        })
        .collect();
    let (normal, abnormal) = cohort.counts();
    Ok(Verdicts {
        subjects,
        classifier: match trained {
            Some(_) => ClassifierSource::Cohort { normal, abnormal },
            None => ClassifierSource::Uncalibrated { normal, abnormal },
        },
        quality: trained.map(|trained| trained.quality),
    })
}

/// Why there is no verdict on what lies between two surfaces: they do not lie in each other, or the outer one is
/// not that of the left ventricle alone.
pub fn wall_in_doubt(subject: &Subject) -> Option<NotAssessed> {
    WallDoubt::of(&subject.sequence, subject.unit)
        .map(|doubt| NotAssessed::WallInDoubt(doubt.sentence()))
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
    if SURE * noise > remote.max(MIN_THICKENING) {
        return Err(NotAssessed::Noise { noise, remote });
    }
    let features = Features::new(heart);
    match features.not_finite() {
        Some(feature) => Err(NotAssessed::NotFinite {
            feature: feature.name(),
        }),
        None => Ok(Examined {
            features,
            extent: heart.thickening.extent,
            patched: (heart.thickening.patches.iter()).fold(0.0, |sum, patch| sum + patch.share),
        }),
    }
}

/// What is needed for the verdict on each subject.
struct Classification<'a> {
    cohort: &'a Cohort,
    trained: Option<&'a Trained>,
    /// Standardised rows; empty where not assessed.
    standardised: Vec<Vec<f64>>,
    nearest_distances: Vec<f64>,
}

impl<'a> Classification<'a> {
    fn new(cohort: &'a Cohort, trained: Option<&'a Trained>) -> Self {
        let assessed: Vec<&[f64]> = cohort
            .rows
            .iter()
            .filter(|row| !row.is_empty())
            .map(Vec::as_slice)
            .collect();
        let standard = trained.map_or_else(
            // Without a classifier distances between subjects still need a common scale.
            || Standard::new(&assessed),
            |trained| trained.classifier.standard.clone(),
        );
        // In standard deviations, or the feature of the largest numbers would decide who is similar.
        let standardised: Vec<Vec<f64>> = cohort.rows.iter().map(|row| standard.of(row)).collect();
        let nearest_distances = trained.map_or_else(Vec::new, |trained| {
            nearest_distances(&standardised, &trained.training_set)
        });
        Self {
            cohort,
            trained,
            standardised,
            nearest_distances,
        }
    }

    fn probability(&self, index: usize, features: &Features) -> f64 {
        let Some(trained) = self.trained else {
            // Without labels nothing can be trained; the akinetic share with a default threshold stands in, and is
            // called a score.
            let akinetic = features.get(Feature::AkineticShare).unwrap_or(0.0);
            return sigmoid((akinetic - AKINETIC_LIMIT) / AKINETIC_SCALE);
        };
        match trained
            .training_set
            .binary_search(&self.cohort.copies.first_of(index))
        {
            // A subject in the training set, or a copy of one, gets the leave-one-out result; the classifier of all subjects was trained with its label.
            Ok(place) => trained.left_out.probabilities[place],
            Err(_) => {
                let score = trained.classifier.score(&self.cohort.rows[index]);
                trained.calibration.probability(score)
            }
        }
    }

    fn verdict(&self, index: usize, subject: &Examined) -> Verdict {
        let features = &subject.features;
        let probability = self.probability(index, features);
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
            finding: if abnormal {
                failure(features, subject.extent)
            } else {
                Finding::Nothing
            },
            abnormal,
            probability,
            similar_normal: nearest_rows(&self.cohort.normal),
            similar_abnormal: nearest_rows(&self.cohort.abnormal),
            training_set_distance: (self.trained).and_then(|trained| {
                training_set_distance(
                    &self.standardised,
                    self.cohort.copies.first_of(index),
                    &trained.training_set,
                    &self.nearest_distances,
                )
            }),
            features: features.clone(),
            patched: subject.patched,
        }
    }
}

/// What fails in an abnormal subject.
fn failure(features: &Features, extent: Extent) -> Finding {
    let reach = features.get(Feature::UpperRange).unwrap_or(0.0);
    match extent {
        // Nothing thickens: there is no remote myocardium that a region could be compared with.
        Extent::HardlyAnywhere => Finding::GlobalHypokinesia,
        // Before patches: a wall that fails as a whole often has a weakest part, which is no regional finding.
        _ if reach < REGIONAL_REACH => Finding::GlobalHypokinesia,
        Extent::AllButPatches => Finding::Patch,
        Extent::Everywhere => Finding::WithoutPatch,
    }
}
