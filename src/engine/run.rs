//! Answers one request: the single place where questions meet the analysis.

use std::sync::Arc;

use crate::analysis::embedding;
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
    let embedding = embed(&distances, params, progress)?;
    Ok(PoseMap {
        distances,
        embedding,
    })
}
