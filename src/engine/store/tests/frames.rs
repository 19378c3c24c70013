//! What frames ask for: superseded, stopped, cancelled, finished first, forgotten, and in which order it runs.

use super::*;
use crate::engine::store::queue::MAX_THREADS;

#[test]
fn the_last_good_answer_stays_while_a_new_one_is_computed_and_the_newest_question_wins() {
    let (store, study, desk) = (store(), study(), Desk::default());
    until_ready(&store, &study, &number(&desk, 1));
    let showing = store.ask(&study, &gated(&desk, 2));
    assert_eq!(showing.latest().map(|answer| **answer), Some(1));
    store.end_frame();
    until(|| desk.runs() == 2);
    store.ask(&study, &gated(&desk, 3));
    store.end_frame();
    until(|| store.activities()[1].state == ActivityState::Stopped);
    desk.open();
    assert_eq!(*until_ready(&store, &study, &gated(&desk, 3)), 3);
    assert!(store.known(&study, &gated(&desk, 2)).is_none());
    // Going back to what is known computes nothing.
    assert!(store.ask(&study, &number(&desk, 1)).ready().is_some());
    assert_eq!(desk.runs(), 3);
}

#[test]
fn what_no_pane_asks_for_any_more_is_stopped_and_can_begin_again() {
    let (store, study, desk) = (store(), study(), Desk::default());
    store.ask(&study, &gated(&desk, 5));
    until(|| desk.runs() == 1);
    store.end_frame();
    assert!(store.ask(&study, &gated(&desk, 5)).computing());
    store.end_frame();
    assert_eq!(desk.runs(), 1, "asked in each frame, it goes on");
    store.end_frame();
    until(|| !store.busy());
    assert_eq!(store.activities()[0].state, ActivityState::Stopped);
    desk.open();
    assert_eq!(*until_ready(&store, &study, &gated(&desk, 5)), 5);
}

#[test]
fn cancelled_work_ends_at_once_and_stays_cancelled_until_it_is_retried() {
    let (store, study, desk) = (store(), study(), Desk::default());
    let topic = Topic::of::<Number>();
    until_ready(&store, &study, &number(&desk, 1));
    store.ask(&study, &gated(&desk, 5));
    until(|| desk.runs() == 2);
    let asked = Instant::now();
    store.cancel(topic);
    until(|| store.running().is_empty() && !store.busy());
    assert!(asked.elapsed() < Duration::from_millis(500));
    for _ in 0..3 {
        let showing = store.ask(&study, &gated(&desk, 5));
        assert!(showing.stopped() && showing.failure().is_none());
        assert_eq!(showing.latest().map(|answer| **answer), Some(1));
        store.end_frame();
    }
    assert!(store.take_failures().is_empty(), "a stop is no failure");
    store.retry(topic);
    assert!(store.ask(&study, &gated(&desk, 5)).computing());
    until(|| desk.runs() == 3);
    // A command gets what a pane was denied.
    store.cancel(topic);
    desk.open();
    let answer = store.answer(&study, &gated(&desk, 5), &Progress::default());
    assert_eq!(*answer.unwrap(), 5);
}

/// A dragged slider: what was begun is finished first.
#[derive(Clone, Debug, PartialEq)]
struct Dragged(Number);

impl Query for Dragged {
    type Answer = u32;
    const TITLE: &'static str = "Dragged";
    const URGENCY: Urgency = Urgency::Interactive;

    fn depends_on(&self, study: &Study) -> Dependencies {
        self.0.depends_on(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        self.0.run(cx)
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn lets_finish(&self, _begun: &Self) -> bool {
        true
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

#[test]
fn a_dragged_setting_lets_the_one_before_finish_and_ends_with_the_newest() {
    let (store, study, desk) = (store(), study(), Desk::default());
    store.ask(&study, &Dragged(gated(&desk, 1)));
    store.end_frame();
    until(|| desk.runs() == 1);
    for step in 2..5 {
        assert!(store.ask(&study, &Dragged(gated(&desk, step))).computing());
        store.end_frame();
    }
    assert_eq!(desk.runs(), 1, "none of them began");
    desk.open();
    until(|| {
        let showing = store.ask(&study, &Dragged(gated(&desk, 5)));
        store.end_frame();
        showing.latest().is_some_and(|answer| **answer == 1)
    });
    assert_eq!(*until_ready(&store, &study, &Dragged(gated(&desk, 5))), 5);
    assert_eq!(desk.order(), [1, 5]);
}

/// The statistics of a cohort.
#[derive(Clone, Debug, PartialEq)]
struct Statistics(Number);

impl Query for Statistics {
    type Answer = u32;
    const TITLE: &'static str = "Statistics";
    const URGENCY: Urgency = Urgency::Background;

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        self.0.run(cx)
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

#[test]
fn sliders_come_first_and_statistics_of_the_cohort_last() {
    let (store, study, desk) = (store(), study(), Desk::default());
    // Two fill all places of visible work; the third waits, and the statistics wait longer.
    let ask = |dragged: bool| {
        for i in 1..4 {
            store.ask(&study, &gated(&desk, i));
        }
        store.ask(&study, &Statistics(gated(&desk, 50)));
        if dragged {
            store.ask(&study, &Dragged(number(&desk, 90)));
        }
    };
    store.ask(&study, &Statistics(gated(&desk, 49)));
    until(|| desk.runs() == 1);
    // What is visible does not wait for statistics that have begun.
    store.ask(&study, &gated(&desk, 1));
    until(|| desk.runs() == 2);
    store.end_frame();
    store.end_frame();
    until(|| !store.busy());
    let before = desk.runs();
    ask(false);
    until(|| desk.runs() == before + 2);
    std::thread::sleep(Duration::from_millis(20));
    assert_eq!(desk.runs(), before + 2, "all places are taken");
    ask(true);
    until(|| desk.order().contains(&90));
    desk.open();
    until(|| !store.busy());
    let order = desk.order();
    let place = |number: u32| order.iter().rposition(|&n| n == number).unwrap();
    assert!(place(90) < place(3) && place(3) < place(50), "{order:?}");
}

/// Asked for with the pointer down; unlike a slider's, none waits for another.
#[derive(Clone, Debug, PartialEq)]
struct Urgent(Number);

impl Query for Urgent {
    type Answer = u32;
    const TITLE: &'static str = "Urgent";
    const URGENCY: Urgency = Urgency::Interactive;

    fn run(&self, cx: &Context<'_>) -> Result<u32, Interrupted> {
        self.0.run(cx)
    }

    fn memory(_: &u32, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

#[test]
fn of_what_waits_for_a_thread_the_most_urgent_begins_first() {
    let (store, study) = (store(), study());
    let [held, last, waiting] = [Desk::default(), Desk::default(), Desk::default()];
    // As many threads as there may be are taken; one of them is given back.
    let most = MAX_THREADS as u32;
    for i in 1..most {
        store.ask(&study, &Urgent(gated(&held, i)));
    }
    store.ask(&study, &Urgent(gated(&last, most)));
    until(|| held.runs() + last.runs() == MAX_THREADS);
    store.ask(&study, &number(&waiting, 60));
    store.ask(&study, &Urgent(number(&waiting, 95)));
    last.open();
    // It takes what is less urgent after that.
    until(|| waiting.runs() == 2);
    assert_eq!(waiting.order(), [95, 60]);
    held.open();
}

#[test]
fn past_the_budget_the_answer_used_longest_ago_goes_and_what_is_on_screen_stays() {
    // Each answer holds a megabyte and a little: three fit.
    let (store, study, desk) = (small_store(3_500_000), study(), Desk::default());
    let none = Progress::default();
    for i in 1..4 {
        store.answer(&study, &number(&desk, i), &none).unwrap();
    }
    assert_eq!(store.answers::<Number>(), 3);
    assert!(
        store.known(&study, &number(&desk, 1)).is_some(),
        "used again"
    );
    store.answer(&study, &number(&desk, 4), &none).unwrap();
    // The thread that has answered gives memory back just after.
    until(|| store.answers::<Number>() == 3);
    let known = |i: u32| store.known(&study, &number(&desk, i)).is_some();
    assert_eq!([1, 2, 3, 4].map(known), [true, false, true, true]);
    // Five on screen at once are more than the budget, and stay.
    let all = || {
        (5..10)
            .filter(|&i| store.ask(&study, &number(&desk, i)).ready().is_some())
            .count()
    };
    until(|| {
        let ready = all();
        store.end_frame();
        ready == 5
    });
    assert_eq!(all(), 5, "none went while it was on screen");
    store.end_frame();
    // Once they leave it, only as many stay as there is room for.
    for _ in 0..3 {
        store.ask(&study, &number(&desk, 9));
        store.end_frame();
    }
    assert_eq!(store.answers::<Number>(), 3);
    assert!(known(9) && known(8) && !known(5));
}
