//! Drives the engine as the window does: poll, request, cancel, retry.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use super::*;
use crate::analysis::embedding::MapMethod;
use crate::analysis::geodesics::GeodesicParams;
use crate::study::Study;
use crate::study::built_in::BuiltInParams;

fn engine() -> Engine {
    Engine::start(Arc::new(|| ())).unwrap()
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
    Arc::new(study.unwrap().study.clone())
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

#[test]
fn a_map_is_computed_once_and_then_found() {
    let wakes = Arc::new(AtomicUsize::new(0));
    let counter = Arc::clone(&wakes);
    let mut engine = Engine::start(Arc::new(move || {
        counter.fetch_add(1, Ordering::SeqCst);
    }))
    .unwrap();
    let study = opened(&mut engine, 200);
    let params = PoseMapParams::default();
    for _ in 0..3 {
        engine.request(&study, AnalysisRequest::Measures);
        engine.request(&study, AnalysisRequest::PoseMap(params));
    }
    until(&mut engine, |engine| !engine.busy());
    let measures = engine.latest(WorkKind::Measures).unwrap();
    assert_eq!(measures.measures().unwrap().len(), 23);
    let map = engine.latest(WorkKind::PoseMap).unwrap();
    assert_eq!(map.pose_map().unwrap().embedding.len(), 184);
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
    let request = AnalysisRequest::PoseMap(PoseMapParams {
        method: MapMethod::ClassicalMds,
        ..PoseMapParams::default()
    });
    engine.request(&study, request);
    until(&mut engine, |engine| {
        engine
            .running()
            .first()
            .is_some_and(|activity| activity.duration > Duration::ZERO)
    });
    let asked = Instant::now();
    engine.cancel(WorkKind::PoseMap);
    until(&mut engine, |engine| engine.running().is_empty());
    assert!(asked.elapsed() < Duration::from_millis(500));
    assert_eq!(engine.activities()[0].state, ActivityState::Stopped);
    engine.request(&study, request);
    assert!(!engine.busy(), "what was stopped does not begin by itself");
    let showing = engine.showing(WorkKind::PoseMap);
    assert!(matches!(showing, Showing::Stopped { .. }));
    engine.retry(&study, request);
    assert!(engine.busy());
    assert!(engine.activities()[0].parameters.contains("classical MDS"));
}

#[test]
fn intervals_of_a_beat_are_known_one_by_one_beginning_with_the_one_looked_at() {
    let mut engine = engine();
    let study = opened(&mut engine, 200);
    let params = GeodesicParams {
        in_betweens: 1,
        max_iterations: 20,
        ..GeodesicParams::default()
    };
    let interval = |interval| AnalysisRequest::Interval {
        subject: 2,
        interval,
        params,
    };
    engine.look_at_interval(6);
    let whole = AnalysisRequest::InBetweens { subject: 2, params };
    engine.request(&study, whole);
    until(&mut engine, |engine| {
        engine.known(&study, &interval(6)).is_some()
    });
    until(&mut engine, |engine| !engine.busy());
    let showing = engine.showing(WorkKind::InBetweens);
    let Showing::Ready(outcome) = showing else {
        panic!("{showing:?}");
    };
    assert_eq!(outcome.in_betweens().unwrap().len(), 8);
    assert_eq!(engine.running(), []);
    assert!(matches!(
        engine.showing(WorkKind::Transfer),
        Showing::Nothing
    ));
}

#[test]
fn kinds_of_analysis_stand_beside_each_other_and_are_cancelled_alone() {
    let mut engine = engine();
    let study = opened(&mut engine, 2_000);
    let map = AnalysisRequest::DeformationMap(DeformationMapSettings::default());
    engine.request(&study, AnalysisRequest::Measures);
    engine.request(&study, map);
    engine.cancel(WorkKind::DeformationMap);
    until(&mut engine, |engine| !engine.busy());
    assert!(engine.latest(WorkKind::Measures).is_some());
    assert!(engine.latest(WorkKind::DeformationMap).is_none());
    let showing = engine.showing(WorkKind::DeformationMap);
    assert!(matches!(showing, Showing::Stopped { .. }));
    engine.retry(&study, map);
    assert!(engine.busy());
}

#[test]
fn closing_the_window_while_work_runs_takes_less_than_half_a_second() {
    let mut engine = engine();
    let study = opened(&mut engine, 4_000);
    engine.request(&study, AnalysisRequest::PoseMap(PoseMapParams::default()));
    engine.request(&study, AnalysisRequest::Measures);
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
    assert_eq!(*written.unwrap(), std::slice::from_ref(&path));
    assert!(path.is_file());
    engine.start_export("Figure", "", |_| Err("no adapter".to_owned()));
    until(&mut engine, |engine| !engine.busy());
    let Showing::Failed { error, .. } = engine.export() else {
        panic!("{:?}", engine.export());
    };
    assert_eq!(error.to_string(), "no adapter");
}

#[test]
fn the_activity_list_names_files_without_their_folders() {
    let source = OpenSource::Paths(vec![PathBuf::from("/home/Jane Doe/n01/endo_0.ply")]);
    assert_eq!(source.words(), "endo_0.ply");
}

#[test]
fn thickening_is_stopped_retried_and_follows_a_slider() {
    let mut engine = engine();
    let study = opened(&mut engine, 2_500);
    let mut params = ThickeningSettings::default();
    let request = AnalysisRequest::Thickening { subject: 9, params };
    engine.request(&study, request);
    engine.cancel(WorkKind::Medial);
    until(&mut engine, |engine| !engine.busy());
    let stopped = |engine: &Engine| {
        let showing = engine.showing(WorkKind::Medial);
        matches!(showing, Showing::Stopped { .. })
    };
    assert!(stopped(&engine));
    engine.request(&study, request);
    assert!(
        stopped(&engine),
        "what was stopped does not begin by itself"
    );
    engine.retry(&study, request);
    until(&mut engine, |engine| !engine.busy());
    let found = |engine: &Engine| {
        let outcome = engine.latest(WorkKind::Medial).unwrap();
        Arc::clone(outcome.thickening().unwrap())
    };
    let first = found(&engine);
    for step in 1..4 {
        params.thickening.tolerance = Some(0.05 * f64::from(step));
        engine.request(&study, AnalysisRequest::Thickening { subject: 9, params });
        until(&mut engine, |engine| !engine.busy());
        assert!(Arc::ptr_eq(&found(&engine).beat, &first.beat));
        assert_eq!(found(&engine).thickening.tolerance, 0.05 * f64::from(step));
    }
    assert_eq!(engine.activities()[0].name, "Thickening");
    assert!(engine.activities()[0].parameters.contains("± 0.15"));
}
