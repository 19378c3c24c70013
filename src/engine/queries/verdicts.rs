//! Verdicts on all subjects of a study: walls one after the other, then a classifier trained on the labels.

use std::sync::Arc;

use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::verdicts::{
    CheckedClassifier, CheckedVerdictParams, ClassifierFile, Examined, Feature, NotAssessed,
    VerdictInput, VerdictParams, Verdicts, examine, learn, verdicts,
};
use crate::engine::queries::thickening::WallThickeningQuery;
use crate::engine::store::{Answered, Context, Interrupted, Memory, Query, Urgency};
use crate::progress::Stopped;
use crate::report::thickening_words;

/// Share of the time of verdicts that the walls take.
const WALLS_SHARE: f32 = 0.95;

/// Settings of verdicts, from the surfaces on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictQuery {
    /// How walls are assessed.
    pub thickening: ThickeningSettings,
    /// How a verdict is made.
    pub verdicts: VerdictParams,
    /// Which rule makes it, in the place of the labels of the study.
    pub rule: Option<Arc<CheckedClassifier>>,
}

impl Query for VerdictQuery {
    type Answer = Verdicts;
    const TITLE: &'static str = "Verdicts";
    const FAILURE: Option<&'static str> = Some("Verdicts could not be computed");
    const URGENCY: Urgency = Urgency::Background;

    fn parameters(&self) -> String {
        let VerdictParams {
            permutations, seed, ..
        } = self.verdicts;
        let walls = thickening_words(&self.thickening);
        match &self.rule {
            Some(rule) => format!("{walls}; classifier “{}”", rule.name()),
            None => format!("{walls}; {permutations} permutations, seed {seed}"),
        }
    }

    /// A subject whose wall cannot be assessed is no error.
    fn run(&self, cx: &Context<'_>) -> Result<Verdicts, Interrupted> {
        let params = self.verdicts.check()?;
        let examined = self.examined(cx, &params)?;
        let part = cx.part("training the classifier", WALLS_SHARE, 1.0);
        let rule = self.rule.as_deref();
        Ok(verdicts(
            cx.study(),
            &examined,
            &params,
            rule,
            part.progress(),
        )?)
    }

    fn memory(verdicts: &Verdicts, memory: &mut Memory) {
        memory.own(size_of_val(&*verdicts.subjects));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

impl VerdictQuery {
    /// What a verdict reads of every wall of the study.
    fn examined(
        &self,
        cx: &Context<'_>,
        params: &CheckedVerdictParams,
    ) -> Result<Vec<Result<Examined, NotAssessed>>, Stopped> {
        let count = cx.study().subjects.len();
        (0..count)
            .map(|subject| {
                let share = |done: usize| WALLS_SHARE * done as f32 / count as f32;
                let part = cx.part("assessing walls", share(subject), share(subject + 1));
                let wall = WallThickeningQuery {
                    subject,
                    settings: self.thickening,
                };
                examined(&part.get(&wall), params)
            })
            .collect()
    }
}

/// The classifier that is trained on a study with these settings.
#[derive(Clone, Debug, PartialEq)]
pub struct TrainedClassifierQuery {
    /// How walls are assessed, and verdicts made.
    pub verdicts: VerdictQuery,
    /// Which model features it reads.
    pub features: Vec<Feature>,
}

impl TrainedClassifierQuery {
    /// A rule that reads all of them.
    pub fn new(verdicts: VerdictQuery) -> Self {
        Self {
            verdicts,
            features: Feature::MODEL_FEATURES.to_vec(),
        }
    }
}

impl Query for TrainedClassifierQuery {
    type Answer = ClassifierFile;
    const TITLE: &'static str = "Classifier trained on the study";
    const FAILURE: Option<&'static str> = Some("No classifier could be trained");
    const URGENCY: Urgency = Urgency::Background;

    fn parameters(&self) -> String {
        self.verdicts.parameters()
    }

    fn run(&self, cx: &Context<'_>) -> Result<ClassifierFile, Interrupted> {
        let params = self.verdicts.verdicts.check()?;
        let examined = self.verdicts.examined(cx, &params)?;
        let part = cx.part("training the classifier", WALLS_SHARE, 1.0);
        Ok(learn(
            cx.study(),
            &examined,
            &params,
            &self.features,
            part.progress(),
        )?)
    }

    fn memory(rule: &ClassifierFile, memory: &mut Memory) {
        memory.own(size_of_val(&*rule.features));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// What a verdict reads of the answer about one wall.
///
/// # Errors
/// If that was stopped.
pub fn examined(
    answer: &Answered<WallThickeningQuery>,
    params: &CheckedVerdictParams,
) -> Result<Result<Examined, NotAssessed>, Stopped> {
    match answer {
        Ok(wall) => {
            let input = VerdictInput {
                beat: &wall.beat,
                thickening: &wall.thickening,
            };
            Ok(examine(&input, params))
        }
        Err(Interrupted::Stopped) => Err(Stopped),
        Err(Interrupted::Failed(failure)) => {
            Ok(Err(NotAssessed::NoThickening(failure.to_string())))
        }
    }
}

#[cfg(test)]
mod tests;
