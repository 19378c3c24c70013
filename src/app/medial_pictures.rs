//! Medial surfaces made ready for drawing, in the background, and kept for the hearts seen lately.

use std::convert::Infallible;
use std::sync::Arc;

use crate::analysis::medial::MedialBeat;
use crate::engine::{Job, SubjectThickening, Wake, Workers};
use crate::picture::PreparedMedial;
use crate::study::Subject;

/// Medial surfaces kept: two side by side, and those one steps back to.
const MOST_KEPT: usize = 8;

#[derive(Clone, Debug)]
struct Key {
    subject: Arc<Subject>,
    beat: Arc<MedialBeat>,
    end_diastole: usize,
}

impl Key {
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.subject, &other.subject)
            && Arc::ptr_eq(&self.beat, &other.beat)
            && self.end_diastole == other.end_diastole
    }
}

struct Making {
    key: Key,
    job: Job<PreparedMedial, Infallible>,
    wanted: bool,
}

/// A medial surface on screen: the drawn one, and what was found on it.
#[derive(Clone, Debug)]
pub struct ShownMedial {
    /// Ready for drawing.
    pub prepared: Arc<PreparedMedial>,
    /// What was found.
    pub found: Arc<SubjectThickening>,
}

/// All medial surfaces that are ready or being made ready.
pub struct MedialPictures {
    // Jobs stand before the thread: dropped first, which stops what still runs.
    making: Vec<Making>,
    kept: Vec<(Key, Arc<PreparedMedial>)>,
    threads: Workers,
    wake: Wake,
}

impl MedialPictures {
    /// Starts the thread.
    ///
    /// # Errors
    /// If the operating system refuses it.
    pub fn start(wake: Wake) -> std::io::Result<Self> {
        Ok(Self {
            making: Vec::new(),
            kept: Vec::new(),
            threads: Workers::start("wall picture", 1)?,
            wake,
        })
    }

    /// Takes in what became ready; says what broke.
    pub fn poll(&mut self) -> Vec<String> {
        let mut problems = Vec::new();
        let kept = &mut self.kept;
        self.making.retain_mut(|making| match making.job.poll() {
            None => true,
            Some(Ok(prepared)) => {
                kept.push((making.key.clone(), Arc::new(prepared)));
                false
            }
            Some(Err(error)) => {
                problems.push(error.to_string());
                false
            }
        });
        while self.kept.len() > MOST_KEPT {
            self.kept.remove(0);
        }
        problems
    }

    /// The medial surface of a heart, if it is ready; else it is begun. Cheap every frame.
    pub fn medial(
        &mut self,
        subject: &Arc<Subject>,
        found: &Arc<SubjectThickening>,
    ) -> Option<ShownMedial> {
        let key = Key {
            subject: Arc::clone(subject),
            beat: Arc::clone(&found.beat),
            end_diastole: found.thickening.end_diastole,
        };
        if let Some(place) = self.kept.iter().position(|(kept, _)| kept.is(&key)) {
            // The most recently drawn stands last.
            let kept = self.kept.remove(place);
            let prepared = Arc::clone(&kept.1);
            self.kept.push(kept);
            return Some(ShownMedial {
                prepared,
                found: Arc::clone(found),
            });
        }
        if let Some(making) = self.making.iter_mut().find(|making| making.key.is(&key)) {
            making.wanted = true;
            return None;
        }
        let work = key.clone();
        let job = Job::spawn(&self.threads, Arc::clone(&self.wake), move |_| {
            Ok(PreparedMedial::new(
                &work.subject,
                &work.beat,
                work.end_diastole,
            ))
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
    }

    /// Whether anything is being made ready.
    pub fn busy(&self) -> bool {
        !self.making.is_empty()
    }
}
