//! Answers one request: the single place where questions meet the analysis.

use std::sync::Arc;

use crate::analysis::classification::{Classes, ClassifyError, classify};
use crate::analysis::deformations::{
    DeformationMap, DeformationMapError, deformation_distances, deformation_map,
};
use crate::analysis::embedding::{EmbeddingError, embed};
use crate::analysis::measures::measure_study;
use crate::analysis::pose_distances::{
    KnownDistances, PoseDistanceError, PoseDistanceParams, PoseDistances, pose_distances_knowing,
};
use crate::engine::cache::Cache;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisError, AnalysisRequest, PoseMap};
use crate::engine::settings::{ClassesSettings, DeformationMapSettings, PoseMapParams};
use crate::engine::{medial_map, run_pairs, thickening, thickness, verdicts};
use crate::progress::{Progress, Stopped};
use crate::study::Study;

/// Share of a map's time that its distances take: some 95 % on 184 poses of 2,500 vertices.
const DISTANCE_SHARE: f32 = 0.95;

/// Share of the time of a map of deformations that its map of poses takes.
const POSE_MAP_SHARE: f32 = 0.95;

/// Share of the time of telling classes apart that the map of deformations takes.
const DEFORMATION_MAP_SHARE: f32 = 0.8;

/// The map is a plane.
const MAP_DIMENSIONS: usize = 2;

/// Answers `request` on `study`, from `cache` if it was answered before.
///
/// What an answer is made of is a request of its own, so that another method of mapping finds its
/// distances, and another rule its map, in the cache. Same study, request and seed: the same bits
/// with any number of threads.
///
/// # Errors
/// If it was asked to stop, or if the study cannot answer.
pub fn run(
    study: &Study,
    request: &AnalysisRequest,
    cache: &Cache,
    progress: &Progress,
) -> Result<AnalysisOutcome, AnalysisError> {
    if let Some(outcome) = cache.get(study, request) {
        return Ok(outcome);
    }
    let outcome = match request {
        AnalysisRequest::Measures => {
            progress.begin_phase("measuring volumes", 0.0, 1.0);
            AnalysisOutcome::Measures(Arc::new(measure_study(study, progress)?))
        }
        AnalysisRequest::PoseDistances(params) => {
            progress.begin_phase("comparing poses", 0.0, 1.0);
            let distances = distances(study, params, cache, progress)?;
            AnalysisOutcome::PoseDistances(Arc::new(distances))
        }
        AnalysisRequest::PoseMap(params) => {
            AnalysisOutcome::PoseMap(Arc::new(pose_map(study, params, cache, progress)?))
        }
        AnalysisRequest::DeformationMap(settings) => {
            let map = map_of_deformations(study, settings, cache, progress)?;
            AnalysisOutcome::DeformationMap(Arc::new(map))
        }
        AnalysisRequest::Classes(settings) => {
            AnalysisOutcome::Classes(Arc::new(classes(study, settings, cache, progress)?))
        }
        AnalysisRequest::InBetweens { subject, params } => {
            run_pairs::in_betweens(study, *subject, *params, cache, progress)?
        }
        AnalysisRequest::Interval {
            subject,
            interval,
            params,
        } => {
            progress.begin_phase("finding poses between frames", 0.0, 1.0);
            let path = run_pairs::interval(study, *subject, *interval, params, progress)?;
            let stopped = path.stopped;
            let outcome = AnalysisOutcome::Interval(Arc::new(path));
            if stopped {
                // The best path so far, but not the answer.
                return Ok(outcome);
            }
            outcome
        }
        AnalysisRequest::Transfer { from, onto, params } => {
            let sequence = run_pairs::transfer(study, *from, *onto, params, progress)?;
            AnalysisOutcome::Transfer(Arc::new(sequence))
        }
        AnalysisRequest::Contribution { a, b, distances } => {
            let shares = run_pairs::contribution(study, [*a, *b], distances, progress)?;
            AnalysisOutcome::Contribution(Arc::new(shares))
        }
        AnalysisRequest::MedialBeat { subject, params } => {
            let beat = thickening::atoms(study, *subject, params, progress)?;
            AnalysisOutcome::MedialBeat(Arc::new(beat))
        }
        AnalysisRequest::Thickening { subject, params } => {
            let found = thickening::subject_thickening(study, *subject, params, cache, progress)?;
            AnalysisOutcome::Thickening(Arc::new(found))
        }
        AnalysisRequest::Verdicts(settings) => {
            let found = verdicts::study_verdicts(study, settings, cache, progress)?;
            AnalysisOutcome::Verdicts(Arc::new(found))
        }
        AnalysisRequest::MedialPaths(settings) => {
            let paths = medial_map::study_paths(study, settings, cache, progress)?;
            AnalysisOutcome::MedialPaths(Arc::new(paths))
        }
        AnalysisRequest::MedialMap(params) => {
            let map = medial_map::study_map(study, params, cache, progress)?;
            AnalysisOutcome::MedialMap(Arc::new(map))
        }
        AnalysisRequest::FrameThickness {
            subject,
            frame,
            params,
        } => {
            let found =
                thickness::frame_thickness(study, *subject, *frame, params, cache, progress)?;
            AnalysisOutcome::FrameThickness(Arc::new(found))
        }
    };
    cache.put(study, *request, outcome.clone());
    Ok(outcome)
}

fn distances(
    study: &Study,
    params: &PoseDistanceParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<PoseDistances, AnalysisError> {
    let checked = params.check().map_err(AnalysisError::unanswerable)?;
    let similar = cache.similar(&AnalysisRequest::PoseDistances(*params));
    let known = similar.as_ref().and_then(|(shapes, outcome)| {
        Some(KnownDistances {
            shapes,
            distances: outcome.pose_distances()?,
        })
    });
    let computed = pose_distances_knowing(study, &checked, known.as_ref(), progress);
    Ok(computed
        .map_err(|error| match error {
            PoseDistanceError::Stopped(stopped) => AnalysisError::Stopped(stopped),
            other => AnalysisError::unanswerable(other),
        })?
        .distances)
}

/// The distances of poses, as a request of their own.
fn distances_of(
    study: &Study,
    params: PoseDistanceParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<Arc<PoseDistances>, AnalysisError> {
    let outcome = run(
        study,
        &AnalysisRequest::PoseDistances(params),
        cache,
        progress,
    )?;
    let distances = outcome.pose_distances().cloned();
    distances.ok_or(AnalysisError::Stopped(Stopped))
}

fn pose_map(
    study: &Study,
    params: &PoseMapParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<PoseMap, AnalysisError> {
    let request = AnalysisRequest::PoseDistances(params.distances);
    let known = cache.get(study, &request).is_some();
    let share = if known { 0.0 } else { DISTANCE_SHARE };
    let comparing = progress.part("comparing poses", 0.0, share);
    let distances = distances_of(study, params.distances, cache, &comparing)?;
    progress.begin_phase("laying out the map", share, 1.0);
    let matrix = &distances.distances;
    let embedding = embed(matrix, params.method, MAP_DIMENSIONS, progress).map_err(map_error)?;
    Ok(PoseMap {
        distances,
        embedding,
    })
}

fn map_of_deformations(
    study: &Study,
    settings: &DeformationMapSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<DeformationMap, AnalysisError> {
    let params = settings.map.check().map_err(AnalysisError::unanswerable)?;
    let request = AnalysisRequest::PoseMap(settings.poses);
    let mapping = progress.part("mapping poses", 0.0, POSE_MAP_SHARE);
    let outcome = run(study, &request, cache, &mapping)?;
    let poses = outcome.pose_map().ok_or(AnalysisError::Stopped(Stopped))?;
    progress.begin_phase("laying out deformations", POSE_MAP_SHARE, 1.0);
    let rows = &poses.distances.poses;
    deformation_map(study, rows, &poses.embedding, &params, progress).map_err(|error| match error {
        DeformationMapError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

fn classes(
    study: &Study,
    settings: &ClassesSettings,
    cache: &Cache,
    progress: &Progress,
) -> Result<Classes, AnalysisError> {
    let params = settings
        .classes
        .check()
        .map_err(AnalysisError::unanswerable)?;
    let mapping = progress.part("mapping deformations", 0.0, DEFORMATION_MAP_SHARE);
    let request = AnalysisRequest::DeformationMap(settings.deformations);
    let outcome = run(study, &request, cache, &mapping)?;
    let map = outcome
        .deformation_map()
        .ok_or(AnalysisError::Stopped(Stopped))?;
    let telling = progress.part("telling classes apart", DEFORMATION_MAP_SHARE, 1.0);
    let poses = distances_of(
        study,
        settings.deformations.poses.distances,
        cache,
        &telling,
    )?;
    let deformations = deformation_distances(study, &poses, &telling)?;
    let labels: Vec<Option<&str>> = (deformations.subjects.iter())
        .map(|&index| study.subjects.get(index)?.label.as_deref())
        .collect();
    telling.begin_phase("telling classes apart", 0.0, 1.0);
    classify(
        &deformations.distances,
        &map.embedding,
        &labels,
        &params,
        &telling,
    )
    .map_err(|error| match error {
        ClassifyError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

fn map_error(error: EmbeddingError) -> AnalysisError {
    match error {
        EmbeddingError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    }
}

#[cfg(test)]
mod tests;
