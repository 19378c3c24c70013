//! Verdicts as plain values.

use crate::analysis::classification::Accuracy;
use crate::analysis::thickening::Extent;

use super::features::Features;

/// What verdicts read of one heart.
#[derive(Clone, Debug, PartialEq)]
pub struct Examined {
    /// What the rule reads, and what else describes the heart.
    pub features: Features,
    /// What the whole wall does.
    pub extent: Extent,
    /// Share of the wall in patches, 0..=1.
    pub patched: f64,
}

/// Why nothing is said of a heart.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotAssessed {
    /// There is no wall, there are too few frames …: what the thickening says.
    #[error("{0}")]
    NoThickening(String),
    /// The wall loses volume that muscle cannot lose.
    #[error(
        "the wall is not resolved: at end-systole it has {:.0} % of its volume at end-diastole, and muscle keeps \
         nearly all of it; blur hides thickening",
        100.0 * share
    )]
    WallNotResolved {
        /// Volume at end-systole over that at end-diastole.
        share: f64,
    },
    /// Noise is as large as what is looked for.
    #[error(
        "the wall is not resolved: noise of thickening, {:.0} %, is not small against the {:.0} % by which remote \
         myocardium thickens",
        100.0 * noise.exp_m1(),
        100.0 * well.exp_m1()
    )]
    Noise {
        /// Standard deviation of averaged thickening, in ln PT.
        noise: f64,
        /// Thickening of the part that works best, in ln PT.
        well: f64,
    },
    /// A feature is not a finite number.
    #[error("{feature} is not a finite number")]
    NotFinite {
        /// Its name.
        feature: &'static str,
    },
}

/// What was found in a heart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Finding {
    /// Thickens as normal hearts do.
    Nothing,
    /// A part of the wall does not thicken.
    Patch,
    /// The whole wall hardly thickens, or thickens too little without a part that stands out.
    GlobalFailure,
    /// Unlike the normal hearts, but the wall thickens and no part of it stands still.
    Elsewhere,
}

impl Finding {
    /// In words, as tables and views say it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "no regional abnormality",
            Self::Patch => "abnormal patch",
            Self::GlobalFailure => "global hypokinesia",
            Self::Elsewhere => "abnormal without a patch",
        }
    }

    /// In files, where scripts rely on it.
    pub fn key(self) -> &'static str {
        match self {
            Self::Nothing => "no abnormal patch",
            Self::Patch => "abnormal patch",
            Self::GlobalFailure => "global failure",
            Self::Elsewhere => "abnormal without a patch",
        }
    }
}

/// How near a heart lies to those that the rule was made of, by the rule's standardised features.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Familiarity {
    /// Distance to the nearest heart that the rule has seen, itself left out.
    pub distance: f64,
    /// Median of the same distance among the hearts that it has seen.
    pub usual: f64,
    /// Share of these that lie at least as far from the others: near 0, the heart is unlike any that was seen.
    pub as_far: f64,
}

/// What is said of one heart.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// What was found.
    pub finding: Finding,
    /// Whether the probability is above one half.
    pub abnormal: bool,
    /// That the heart counts as abnormal, if either were as likely beforehand. By a rule that was made without it where
    /// it has a label; not calibrated where [`Verdicts::rule`] says so.
    pub probability: f64,
    /// What the rule saw, and what else describes the heart.
    pub features: Features,
    /// Share of the wall in patches, 0..=1, whatever was found: a part that thickens little is no finding by itself.
    pub patched: f64,
    /// The three most alike hearts with a normal label, nearest first, by the rule's standardised features.
    pub alike_normal: Vec<usize>,
    /// The three most alike with an abnormal label.
    pub alike_abnormal: Vec<usize>,
    /// How near it lies to what the rule has seen; `None` for a rule that has seen nothing.
    pub familiarity: Option<Familiarity>,
}

/// Where the rule comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RuleSource {
    /// From the labelled hearts, each left out in turn.
    Cohort {
        /// Assessed hearts with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
    },
    /// Fixed beforehand, since too few hearts with a label could be assessed: the number is an order, no probability.
    Uncalibrated {
        /// Assessed hearts with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
    },
}

/// How good the rule is on the hearts with labels, each left out in turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RuleQuality {
    /// Right answers beside those with permuted labels. Both classes weigh alike in the rule: where one is much more
    /// frequent, always saying that one may be right as often.
    pub accuracy: Accuracy,
    /// Normal hearts called abnormal.
    pub false_alarms: usize,
    /// Abnormal hearts called normal.
    pub missed: usize,
    /// Area under the ROC curve: chance that an abnormal heart has a higher score than a normal one.
    pub auc: f64,
    /// Its mean where labels are permuted. Leaving out pulls it below one half.
    pub auc_baseline: f64,
    /// Share of permutations at least as good, those labels that are one of them.
    pub auc_p_value: f64,
}

/// What is said of all hearts of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdicts {
    /// One per subject, in their order.
    pub subjects: Vec<Result<Verdict, NotAssessed>>,
    /// Where the rule comes from.
    pub rule: RuleSource,
    /// How good it is; `None` where it was not learnt.
    pub quality: Option<RuleQuality>,
}
