//! Results that were computed before, keyed by what they answer.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::engine::activity::WorkKind;
use crate::engine::outcome::AnalysisOutcome;
use crate::engine::request::{AnalysisRequest, Reads};
use crate::engine::thickening::beat_bytes;
use crate::study::{Anatomy, Revision, ShapeKey, Study, Subject};
use crate::units::LengthUnit;

/// Most results kept of one kind of work. A few settings tried back and forth on one study are some
/// dozens, and a beat has an answer per interval.
const MOST_ENTRIES: usize = 128;

/// Most bytes kept of one kind of work; of all kinds together some 900 MB.
fn most_bytes(kind: WorkKind) -> usize {
    match kind {
        // All pairs of 4,000 poses are 64 MB.
        WorkKind::PoseMap => 256 << 20,
        // Atoms of 2,500 vertices at 25 frames are 5 MB; of 40,000, on the inner side of a wall, 70 MB.
        WorkKind::Medial => 192 << 20,
        // Three poses of 2,500 vertices in each of 25 intervals are 5 MB.
        WorkKind::InBetweens => 128 << 20,
        _ => 64 << 20,
    }
}

/// A bounded map from study state and request to the answer. Of each kind of work the answer used longest
/// ago goes first; going through the hearts of a cohort one by one pushes out no answer about all of them.
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
    hearts: Vec<HeartKey>,
    request: AnalysisRequest,
    outcome: AnalysisOutcome,
}

/// All that an answer about one heart can depend on, and that an edit can change.
#[derive(Clone, Copy, Debug, PartialEq)]
struct HeartKey {
    shape: ShapeKey,
    end_systole: Option<usize>,
    unit: LengthUnit,
    anatomy: Option<Anatomy>,
}

impl HeartKey {
    fn of(subject: &Subject) -> Self {
        Self {
            shape: subject.shape_key(),
            end_systole: subject.end_systole,
            unit: subject.unit,
            anatomy: subject.anatomy,
        }
    }

    /// Whether nothing has changed that an answer has read.
    fn agrees(&self, other: &Self, reads: Reads) -> bool {
        match reads {
            Reads::Surfaces => self.shape.sequence == other.shape.sequence,
            Reads::Shape => self.shape == other.shape,
            Reads::Heart => self == other,
        }
    }
}

impl Entry {
    fn answers(&self, study: &Study, request: &AnalysisRequest) -> bool {
        if self.request != *request {
            return false;
        }
        self.revision == study.revision
            || request.subjects().is_some_and(|subjects| {
                subjects.iter().all(|&index| {
                    let now = study.subjects.get(index).map(|s| HeartKey::of(s));
                    (now.zip(self.hearts.get(index)))
                        .is_some_and(|(now, then)| now.agrees(then, request.reads()))
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
        let shapes = entry.hearts.iter().map(|heart| heart.shape).collect();
        Some((shapes, entry.outcome.clone()))
    }

    /// Keeps an answer, and lets the oldest of its kind go if there are too many. An answer that is
    /// larger than all that may be kept of its kind is not kept.
    pub fn put(&self, study: &Study, request: AnalysisRequest, outcome: AnalysisOutcome) {
        let mut entries = self.lock();
        entries.retain(|entry| entry.revision != study.revision || entry.request != request);
        entries.push(Entry {
            revision: study.revision,
            hearts: study.subjects.iter().map(|s| HeartKey::of(s)).collect(),
            request,
            outcome,
        });
        let kind = request.kind();
        while too_much(&entries, kind)
            && let Some(oldest) = entries.iter().position(|e| e.request.kind() == kind)
        {
            entries.remove(oldest);
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

/// Whether more is held of a kind than may be. Atoms that several answers share count once.
fn too_much(entries: &[Entry], kind: WorkKind) -> bool {
    let mut count = 0;
    let mut bytes = 0;
    let mut beats = Vec::new();
    for entry in entries.iter().filter(|e| e.request.kind() == kind) {
        count += 1;
        bytes += entry.outcome.bytes();
        if let Some(beat) = entry.outcome.shared_beat()
            && !beats.contains(&Arc::as_ptr(beat))
        {
            beats.push(Arc::as_ptr(beat));
            bytes += beat_bytes(beat);
        }
    }
    count > MOST_ENTRIES || bytes > most_bytes(kind)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::metrics::MetricParams;
    use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams, PoseDistances};

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
