//! A large study on its way: what the thread that reads it tells the window, and what the window tells it.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::engine::job::Wake;
use crate::io::{OpenListener, Opened};
use crate::study::{ReadSubject, Study};

/// Studies whose files have fewer bytes are there within about half a second: they are shown when all is read.
const LARGE: u64 = 32 << 20;

/// Subjects that were read are shown this often: each time is another state of the study.
const PERIOD: Duration = Duration::from_millis(250);

/// A step of opening a large study.
#[derive(Clone, Debug)]
pub enum Stage {
    /// The study with its first subjects; the others are unread.
    Begun(Study),
    /// What came of more of them.
    Read(Vec<ReadSubject>),
    /// All was read, or reading was stopped: errors and notes are those of the whole.
    Ended(Opened),
    /// Nothing further comes, for something else is being opened.
    GivenUp,
}

/// Shared by the thread that reads and the window.
pub(super) struct Feed {
    news: Mutex<News>,
    wake: Wake,
}

#[derive(Default)]
struct News {
    /// The study until its first subject is read; `None` for one that is shown when all is read.
    planned: Option<Study>,
    begun: bool,
    read: Vec<ReadSubject>,
    wanted: Option<String>,
    /// Whether the user waits for what was read.
    urgent: bool,
    enough: bool,
    reported: Option<Instant>,
}

impl Feed {
    pub fn new(wake: Wake) -> Self {
        Self {
            news: Mutex::default(),
            wake,
        }
    }

    /// Whether the study is shown while it is read.
    pub fn begun(&self) -> bool {
        self.news().begun
    }

    /// The next step, if it is time for one; with `all`, whatever there is.
    pub fn stage(&self, all: bool) -> Option<Stage> {
        let mut news = self.news();
        let due = all
            || news.urgent
            || news
                .reported
                .is_none_or(|reported| reported.elapsed() >= PERIOD);
        let found = news.begun || news.read.iter().any(|(_, subject)| subject.is_some());
        if news.read.is_empty() || !due || !found {
            return None;
        }
        news.reported = Some(Instant::now());
        news.urgent = false;
        let read = std::mem::take(&mut news.read);
        if news.begun {
            return Some(Stage::Read(read));
        }
        news.begun = true;
        let planned = news.planned.take()?;
        Some(Stage::Begun(planned.with_read(&read, planned.revision).0))
    }

    /// Has a subject read before the others.
    pub fn want(&self, id: String) {
        self.news().wanted = Some(id);
    }

    /// Ends reading after the subjects that are being read; whether it was not ended before.
    pub fn stop_reading(&self) -> bool {
        !std::mem::replace(&mut self.news().enough, true)
    }

    fn news(&self) -> MutexGuard<'_, News> {
        self.news.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl OpenListener for Feed {
    fn planned(&self, study: Study, bytes: u64) {
        if bytes >= LARGE && study.unread.len() > 1 {
            self.news().planned = Some(study);
        }
    }

    fn read(&self, subject: ReadSubject) {
        let mut news = self.news();
        if news.planned.is_none() && !news.begun {
            return;
        }
        if news.wanted.as_ref() == Some(&subject.0) {
            news.wanted = None;
            news.urgent = true;
        }
        let urgent = news.urgent || !news.begun;
        news.read.push(subject);
        drop(news);
        if urgent {
            (self.wake)();
        }
    }

    fn wanted(&self) -> Option<String> {
        self.news().wanted.clone()
    }

    fn enough(&self) -> bool {
        self.news().enough
    }

    /// Few, so that a subject that is wanted next waits for few.
    fn at_a_time(&self, threads: usize) -> usize {
        threads
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::built_in::{BuiltInParams, cohort};
    use crate::study::{Revision, UnreadSubject};
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// The built-in cohort as a study of which nothing is read, and its subjects.
    fn planned() -> (Study, Vec<ReadSubject>) {
        let params = BuiltInParams {
            vertices: 200,
            ..BuiltInParams::default()
        };
        let study = cohort(&params).unwrap().study;
        let read = |s: &Arc<crate::study::Subject>| (s.id.clone(), Some(Arc::clone(s)));
        let subjects: Vec<ReadSubject> = study.subjects.iter().map(read).collect();
        let unread = subjects.iter().map(|(id, _)| UnreadSubject {
            id: id.clone(),
            label: None,
            read_before: 0,
        });
        let planned = Study {
            unread: unread.collect(),
            ..Study::default()
        };
        (planned, subjects)
    }

    #[test]
    fn a_small_study_is_not_told_of_before_all_is_read() {
        let (study, subjects) = planned();
        let feed = Feed::new(Arc::new(|| ()));
        feed.planned(study, LARGE - 1);
        feed.read(subjects[0].clone());
        assert!(feed.stage(true).is_none() && !feed.begun());
    }

    #[test]
    fn a_large_study_begins_with_its_first_subject_and_the_one_that_is_waited_for_comes_at_once() {
        let wakes = Arc::new(AtomicUsize::new(0));
        let counter = Arc::clone(&wakes);
        let feed = Feed::new(Arc::new(move || {
            counter.fetch_add(1, Ordering::SeqCst);
        }));
        let (study, subjects) = planned();
        feed.planned(study, LARGE);
        assert!(feed.stage(true).is_none(), "nothing is read");
        feed.read(("N01".to_owned(), None));
        assert!(feed.stage(true).is_none(), "nothing could be read");
        feed.read(subjects[1].clone());
        let Some(Stage::Begun(study)) = feed.stage(false) else {
            panic!("the first subject begins the study");
        };
        assert_eq!((study.subjects.len(), study.unread.len()), (1, 21));
        feed.read(subjects[2].clone());
        assert!(feed.stage(false).is_none(), "it is not time yet");
        feed.want("P03".to_owned());
        assert_eq!(feed.wanted().as_deref(), Some("P03"));
        let woken = wakes.load(Ordering::SeqCst);
        let wanted = subjects.iter().find(|(id, _)| id == "P03").unwrap();
        feed.read(wanted.clone());
        assert_eq!(wakes.load(Ordering::SeqCst), woken + 1);
        assert_eq!(feed.wanted(), None);
        let Some(Stage::Read(read)) = feed.stage(false) else {
            panic!("what is waited for is told at once");
        };
        let (study, index) = study.with_read(&read, Revision(2));
        let ids: Vec<&str> = study.subjects.iter().map(|s| s.id.as_str()).collect();
        assert_eq!(
            (ids.as_slice(), index.as_slice()),
            (&["N02", "N03", "P03"][..], &[0][..])
        );
        assert!(feed.stop_reading() && !feed.stop_reading() && feed.enough());
    }
}
