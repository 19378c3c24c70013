//! Deformation and shape apart: what each part sees, and what it does not.

use super::*;
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::mesh::{Point3, TriMesh};

/// A half sphere that contracts by `amount`, its length `long` times as long, and laid anywhere.
fn heart(long: f64, size: f64, frames: u32, amount: f64, turned: f64) -> Arc<Subject> {
    let bowl = phantom::bowl(size, 5, 12);
    let turn = nalgebra::Rotation3::from_euler_angles(turned, 2.0 * turned, 0.0);
    let meshes = (0..frames).map(|frame| {
        let phase = std::f64::consts::TAU * f64::from(frame) / f64::from(frames);
        let contracted = amount * 0.5 * (1.0 - phase.cos());
        let points = bowl.vertices().iter().map(|p| {
            let across = 1.0 - contracted;
            turn * Point3::new(across * p.x, across * p.y, long * p.z)
                + nalgebra::Vector3::x() * turned
        });
        TriMesh::new(points.collect::<Vec<Point3>>(), Arc::clone(bowl.faces())).unwrap()
    });
    let surface = SurfaceSequence::new(SurfaceKind::Endocardium, meshes.collect()).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    Arc::new(Subject::new("a", sequence, LengthUnit::Millimetre))
}

fn parts_of(subjects: Vec<Arc<Subject>>) -> PartDistances {
    let study = Study {
        subjects,
        ..Study::default()
    };
    let params = PartParams::like(&PoseDistanceParams::default(), 0.0);
    part_distances(&study, &params.check().unwrap(), &Progress::default()).unwrap()
}

#[test]
fn one_motion_of_a_heart_and_its_copy_of_another_size_is_at_no_distance() {
    // A quarter turn keeps the largest side of the box that says the size.
    let parts = parts_of(vec![
        heart(1.5, 1.0, 8, 0.3, 0.0),
        heart(1.5, 40.0, 8, 0.3, std::f64::consts::FRAC_PI_2),
        heart(1.5, 1.0, 8, 0.1, 0.0),
    ]);
    let far = parts.deformation.get(0, 2);
    assert!(far > 0.05, "{far}");
    assert!(parts.deformation.get(0, 1) < 1e-6 * far);
    assert!(parts.shape.get(0, 1) < 1e-9 && parts.shape.get(0, 2) < 1e-9);
    assert_eq!(parts.shape_share(0, 2), Some(0.0));
    assert_eq!(parts.subjects, [0, 1, 2]);
}

#[test]
fn hearts_of_other_shapes_that_move_alike_differ_in_shape() {
    let parts = parts_of(vec![
        heart(1.2, 1.0, 6, 0.3, 0.0),
        heart(1.8, 1.0, 6, 0.3, 0.0),
        heart(1.2, 1.0, 6, 0.1, 0.0),
        heart(1.8, 1.0, 6, 0.1, 0.0),
    ]);
    let share = |i, j| parts.shape_share(i, j).unwrap();
    assert!(share(0, 1) > 0.9, "{}", share(0, 1));
    assert!(share(0, 2) < 1e-9, "{}", share(0, 2));
    assert!((0.1..0.9).contains(&share(0, 3)), "{}", share(0, 3));
}

#[test]
fn frames_at_other_phases_change_a_deformation_by_no_more_than_their_corners() {
    let parts = parts_of(vec![
        heart(1.5, 1.0, 16, 0.3, 0.0),
        heart(1.5, 1.0, 32, 0.3, 0.0),
        heart(1.5, 1.0, 16, 0.1, 0.0),
    ]);
    assert!(parts.deformation.get(0, 1) < 0.05 * parts.deformation.get(0, 2));
}

#[test]
fn parts_are_weighted_by_their_medians() {
    let matrix = |upper: [f64; 3]| DistanceMatrix::from_upper(3, upper.to_vec()).unwrap();
    let (deformation, shape) = (matrix([1.0, 2.0, 4.0]), matrix([30.0, 10.0, 0.0]));
    let parts = PartDistances::new(vec![0, 1, 2], [deformation, shape], Vec::new(), Vec::new());
    let weighted = parts.weighted(PartWeights {
        deformation: 2.0,
        shape: 0.5,
    });
    let expected: f64 = 2.0 * 0.25 + 0.5 * 9.0;
    assert!((weighted.get(0, 1) - expected.sqrt()).abs() < 1e-12);
    assert!((parts.shape_share(0, 1).unwrap() - 9.0 / 9.25).abs() < 1e-12);
    assert_eq!(parts.shape_share(1, 2), Some(0.0));
    assert!((parts.median_shape_share().unwrap() - 0.5).abs() < 1e-12);
    let alone = parts.weighted(PartWeights::DEFORMATION);
    assert_eq!([alone.get(0, 1), alone.get(1, 2)], [0.5, 2.0]);
    // Where no two differ in a part, it counts for nothing instead of dividing by it.
    let same = matrix([0.0; 3]);
    let parts = PartDistances::new(vec![0, 1, 2], [same.clone(), same], Vec::new(), Vec::new());
    assert_eq!(parts.weighted(PartWeights::BOTH).get(0, 1), 0.0);
    assert_eq!(
        (parts.shape_share(0, 1), parts.median_shape_share()),
        (None, None)
    );
}

#[test]
fn a_heart_that_does_not_correspond_is_left_out_of_both_parts() {
    let stranger = phantom::sphere(2, 1.0);
    let surface = SurfaceSequence::new(SurfaceKind::Endocardium, vec![stranger; 6]).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    let stranger = Arc::new(Subject::new("b", sequence, LengthUnit::Millimetre));
    let parts = parts_of(vec![
        heart(1.2, 1.0, 6, 0.3, 0.0),
        stranger,
        heart(1.8, 1.0, 6, 0.3, 0.0),
    ]);
    assert_eq!(parts.subjects, [0, 2]);
    assert_eq!((parts.deformation.size(), parts.shape.size()), (2, 2));
    assert_eq!(
        parts
            .left_out
            .iter()
            .map(|left| left.subject)
            .collect::<Vec<_>>(),
        [1]
    );
}

#[test]
fn a_map_of_parts_has_few_neighbours_and_none_of_two_subjects() {
    let hearts = |count: u32| {
        let amount = |i| 0.1 + 0.3 * f64::from(i) / f64::from(count);
        parts_of(
            (0..count)
                .map(|i| heart(1.5, 1.0, 4, amount(i), 0.0))
                .collect(),
        )
    };
    let params = DeformationMapParams::default().check().unwrap();
    let progress = Progress::default();
    let map = |parts| {
        map_of_parts(
            &Arc::new(parts),
            PartWeights::DEFORMATION,
            &params,
            &progress,
        )
    };
    let of_twelve = map(hearts(12)).unwrap();
    assert_eq!(of_twelve.embedding.neighbours, Some(8));
    // Amounts lie on a line, and so do the places: columns have mean 0 and length 1, numbers from −5.5 on have √143.
    let first = (0..12).map(|row| of_twelve.embedding.point(row)[0]);
    let along: f64 = first
        .zip(0..12)
        .map(|(x, row)| x * (f64::from(row) - 5.5))
        .sum();
    assert!(along.abs() > 0.9 * 143_f64.sqrt(), "{along}");
    assert_eq!(
        map(hearts(2)),
        Err(DeformationMapError::TooFew { deformations: 2 })
    );
}

#[test]
fn weights_that_compare_nothing_are_refused() {
    let with = |deformation, shape| {
        let params = DeformationMapParams {
            comparison: Comparison::Parts(PartWeights { deformation, shape }),
            ..DeformationMapParams::default()
        };
        params.check().unwrap_err().to_string()
    };
    assert!(with(0.0, 0.0).contains("above zero"));
    assert!(with(-1.0, 0.0).contains("-1"));
    assert!(with(1.0, f64::NAN).contains("NaN"));
    let smoothing = DeformationMapParams {
        smoothing: 7.0,
        ..DeformationMapParams::default()
    };
    assert!(smoothing.check().unwrap_err().to_string().contains("not 7"));
}

#[test]
fn kinds_of_motion_that_are_far_apart_do_not_fall_onto_each_other() {
    // Four tight groups at the corners of a tetrahedron: a plane of two of the three axes that say which group would lay
    // two of them onto each other.
    let corners = [
        [0.0, 0.0, 0.0],
        [9.0, 0.0, 0.0],
        [0.0, 8.0, 0.0],
        [0.0, 0.0, 7.0],
    ];
    let points = corners.iter().flat_map(|corner| {
        (0..15).flat_map(move |k| {
            let wave = |axis: usize| 0.3 * (1.7 * k as f64 + 2.3 * axis as f64).sin();
            [0, 1, 2].map(|axis| corner[axis] + wave(axis))
        })
    });
    let points: Vec<f64> = points.collect();
    let distances = DistanceMatrix::of_points(&points, 60).unwrap();
    let params = DeformationMapParams::default().check().unwrap();
    let map = map_of_distances(&distances, &params, &Progress::default()).unwrap();
    assert_eq!(map.parts, Some(4));
    let apart = |i: usize, j: usize| {
        let (a, b) = (map.point(i), map.point(j));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let (mut within, mut between) = (0.0_f64, f64::MAX);
    for i in 0..60 {
        for j in 0..i {
            match i / 15 == j / 15 {
                true => within = within.max(apart(i, j)),
                false => between = between.min(apart(i, j)),
            }
        }
    }
    assert!(between > 2.0 * within, "{within} {between}");
    for axis in 0..2 {
        let length: f64 = (0..60).map(|i| map.point(i)[axis].powi(2)).sum();
        assert!((length - 1.0).abs() < 1e-9, "{length}");
    }
}
