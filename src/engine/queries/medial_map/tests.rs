//! What the map of a cohort finds again, who is left out, and that it can be stopped.

use std::sync::Arc;

use super::*;
use crate::engine::queries::tests::{ask, edited, is_stopped, refusal, store};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Revision, Study};

fn study() -> Arc<Study> {
    let params = BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole.subjects.iter().filter(|s| s.id.starts_with('P'));
    let mut subjects = vec![Arc::clone(&whole.subjects[0])];
    subjects.extend(ill.take(2).map(Arc::clone));
    Arc::new(Study {
        subjects,
        revision: Revision(3),
        ..whole
    })
}

fn settings() -> ThickeningSettings {
    let mut settings = ThickeningSettings::default();
    settings.patches.redraws = 3;
    settings
}

fn query(method: MapMethod) -> MedialMapQuery {
    MedialMapQuery {
        thickening: settings(),
        method,
    }
}

#[test]
fn another_method_assesses_no_wall_again_and_the_same_question_keeps_its_answer() {
    let (study, store) = (study(), store());
    let asked = query(MapMethod::ClassicalMds);
    let map = ask(&store, &study, &asked);
    assert!(map.left_out.is_empty(), "{:?}", map.left_out);
    let paths = MedialPathsQuery {
        thickening: settings(),
    };
    assert_eq!(store.known(&study, &paths).unwrap().len(), 3);
    assert!(Arc::ptr_eq(&ask(&store, &study, &asked), &map));
    let other = ask(&store, &study, &query(MapMethod::Smacof));
    assert_eq!(other.distances, map.distances);
    let [classical, majorised] = [&map, &other].map(|map| map.embedding.stress.unwrap());
    assert!(majorised <= classical + 1e-9, "{majorised} {classical}");
    // Walls are answers of their own: those of hearts that an edit left alone are found again.
    assert_eq!(store.answers::<WallThickeningQuery>(), 3);
    assert_eq!(store.answers::<MedialPathsQuery>(), 1);
}

#[test]
fn a_heart_without_wall_is_left_out_with_its_reason() {
    let study = edited(&study(), 1, |hollow| {
        let endocardium = hollow.sequence.surfaces()[0].clone();
        hollow.sequence = MeshSequence::new(vec![endocardium]).unwrap();
    });
    let map = ask(&store(), &study, &query(MapMethod::Smacof));
    assert_eq!(map.left_out.len(), 1);
    assert_eq!(map.left_out[0].0, 1);
    assert!(
        map.left_out[0].1.starts_with("no wall"),
        "{:?}",
        map.left_out
    );
    assert!(map.poses.iter().all(|pose| pose.subject != 1));
    let alone = Arc::new(Study {
        subjects: vec![Arc::clone(&study.subjects[1])],
        ..Study::clone(&study)
    });
    let message = refusal(&store(), &alone, &query(MapMethod::Smacof));
    assert!(message.starts_with("0 poses of 0 subjects"), "{message}");
}

#[test]
fn stopped_work_is_not_an_answer() {
    assert!(is_stopped(&store(), &study(), &query(MapMethod::Smacof)));
}
