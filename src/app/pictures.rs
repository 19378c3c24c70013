//! Hearts made ready for drawing, in the background, and kept as long as memory allows.

use std::convert::Infallible;
use std::sync::Arc;

use crate::engine::{Job, Wake, Workers};
use crate::picture::{CohortLimits, HeartFrame, PreparedSubject, fitted_camera};
use crate::render::Camera;
use crate::study::{Revision, Study, Subject};

use super::in_betweens::InBetweens;
use super::medial_pictures::MedialPictures;

/// Hearts are let go of, least recently drawn first, while all together have more vertices than
/// this over all frames: about 600 MB.
const MOST_VERTEX_FRAMES: usize = 16_000_000;

/// A heart ready for drawing, with where it lies.
#[derive(Debug)]
pub struct Heart {
    /// Its geometry and colour values.
    pub prepared: PreparedSubject,
    /// Where it lies in the world.
    pub frame: HeartFrame,
}

impl Heart {
    /// A camera with this rotation that has all frames in view.
    pub fn fitted(&self, world_from_camera: glam::Quat, aspect: f32) -> Camera {
        fitted_camera(self.prepared.all_positions(), world_from_camera, aspect)
    }
}

#[derive(Debug)]
struct Kept {
    key: HeartKey,
    heart: Arc<Heart>,
    vertex_frames: usize,
}

/// What a heart is made from.
#[derive(Clone, Debug)]
struct HeartKey {
    subject: Arc<Subject>,
    reference_frame: usize,
    in_betweens: Option<Arc<InBetweens>>,
}

impl HeartKey {
    fn is(&self, other: &Self) -> bool {
        let same_poses = match (&self.in_betweens, &other.in_betweens) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (None, None) => true,
            _ => false,
        };
        same_poses
            && Arc::ptr_eq(&self.subject, &other.subject)
            && self.reference_frame == other.reference_frame
    }

    fn vertex_frames(&self) -> usize {
        let sequence = &self.subject.sequence;
        sequence.vertex_count() * sequence.frame_count()
            + self.in_betweens.as_ref().map_or(0, |beat| beat.vertices())
    }

    fn heart(&self) -> Heart {
        let between = self.in_betweens.as_ref();
        let between = between.map_or_else(Vec::new, |beat| beat.inner_poses());
        let prepared =
            PreparedSubject::with_in_betweens(&self.subject, self.reference_frame, &between);
        let frame = HeartFrame::of(&prepared);
        Heart { prepared, frame }
    }
}

#[derive(Debug)]
struct Making {
    key: HeartKey,
    job: Job<Heart, Infallible>,
    wanted: bool,
}

#[derive(Debug)]
struct Limits {
    key: (Revision, Vec<usize>),
    value: Option<CohortLimits>,
    job: Option<Job<CohortLimits, Infallible>>,
}

/// All hearts that are ready or being made ready.
pub struct Pictures {
    /// Medial surfaces of these hearts.
    pub walls: MedialPictures,
    // Jobs stand before the threads: dropped first, which stops what still runs.
    making: Vec<Making>,
    kept: Vec<Kept>,
    limits: Option<Limits>,
    latest_limits: CohortLimits,
    threads: Workers,
    wake: Wake,
}

impl Pictures {
    /// Starts the threads.
    ///
    /// # Errors
    /// If the operating system refuses a thread.
    pub fn start(wake: Wake) -> std::io::Result<Self> {
        Ok(Self {
            walls: MedialPictures::start(Arc::clone(&wake))?,
            making: Vec::new(),
            kept: Vec::new(),
            limits: None,
            latest_limits: CohortLimits::default(),
            threads: Workers::start("picture", 2)?,
            wake,
        })
    }

    /// Takes in hearts that became ready; says what broke. Call once a frame, before requests.
    pub fn poll(&mut self) -> Vec<String> {
        let mut problems = self.walls.poll();
        let mut ready = Vec::new();
        self.making.retain_mut(|making| match making.job.poll() {
            None => true,
            Some(Ok(heart)) => {
                ready.push(Kept {
                    vertex_frames: making.key.vertex_frames(),
                    key: making.key.clone(),
                    heart: Arc::new(heart),
                });
                false
            }
            Some(Err(error)) => {
                problems.push(error.to_string());
                false
            }
        });
        self.kept.append(&mut ready);
        self.let_go();
        if let Some(limits) = &mut self.limits
            && let Some(outcome) = limits.job.as_mut().and_then(Job::poll)
        {
            limits.job = None;
            match outcome {
                Ok(value) => {
                    limits.value = Some(value);
                    self.latest_limits = value;
                }
                Err(error) => problems.push(error.to_string()),
            }
        }
        problems
    }

    /// The heart, if it is ready; else it is begun. Cheap every frame.
    pub fn heart(&mut self, subject: &Arc<Subject>, reference_frame: usize) -> Option<Arc<Heart>> {
        self.heart_of(HeartKey {
            subject: Arc::clone(subject),
            reference_frame,
            in_betweens: None,
        })
    }

    /// The heart with poses between its frames; while it is being made, the heart without them.
    pub fn heart_between(
        &mut self,
        subject: &Arc<Subject>,
        reference_frame: usize,
        in_betweens: Option<&Arc<InBetweens>>,
    ) -> Option<Arc<Heart>> {
        let whole = in_betweens.and_then(|beat| {
            self.heart_of(HeartKey {
                subject: Arc::clone(subject),
                reference_frame,
                in_betweens: Some(Arc::clone(beat)),
            })
        });
        whole.or_else(|| self.heart(subject, reference_frame))
    }

    fn heart_of(&mut self, key: HeartKey) -> Option<Arc<Heart>> {
        let place = self.kept.iter().position(|kept| kept.key.is(&key));
        if let Some(place) = place {
            // The most recently drawn stands last.
            let kept = self.kept.remove(place);
            let heart = Arc::clone(&kept.heart);
            self.kept.push(kept);
            return Some(heart);
        }
        let running = self.making.iter_mut().find(|making| making.key.is(&key));
        if let Some(making) = running {
            making.wanted = true;
            return None;
        }
        let work = key.clone();
        let job = Job::spawn(&self.threads, Arc::clone(&self.wake), move |_| {
            Ok(work.heart())
        });
        self.making.push(Making {
            key,
            job,
            wanted: true,
        });
        None
    }

    /// Drops work that nobody asked for since the last call.
    pub fn drop_unwanted(&mut self) {
        self.making
            .retain_mut(|making| std::mem::take(&mut making.wanted));
        self.walls.drop_unwanted();
    }

    /// The fixed colour ranges of a study; the ones before while new ones are computed.
    pub fn cohort_limits(
        &mut self,
        study: &Arc<Study>,
        reference_frames: &[usize],
    ) -> CohortLimits {
        let same = self.limits.as_ref().is_some_and(|limits| {
            limits.key.0 == study.revision && limits.key.1 == reference_frames
        });
        if !same {
            let (study, frames) = (Arc::clone(study), reference_frames.to_vec());
            self.limits = Some(Limits {
                key: (study.revision, frames.clone()),
                value: None,
                job: Some(Job::spawn(
                    &self.threads,
                    Arc::clone(&self.wake),
                    move |_| Ok(CohortLimits::of(&study, &frames)),
                )),
            });
        }
        self.limits
            .as_ref()
            .and_then(|limits| limits.value)
            .unwrap_or(self.latest_limits)
    }

    /// Whether anything is being made ready.
    pub fn busy(&self) -> bool {
        !self.making.is_empty()
            || self.walls.busy()
            || self.limits.as_ref().is_some_and(|l| l.job.is_some())
    }

    fn let_go(&mut self) {
        let mut total: usize = self.kept.iter().map(|kept| kept.vertex_frames).sum();
        while total > MOST_VERTEX_FRAMES && self.kept.len() > 2 {
            total -= self.kept.remove(0).vertex_frames;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::subject_with_frames;
    use std::time::{Duration, Instant};

    fn pictures() -> Pictures {
        Pictures::start(Arc::new(|| ())).unwrap()
    }

    #[test]
    fn a_heart_is_made_once_and_then_kept() {
        let mut pictures = pictures();
        let subject = Arc::new(subject_with_frames("a", 3));
        let begin = Instant::now();
        let heart = loop {
            assert!(pictures.poll().is_empty());
            if let Some(heart) = pictures.heart(&subject, 0) {
                break heart;
            }
            assert!(begin.elapsed() < Duration::from_secs(5));
            std::hint::spin_loop();
        };
        assert_eq!(heart.prepared.frame_count, 3);
        assert!(heart.frame.middle.length() < 1e-3);
        let again = pictures.heart(&subject, 0).unwrap();
        assert!(Arc::ptr_eq(&heart, &again));
        assert!(!pictures.busy());
    }

    #[test]
    fn hearts_that_nobody_wants_any_more_are_dropped() {
        let mut pictures = pictures();
        let subject = Arc::new(subject_with_frames("a", 3));
        assert!(pictures.heart(&subject, 0).is_none());
        pictures.drop_unwanted();
        assert!(pictures.busy());
        pictures.drop_unwanted();
        assert!(!pictures.busy());
    }
}
