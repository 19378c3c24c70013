//! Who belongs to a study after edits, in which order, and under which names.

use proptest::prelude::*;

use super::*;
use crate::mesh::phantom;
use crate::study::{LabelClasses, MeshSequence, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

fn subject(id: &str) -> Arc<Subject> {
    let cavity = SurfaceSequence::new(SurfaceKind::Cavity, vec![phantom::sphere(1, 30.0)]);
    let sequence = MeshSequence::new(vec![cavity.unwrap()]).unwrap();
    Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
}

fn study(ids: &[&str]) -> Study {
    Study {
        subjects: ids.iter().map(|id| subject(id)).collect(),
        ..Study::default()
    }
}

fn ids<'a>(subjects: impl IntoIterator<Item = &'a Arc<Subject>>) -> Vec<&'a str> {
    subjects.into_iter().map(|s| s.id.as_str()).collect()
}

fn in_order(study: &Study) -> Vec<&str> {
    let order = study.in_order();
    ids(order.into_iter().filter_map(|index| study.subject(index)))
}

#[test]
fn an_excluded_subject_keeps_its_place_and_comes_back_to_it() {
    let whole = study(&["a", "b", "c", "d"]);
    let one = whole.excluding(1, Revision(1)).unwrap();
    let two = one.excluding(1, Revision(2)).unwrap();
    assert_eq!(ids(&two.subjects), ["a", "d"]);
    assert_eq!(ids(two.all()), ["a", "d", "b", "c"]);
    assert_eq!(in_order(&two), ["a", "b", "c", "d"]);
    assert!(two.is_excluded(2) && !two.is_excluded(1));
    assert_eq!(two.index_of("c"), Some(3));
    // In either order they are where they were.
    let c = two.including(3, Revision(3)).unwrap();
    assert_eq!(ids(&c.subjects), ["a", "c", "d"]);
    let b = two.including(2, Revision(3)).unwrap();
    assert_eq!(ids(&b.subjects), ["a", "b", "d"]);
    let back = c.including(3, Revision(4)).unwrap();
    assert_eq!(ids(&back.subjects), ["a", "b", "c", "d"]);
    assert!(back.excluded.is_empty());
}

#[test]
fn the_last_subject_of_a_cohort_stays() {
    let study = study(&["a", "b"]).excluding(0, Revision(1)).unwrap();
    let last = EditError::LastSubject { id: "b".to_owned() };
    assert_eq!(study.excluding(0, Revision(2)).unwrap_err(), last);
    assert_eq!(study.removing(0, Revision(2)).unwrap_err(), last);
    assert_eq!(last.to_string(), "b is the only subject of the cohort");
    // Who is excluded may go.
    let alone = study.removing(1, Revision(2)).unwrap();
    assert_eq!(ids(alone.all()), ["b"]);
    for index in [1, 9] {
        let none = alone.including(index, Revision(3)).unwrap_err();
        assert_eq!(none, EditError::NoSubject);
    }
    assert!(alone.excluding(7, Revision(3)).is_err());
}

#[test]
fn an_id_is_not_empty_and_not_that_of_another_subject() {
    let study = study(&["a", "b", "c"]).excluding(2, Revision(1)).unwrap();
    assert_eq!(study.check_id(0, "  ").unwrap_err(), EditError::EmptyId);
    for taken in ["b", " c "] {
        let id = taken.trim().to_owned();
        let refused = study.check_id(0, taken).unwrap_err();
        assert_eq!(refused, EditError::TakenId { id });
    }
    study.check_id(0, "a").unwrap();
    study.check_id(0, "d").unwrap();
}

#[test]
fn a_label_has_one_spelling_in_a_study_and_an_empty_one_is_none() {
    let mut study = study(&["a", "b", "c"]);
    study.label_classes = LabelClasses {
        normal: vec!["NOR".to_owned()],
        abnormal: Vec::new(),
    };
    let one = study.labelling(&[0], " Minf ", Revision(1));
    assert_eq!(one.subjects[0].label.as_deref(), Some("Minf"));
    let two = one.labelling(&[1, 2], "MINF", Revision(2));
    assert_eq!(two.subjects[2].label.as_deref(), Some("Minf"));
    // Its own spelling can be corrected where no other subject has it.
    let corrected = one.labelling(&[0], "MINF", Revision(2));
    assert_eq!(corrected.subjects[0].label.as_deref(), Some("MINF"));
    let normal = two.labelling(&[1], "nor", Revision(3));
    assert_eq!(normal.subjects[1].label.as_deref(), Some("NOR"));
    assert_eq!(normal.labels(), ["Minf", "NOR"]);
    let none = normal.labelling(&[0, 1, 2], "  ", Revision(4));
    assert!(none.subjects.iter().all(|subject| subject.label.is_none()));
}

#[test]
fn a_label_has_one_role() {
    let study = study(&["a"]).labelling(&[0], "MINF", Revision(1));
    let class = |study: &Study| study.class_of(&study.subjects[0]);
    assert_eq!(class(&study), LabelClass::Neither);
    let abnormal = study.with_class("MINF", LabelClass::Abnormal, Revision(2));
    assert_eq!(class(&abnormal), LabelClass::Abnormal);
    let normal = abnormal.with_class("minf", LabelClass::Normal, Revision(3));
    assert_eq!(class(&normal), LabelClass::Normal);
    assert_eq!(normal.label_classes.abnormal, ["abnormal"]);
    let none = normal.with_class("MINF", LabelClass::Neither, Revision(4));
    assert_eq!(none.label_classes, study.label_classes);
}

#[test]
fn added_subjects_come_last_under_ids_of_their_own() {
    let own = study(&["a", "b"]).excluding(0, Revision(1)).unwrap();
    let mut other = study(&["a", "b", "b (2)"])
        .excluding(1, Revision(2))
        .unwrap();
    other.label_classes.abnormal.push("DCM".to_owned());
    let both = own.adding(&other, Revision(3));
    assert_eq!(
        in_order(&both),
        ["a", "b", "a (2)", "b (2)", "b (2) (2)"],
        "no subject of either changes its place"
    );
    assert_eq!(ids(&both.subjects), ["b", "a (2)", "b (2) (2)"]);
    assert_eq!(
        both.label_classes.class_of(Some("dcm")),
        LabelClass::Abnormal
    );
    let note = &both.subjects[1].notices[0].text;
    assert!(
        note.contains("\"a\"") && note.contains("\"a (2)\""),
        "{note}"
    );
}

/// An edit by the number of the subject that it concerns.
#[derive(Clone, Copy, Debug)]
enum Edit {
    Exclude(usize),
    Include(usize),
    Remove(usize),
}

fn edit() -> impl Strategy<Value = Edit> {
    prop_oneof![
        (0..9_usize).prop_map(Edit::Exclude),
        (0..9_usize).prop_map(Edit::Include),
        (0..9_usize).prop_map(Edit::Remove),
    ]
}

proptest! {
    #[test]
    fn whatever_is_excluded_included_and_removed_the_order_is_that_of_the_input(
        edits in prop::collection::vec(edit(), 0..24)
    ) {
        let mut study = study(&["a", "b", "c", "d", "e", "f"]);
        for edit in edits {
            let edited = match edit {
                Edit::Exclude(index) => study.excluding(index, Revision(1)),
                Edit::Include(index) => study.including(index, Revision(1)),
                Edit::Remove(index) => study.removing(index, Revision(1)),
            };
            study = edited.unwrap_or(study);
            prop_assert!(in_order(&study).is_sorted());
            prop_assert!(ids(&study.subjects).is_sorted());
            prop_assert!(!study.subjects.is_empty());
            let mut indices = study.in_order();
            indices.sort_unstable();
            prop_assert_eq!(indices, (0..study.count()).collect::<Vec<_>>());
        }
    }
}
