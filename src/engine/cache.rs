//! Results that were computed before, keyed by what they answer.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::engine::request::{AnalysisOutcome, AnalysisRequest};
use crate::study::Revision;

/// Most results kept. A few settings tried back and forth on one study are a dozen at most.
const MOST_ENTRIES: usize = 16;
/// Most bytes kept: all pairs of 4,000 poses are 64 MB.
const MOST_BYTES: usize = 256 << 20;

/// A bounded map from study state and request to the answer; the one used longest ago goes first.
///
/// Nothing in it is ever wrong: an edit makes another [`Revision`], under which nothing is found.
#[derive(Debug, Default)]
pub struct Cache {
    /// From the one used longest ago to the newest.
    entries: Mutex<Vec<Entry>>,
}

#[derive(Debug)]
struct Entry {
    revision: Revision,
    request: AnalysisRequest,
    outcome: AnalysisOutcome,
}

impl Cache {
    /// The answer, if it was computed before and is still kept.
    pub fn get(&self, revision: Revision, request: &AnalysisRequest) -> Option<AnalysisOutcome> {
        let mut entries = self.lock();
        let place = entries
            .iter()
            .position(|entry| entry.revision == revision && entry.request == *request)?;
        let entry = entries.remove(place);
        let outcome = entry.outcome.clone();
        entries.push(entry);
        Some(outcome)
    }

    /// Keeps an answer, and lets the oldest go if there are too many. An answer that is larger
    /// than all that may be kept is not kept.
    pub fn put(&self, revision: Revision, request: AnalysisRequest, outcome: AnalysisOutcome) {
        let mut entries = self.lock();
        entries.retain(|entry| entry.revision != revision || entry.request != request);
        entries.push(Entry {
            revision,
            request,
            outcome,
        });
        let mut bytes: usize = entries.iter().map(|entry| entry.outcome.bytes()).sum();
        while entries.len() > MOST_ENTRIES || (bytes > MOST_BYTES && !entries.is_empty()) {
            bytes -= entries.remove(0).outcome.bytes();
        }
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
        })
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
        cache.put(Revision(1), request(1.0), outcome(3));
        assert!(cache.get(Revision(1), &request(1.0)).is_some());
        assert!(cache.get(Revision(2), &request(1.0)).is_none());
        assert!(cache.get(Revision(1), &request(2.0)).is_none());
    }

    #[test]
    fn what_was_used_longest_ago_goes_first() {
        let cache = Cache::default();
        for i in 0..MOST_ENTRIES {
            cache.put(Revision(1), request(i as f64), outcome(2));
        }
        assert!(cache.get(Revision(1), &request(0.0)).is_some());
        cache.put(Revision(1), request(-1.0), outcome(2));
        assert_eq!(cache.len(), MOST_ENTRIES);
        assert!(cache.get(Revision(1), &request(0.0)).is_some());
        assert!(cache.get(Revision(1), &request(1.0)).is_none());
    }

    #[test]
    fn large_answers_are_bounded_in_bytes() {
        let cache = Cache::default();
        // 5,000 items are 100 MB: two fit, three do not.
        for i in 0..3 {
            cache.put(Revision(1), request(f64::from(i)), outcome(5_000));
        }
        assert_eq!(cache.len(), 2);
        assert!(cache.get(Revision(1), &request(0.0)).is_none());
    }
}
