//! Whole beats on other subjects.

use super::*;
use crate::analysis::alignment::rigid_motion;

fn greatest_gap(a: &MeshSequence, b: &MeshSequence) -> f64 {
    (0..a.frame_count())
        .flat_map(|frame| {
            let (a, b) = (a.pose(frame).unwrap(), b.pose(frame).unwrap());
            a.into_iter()
                .zip(b)
                .map(|(a, b)| (b - a).norm())
                .collect::<Vec<_>>()
        })
        .fold(0.0, f64::max)
}

fn changed(subject: &Subject, change: impl Fn(&Point3) -> Point3) -> Subject {
    let surface = &subject.sequence.surfaces()[0];
    let frames = surface.frames().iter().map(|mesh| {
        let points: Vec<Point3> = mesh.vertices().iter().map(&change).collect();
        TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
    });
    let surface = SurfaceSequence::new(surface.kind(), frames.collect()).unwrap();
    Subject {
        sequence: MeshSequence::new(vec![surface]).unwrap(),
        ..subject.clone()
    }
}

#[test]
fn a_beat_on_the_same_heart_comes_back_unchanged() {
    let one = Subject {
        end_diastole: Some(2),
        ..heart(1.0, 6)
    };
    for params in [straight(), TransportParams::default().check().unwrap()] {
        let back = transported_motion(&one, &one, &params, &Progress::default())
            .unwrap()
            .sequence;
        assert!(greatest_gap(&back, &one.sequence) < 1e-9);
        assert_eq!(back.pose(2), one.sequence.pose(2));
    }
}

#[test]
fn a_heart_that_was_turned_and_enlarged_moves_as_it_did_but_larger() {
    let one = heart(0.0, 5);
    let turn = Rotation3::from_euler_angles(0.3, -1.0, 2.0);
    let place = |p: &Point3| turn * (p * 1.25) + Vector3::new(100.0, -20.0, 7.0);
    let other = changed(&one, place);
    let there = transported_motion(&one, &other, &straight(), &Progress::default())
        .unwrap()
        .sequence;
    assert!(greatest_gap(&there, &other.sequence) < 1e-8);
}

#[test]
fn a_motion_starts_from_the_subject_it_is_transported_to_at_its_own_end_diastole() {
    let from = Subject {
        end_diastole: Some(4),
        ..heart(0.0, 5)
    };
    let onto = Subject {
        end_diastole: Some(1),
        ..heart(2.0, 3)
    };
    let params = TransportParams::default().check().unwrap();
    let there = transported_motion(&from, &onto, &params, &Progress::default())
        .unwrap()
        .sequence;
    assert_eq!(there.frame_count(), 5);
    assert_eq!(there.pose(4), onto.sequence.pose(1));
    assert_eq!(there.correspondence(), onto.sequence.correspondence());
    assert!(greatest_gap(&there, &from.sequence) > 1.0);
}

#[test]
fn it_does_not_matter_where_the_moving_heart_lies_or_how_large_it_is() {
    let (from, onto) = (heart(0.0, 4), heart(2.0, 4));
    let turn = Rotation3::from_euler_angles(-0.4, 0.2, 1.0);
    let elsewhere = changed(&from, |p| turn * (p * 0.8) + Vector3::new(3.0, 40.0, -9.0));
    let beat = |from: &Subject| {
        transported_motion(from, &onto, &straight(), &Progress::default())
            .unwrap()
            .sequence
    };
    assert!(greatest_gap(&beat(&from), &beat(&elsewhere)) < 1e-8);
}

#[test]
fn the_deformation_of_one_frame_is_the_heart_itself() {
    let one = heart(0.0, 1);
    let there = transported_motion(&one, &heart(1.0, 3), &straight(), &Progress::default())
        .unwrap()
        .sequence;
    assert_eq!(there.frame_count(), 1);
    assert_eq!(there.pose(0), heart(1.0, 3).sequence.pose(0));
    let faces = one.sequence.joined_faces();
    let none = transport_deformation(&faces, &[], &[], &straight(), &Progress::default());
    assert_eq!(none, Err(TransportError::NoPoses));
}

#[test]
fn hearts_that_do_not_fit_are_refused_with_both_names() {
    let surface = SurfaceSequence::new(SurfaceKind::Wall, vec![phantom::sphere(1, 1.0)]).unwrap();
    let ball = MeshSequence::new(vec![surface]).unwrap();
    let ball = Subject::new("ball", ball, LengthUnit::Millimetre);
    let error = |from: &Subject, onto: &Subject| {
        let beat = transported_motion(from, onto, &straight(), &Progress::default());
        beat.unwrap_err().to_string()
    };
    assert_eq!(
        error(&ball, &heart(0.0, 2)),
        "the vertices of ball (42 with 80 faces) do not correspond with those of heart 0 \
         (61 with 110 faces)"
    );
    let late = Subject {
        end_diastole: Some(9),
        ..heart(0.0, 2)
    };
    // An end-diastole beyond the last frame is none.
    let onto = |subject: &Subject| {
        transported_motion(&heart(0.3, 2), subject, &straight(), &Progress::default())
            .unwrap()
            .sequence
    };
    assert_eq!(greatest_gap(&onto(&late), &onto(&heart(0.0, 2))), 0.0);
    let point = changed(&heart(0.0, 2), |_| Point3::new(1.0, 2.0, 3.0));
    assert_eq!(
        error(&point, &heart(0.0, 2)),
        "the size of heart 0 at end-diastole (frame 0) is not measurable"
    );
}

#[test]
fn a_cohort_is_transported_to_its_mean_or_to_one_of_it() {
    let cohort = study((0..4).map(|who| heart(f64::from(who), 5)).collect());
    let metric = MetricParams::default().check().unwrap();
    for reference in [Reference::Mean, Reference::Subject(2)] {
        let params = CohortTransportParams {
            reference,
            ..CohortTransportParams::default()
        };
        let there = transport_cohort(&cohort, &metric, &params, &Progress::default()).unwrap();
        assert!(there.left_out.is_empty());
        assert_eq!(there.members.len(), 4);
        for member in &there.members {
            assert_eq!(member.poses.len(), 5);
            assert_eq!(member.poses[0], there.reference);
        }
        if reference == Reference::Subject(2) {
            // Its own beat comes back, size normalised.
            let own = &there.members[2];
            for (frame, pose) in own.poses.iter().enumerate() {
                let was = cohort.subjects[2].sequence.pose(frame).unwrap();
                for (p, was) in pose.iter().zip(&was) {
                    assert!((own.scale.restored(p) - was).norm() < 1e-9);
                }
            }
        }
    }
}

#[test]
fn the_mean_of_equal_hearts_is_that_heart() {
    let one = heart(1.0, 3);
    let other = changed(&one, |p| {
        Rotation3::from_euler_angles(1.0, 0.0, 0.2) * (p * 3.0)
    });
    let metric = MetricParams::default().check().unwrap();
    let params = CohortTransportParams::default();
    let cohort = study(vec![one, other]);
    let there = transport_cohort(&cohort, &metric, &params, &Progress::default()).unwrap();
    let first = &there.members[0];
    let rest: Vec<Point3> = (cohort.subjects[0].sequence.pose(0).unwrap().iter())
        .map(|p| first.scale.normalised(p))
        .collect();
    let motion = rigid_motion(&rest, &there.reference).unwrap();
    for (p, q) in rest.iter().zip(&there.reference) {
        assert!((motion.apply(p) - q).norm() < 1e-10);
    }
    for (a, b) in first
        .poses
        .iter()
        .flatten()
        .zip(there.members[1].poses.iter().flatten())
    {
        assert!((a - b).norm() < 1e-9);
    }
}

#[test]
fn the_same_cohort_gives_the_same_bits_with_any_number_of_threads() {
    let cohort = study((0..5).map(|who| heart(f64::from(who), 4)).collect());
    let metric = MetricParams::default().check().unwrap();
    let params = CohortTransportParams::default();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| transport_cohort(&cohort, &metric, &params, &Progress::default()))
            .unwrap()
    };
    assert_eq!(with(1), with(4));
}

#[test]
fn who_cannot_take_part_is_left_out_with_a_reason() {
    let surface = SurfaceSequence::new(SurfaceKind::Wall, vec![phantom::sphere(1, 1.0)]).unwrap();
    let ball = MeshSequence::new(vec![surface]).unwrap();
    let mut wild = heart(1.0, 3);
    wild = changed(&wild, |p| if p.z > -1.0 { *p } else { p * 1.0 });
    let far = {
        let mut meshes: Vec<TriMesh> = wild.sequence.surfaces()[0].frames().to_vec();
        let thrown: Vec<Point3> = meshes[1].vertices().iter().map(|p| p * 1e90).collect();
        meshes[1] = TriMesh::new(thrown, Arc::clone(meshes[0].faces())).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Endocardium, meshes).unwrap();
        Subject::new(
            "far",
            MeshSequence::new(vec![surface]).unwrap(),
            LengthUnit::Millimetre,
        )
    };
    let ball = Subject::new("ball", ball, LengthUnit::Millimetre);
    let cohort = study(vec![heart(0.0, 3), far, ball, heart(2.0, 3)]);
    let metric = MetricParams::default().check().unwrap();
    let params = CohortTransportParams {
        interpolated_poses: 0,
        ..CohortTransportParams::default()
    };
    let there = transport_cohort(&cohort, &metric, &params, &Progress::default()).unwrap();
    let left: Vec<usize> = there.left_out.iter().map(|left| left.subject).collect();
    assert_eq!(left, [1, 2]);
    assert!(
        there.left_out[0]
            .reason
            .starts_with("its motion cannot be transported")
    );
    assert_eq!(there.members.len(), 2);
    let onto_ball = CohortTransportParams {
        reference: Reference::Subject(2),
        ..params
    };
    let error = transport_cohort(&cohort, &metric, &onto_ball, &Progress::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("subject 2 of 4 cannot be used as the reference: its vertices")
    );
    let nobody = CohortTransportParams {
        reference: Reference::Subject(9),
        ..params
    };
    let error = transport_cohort(&cohort, &metric, &nobody, &Progress::default()).unwrap_err();
    assert!(error.to_string().ends_with("there is none"));
    let empty = transport_cohort(&Study::default(), &metric, &params, &Progress::default());
    assert_eq!(empty, Ok(TransportedCohort::default()));
}

#[test]
fn a_stopped_transport_says_so() {
    let cohort = study((0..3).map(|who| heart(f64::from(who), 3)).collect());
    let metric = MetricParams::default().check().unwrap();
    let progress = Progress::default();
    progress.stop();
    let params = CohortTransportParams::default();
    let stopped = transport_cohort(&cohort, &metric, &params, &progress);
    assert_eq!(stopped, Err(TransportError::Stopped(Stopped)));
    let (a, b) = (&cohort.subjects[0], &cohort.subjects[1]);
    let stopped = transported_motion(a, b, &straight(), &progress);
    assert_eq!(stopped, Err(TransportError::Stopped(Stopped)));
}

#[test]
fn one_geodesic_bent_for_all_steps_is_near_a_geodesic_for_each() {
    let (from, onto) = (heart(0.0, 4), heart(3.0, 4));
    let beat = |interpolated_poses: u16, geodesics: Geodesics| {
        let params = TransportParams {
            interpolated_poses,
            geodesics,
            max_vertices: None,
            ..TransportParams::default()
        };
        let params = params.check().unwrap();
        transported_motion(&from, &onto, &params, &Progress::default())
            .unwrap()
            .sequence
    };
    let moved = greatest_gap(
        &beat(0, Geodesics::First),
        &sequence_at_rest(&onto.sequence, 4),
    );
    let best = beat(3, Geodesics::EveryStep);
    let first = greatest_gap(&beat(3, Geodesics::First), &best) / moved;
    let straight = greatest_gap(&beat(0, Geodesics::First), &best) / moved;
    assert!(first < 0.02, "{first}");
    // Subjects this different: the straight way misses a tenth of the motion.
    assert!(straight > 4.0 * first, "{straight} {first}");
}

fn sequence_at_rest(sequence: &MeshSequence, frames: usize) -> MeshSequence {
    let surface = &sequence.surfaces()[0];
    let still = vec![surface.frames()[0].clone(); frames];
    let surface = SurfaceSequence::new(surface.kind(), still).unwrap();
    MeshSequence::new(vec![surface]).unwrap()
}
