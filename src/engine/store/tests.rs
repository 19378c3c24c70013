//! The laws of the store, on questions about numbers.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use super::*;
use crate::engine::activity::{ActivityState, Topic};
use crate::mesh::phantom;
use crate::progress::{Progress, Stopped};
use crate::study::{MeshSequence, Revision, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

mod chains;
mod frames;
mod places;

/// What questions of one test share: how often they ran, in which order, and a gate that holds them.
#[derive(Clone, Debug, Default)]
struct Desk(Arc<Inner>);

#[derive(Debug, Default)]
struct Inner {
    runs: AtomicUsize,
    order: Mutex<Vec<u32>>,
    open: Mutex<bool>,
    opened: Condvar,
}

impl PartialEq for Desk {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Desk {
    fn runs(&self) -> usize {
        self.0.runs.load(Ordering::SeqCst)
    }

    fn order(&self) -> Vec<u32> {
        self.0.order.lock().unwrap().clone()
    }

    fn open(&self) {
        *self.0.open.lock().unwrap() = true;
        self.0.opened.notify_all();
    }

    /// Waits until the gate is open or it is stopped; the gate is one of the two steps that are announced.
    fn pass(&self, progress: &Progress) -> Result<(), Stopped> {
        progress.expect_steps(2);
        progress.step()?;
        let mut open = self.0.open.lock().unwrap();
        while !*open {
            progress.check()?;
            open = (self
                .0
                .opened
                .wait_timeout(open, Duration::from_millis(2))
                .unwrap())
            .0;
        }
        progress.check()
    }
}

#[derive(Debug, thiserror::Error)]
#[error("{number} is too large")]
struct TooLarge {
    number: u32,
    source: std::num::TryFromIntError,
}

/// A number, found at once or behind the gate.
#[derive(Clone, Debug, PartialEq)]
struct Number {
    desk: Desk,
    number: u32,
    gated: bool,
}

impl Query for Number {
    type Answer = u32;
    const TITLE: &'static str = "Number";
    const FAILURE: Option<&'static str> = Some("There is no number");

    fn parameters(&self) -> String {
        format!("number {}", self.number)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [0])
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        self.desk.0.runs.fetch_add(1, Ordering::SeqCst);
        self.desk.0.order.lock().unwrap().push(self.number);
        cx.progress().begin_phase("counting", 0.0, 1.0);
        if self.gated {
            self.desk.pass(cx.progress())?;
        }
        assert_ne!(self.number, 13, "unlucky");
        let number = self.number;
        u8::try_from(number).map_err(|source| TooLarge { number, source })?;
        Ok(self.number)
    }

    fn memory(_: &u32, memory: &mut Memory) {
        memory.own(1_000_000);
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

fn store() -> Store {
    Store::start(StoreOptions::default()).unwrap()
}

fn small_store(budget: usize) -> Store {
    Store::start(StoreOptions {
        budget,
        ..StoreOptions::default()
    })
    .unwrap()
}

fn number(desk: &Desk, number: u32) -> Number {
    Number {
        desk: desk.clone(),
        number,
        gated: false,
    }
}

fn gated(desk: &Desk, number: u32) -> Number {
    Number {
        desk: desk.clone(),
        number,
        gated: true,
    }
}

fn subject() -> Subject {
    let surface =
        SurfaceSequence::new(SurfaceKind::Endocardium, vec![phantom::sphere(0, 1.0)]).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    Subject::new("a", sequence, LengthUnit::Millimetre)
}

fn study() -> Arc<Study> {
    Arc::new(Study {
        subjects: vec![Arc::new(subject())],
        revision: Revision(1),
        ..Study::default()
    })
}

fn edited(study: &Study, edit: impl FnOnce(&mut Subject)) -> Arc<Study> {
    let mut subject = Subject::clone(&study.subjects[0]);
    edit(&mut subject);
    let revision = Revision(study.revision.0 + 1);
    Arc::new(study.with_subject(0, subject, revision))
}

fn until(mut met: impl FnMut() -> bool) {
    let begin = Instant::now();
    while !met() {
        assert!(begin.elapsed() < Duration::from_secs(10), "it never came");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Asks as a pane does, frame by frame.
fn until_ready<Q: Query>(store: &Store, study: &Arc<Study>, query: &Q) -> Arc<Q::Answer> {
    let mut answer = None;
    until(|| {
        answer = store.ask(study, query).ready().cloned();
        store.end_frame();
        answer.is_some()
    });
    answer.unwrap()
}

#[test]
fn a_question_is_answered_once_and_the_command_line_reads_the_same_answer() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let seen = until_ready(&store, &study, &number(&desk, 7));
    let answer = store.answer(&study, &number(&desk, 7), &Progress::default());
    assert!(Arc::ptr_eq(&seen, &answer.unwrap()));
    assert_eq!((*seen, desk.runs()), (7, 1));
    // What is known is returned even to whoever is stopped.
    let stopped = Progress::default();
    stopped.stop();
    assert!(store.answer(&study, &number(&desk, 7), &stopped).is_ok());
    let other = store.answer(&study, &number(&desk, 8), &stopped);
    assert!(matches!(other, Err(Interrupted::Stopped)));
    assert_eq!(desk.runs(), 1);
}

#[test]
fn an_edited_label_keeps_what_depends_on_shapes_and_another_study_does_not() {
    let (store, first, desk) = (store(), study(), Desk::default());
    let seven = number(&desk, 7);
    let seen = until_ready(&store, &first, &seven);
    let labelled = edited(&first, |subject| subject.label = Some("MINF".to_owned()));
    assert!(Arc::ptr_eq(
        &seen,
        store.ask(&labelled, &seven).ready().unwrap()
    ));
    let restated = edited(&first, |subject| subject.end_diastole = Some(0));
    let showing = store.ask(&restated, &seven);
    assert!(
        Arc::ptr_eq(&seen, showing.latest().unwrap()),
        "it stays on screen"
    );
    assert!(showing.ready().is_none());
    let showing = store.ask(&study(), &seven);
    assert!(
        showing.latest().is_none(),
        "of another study nothing is shown"
    );
}

#[test]
fn a_failure_keeps_its_type_and_its_sources_and_it_has_one_card() {
    let (store, study, desk) = (store(), study(), Desk::default());
    until(|| store.ask(&study, &number(&desk, 999)).failure().is_some());
    let showing = store.ask(&study, &number(&desk, 999));
    let error = showing.failure().unwrap();
    assert_eq!(error.to_string(), "999 is too large");
    assert!(error.source().unwrap().is::<std::num::TryFromIntError>());
    assert!(error.is::<TooLarge>());
    let failures = store.take_failures();
    assert_eq!(failures.len(), 1);
    assert_eq!(failures[0].title, "There is no number");
    store.end_frame();
    assert!(store.ask(&study, &number(&desk, 999)).failure().is_some());
    assert!(store.take_failures().is_empty());
    assert_eq!(desk.runs(), 1, "it is not tried again by itself");
    store.retry(failures[0].topic);
    assert!(store.ask(&study, &number(&desk, 999)).computing());
    until(|| store.ask(&study, &number(&desk, 999)).failure().is_some());
    assert_eq!((desk.runs(), store.take_failures().len()), (2, 1));
}

#[test]
fn a_panic_is_a_failure_and_takes_nothing_else_with_it() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let bug = store.answer(&study, &number(&desk, 13), &Progress::default());
    let Err(Interrupted::Failed(failure)) = bug else {
        panic!("{bug:?}");
    };
    assert!(
        failure.to_string().contains("internal error: "),
        "{failure}"
    );
    assert_eq!(*until_ready(&store, &study, &number(&desk, 14)), 14);
}

#[test]
fn closing_the_store_while_it_works_takes_less_than_half_a_second() {
    let (store, study, desk) = (store(), study(), Desk::default());
    for i in 0..5 {
        store.ask(&study, &gated(&desk, i));
    }
    until(|| desk.runs() == 2);
    let asked = Instant::now();
    drop(store);
    assert!(asked.elapsed() < Duration::from_millis(500));
    assert_eq!(desk.runs(), 2, "what waited never began");
}

#[test]
fn the_activity_list_shows_what_was_asked_and_how_it_ended() {
    let (store, study, desk) = (store(), study(), Desk::default());
    store.ask(&study, &gated(&desk, 5));
    until(|| desk.runs() == 1);
    let running = store.running();
    assert_eq!(running[0].name, "Number");
    assert_eq!(running[0].parameters, "number 5");
    assert!(store.busy() && store.works_on(Topic::of::<Number>()));
    until(|| {
        matches!(store.running()[0].state, ActivityState::Running { fraction, phase, .. }
            if fraction == 0.5 && phase == "counting")
    });
    desk.open();
    until(|| !store.busy());
    assert_eq!(store.activities()[0].state, ActivityState::Done);
    assert!(store.running().is_empty());
}

#[test]
fn nobody_else_has_to_wait_for_a_reader_that_was_stopped() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let progress = Progress::default();
    let answer = std::thread::scope(|scope| {
        let reader = scope.spawn(|| store.answer(&study, &gated(&desk, 5), &progress));
        until(|| desk.runs() == 1);
        // A pane wants it too.
        assert!(store.ask(&study, &gated(&desk, 5)).computing());
        let asked = Instant::now();
        progress.stop();
        let answer = reader.join().unwrap();
        assert!(asked.elapsed() < Duration::from_millis(500));
        answer
    });
    assert!(matches!(answer, Err(Interrupted::Stopped)));
    desk.open();
    assert_eq!(*until_ready(&store, &study, &gated(&desk, 5)), 5);
    assert_eq!(desk.runs(), 1, "it went on for the pane");
}
