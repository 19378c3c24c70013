//! Answers one request: the single place where questions meet the analysis.

use std::sync::Arc;

use crate::analysis::embedding::{EmbeddingError, embed};
use crate::analysis::measures::measure_study;
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances, pose_distances};
use crate::engine::cache::Cache;
use crate::engine::request::{
    AnalysisError, AnalysisOutcome, AnalysisRequest, PoseMap, PoseMapParams,
};
use crate::progress::Progress;
use crate::study::Study;

/// Share of a map's time that its distances take: some 95 % on 184 poses of 2,500 vertices.
const DISTANCE_SHARE: f32 = 0.95;

/// The map is a plane.
const MAP_DIMENSIONS: usize = 2;

/// Answers `request` on `study`, from `cache` if it was answered before.
///
/// A map computes its distances as a request of their own, so that another method of mapping
/// finds them in the cache. Same study, request and seed: the same bits with any number of threads.
///
/// # Errors
/// If it was asked to stop, or if the study cannot answer.
pub fn run(
    study: &Study,
    request: &AnalysisRequest,
    cache: &Cache,
    progress: &Progress,
) -> Result<AnalysisOutcome, AnalysisError> {
    if let Some(outcome) = cache.get(study.revision, request) {
        return Ok(outcome);
    }
    let outcome = match request {
        AnalysisRequest::Measures => {
            progress.begin_phase("measuring volumes", 0.0, 1.0);
            AnalysisOutcome::Measures(Arc::new(measure_study(study, progress)?))
        }
        AnalysisRequest::PoseDistances(params) => {
            progress.begin_phase("comparing poses", 0.0, 1.0);
            AnalysisOutcome::PoseDistances(Arc::new(distances(study, params, progress)?))
        }
        AnalysisRequest::PoseMap(params) => {
            AnalysisOutcome::PoseMap(Arc::new(pose_map(study, params, cache, progress)?))
        }
    };
    cache.put(study.revision, *request, outcome.clone());
    Ok(outcome)
}

fn pose_map(
    study: &Study,
    params: &PoseMapParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<PoseMap, AnalysisError> {
    let request = AnalysisRequest::PoseDistances(params.distances);
    let known = cache.get(study.revision, &request);
    let share = if known.is_some() { 0.0 } else { DISTANCE_SHARE };
    let distances = match known {
        Some(AnalysisOutcome::PoseDistances(distances)) => distances,
        _ => {
            progress.begin_phase("comparing poses", 0.0, share);
            let distances = Arc::new(distances(study, &params.distances, progress)?);
            let outcome = AnalysisOutcome::PoseDistances(Arc::clone(&distances));
            cache.put(study.revision, request, outcome);
            distances
        }
    };
    progress.begin_phase("laying out the map", share, 1.0);
    let embedding = embed(
        &distances.distances,
        params.method,
        MAP_DIMENSIONS,
        progress,
    )
    .map_err(map_error)?;
    Ok(PoseMap {
        distances,
        embedding,
    })
}

fn distances(
    study: &Study,
    params: &PoseDistanceParams,
    progress: &Progress,
) -> Result<PoseDistances, AnalysisError> {
    let params = params
        .check()
        .map_err(|error| AnalysisError::Unanswerable(error.to_string()))?;
    Ok(pose_distances(study, &params, progress)?)
}

fn map_error(error: EmbeddingError) -> AnalysisError {
    match error {
        EmbeddingError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::Unanswerable(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::MapMethod;
    use crate::progress::Stopped;
    use crate::study::built_in::{BuiltInParams, cohort};
    use crate::study::{Revision, Study};

    fn study() -> Study {
        let params = BuiltInParams {
            vertices: 200,
            ..BuiltInParams::default()
        };
        let whole = cohort(&params).unwrap().study;
        Study {
            subjects: whole.subjects[..4].to_vec(),
            revision: Revision(7),
            ..whole
        }
    }

    fn map(method: MapMethod) -> AnalysisRequest {
        AnalysisRequest::PoseMap(PoseMapParams {
            method,
            ..PoseMapParams::default()
        })
    }

    #[test]
    fn another_method_of_mapping_computes_no_distance_again() {
        let (study, cache, progress) = (study(), Cache::default(), Progress::default());
        let first = run(&study, &map(MapMethod::ClassicalMds), &cache, &progress).unwrap();
        let second = run(&study, &map(MapMethod::Smacof), &cache, &progress).unwrap();
        let (first, second) = (first.pose_map().unwrap(), second.pose_map().unwrap());
        assert!(Arc::ptr_eq(&first.distances, &second.distances));
        assert_ne!(first.embedding, second.embedding);
        assert_eq!(first.embedding.len(), 32);
    }

    #[test]
    fn the_same_question_brings_the_same_answer_back() {
        let (study, cache, progress) = (study(), Cache::default(), Progress::default());
        let ask = || run(&study, &AnalysisRequest::Measures, &cache, &progress).unwrap();
        let (first, second) = (ask(), ask());
        assert!(Arc::ptr_eq(
            first.measures().unwrap(),
            second.measures().unwrap()
        ));
        let edited = Study {
            revision: Revision(8),
            ..study.clone()
        };
        let third = run(&edited, &AnalysisRequest::Measures, &cache, &progress).unwrap();
        assert!(!Arc::ptr_eq(
            first.measures().unwrap(),
            third.measures().unwrap()
        ));
    }

    #[test]
    fn a_stopped_run_keeps_nothing() {
        let (study, cache, progress) = (study(), Cache::default(), Progress::default());
        progress.stop();
        for request in [AnalysisRequest::Measures, map(MapMethod::Smacof)] {
            let error = run(&study, &request, &cache, &progress).unwrap_err();
            assert_eq!(error, AnalysisError::Stopped(Stopped));
        }
        assert!(cache.is_empty());
    }

    #[test]
    fn settings_out_of_range_are_an_answer_in_words() {
        let mut params = PoseDistanceParams::default();
        params.metric.lambda = -1.0;
        let error = run(
            &study(),
            &AnalysisRequest::PoseDistances(params),
            &Cache::default(),
            &Progress::default(),
        )
        .unwrap_err();
        assert!(error.to_string().contains("-1"), "{error}");
    }
}
