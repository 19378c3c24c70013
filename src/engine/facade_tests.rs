//! Drives the engine as the window does: poll, ask, cancel, retry.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use super::*;
use crate::analysis::embedding::MapMethod;
use crate::analysis::medial::MedialParams;
use crate::analysis::thickening::ThickeningSettings;
use crate::progress::Progress;
use crate::study::Study;
use crate::study::built_in::BuiltInParams;

fn engine() -> Engine {
    Engine::start(StoreOptions::default()).unwrap()
}

fn until(engine: &mut Engine, mut met: impl FnMut(&mut Engine) -> bool) {
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(60) {
        engine.poll();
        if met(engine) {
            return;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("it never came: {:?}", engine.activities());
}

fn opened(engine: &mut Engine, vertices: usize) -> Arc<Study> {
    engine.open(OpenSource::BuiltIn(BuiltInParams {
        vertices,
        ..BuiltInParams::default()
    }));
    let mut study = None;
    until(engine, |engine| {
        study = engine.take_opened();
        study.is_some()
    });
    Arc::new(study.unwrap().study)
}

#[test]
fn opening_is_handed_out_once_under_a_revision_of_its_own() {
    let mut engine = engine();
    let first = opened(&mut engine, 200);
    assert!(engine.take_opened().is_none());
    let second = opened(&mut engine, 200);
    assert_eq!(first.subjects.len(), 23);
    assert_ne!(first.revision, second.revision);
    assert_ne!(engine.next_revision(), second.revision);
}

#[test]
fn what_cannot_be_made_is_an_error_beside_an_empty_study() {
    let mut engine = engine();
    engine.open(OpenSource::BuiltIn(BuiltInParams {
        vertices: 1,
        ..BuiltInParams::default()
    }));
    let mut opened = None;
    until(&mut engine, |engine| {
        opened = engine.take_opened();
        opened.is_some()
    });
    let opened = opened.unwrap();
    assert!(opened.study.subjects.is_empty());
    assert_eq!(opened.errors.len(), 1);
}

#[cfg(unix)]
#[test]
fn what_was_opened_last_can_be_opened_again_with_its_links() {
    let (root, store) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let mesh = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    std::fs::write(store.path().join("endo_0.obj"), mesh).unwrap();
    std::os::unix::fs::symlink(store.path(), root.path().join("linked")).unwrap();
    let mut engine = engine();
    let count = |engine: &mut Engine| {
        let mut count = None;
        until(engine, |engine| {
            count = engine
                .take_opened()
                .map(|opened| opened.study.subjects.len());
            count.is_some()
        });
        count.unwrap()
    };
    engine.open_following_links();
    assert!(!engine.opening(), "nothing was opened before");
    engine.open(OpenSource::Paths(vec![root.path().to_owned()]));
    assert_eq!(count(&mut engine), 0);
    engine.open_following_links();
    assert_eq!(count(&mut engine), 1);
}

#[test]
fn a_map_is_computed_once_and_then_found() {
    let wakes = Arc::new(AtomicUsize::new(0));
    let counter = Arc::clone(&wakes);
    let options = StoreOptions {
        wake: Arc::new(move || {
            counter.fetch_add(1, Ordering::SeqCst);
        }),
        ..StoreOptions::default()
    };
    let mut engine = Engine::start(options).unwrap();
    let study = opened(&mut engine, 200);
    let (mut measures, mut map) = (None, None);
    until(&mut engine, |engine| {
        measures = engine.store().ask(&study, &MeasuresQuery).ready().cloned();
        let params = PoseMapQuery::default();
        map = engine.store().ask(&study, &params).ready().cloned();
        engine.store().end_frame();
        measures.is_some() && map.is_some()
    });
    assert_eq!(measures.unwrap().len(), 23);
    assert_eq!(map.unwrap().embedding.len(), 184);
    until(&mut engine, |engine| !engine.busy());
    assert_eq!(wakes.load(Ordering::SeqCst), 3, "open, measures, map");
    let names: Vec<String> = engine.activities().into_iter().map(|a| a.name).collect();
    assert_eq!(names.len(), 3);
    assert_eq!(names[0], "Pose map");
    assert!(
        engine
            .activities()
            .iter()
            .all(|a| a.state == ActivityState::Done)
    );
}

#[test]
fn cancel_takes_effect_within_half_a_second_and_retry_begins_again() {
    let mut engine = engine();
    let study = opened(&mut engine, 4_000);
    let query = PoseMapQuery {
        method: MapMethod::ClassicalMds,
        ..PoseMapQuery::default()
    };
    engine.store().ask(&study, &query);
    until(&mut engine, |engine| {
        engine
            .running()
            .first()
            .is_some_and(|activity| activity.duration > Duration::ZERO)
    });
    let asked = Instant::now();
    let topic = Topic::of::<PoseMapQuery>();
    engine.cancel(topic);
    until(&mut engine, |engine| !engine.busy());
    assert!(asked.elapsed() < Duration::from_millis(500));
    assert_eq!(engine.activities()[0].state, ActivityState::Stopped);
    assert!(engine.store().ask(&study, &query).stopped());
    assert!(!engine.busy(), "what was stopped does not begin by itself");
    engine.retry(topic);
    assert!(engine.store().ask(&study, &query).computing());
    assert!(engine.busy());
    assert!(engine.activities()[0].parameters.contains("classical MDS"));
}

#[test]
fn kinds_of_analysis_stand_beside_each_other_and_are_cancelled_alone() {
    let mut engine = engine();
    let study = opened(&mut engine, 2_000);
    let map = DeformationMapQuery::default();
    engine.store().ask(&study, &MeasuresQuery);
    engine.store().ask(&study, &map);
    engine.cancel(Topic::of::<DeformationMapQuery>());
    until(&mut engine, |engine| !engine.busy());
    assert!(engine.store().ask(&study, &MeasuresQuery).ready().is_some());
    assert!(engine.store().ask(&study, &map).stopped());
    engine.retry(Topic::of::<DeformationMapQuery>());
    assert!(engine.store().ask(&study, &map).computing());
}

/// Looks at the walls of five subjects one after the other, and says whose are kept.
fn kept_walls(options: StoreOptions) -> [bool; 5] {
    let mut engine = Engine::start(options).unwrap();
    let study = opened(&mut engine, 200);
    let wall = |subject| MedialSurfacesQuery {
        subject,
        params: MedialParams::default(),
    };
    for subject in 0..5 {
        until(&mut engine, |engine| {
            let showing = engine.store().ask(&study, &wall(subject));
            engine.store().end_frame();
            showing.ready().is_some()
        });
    }
    // What has left the screen goes once frames have passed without it.
    for _ in 0..3 {
        assert!(engine.store().ask(&study, &wall(4)).ready().is_some());
        engine.store().end_frame();
    }
    [0, 1, 2, 3, 4].map(|subject| engine.store().known(&study, &wall(subject)).is_some())
}

#[test]
fn past_the_budget_of_the_window_only_what_is_looked_at_is_kept() {
    assert_eq!(kept_walls(StoreOptions::default()), [true; 5]);
    let tight = StoreOptions {
        budget: 1,
        ..StoreOptions::default()
    };
    assert_eq!(kept_walls(tight), [false, false, false, false, true]);
}

#[test]
fn closing_the_window_while_work_runs_takes_less_than_half_a_second() {
    let mut engine = engine();
    let study = opened(&mut engine, 4_000);
    engine.store().ask(&study, &PoseMapQuery::default());
    engine.store().ask(&study, &MeasuresQuery);
    std::thread::sleep(Duration::from_millis(50));
    let asked = Instant::now();
    drop(engine);
    assert!(asked.elapsed() < Duration::from_millis(500));
}

#[test]
fn an_export_is_written_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let mut engine = engine();
    let path = folder.path().join("out/table.csv");
    let file = ExportFile {
        path: path.clone(),
        bytes: b"a,b\n".to_vec().into(),
    };
    engine.start_export("Tables", "", move |_| Ok(vec![file]));
    let mut written = None;
    until(&mut engine, |engine| {
        written = engine.take_exported();
        written.is_some()
    });
    assert_eq!(written.unwrap(), std::slice::from_ref(&path));
    assert!(path.is_file());
    engine.start_export("Figure", "", |_| Err("no adapter".to_owned()));
    until(&mut engine, |engine| !engine.busy());
    let failures = engine.take_failures();
    assert_eq!(failures[0].error.to_string(), "no adapter");
    assert_eq!(failures[0].topic, Topic::EXPORT);
}

#[test]
fn the_activity_list_names_files_without_their_folders() {
    let source = OpenSource::Paths(vec![PathBuf::from("/elsewhere/Jane Doe/n01/endo_0.ply")]);
    assert_eq!(source.words(), "endo_0.ply");
}

#[test]
fn thickening_is_stopped_retried_and_follows_a_slider() {
    let mut engine = engine();
    let study = opened(&mut engine, 2_500);
    let settings = ThickeningSettings::default();
    let mut query = WallThickeningQuery {
        subject: 9,
        settings,
    };
    let topic = Topic::of::<WallThickeningQuery>();
    engine.store().ask(&study, &query);
    engine.cancel(topic);
    until(&mut engine, |engine| !engine.busy());
    assert!(engine.store().ask(&study, &query).stopped());
    engine.retry(topic);
    let answered = |engine: &mut Engine, query: &WallThickeningQuery| {
        let mut found = None;
        until(engine, |engine| {
            found = engine.store().ask(&study, query).ready().cloned();
            engine.store().end_frame();
            found.is_some()
        });
        found.unwrap()
    };
    let first = answered(&mut engine, &query);
    for step in 1..4 {
        let tolerance = 0.05 * f64::from(step);
        query.settings.patches.tolerance = Some(tolerance);
        let found = answered(&mut engine, &query);
        assert!(Arc::ptr_eq(&found.beat, &first.beat));
        assert_eq!(found.thickening.tolerance, tolerance);
    }
    assert_eq!(engine.activities()[0].name, "Thickening");
    assert!(engine.activities()[0].parameters.contains("± 0.15"));
}

#[test]
fn what_is_known_of_a_subject_stays_known_when_others_come_before_it_and_the_cohort_waits_for_all()
{
    let mut engine = engine();
    let whole = opened(&mut engine, 200);
    let wall = |subject| MedialSurfacesQuery {
        subject,
        params: MedialParams::default(),
    };
    let unread = |id: &str, read_before| crate::study::UnreadSubject {
        id: id.to_owned(),
        label: None,
        read_before,
    };
    let alone = Arc::new(Study {
        subjects: vec![Arc::clone(&whole.subjects[1])],
        unread: vec![unread("N01", 0), unread("N03", 1)],
        revision: engine.next_revision(),
        ..Study::default()
    });
    let store = Arc::clone(engine.store());
    let mut known = None;
    until(&mut engine, |engine| {
        known = engine.store().ask(&alone, &wall(0)).ready().cloned();
        engine.store().end_frame();
        known.is_some()
    });
    assert!(store.ask(&alone, &MeasuresQuery).computing());
    assert!(store.ask(&alone, &PoseMapQuery::default()).computing());
    let refused = store.answer(&alone, &MeasuresQuery, &Progress::default());
    let Err(Interrupted::Failed(why)) = refused else {
        panic!("the cohort is not read");
    };
    assert_eq!(why.to_string(), "2 of 3 subjects are still to be read");
    until(&mut engine, |engine| !engine.busy());
    let read = [0, 2].map(|index| {
        let subject = &whole.subjects[index];
        (subject.id.clone(), Some(Arc::clone(subject)))
    });
    let (all, index) = alone.with_read(&read, engine.next_revision());
    assert_eq!(index, [1]);
    store.follow(&all);
    let kept = store.known(&all, &wall(1)).unwrap();
    assert!(Arc::ptr_eq(&kept, &known.unwrap()));
    assert!(store.known(&all, &wall(0)).is_none());
    assert_eq!(
        store
            .answer(&Arc::new(all), &MeasuresQuery, &Progress::default())
            .unwrap()
            .len(),
        3
    );
}

#[test]
fn the_surfaces_of_the_study_on_screen_count_to_the_memory() {
    let mut engine = Engine::start(StoreOptions {
        budget: 200 << 10,
        ..StoreOptions::default()
    })
    .unwrap();
    let study = opened(&mut engine, 200);
    let one = Study {
        subjects: study.subjects[..1].to_vec(),
        ..Study::default()
    };
    assert!(study.bytes() > 400 << 10 && one.bytes() < 100 << 10);
    let store = Arc::clone(engine.store());
    let mut kept_beside = |shown: &Study| {
        store.follow(shown);
        until(&mut engine, |engine| {
            let asked = engine.store().ask(&study, &MeasuresQuery);
            engine.store().end_frame();
            asked.ready().is_some()
        });
        for _ in 0..3 {
            store.end_frame();
        }
        store.known(&study, &MeasuresQuery).is_some()
    };
    assert!(kept_beside(&one));
    assert!(!kept_beside(&study));
}
