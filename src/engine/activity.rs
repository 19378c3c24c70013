//! The list of running and finished work, with parameters, durations and outcomes.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Duration;

use crate::engine::job::{Ending, JobWatch};

/// Most entries kept; the oldest finished one goes first.
const MAX_ENTRIES: usize = 200;

/// What a piece of work is about, for Cancel and retry: all questions of one type, or a kind of job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Topic(&'static str);

impl Topic {
    /// Reading files or making the built-in cohort.
    pub const OPENING: Self = Self::named("Open");
    /// Writing tables or a figure.
    pub const EXPORT: Self = Self::named("Export");

    /// A topic by its title, which no other has.
    pub(super) const fn named(title: &'static str) -> Self {
        Self(title)
    }
}

/// One line of the activity list, as it stands now.
#[derive(Clone, Debug, PartialEq)]
pub struct Activity {
    /// Counts from 0 over the run of the program.
    pub number: u64,
    /// What it is about; Cancel takes it.
    pub topic: Topic,
    /// What it is.
    pub name: String,
    /// Its settings in words.
    pub parameters: String,
    /// Time since it was asked for.
    pub asked_ago: Duration,
    /// How long it has run, or ran.
    pub duration: Duration,
    /// How it stands.
    pub state: ActivityState,
}

/// How a piece of work stands.
#[derive(Clone, Debug, PartialEq)]
pub enum ActivityState {
    /// It waits or runs.
    Running {
        /// Share that is done, in `0.0..=1.0`.
        fraction: f32,
        /// What is being done now; may be empty.
        phase: &'static str,
        /// Estimate, once there is one.
        time_left: Option<Duration>,
    },
    /// It brought a result.
    Done,
    /// It was stopped, by the user or by newer work.
    Stopped,
    /// It failed, and why.
    Failed(String),
}

/// The work of this run of the program, newest last.
#[derive(Debug, Default)]
pub struct ActivityLog {
    next_number: u64,
    records: VecDeque<Record>,
}

#[derive(Debug)]
struct Record {
    number: u64,
    topic: Topic,
    name: String,
    parameters: String,
    watch: Arc<JobWatch>,
}

impl ActivityLog {
    /// Takes in a job that was just started.
    pub fn record(
        &mut self,
        topic: Topic,
        name: impl Into<String>,
        parameters: impl Into<String>,
        watch: Arc<JobWatch>,
    ) {
        self.records.push_back(Record {
            number: self.next_number,
            topic,
            name: name.into(),
            parameters: parameters.into(),
            watch,
        });
        self.next_number += 1;
        if self.records.len() > MAX_ENTRIES
            && let Some(oldest) = self.records.iter().position(|r| r.watch.ending().is_some())
        {
            self.records.remove(oldest);
        }
    }

    /// All entries as they stand now, newest first.
    pub fn list(&self) -> Vec<Activity> {
        self.records.iter().rev().map(Record::now).collect()
    }

    /// Those that wait or run, newest first.
    pub fn running(&self) -> Vec<Activity> {
        self.records
            .iter()
            .rev()
            .filter(|record| record.watch.ending().is_none())
            .map(Record::now)
            .collect()
    }
}

impl Record {
    fn now(&self) -> Activity {
        let watch = &self.watch;
        let state = match watch.ending() {
            Some(Ending::Done) => ActivityState::Done,
            Some(Ending::Stopped) => ActivityState::Stopped,
            Some(Ending::Failed(reason)) => ActivityState::Failed(reason.clone()),
            None => ActivityState::Running {
                fraction: watch.fraction(),
                phase: watch.phase(),
                time_left: watch.time_left(),
            },
        };
        Activity {
            number: self.number,
            topic: self.topic,
            name: self.name.clone(),
            parameters: self.parameters.clone(),
            asked_ago: watch.queued().elapsed(),
            duration: watch.elapsed(),
            state,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::job::Job;
    use crate::engine::workers::Workers;

    #[test]
    fn the_list_shows_how_work_ended_and_keeps_the_newest() {
        let pool = Workers::start("job", 1).unwrap();
        let mut log = ActivityLog::default();
        let mut jobs = Vec::new();
        for i in 0..MAX_ENTRIES + 5 {
            let job: Job<(), String> = Job::spawn(&pool, Arc::new(|| ()), move |_| {
                if i == MAX_ENTRIES + 4 {
                    Err("no volume".to_owned())
                } else {
                    Ok(())
                }
            });
            while job.watch().ending().is_none() {
                std::thread::yield_now();
            }
            log.record(
                Topic::OPENING,
                format!("work {i}"),
                "",
                Arc::clone(job.watch()),
            );
            jobs.push(job);
        }
        let list = log.list();
        assert_eq!(list.len(), MAX_ENTRIES);
        assert_eq!(list[0].state, ActivityState::Failed("no volume".to_owned()));
        assert_eq!(list[1].state, ActivityState::Done);
        assert_eq!(list[0].number as usize, MAX_ENTRIES + 4);
        assert!(log.running().is_empty());
    }
}
