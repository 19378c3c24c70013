//! Laws of the matrix of pose distances, and what it does with odd subjects.

use std::sync::Arc;

use nalgebra::Rotation3;

use super::*;
use crate::analysis::metrics::{Corners, Form, METRICS, MetricParams};
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::mesh::{Point3, TriMesh, Vector3, phantom};
use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// A beating bowl without symmetry.
pub(super) fn beat(size: f64, squeeze: f64, frames: u32) -> Vec<TriMesh> {
    let rest = phantom::bowl(1.0, 6, 12);
    (0..frames)
        .map(|frame| {
            let t = f64::from(frame) / f64::from(frames);
            let narrow = 1.0 - squeeze * (std::f64::consts::PI * t).sin();
            let points: Vec<Point3> = rest
                .vertices()
                .iter()
                .map(|p| {
                    Point3::new(
                        size * narrow * (p.x + 0.15 * p.z * p.z),
                        size * (0.9 * p.y + 0.1 * t * p.x * p.z),
                        size * 1.8 * p.z * (1.0 - 0.3 * squeeze * t),
                    )
                })
                .collect();
            TriMesh::new(points, Arc::clone(rest.faces())).unwrap()
        })
        .collect()
}

pub(super) fn subject(id: &str, frames: Vec<TriMesh>) -> Arc<Subject> {
    let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre))
}

fn study(subjects: Vec<Arc<Subject>>) -> Study {
    Study {
        subjects,
        ..Study::default()
    }
}

fn moved(frames: &[TriMesh]) -> Vec<TriMesh> {
    let turn = Rotation3::from_euler_angles(0.7, -1.3, 2.1);
    let points = |mesh: &TriMesh| -> Vec<Point3> {
        (mesh.vertices().iter())
            .map(|p| turn * p + Vector3::new(30.0, -12.0, 8.0))
            .collect()
    };
    (frames.iter())
        .map(|mesh| TriMesh::new(points(mesh), Arc::clone(mesh.faces())).unwrap())
        .collect()
}

fn distances(study: &Study) -> PoseDistances {
    let params = PoseDistanceParams::default().check().unwrap();
    pose_distances(study, &params, &Progress::default()).unwrap()
}

fn two_hearts() -> Study {
    study(vec![
        subject("a", beat(40.0, 0.3, 5)),
        subject("b", beat(50.0, 0.1, 4)),
    ])
}

#[test]
fn rows_go_by_subject_and_then_by_frame() {
    let result = distances(&two_hearts());
    assert_eq!(result.poses.len(), 9);
    assert_eq!(
        result.poses[5],
        PoseId {
            subject: 1,
            frame: 0
        }
    );
    // Both subjects have one shape at frame 0, in two sizes.
    assert!(result.distances.get(0, 5) < 1e-12);
    assert!(result.distances.get(0, 2) > 1e-2 && result.distances.get(2, 6) > 1e-2);
    assert!(result.left_out.is_empty());
}

#[test]
fn moving_or_scaling_a_heart_changes_no_distance() {
    let before = distances(&two_hearts());
    let scaled: Vec<TriMesh> = beat(65.0, 0.1, 4);
    let after = distances(&study(vec![
        subject("a", moved(&beat(40.0, 0.3, 5))),
        subject("b", moved(&scaled)),
    ]));
    for (d, e) in before.distances.upper().iter().zip(after.distances.upper()) {
        assert!((d - e).abs() < 1e-12, "{d} {e}");
    }
}

#[test]
fn a_distance_depends_on_its_two_poses_alone() {
    let two = distances(&two_hearts());
    let three = distances(&study(vec![
        subject("a", beat(40.0, 0.3, 5)),
        subject("b", beat(50.0, 0.1, 4)),
        subject("c", beat(45.0, 0.5, 3)),
    ]));
    assert_eq!(two.distances.get(1, 7), three.distances.get(1, 7));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let study = two_hearts();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| distances(&study))
    };
    assert_eq!(with(1), with(5));
}

#[test]
fn subjects_of_another_connectivity_or_without_size_are_left_out_with_a_reason() {
    let flat = |mesh: &TriMesh| {
        let points = vec![Point3::new(1.0, 2.0, 3.0); mesh.vertices().len()];
        TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
    };
    let collapsed: Vec<TriMesh> = beat(40.0, 0.3, 2).iter().map(flat).collect();
    let mut late = (*subject("late", beat(40.0, 0.2, 2))).clone();
    late.end_diastole = Some(7);
    let result = distances(&study(vec![
        subject("sphere", vec![phantom::sphere(2, 1.0)]),
        subject("a", beat(40.0, 0.3, 2)),
        subject("point", collapsed),
        Arc::new(late),
    ]));
    // An end-diastole beyond the last frame is none: that subject begins at frame 0.
    let taken: Vec<usize> = result.poses.iter().map(|pose| pose.subject).collect();
    assert_eq!(taken, [1, 1, 3, 3]);
    let reasons: Vec<&str> = result.left_out.iter().map(|l| l.reason.as_str()).collect();
    assert_eq!(
        reasons,
        [
            "its vertices (162 with 320 faces) do not correspond with those of a (73 with 132 faces)",
            "its size at end-diastole (frame 0) is not measurable",
        ]
    );
}

#[test]
fn folded_faces_and_coinciding_vertices_give_finite_distances() {
    let damaged = |mesh: &TriMesh| {
        let mut points = mesh.vertices().to_vec();
        points[1] = points[0];
        points[2] = points[0];
        points[30] = points[31];
        TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
    };
    let frames: Vec<TriMesh> = beat(40.0, 0.3, 3).iter().map(damaged).collect();
    let collapsed = TriMesh::new(
        vec![Point3::origin(); frames[0].vertices().len()],
        Arc::clone(frames[0].faces()),
    );
    let study = study(vec![
        subject("damaged", [frames, vec![collapsed.unwrap()]].concat()),
        subject("a", beat(40.0, 0.2, 2)),
    ]);
    for kind in METRICS {
        for form in [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive] {
            for (corners, area_weights) in [(Corners::Raw, false), (Corners::ScaleFree, true)] {
                let metric = MetricParams {
                    kind,
                    form,
                    corners,
                    area_weights,
                    ..MetricParams::default()
                };
                let params = PoseDistanceParams {
                    metric,
                    transport: None,
                    ..PoseDistanceParams::default()
                }
                .check()
                .unwrap();
                let result = pose_distances(&study, &params, &Progress::default()).unwrap();
                assert_eq!(result.poses.len(), 6, "{metric:?}");
            }
        }
    }
}

#[test]
fn nothing_gives_nothing() {
    assert!(distances(&Study::default()).poses.is_empty());
}

#[test]
fn a_stopped_matrix_says_so() {
    let progress = Progress::default();
    progress.stop();
    let params = PoseDistanceParams::default().check().unwrap();
    assert_eq!(
        pose_distances(&two_hearts(), &params, &progress),
        Err(PoseDistanceError::Stopped(Stopped))
    );
}

#[test]
fn in_bands_of_a_few_poses_distances_have_the_same_bits_and_leave_out_the_same() {
    let huge = beat(1e300, 0.2, 5);
    let hearts = study(vec![
        subject("a", beat(30.0, 0.3, 9)),
        subject("huge", huge),
        subject("b", beat(25.0, 0.4, 11)),
        subject("c", beat(28.0, 0.1, 8)),
    ]);
    let params = PoseDistanceParams::default().check().unwrap();
    let within = |bytes| {
        computed(
            &hearts,
            &params,
            (None, &|_, _| true),
            bytes,
            &Progress::default(),
        )
        .unwrap()
    };
    let whole = within(usize::MAX);
    assert!(whole.distances.poses.len() > 2 * 8, "more than two bands");
    assert_eq!(within(1), whole);
}
