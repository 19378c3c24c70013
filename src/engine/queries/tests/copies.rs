//! Classes of a study that lists a subject more than once, and of labels that count as normal and abnormal.

use super::*;

#[test]
fn a_study_that_lists_every_subject_twice_classifies_each_once() {
    let study = two_classes();
    let mut doubled = Study::clone(&study);
    for subject in &study.subjects {
        let mut copy = Subject::clone(subject);
        copy.id += " again";
        doubled.subjects.push(Arc::new(copy));
    }
    doubled.revision = Revision(8);
    let found = ask(&store(), &Arc::new(doubled), &classes());
    let (nearest, linear) = (
        found.nearest_neighbour.unwrap(),
        found.linear_classifier.unwrap(),
    );
    assert_eq!((nearest.of, linear.of), (10, 10));
    // A subject of random label would be told by its copy.
    assert_eq!(found.of_row.iter().flatten().count(), 10);
}

#[test]
fn labels_are_told_apart_as_they_are_and_as_normal_and_abnormal() {
    let mut study = Study::clone(&two_classes());
    for (index, subject) in study.subjects.iter_mut().enumerate() {
        Arc::make_mut(subject).label =
            Some(["NOR", "NOR", "DCM", "MINF", "RV"][index / 2].to_owned());
    }
    study.label_classes.normal = vec!["NOR".to_owned()];
    study.label_classes.abnormal = vec!["DCM".to_owned(), "MINF".to_owned()];
    let study = Arc::new(study);
    let by_label = ask(&store(), &study, &classes());
    assert_eq!(by_label.names, ["DCM", "MINF", "NOR", "RV"]);
    let by_role = ClassesQuery {
        by: ClassesBy::Class,
        ..classes()
    };
    let by_role = ask(&store(), &study, &by_role);
    assert_eq!(by_role.names, ["abnormal", "normal"]);
    // RV counts as neither.
    assert_eq!(by_role.nearest_neighbour.unwrap().of, 8);
}
