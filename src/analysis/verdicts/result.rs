//! Verdicts as plain values.

use crate::analysis::classification::Accuracy;
use crate::analysis::thickening::Extent;

use super::features::Features;

/// What a verdict needs of one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct Examined {
    /// Model features, and what else describes the subject.
    pub features: Features,
    /// What the whole wall does.
    pub extent: Extent,
    /// Share of the wall in patches, 0..=1.
    pub patched: f64,
}

/// Why a subject is not assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotAssessed {
    /// There is no wall, there are too few frames …: what the thickening says.
    #[error("{0}")]
    NoThickening(String),
    /// The wall loses volume that myocardium cannot lose.
    #[error(
        "the wall is not resolved: at end-systole it has {:.0} % of its volume at end-diastole, but \
         myocardium is nearly incompressible; blur hides thickening",
        100.0 * share
    )]
    WallNotResolved {
        /// Volume at end-systole over that at end-diastole.
        share: f64,
    },
    /// What lies between the surfaces is no wall of a left ventricle: what the check of both surfaces says.
    #[error("{0}")]
    WallInDoubt(String),
    /// Noise is as large as what is looked for.
    #[error(
        "the wall is not resolved: noise of thickening, {:.0} %, is not small against the {:.0} % by which remote \
         myocardium thickens",
        100.0 * noise.exp_m1(),
        100.0 * remote.exp_m1()
    )]
    Noise {
        /// Standard deviation of averaged thickening, in ln PT.
        noise: f64,
        /// Thickening of remote myocardium, in ln PT.
        remote: f64,
    },
    /// A feature is not a finite number.
    #[error("{feature} is not a finite number")]
    NotFinite {
        /// Its name.
        feature: &'static str,
    },
}

/// What the classifier and the patch detection say together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Finding {
    /// Thickens as normal subjects do.
    Nothing,
    /// A part of the wall does not thicken.
    Patch,
    /// The whole wall hardly thickens, or thickens too little without a part that stands out.
    GlobalHypokinesia,
    /// Unlike the normal subjects, but the wall thickens and no part of it is akinetic.
    WithoutPatch,
}

impl Finding {
    /// In words, as tables and views say it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "no regional abnormality",
            Self::Patch => "abnormal patch",
            Self::GlobalHypokinesia => "global hypokinesia",
            Self::WithoutPatch => "abnormal without a patch",
        }
    }
}

/// How near a subject lies to the training set, by the classifier's standardised features.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainingSetDistance {
    /// Distance to the nearest subject of the training set, itself left out.
    pub distance: f64,
    /// Median of the same distance within the training set.
    pub median: f64,
    /// Share of the training set that lies at least as far from the others: near 0, the subject is unlike all of it.
    pub as_far: f64,
}

/// The verdict on one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Its kind.
    pub finding: Finding,
    /// Whether the probability is above one half.
    pub abnormal: bool,
    /// Predicted probability that the subject is abnormal, for equal priors; leave-one-out where it has a label, and
    /// an uncalibrated score where [`Verdicts::classifier`] says so.
    pub probability: f64,
    /// Model features, and what else describes the subject.
    pub features: Features,
    /// Share of the wall in patches, 0..=1, whatever the finding: a region of low thickening is no finding by itself.
    pub patched: f64,
    /// The three most similar subjects with a normal label, nearest first, by the classifier's standardised features.
    pub similar_normal: Vec<usize>,
    /// The three most similar with an abnormal label.
    pub similar_abnormal: Vec<usize>,
    /// How near it lies to the training set; `None` for default thresholds, which have none.
    pub training_set_distance: Option<TrainingSetDistance>,
}

/// Where the classifier comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClassifierSource {
    /// Trained on the labelled subjects, leave-one-out.
    Cohort {
        /// Assessed subjects with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
    },
    /// Default thresholds, since too few subjects with a label could be assessed: the number is an uncalibrated score.
    Uncalibrated {
        /// Assessed subjects with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
    },
}

/// Accuracy of the classifier on the labelled subjects, leave-one-out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassifierQuality {
    /// Accuracy beside that with permuted labels. Both classes weigh alike in the classifier: where one is much more
    /// frequent, always saying that one may be right as often.
    pub accuracy: Accuracy,
    /// Normal subjects classified as abnormal.
    pub false_positives: usize,
    /// Abnormal subjects classified as normal.
    pub false_negatives: usize,
    /// Area under the ROC curve: probability that an abnormal subject has a higher score than a normal one.
    pub auc: f64,
    /// Its permutation mean; leave-one-out pulls it below one half.
    pub auc_baseline: f64,
    /// Share of permutations at least as good, those labels that are one of them.
    pub auc_p_value: f64,
}

/// The verdicts on all subjects of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdicts {
    /// One per subject, in their order.
    pub subjects: Vec<Result<Verdict, NotAssessed>>,
    /// Where the classifier comes from.
    pub classifier: ClassifierSource,
    /// Its accuracy; `None` where it was not trained.
    pub quality: Option<ClassifierQuality>,
}
