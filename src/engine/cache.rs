//! Results that were computed before, keyed by what they answer.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::AnalysisRequest;
use crate::study::{Revision, ShapeKey, Study};

/// Most results kept. A few settings tried back and forth on one study are some dozens, and a beat has
/// an answer per interval.
const MOST_ENTRIES: usize = 128;
/// Most bytes kept: all pairs of 4,000 poses are 64 MB.
const MOST_BYTES: usize = 256 << 20;

/// A bounded map from study state and request to the answer; the one used longest ago goes first.
///
/// Nothing in it is ever wrong: an edit makes another [`Revision`], under which nothing is found but
/// what depends on shapes that the edit left alone.
#[derive(Debug, Default)]
pub struct Cache {
    /// From the one used longest ago to the newest.
    entries: Mutex<Vec<Entry>>,
    /// The interval of the beat that somebody looks at. It changes the order in which intervals are
    /// computed and no answer.
    interval: AtomicUsize,
}

#[derive(Debug)]
struct Entry {
    revision: Revision,
    /// What the subjects of the study were known by.
    shapes: Vec<ShapeKey>,
    request: AnalysisRequest,
    outcome: AnalysisOutcome,
}

impl Entry {
    fn answers(&self, study: &Study, request: &AnalysisRequest) -> bool {
        if self.request != *request {
            return false;
        }
        self.revision == study.revision
            || request.subjects().is_some_and(|subjects| {
                subjects.iter().all(|&index| {
                    let now = study.subjects.get(index).map(|s| s.shape_key());
                    now.is_some() && now.as_ref() == self.shapes.get(index)
                })
            })
    }
}

impl Cache {
    /// The answer, if it was computed before and is still kept.
    pub fn get(&self, study: &Study, request: &AnalysisRequest) -> Option<AnalysisOutcome> {
        let mut entries = self.lock();
        let place = entries
            .iter()
            .position(|entry| entry.answers(study, request))?;
        let entry = entries.remove(place);
        let outcome = entry.outcome.clone();
        entries.push(entry);
        Some(outcome)
    }

    /// The newest answer to the same request on any state of the study, with what the subjects of
    /// that state were known by: for whoever can use a part of it.
    pub fn similar(&self, request: &AnalysisRequest) -> Option<(Vec<ShapeKey>, AnalysisOutcome)> {
        let entries = self.lock();
        let entry = entries.iter().rev().find(|e| e.request == *request)?;
        Some((entry.shapes.clone(), entry.outcome.clone()))
    }

    /// Keeps an answer, and lets the oldest go if there are too many. An answer that is larger
    /// than all that may be kept is not kept.
    pub fn put(&self, study: &Study, request: AnalysisRequest, outcome: AnalysisOutcome) {
        let mut entries = self.lock();
        entries.retain(|entry| entry.revision != study.revision || entry.request != request);
        entries.push(Entry {
            revision: study.revision,
            shapes: study.subjects.iter().map(|s| s.shape_key()).collect(),
            request,
            outcome,
        });
        let mut bytes: usize = entries.iter().map(|entry| entry.outcome.bytes()).sum();
        while entries.len() > MOST_ENTRIES || (bytes > MOST_BYTES && !entries.is_empty()) {
            bytes -= entries.remove(0).outcome.bytes();
        }
    }

    /// Says which interval of the beat is looked at.
    pub fn look_at_interval(&self, interval: usize) {
        self.interval.store(interval, Ordering::Relaxed);
    }

    /// The interval of the beat that is looked at.
    pub fn interval_looked_at(&self) -> usize {
        self.interval.load(Ordering::Relaxed)
    }

    /// How many answers are kept.
    pub fn len(&self) -> usize {
        self.lock().len()
    }

    /// Whether none is kept.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Entry>> {
        // Entries are whole at every moment, so a panic elsewhere leaves nothing half done.
        self.entries.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::metrics::MetricParams;
    use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams, PoseDistances};
    use std::sync::Arc;

    fn request(mu: f64) -> AnalysisRequest {
        AnalysisRequest::PoseDistances(PoseDistanceParams {
            metric: MetricParams {
                mu,
                ..MetricParams::default()
            },
            ..PoseDistanceParams::default()
        })
    }

    fn study(revision: u64) -> Study {
        Study {
            revision: Revision(revision),
            ..Study::default()
        }
    }

    fn outcome(size: usize) -> AnalysisOutcome {
        AnalysisOutcome::PoseDistances(Arc::new(PoseDistances {
            poses: Vec::new(),
            distances: DistanceMatrix::from_upper(size, vec![0.0; size * (size - 1) / 2]).unwrap(),
            left_out: Vec::new(),
        }))
    }

    #[test]
    fn an_answer_is_found_under_its_revision_and_request_only() {
        let cache = Cache::default();
        cache.put(&study(1), request(1.0), outcome(3));
        assert!(cache.get(&study(1), &request(1.0)).is_some());
        assert!(cache.get(&study(2), &request(1.0)).is_none());
        assert!(cache.get(&study(1), &request(2.0)).is_none());
    }

    #[test]
    fn what_was_used_longest_ago_goes_first() {
        let cache = Cache::default();
        for i in 0..MOST_ENTRIES {
            cache.put(&study(1), request(i as f64), outcome(2));
        }
        assert!(cache.get(&study(1), &request(0.0)).is_some());
        cache.put(&study(1), request(-1.0), outcome(2));
        assert_eq!(cache.len(), MOST_ENTRIES);
        assert!(cache.get(&study(1), &request(0.0)).is_some());
        assert!(cache.get(&study(1), &request(1.0)).is_none());
    }

    #[test]
    fn large_answers_are_bounded_in_bytes() {
        let cache = Cache::default();
        // 5,000 items are 100 MB: two fit, three do not.
        for i in 0..3 {
            cache.put(&study(1), request(f64::from(i)), outcome(5_000));
        }
        assert_eq!(cache.len(), 2);
        assert!(cache.get(&study(1), &request(0.0)).is_none());
    }
}
