//! Verdicts on all hearts of a study, made of one heart after the other.

use crate::analysis::verdicts::{
    CheckedVerdictParams, Examined, NotAssessed, VerdictError, VerdictInput, VerdictParams,
    Verdicts, examine, verdicts,
};
use crate::engine::cache::Cache;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::engine::thickening::ThickeningSettings;
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

/// Verdicts on all hearts; a heart whose wall cannot be assessed is no error.
pub(super) fn study_verdicts(
    study: &Study,
    settings: &VerdictSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<Verdicts, AnalysisError> {
    let params = (settings.verdicts.check()).map_err(AnalysisError::unanswerable)?;
    let count = study.subjects.len();
    let hearts = (0..count)
        .map(|subject| {
            let share = |done: usize| WALLS_SHARE * done as f32 / count as f32;
            let part = progress.part("assessing walls", share(subject), share(subject + 1));
            let request = AnalysisRequest::Thickening {
                subject,
                params: settings.thickening,
            };
            examined(&run(study, &request, cache, &part), &params)
        })
        .collect::<Result<Vec<_>, Stopped>>()?;
    let part = progress.part("learning from labels", WALLS_SHARE, 1.0);
    judged(study, &hearts, &params, &part)
}

/// What a verdict reads of the answer about one heart.
///
/// # Errors
/// If that was stopped.
pub(super) fn examined(
    answer: &Result<AnalysisOutcome, AnalysisError>,
    params: &CheckedVerdictParams,
) -> Result<Result<Examined, NotAssessed>, Stopped> {
    match answer {
        Ok(outcome) => {
            let found = outcome.thickening().ok_or(Stopped)?;
            let heart = VerdictInput {
                beat: &found.beat,
                thickening: &found.thickening,
            };
            Ok(examine(&heart, params))
        }
        Err(AnalysisError::Stopped(stopped)) => Err(*stopped),
        Err(AnalysisError::Unanswerable(reason)) => {
            Ok(Err(NotAssessed::NoThickening(reason.clone())))
        }
    }
}

/// The verdicts on hearts that were examined.
pub(super) fn judged(
    study: &Study,
    hearts: &[Result<Examined, NotAssessed>],
    params: &CheckedVerdictParams,
    progress: &Progress,
) -> Result<Verdicts, AnalysisError> {
    verdicts(study, hearts, params, progress).map_err(|error| match error {
        VerdictError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

#[cfg(test)]
mod tests;
