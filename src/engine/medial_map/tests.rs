//! What the map of a cohort finds again, who is left out, and that it can be stopped.

use std::sync::Arc;

use super::*;
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Revision};

fn study() -> Study {
    let params = BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole.subjects.iter().filter(|s| s.id.starts_with('P'));
    let mut subjects = vec![Arc::clone(&whole.subjects[0])];
    subjects.extend(ill.take(2).map(Arc::clone));
    Study {
        subjects,
        revision: Revision(3),
        ..whole
    }
}

fn settings() -> ThickeningSettings {
    let mut settings = ThickeningSettings::default();
    settings.thickening.redraws = 3;
    settings
}

fn request(method: MapMethod) -> AnalysisRequest {
    AnalysisRequest::MedialMap(MedialMapParams {
        thickening: settings(),
        method,
    })
}

#[test]
fn another_method_assesses_no_wall_again_and_the_same_question_is_answered_from_the_cache() {
    let (study, cache) = (study(), Cache::default());
    let asked = request(MapMethod::ClassicalMds);
    let first = run(&study, &asked, &cache, &Progress::default()).unwrap();
    let map = first.medial_map().unwrap();
    assert!(map.left_out.is_empty(), "{:?}", map.left_out);
    let known = cache.get(&study, &AnalysisRequest::MedialPaths(settings()));
    assert_eq!(known.unwrap().medial_paths().unwrap().len(), 3);
    let stopped = Progress::default();
    stopped.stop();
    let again = run(&study, &asked, &cache, &stopped).unwrap();
    assert!(Arc::ptr_eq(again.medial_map().unwrap(), map));
    let other = run(
        &study,
        &request(MapMethod::Smacof),
        &cache,
        &Progress::default(),
    )
    .unwrap();
    let other = other.medial_map().unwrap();
    assert_eq!(other.distances, map.distances);
    let [classical, majorised] = [map, other].map(|map| map.embedding.stress.unwrap());
    assert!(majorised <= classical + 1e-9, "{majorised} {classical}");
    // Walls are answers of their own: those of hearts that an edit left alone are found again.
    let walls = AnalysisRequest::Thickening {
        subject: 1,
        params: settings(),
    };
    assert!(cache.get(&study, &walls).is_some());
}

#[test]
fn a_heart_without_wall_is_left_out_with_its_reason() {
    let mut study = study();
    let mut hollow = (*study.subjects[1]).clone();
    let endocardium = hollow.sequence.surfaces()[0].clone();
    hollow.sequence = MeshSequence::new(vec![endocardium]).unwrap();
    study.subjects[1] = Arc::new(hollow);
    let outcome = run(
        &study,
        &request(MapMethod::Smacof),
        &Cache::default(),
        &Progress::default(),
    );
    let outcome = outcome.unwrap();
    let map = outcome.medial_map().unwrap();
    assert_eq!(map.left_out.len(), 1);
    assert_eq!(map.left_out[0].0, 1);
    assert!(
        map.left_out[0].1.starts_with("no wall"),
        "{:?}",
        map.left_out
    );
    assert!(map.poses.iter().all(|pose| pose.subject != 1));
    study.subjects = vec![Arc::clone(&study.subjects[1])];
    let error = run(
        &study,
        &request(MapMethod::Smacof),
        &Cache::default(),
        &Progress::default(),
    );
    let said = error.unwrap_err().to_string();
    assert!(said.starts_with("0 poses of 0 hearts"), "{said}");
}

#[test]
fn stopped_work_is_not_an_answer() {
    let (study, cache) = (study(), Cache::default());
    let progress = Progress::default();
    progress.stop();
    let asked = request(MapMethod::Smacof);
    let error = run(&study, &asked, &cache, &progress).unwrap_err();
    assert_eq!(error, AnalysisError::Stopped(Stopped));
    assert!(cache.get(&study, &asked).is_none());
}
