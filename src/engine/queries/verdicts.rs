//! Verdicts on all subjects of a study: walls one after the other, then a classifier trained on the labels.

use crate::analysis::verdicts::{
    CheckedVerdictParams, Examined, NotAssessed, VerdictError, VerdictInput, VerdictParamError,
    VerdictParams, Verdicts, examine, verdicts,
};
use crate::engine::queries::thickening::{ThickeningSettings, WallThickening, thickening_words};
use crate::engine::store::{Answered, Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::progress::{Progress, Stopped};
use crate::study::Study;

/// Share of the time of verdicts that the walls take.
const WALLS_SHARE: f32 = 0.95;

/// Settings of verdicts, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VerdictSettings {
    /// How walls are assessed.
    pub thickening: ThickeningSettings,
    /// How a verdict is made.
    pub verdicts: VerdictParams,
}

/// Why there are no verdicts.
#[derive(Debug, thiserror::Error)]
pub enum VerdictsError {
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] VerdictParamError),
    /// No classifier can be trained.
    #[error(transparent)]
    Verdicts(VerdictError),
}

impl Query for VerdictSettings {
    type Answer = Verdicts;
    type Error = VerdictsError;
    const TITLE: &'static str = "Verdicts";
    const FAILURE: Option<&'static str> = Some("Verdicts could not be computed");
    const URGENCY: Urgency = Urgency::Background;

    fn parameters(&self) -> String {
        let VerdictParams {
            ridge,
            permutations,
            seed,
            ..
        } = self.verdicts;
        let walls = thickening_words(&self.thickening);
        format!("{walls}; ridge {ridge}, {permutations} permutations, seed {seed}")
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    /// A subject whose wall cannot be assessed is no error.
    fn run(&self, cx: &Context<'_>) -> Result<Verdicts, Interrupted<VerdictsError>> {
        let params = (self.verdicts.check()).map_err(|error| Interrupted::Failed(error.into()))?;
        let count = cx.study().subjects.len();
        let examined = (0..count)
            .map(|subject| {
                let share = |done: usize| WALLS_SHARE * done as f32 / count as f32;
                let part = cx.part("assessing walls", share(subject), share(subject + 1));
                let wall = WallThickening {
                    subject,
                    settings: self.thickening,
                };
                examined(&part.get(&wall), &params)
            })
            .collect::<Result<Vec<_>, Stopped>>()?;
        let part = cx.part("training the classifier", WALLS_SHARE, 1.0);
        verdicts_of(cx.study(), &examined, &params, part.progress())
    }

    fn memory(verdicts: &Verdicts, memory: &mut Memory) {
        memory.own(size_of_val(&*verdicts.subjects));
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
    answer: &Answered<WallThickening>,
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

/// The verdicts on subjects whose walls were examined.
///
/// # Errors
/// If stopped, or no classifier can be trained.
pub fn verdicts_of(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<Verdicts, Interrupted<VerdictsError>> {
    match verdicts(study, examined, params, progress) {
        Ok(verdicts) => Ok(verdicts),
        Err(VerdictError::Stopped(_)) => Err(Interrupted::Stopped),
        Err(error) => Err(Interrupted::Failed(VerdictsError::Verdicts(error))),
    }
}

#[cfg(test)]
mod tests;
