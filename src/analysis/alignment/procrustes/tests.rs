//! What alignment must and must not do.

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

use super::*;
use crate::mesh::phantom;

fn turned(points: &[Point3], angles: [f64; 3], shift: [f64; 3], scale: f64) -> Vec<Point3> {
    let rotation = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
    points
        .iter()
        .map(|p| Point3::from(scale * (rotation * p.coords) + Vector3::from(shift)))
        .collect()
}

/// A surface without symmetry.
fn heart() -> Vec<Point3> {
    phantom::bowl(1.0, 6, 10)
        .vertices()
        .iter()
        .map(|p| {
            Point3::new(
                p.x + 0.2 * p.z * p.z,
                0.8 * p.y,
                1.7 * p.z + 0.1 * p.x * p.y,
            )
        })
        .collect()
}

#[test]
fn a_mirror_image_is_never_matched_by_a_reflection() {
    let mirrored: Vec<Point3> = heart()
        .iter()
        .map(|p| Point3::new(p.x, -p.y, p.z))
        .collect();
    let motion = rigid_motion(&heart(), &mirrored).unwrap();
    assert!((motion.rotation.determinant() - 1.0).abs() < 1e-12);
}

#[test]
fn points_on_a_line_and_a_single_point_are_aligned_with_themselves() {
    let line: Vec<Point3> = (0..5)
        .map(|i| Point3::new(f64::from(i), 0.0, 0.0))
        .collect();
    let onto = turned(&line, [0.0, 0.3, 1.0], [1.0, 2.0, 3.0], 1.0);
    let motion = rigid_motion(&line, &onto).unwrap();
    assert!((motion.rotation.determinant() - 1.0).abs() < 1e-12);
    for (p, q) in line.iter().zip(&onto) {
        assert!((motion.apply(p) - q).norm() < 1e-12);
    }
    let motion = rigid_motion(&line[..1], &onto[2..3]).unwrap();
    assert!((motion.apply(&line[0]) - onto[2]).norm() < 1e-12);
}

#[test]
fn what_cannot_be_aligned_says_why() {
    assert_eq!(rigid_motion(&[], &[]), Err(AlignmentError::NoPoints));
    let error = rigid_motion(&heart()[..4], &heart()[..3]).unwrap_err();
    assert_eq!(error.to_string(), "4 points cannot correspond with 3");
    let same = vec![Point3::new(0.1, 0.2, 0.3); 4];
    assert_eq!(
        similarity(&same, &heart()[..4]),
        Err(AlignmentError::NoSize { count: 4 })
    );
}

proptest! {
    #[test]
    fn a_similarity_is_found_again(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-50.0..50.0_f64),
        scale in 0.1..10.0_f64,
    ) {
        let source = heart();
        let target = turned(&source, angles, shift, scale);
        let found = similarity(&source, &target).unwrap();
        prop_assert!((found.scale - scale).abs() < 1e-11 * scale);
        for (p, q) in source.iter().zip(&target) {
            prop_assert!((found.apply(p) - q).norm() < 1e-11 * (scale + 50.0));
        }
    }

    #[test]
    fn a_motion_and_its_inverse_leave_points_in_place(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-50.0..50.0_f64),
    ) {
        let source = heart();
        let motion = rigid_motion(&source, &turned(&source, angles, shift, 1.0)).unwrap();
        let around = motion.then(&motion.inverse());
        for p in &source {
            prop_assert!((around.apply(p) - p).norm() < 1e-12 * 50.0);
        }
    }

    #[test]
    fn no_other_motion_brings_points_nearer(
        angles in prop::array::uniform3(-0.2..0.2_f64),
        shift in prop::array::uniform3(-0.1..0.1_f64),
    ) {
        let source = heart();
        let target: Vec<Point3> = source
            .iter()
            .map(|p| Point3::new(1.1 * p.x + 0.1 * p.y * p.y, p.y - 0.2 * p.z, 0.9 * p.z))
            .collect();
        let best = rigid_motion(&source, &target).unwrap();
        let miss = |points: &[Point3]| -> f64 {
            points.iter().zip(&target).map(|(p, q)| (p - q).norm_squared()).sum()
        };
        let moved: Vec<Point3> = source.iter().map(|p| best.apply(p)).collect();
        let other = turned(&moved, angles, shift, 1.0);
        prop_assert!(miss(&moved) <= miss(&other) + 1e-12);
    }
}
