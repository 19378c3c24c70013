//! The map of poses of the medial shape space: paths of one heart after the other, then their map.

use crate::analysis::embedding::MapMethod;
use crate::analysis::medial_map::{
    MedialMap, MedialMapError, SubjectPaths, medial_map, subject_paths,
};
use crate::engine::cache::Cache;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::engine::thickening::ThickeningSettings;
use crate::progress::{Progress, Stopped};
use crate::study::Study;

/// Share of the map's time that the walls take; the rest is scaling.
const WALLS_SHARE: f32 = 0.97;

/// Settings of the map, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MedialMapParams {
    /// How walls are assessed, and what counts as still.
    pub thickening: ThickeningSettings,
    /// How distances become a map.
    pub method: MapMethod,
}

/// Per subject of a study, its paths in the medial shape space, or why it has none.
pub type StudyPaths = Vec<Result<SubjectPaths, String>>;

/// The paths of all hearts; a heart whose wall cannot be assessed is no error.
pub(super) fn study_paths(
    study: &Study,
    settings: &ThickeningSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<StudyPaths, AnalysisError> {
    let count = study.subjects.len();
    let hearts = (0..count)
        .map(|subject| {
            let [from, to] = [subject, subject + 1].map(|done| done as f32 / count as f32);
            let part = progress.part("assessing walls", from, to);
            let request = AnalysisRequest::Thickening {
                subject,
                params: *settings,
            };
            paths_of(&run(study, &request, cache, &part))
        })
        .collect::<Result<_, Stopped>>()?;
    Ok(hearts)
}

/// The paths that the answer about one heart holds. What is found in a wall that is not resolved would be blur
/// or noise.
///
/// # Errors
/// If that was stopped.
pub(super) fn paths_of(
    answer: &Result<AnalysisOutcome, AnalysisError>,
) -> Result<Result<SubjectPaths, String>, Stopped> {
    match answer {
        Ok(outcome) => {
            let found = outcome.thickening().ok_or(Stopped)?;
            if let Some(reason) = &found.not_assessed {
                return Ok(Err(reason.to_string()));
            }
            let paths = subject_paths(&found.beat, &found.thickening, found.axis.as_ref());
            Ok(paths.map_err(|reason| reason.to_string()))
        }
        Err(AnalysisError::Stopped(stopped)) => Err(*stopped),
        Err(AnalysisError::Unanswerable(reason)) => Ok(Err(reason.clone())),
    }
}

/// The map, with its paths as a request of their own: another method of mapping assesses no wall again.
pub(super) fn study_map(
    study: &Study,
    params: &MedialMapParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<MedialMap, AnalysisError> {
    let request = AnalysisRequest::MedialPaths(params.thickening);
    let known = cache.get(study, &request).is_some();
    let share = if known { 0.0 } else { WALLS_SHARE };
    let part = progress.part("assessing walls", 0.0, share);
    let outcome = run(study, &request, cache, &part)?;
    let paths = outcome
        .medial_paths()
        .ok_or(AnalysisError::Stopped(Stopped))?;
    let part = progress.part("laying out the map", share, 1.0);
    map_of(paths, params.method, &part)
}

/// The map of paths that are at hand.
pub(super) fn map_of(
    paths: &StudyPaths,
    method: MapMethod,
    progress: &Progress,
) -> Result<MedialMap, AnalysisError> {
    medial_map(paths, method, progress).map_err(|error| match error {
        MedialMapError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

/// Memory that paths hold.
pub(super) fn paths_bytes(paths: &StudyPaths) -> usize {
    let of_heart = |heart: &Result<SubjectPaths, String>| match heart {
        Ok(heart) => heart
            .paths
            .iter()
            .map(|path| size_of_val(&*path.steps))
            .sum(),
        Err(reason) => reason.len(),
    };
    size_of_val(&**paths) + paths.iter().map(of_heart).sum::<usize>()
}

/// Memory that a map holds.
pub(super) fn map_bytes(map: &MedialMap) -> usize {
    size_of_val(&*map.poses)
        + size_of_val(map.distances.upper())
        + size_of_val(&*map.embedding.coordinates)
        + size_of_val(&*map.spreads)
}

#[cfg(test)]
mod tests;
