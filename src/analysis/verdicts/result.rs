//! Verdicts as plain values.

use crate::analysis::classification::Accuracy;
use crate::analysis::thickening::WallThickening;

use super::feature::Feature;
use super::features::Features;

/// What a verdict needs of one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Examined {
    /// Model features, and what else describes the subject.
    pub features: Features,
    /// What the whole wall does; `None` of a subject without a wall, of which other features are left.
    pub wall_thickening: Option<WallThickening>,
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
    /// It is not like those that a classifier was trained on.
    #[error("not comparable: {0}")]
    NotComparable(String),
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
    /// As normal subjects are.
    Nothing,
    /// Abnormal, and a part of the wall does not thicken.
    AbnormalPatch,
    /// The whole wall hardly thickens, or thickens too little without a part that stands out.
    GlobalHypokinesia,
    /// Unlike the normal subjects, but the wall thickens and no part of it is akinetic.
    WithoutPatch,
}

impl Finding {
    /// In words, of a subject whose wall was assessed or not.
    pub fn words(self, wall: bool) -> &'static str {
        match (wall, self) {
            (true, _) => self.name(),
            (false, Self::Nothing) => "normal, wall not assessed",
            (false, _) => "abnormal, wall not assessed",
        }
    }

    /// In words, as tables and views say it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "no regional abnormality",
            Self::AbnormalPatch => "abnormal patch",
            Self::GlobalHypokinesia => "global hypokinesia",
            Self::WithoutPatch => "abnormal without a patch",
        }
    }
}

/// How near a subject lies to the training set, by the classifier's standardised features.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainingSetDistance {
    /// Distance to the nearest subject of the training set, itself left out; of a rule, which has no subjects, the root mean
    /// square distance from their mean.
    pub distance: f64,
    /// Median of the same distance within the training set.
    pub median: f64,
    /// Share of the training set that lies at least as far from the others: near 0, the subject is unlike all of it.
    pub as_far: f64,
}

/// One of the labels of the study, and how probable it is that it is the label of a subject.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelProbability {
    /// The label.
    pub label: String,
    /// Calibrated, one label against the rest, and scaled so that those of all labels have the sum 1.
    pub probability: f64,
}

/// What one feature has to do with a verdict.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reason {
    /// The feature.
    pub feature: Feature,
    /// What it adds to the log odds of abnormal, beside the mean of the training set.
    pub log_odds: f64,
}

/// The verdict on one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The verdict itself.
    pub finding: Finding,
    /// Whether the probability is above one half.
    pub abnormal: bool,
    /// Predicted probability that the subject is abnormal, for equal priors; leave-one-out where the classifier was trained
    /// on it.
    pub probability: f64,
    /// Model features, and what else describes the subject.
    pub features: Features,
    /// Share of the wall in patches, 0..=1, whatever the finding: a region of low thickening is no finding by itself.
    pub patched: f64,
    /// The three most similar subjects with a normal label, nearest first, by the classifier's standardised features.
    pub similar_normal: Vec<usize>,
    /// The three most similar with an abnormal label.
    pub similar_abnormal: Vec<usize>,
    /// How near it lies to the training set; `None` of one of its two subjects.
    pub training_set_distance: Option<TrainingSetDistance>,
    /// Whether its wall could be assessed; otherwise the verdict is by what is left, and says nothing of regions.
    pub wall: bool,
    /// Labels of the training set, the most probable first; empty where there are fewer than three.
    pub labels: Vec<LabelProbability>,
    /// The features that speak most for its class, the strongest first.
    pub reasons: Vec<Reason>,
    /// Model features outside the range that a rule has seen; empty without a rule.
    pub outside: Vec<Feature>,
}

impl Verdict {
    /// In words, as tables and views say it.
    pub fn words(&self) -> &'static str {
        self.finding.words(self.wall)
    }
}

/// Where the classifier comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum ClassifierSource {
    /// Trained on the labelled subjects, leave-one-out.
    Cohort {
        /// Assessed subjects with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
    },
    /// A classifier that was trained on another study.
    OtherStudy(AppliedClassifier),
}

/// Which rule makes the verdicts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AppliedClassifier {
    /// What it is called.
    pub name: String,
    /// Name of the study that it was trained on; empty where its file does not say.
    pub study: String,
    /// Normal subjects of that study.
    pub normal: usize,
    /// And abnormal ones.
    pub abnormal: usize,
    /// Area under the ROC curve there, leave-one-out.
    pub auc: Option<f64>,
    /// Of the classifier that ships with the program, which nobody asked for: normal and abnormal subjects with a label that can be
    /// assessed, too few to train a classifier on.
    pub labelled: Option<[usize; 2]>,
}

impl AppliedClassifier {
    /// `Classifier “built-in”, trained on 60 subjects of ACDC walls (20 normal, 40 abnormal), AUC 1.00 there`.
    pub fn words(&self) -> String {
        let Self {
            name,
            study,
            normal,
            abnormal,
            ..
        } = self;
        let of = match study.as_str() {
            "" => "another study",
            study => study,
        };
        let mut words = format!(
            "Classifier “{name}”, trained on {} subjects of {of} ({normal} normal, {abnormal} abnormal)",
            normal + abnormal
        );
        if let Some(auc) = self.auc {
            words += &format!(", AUC {auc:.2} there");
        }
        if let Some([normal, abnormal]) = self.labelled {
            words += &format!(
                "; too few labelled subjects here ({normal} normal, {abnormal} abnormal) to train one"
            );
        }
        words
    }
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
    /// How often the most probable label is right; `None` where there are fewer than three.
    pub labels: Option<LabelQuality>,
}

/// How often the most probable label is that of the study, leave-one-out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LabelQuality {
    /// Subjects whose most probable label is their own.
    pub correct: usize,
    /// Subjects with one of these labels.
    pub of: usize,
    /// As many have the most frequent label: always saying that would be right so often.
    pub largest_label: usize,
}

/// The verdicts on all subjects of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdicts {
    /// One per subject, in their order.
    pub subjects: Vec<Result<Verdict, NotAssessed>>,
    /// Where the classifier comes from.
    pub classifier: ClassifierSource,
    /// The features that it reads.
    pub features: Vec<Feature>,
    /// Its accuracy; `None` where it was not trained.
    pub quality: Option<ClassifierQuality>,
}
