//! Copies however they are moved, rounded or many, and what labels of copies count.

use super::*;
use crate::mesh::{TriMesh, phantom};
use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// A heart of its own shape, moved as asked.
fn heart(id: &str, shape: f64, frames: usize, place: impl Fn(Point3) -> Point3) -> Arc<Subject> {
    let ball = phantom::sphere(2, 30.0);
    let meshes = (0..frames)
        .map(|frame| {
            let beat = 1.0 - 0.05 * frame as f64;
            let points: Vec<Point3> = (ball.vertices().iter())
                .map(|p| place(Point3::new(p.x * beat, p.y * (1.0 + shape), p.z * beat)))
                .collect();
            TriMesh::new(points, ball.faces().clone()).unwrap()
        })
        .collect();
    let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
}

fn labelled(mut subject: Arc<Subject>, label: &str) -> Arc<Subject> {
    Arc::make_mut(&mut subject).label = Some(label.to_owned());
    subject
}

#[test]
fn copies_are_found_moved_turned_rounded_or_cut_short() {
    let motion = nalgebra::Isometry3::new(
        Vector3::new(120.0, -40.0, 1e5),
        Vector3::new(0.3, -1.2, 0.7),
    );
    let rounded = |p: Point3| p.map(|x| (x * 100.0).round() / 100.0);
    let subjects = [
        heart("a", 0.1, 4, |p| p),
        heart("b", 0.2, 4, |p| p),
        heart("a again", 0.1, 4, |p| p),
        heart("a elsewhere", 0.1, 4, |p| motion * p),
        heart("b in two digits", 0.2, 4, rounded),
        heart("a at two frames", 0.1, 2, |p| p),
        heart("c", 0.11, 4, |p| p),
    ];
    let copies = Copies::of(&subjects);
    assert_eq!(copies.groups(), [vec![0, 2, 3, 5], vec![1, 4]]);
    assert!(copies.are_copies(3, 5) && !copies.are_copies(0, 6));
    assert_eq!(copies.first_of(6), 6);
    let text = &copies.notices(&subjects)[0].text;
    assert!(
        text.contains("same meshes") && text.contains("b = b in two digits"),
        "{text}"
    );
    assert_eq!(Copies::of(&subjects[..2]).notices(&subjects), []);
    assert_eq!(*Copies::of(&[]), Copies::default());
    let again = Copies::of(&subjects);
    assert!(Arc::ptr_eq(&again, &Copies::of(&subjects)) || *again == *copies);
}

#[test]
fn subjects_that_share_some_frames_are_told_and_are_no_copies() {
    let cavity = |id: &str, radii: &[f64]| {
        let meshes = radii.iter().map(|&radius| phantom::sphere(1, radius));
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes.collect()).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
    };
    let subjects = [
        cavity("a", &[30.0, 20.0, 25.0]),
        cavity("b", &[30.0, 20.0, 27.0]),
        cavity("b again", &[30.0, 20.0, 27.0]),
        cavity("c", &[33.0, 22.0]),
    ];
    let copies = Copies::of(&subjects);
    assert_eq!(copies.groups(), [vec![1, 2]]);
    let notices = copies.notices(&subjects);
    assert_eq!(notices.len(), 2);
    assert!(
        notices[1].text.ends_with("two ids: a and b (2 frames)"),
        "{notices:?}"
    );
}

#[test]
fn thousands_of_copies_are_one_group() {
    let one = heart("a", 0.1, 2, |p| p);
    let mut subjects = vec![heart("b", 0.2, 3, |p| p), heart("b cut", 0.2, 2, |p| p)];
    subjects.extend(std::iter::repeat_n(one, 3_000));
    let copies = Copies::of(&subjects);
    let sizes: Vec<usize> = copies.groups().iter().map(Vec::len).collect();
    assert_eq!(sizes, [2, 3_000]);
    assert_eq!((copies.first_of(1), copies.first_of(3_001)), (0, 2));
}

#[test]
fn a_label_counts_once_and_labels_that_differ_do_not_count() {
    let subjects = [
        labelled(heart("a", 0.1, 2, |p| p), "ill"),
        labelled(heart("a2", 0.1, 2, |p| p), " ILL"),
        labelled(heart("b", 0.2, 2, |p| p), "ill"),
        labelled(heart("b2", 0.2, 2, |p| p), "normal"),
        heart("c", 0.3, 2, |p| p),
        labelled(heart("c2", 0.3, 2, |p| p), "normal"),
    ];
    let copies = Copies::of(&subjects);
    assert_eq!(
        copies.labels_once(&subjects),
        [Some("ill"), None, None, None, Some("normal"), None]
    );
    assert!(
        copies.notices(&subjects)[0]
            .text
            .contains("different labels")
    );
}
