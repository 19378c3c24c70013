//! What a document keeps and lets go of as subjects and positions change.

use super::*;
use crate::document::testing::{study_of, study_ref, subject_with_frames};
use crate::units::Seconds;

#[test]
fn a_position_comes_back_from_its_phase() {
    let mut subject = subject_with_frames("a", 5);
    for times in [None, Some(vec![0.0, 0.1, 0.3, 0.6, 0.7])] {
        subject.timing.frame_times_s = times;
        subject.timing.rr = Some(Seconds(0.9));
        for step in 0..50 {
            let position = f64::from(step) / 10.0;
            let back = position_at_phase(&subject, cycle_share(&subject, position));
            assert!(
                (back - position).abs() < 1e-9,
                "{position} came back as {back}"
            );
        }
    }
}

#[test]
fn selecting_another_heart_keeps_the_phase() {
    let study = study_of(vec![
        subject_with_frames("a", 8),
        subject_with_frames("b", 4),
    ]);
    let mut document = Document::new(study_ref(study));
    document.position = 4.0;
    document.select_subject(1);
    assert!((document.position - 2.0).abs() < 1e-12);
}

#[test]
fn past_the_last_half_frame_the_first_pose_is_nearest() {
    assert_eq!(nearest_frame(7.4, 8), 7);
    assert_eq!(nearest_frame(7.6, 8), 0);
    assert_eq!(nearest_frame(0.2, 1), 0);
}

#[test]
fn an_edit_makes_another_revision_and_leaves_the_old_study_alone() {
    let study = study_of(vec![subject_with_frames("a", 3)]);
    let mut document = Document::new(study_ref(Arc::clone(&study)));
    let before = document.clone();
    let mut edited = Subject::clone(&study.subjects[0]);
    edited.end_systole = Some(2);
    document.show_edited(study.with_subject(0, edited, Revision(77)));
    assert_ne!(document, before);
    assert_eq!(document.study().subjects[0].end_systole, Some(2));
    assert_eq!(study.subjects[0].end_systole, None);
}

#[test]
fn typed_limits_belong_to_their_quantity() {
    let mut document = Document::new(study_ref(study_of(vec![subject_with_frames("a", 3)])));
    document.quantity = Quantity::Displacement;
    document.set_limits(Some([0.0, 5.0]));
    document.quantity = Quantity::AreaRatio;
    assert_eq!(document.limits(), None);
    document.quantity = Quantity::Displacement;
    assert_eq!(document.limits(), Some([0.0, 5.0]));
}
