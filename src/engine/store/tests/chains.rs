//! Questions that ask other questions: shared work, progress, stops, failures and circles.

use super::*;

/// Ten times a number.
#[derive(Clone, Debug, PartialEq)]
struct Tenfold(Number);

impl Query for Tenfold {
    type Answer = u32;
    const TITLE: &'static str = "Tenfold";
    const FAILURE: Option<&'static str> = Some("There is no tenfold");

    fn depends_on(&self, study: &Study) -> Dependencies {
        self.0.depends_on(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        let part = cx.part("asking", 0.0, 0.8);
        Ok(10 * *part.get(&self.0)?)
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// The sum of tenfolds: two steps deep.
#[derive(Clone, Debug, PartialEq)]
struct Sum(Vec<Tenfold>);

impl Query for Sum {
    type Answer = u32;
    const TITLE: &'static str = "Sum";

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        self.0.iter().map(|tenfold| Ok(*cx.get(tenfold)?)).sum()
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

#[test]
fn what_two_questions_need_is_computed_once() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let tenfold = |i| Tenfold(gated(&desk, i));
    let sum = Sum((1..5).map(tenfold).collect());
    store.ask(&study, &sum);
    for i in 1..5 {
        store.ask(&study, &tenfold(i));
    }
    store.ask(&study, &gated(&desk, 4));
    until(|| desk.runs() > 0);
    desk.open();
    until(|| !store.busy());
    assert_eq!(*store.ask(&study, &sum).ready().unwrap().as_ref(), 100);
    assert_eq!(desk.runs(), 4);
}

#[test]
fn waiting_questions_hold_up_no_other_one() {
    let (store, study, desk) = (store(), study(), Desk::default());
    store.ask(&study, &gated(&desk, 1));
    until(|| desk.runs() == 1);
    // All these wait for the first one, and are more than there are places.
    for factor in 0..6 {
        let sum = Sum(vec![Tenfold(gated(&desk, 1)); factor + 1]);
        store.ask(&study, &sum);
    }
    store.ask(&study, &number(&desk, 2));
    until(|| desk.order().contains(&2));
}

#[test]
fn the_progress_of_what_is_asked_is_that_of_whoever_asks() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let tenfold = Tenfold(gated(&desk, 4));
    // Once computed by the same thread, once by another one.
    for elsewhere in [false, true] {
        if elsewhere {
            store.ask(&study, &gated(&desk, 4));
            until(|| desk.runs() == 2);
        }
        store.ask(&study, &tenfold);
        until(|| {
            store.running().iter().any(|activity| {
                activity.name == "Tenfold"
                    && matches!(activity.state, ActivityState::Running { fraction, phase, .. }
                        if (fraction - 0.4).abs() < 1e-6 && phase == "counting")
            })
        });
        store.end_frame();
        store.end_frame();
        until(|| !store.busy());
    }
}

#[test]
fn work_that_two_want_goes_on_when_one_of_them_loses_interest() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let (tenfold, own) = (Tenfold(gated(&desk, 4)), gated(&desk, 4));
    store.ask(&study, &tenfold);
    until(|| desk.runs() == 1);
    store.ask(&study, &own);
    store.end_frame();
    // Nobody asks for the tenfold any more, on whose thread the number is computed.
    store.ask(&study, &own);
    store.end_frame();
    store.ask(&study, &own);
    assert_eq!(
        store.running().len(),
        0,
        "the tenfold was stopped, and the number is none of the list"
    );
    desk.open();
    assert_eq!(*until_ready(&store, &study, &own), 4);
    assert_eq!(desk.runs(), 1);
}

#[test]
fn what_only_stopped_work_wants_is_stopped_with_it() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let sum = Sum(vec![Tenfold(gated(&desk, 4))]);
    store.ask(&study, &sum);
    until(|| desk.runs() == 1);
    let asked = Instant::now();
    store.end_frame();
    store.end_frame();
    until(|| !store.busy());
    assert!(asked.elapsed() < Duration::from_millis(500));
    assert!(store.known(&study, &gated(&desk, 4)).is_none());
    desk.open();
    assert_eq!(*until_ready(&store, &study, &sum), 40);
}

#[test]
fn who_waits_for_a_cancelled_question_is_held_with_it_and_freed_with_it() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let (tenfold, own) = (Tenfold(gated(&desk, 4)), gated(&desk, 4));
    let ask = || {
        let shown = (store.ask(&study, &own), store.ask(&study, &tenfold));
        store.end_frame();
        shown
    };
    ask();
    until(|| desk.runs() == 1);
    store.cancel(Topic::of::<Number>());
    until(|| ask().1.stopped());
    for _ in 0..5 {
        ask();
    }
    assert_eq!(desk.runs(), 1, "it is not begun again and again");
    store.retry(Topic::of::<Tenfold>());
    let (own, tenfold) = ask();
    assert!(own.computing() && tenfold.computing());
    desk.open();
    until(|| ask().1.ready().is_some());
}

#[test]
fn a_failure_below_is_reported_by_one_card_and_retried_from_above() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let (tenfold, own) = (Tenfold(number(&desk, 999)), number(&desk, 999));
    let ask = || {
        let shown = (store.ask(&study, &own), store.ask(&study, &tenfold));
        store.end_frame();
        shown
    };
    until(|| ask().0.failure().is_some() && ask().1.failure().is_some());
    let showing = ask().1;
    let error = showing.failure().unwrap();
    assert_eq!(error.to_string(), "999 is too large");
    assert!(error.source().is_some() && error.is::<TooLarge>());
    let cards = store.take_failures();
    assert_eq!(cards.len(), 1, "{cards:?}");
    store.retry(Topic::of::<Tenfold>());
    until(|| ask().1.failure().is_some());
    assert_eq!(desk.runs(), 2, "the number itself was tried again");
}

/// A question that needs its own answer.
#[derive(Clone, Debug, PartialEq)]
struct Circle(u32);

impl Query for Circle {
    type Answer = u32;
    const TITLE: &'static str = "Circle";

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        Ok(*cx.get(&Self((self.0 + 1) % 3))?)
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

#[test]
fn a_circle_of_questions_is_a_failure_and_no_endless_wait() {
    let (store, study) = (store(), study());
    store.ask(&study, &Circle(1));
    let answer = store.answer(&study, &Circle(0), &Progress::default());
    let Err(Interrupted::Failed(failure)) = answer else {
        panic!("{answer:?}");
    };
    assert!(
        failure.to_string().contains("depends on itself"),
        "{failure}"
    );
    until(|| store.ask(&study, &Circle(1)).failure().is_some());
    until(|| !store.busy());
}
