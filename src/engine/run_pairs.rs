//! Answers about one heart's beat or about a pair of hearts: in-betweens, transfer, contributions.

use std::sync::Arc;

use crate::analysis::geodesics::{GeodesicParams, GeodesicPath, geodesic};
use crate::analysis::pose_distances::{PairError, PoseDistanceParams, PoseId, pair_contributions};
use crate::analysis::transport::{TransportError, TransportParams, transported_motion};
use crate::engine::cache::Cache;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisError, AnalysisRequest};
use crate::engine::run::run;
use crate::progress::{Progress, Stopped};
use crate::study::{MeshSequence, Study, Subject};

/// One path per interval, each a request of its own, beginning with the interval looked at: when
/// work is stopped or another interval is looked at, what was found stays.
pub(super) fn in_betweens(
    study: &Study,
    subject: usize,
    params: GeodesicParams,
    cache: &Cache,
    progress: &Progress,
) -> Result<AnalysisOutcome, AnalysisError> {
    let count = interval_count(&subject_of(study, subject)?.sequence);
    let mut paths: Vec<Option<Arc<GeodesicPath>>> = vec![None; count];
    for done in 0..count {
        let looked_at = cache.interval_looked_at();
        let next = (0..count)
            .map(|ahead| (looked_at + ahead) % count)
            .find(|&interval| paths[interval].is_none());
        let Some(interval) = next else { break };
        let share = |done: usize| done as f32 / count as f32;
        let part = progress.part("finding poses between frames", share(done), share(done + 1));
        let request = AnalysisRequest::Interval {
            subject,
            interval,
            params,
        };
        let outcome = run(study, &request, cache, &part)?;
        progress.check()?;
        paths[interval] = outcome.interval().cloned();
    }
    let paths: Option<Vec<Arc<GeodesicPath>>> = paths.into_iter().collect();
    let paths = paths.ok_or(AnalysisError::Stopped(Stopped))?;
    Ok(AnalysisOutcome::InBetweens(Arc::new(paths)))
}

/// Intervals between frames; the last frame of more than two runs into the first.
fn interval_count(sequence: &MeshSequence) -> usize {
    match sequence.frame_count() {
        0 | 1 => 0,
        2 => 1,
        frames => frames,
    }
}

/// The path of one interval; where work was stopped, the best so far.
pub(super) fn interval(
    study: &Study,
    subject: usize,
    interval: usize,
    params: &GeodesicParams,
    progress: &Progress,
) -> Result<GeodesicPath, AnalysisError> {
    progress.check()?;
    let params = params.check().map_err(AnalysisError::unanswerable)?;
    let sequence = &subject_of(study, subject)?.sequence;
    let next = (interval + 1) % sequence.frame_count();
    let ends = (sequence.pose(interval)).zip(sequence.pose(next));
    let Some((start, end)) = ends.filter(|_| interval < interval_count(sequence)) else {
        return Err(AnalysisError::Unanswerable(format!(
            "interval {interval} of a beat of {} frames",
            sequence.frame_count()
        )));
    };
    let faces = sequence.joined_faces();
    geodesic(&faces, &start, &end, &params, progress).map_err(AnalysisError::unanswerable)
}

pub(super) fn transfer(
    study: &Study,
    from: usize,
    onto: usize,
    params: &TransportParams,
    progress: &Progress,
) -> Result<MeshSequence, AnalysisError> {
    let params = params.check().map_err(AnalysisError::unanswerable)?;
    let (from, onto) = (subject_of(study, from)?, subject_of(study, onto)?);
    progress.begin_phase("carrying the beat over", 0.0, 1.0);
    transported_motion(from, onto, &params, progress).map_err(|error| match error {
        TransportError::Stopped(stopped) => AnalysisError::Stopped(stopped),
        other => AnalysisError::unanswerable(other),
    })
}

/// Share of each face in the squared distance of two poses.
pub(super) fn contribution(
    study: &Study,
    [a, b]: [PoseId; 2],
    distances: &PoseDistanceParams,
    progress: &Progress,
) -> Result<Vec<f64>, AnalysisError> {
    let params = distances.check().map_err(AnalysisError::unanswerable)?;
    let (first, second) = (subject_of(study, a.subject)?, subject_of(study, b.subject)?);
    progress.begin_phase("dividing a distance over faces", 0.0, 1.0);
    pair_contributions((first, a.frame), (second, b.frame), &params, progress).map_err(|error| {
        match error {
            PairError::Stopped(stopped) => AnalysisError::Stopped(stopped),
            other => AnalysisError::unanswerable(other),
        }
    })
}

pub(super) fn subject_of(study: &Study, index: usize) -> Result<&Subject, AnalysisError> {
    let subject = study.subjects.get(index).map(|subject| &**subject);
    subject.ok_or_else(|| {
        let count = study.subjects.len();
        AnalysisError::Unanswerable(format!("there is no subject {index} among {count}"))
    })
}
