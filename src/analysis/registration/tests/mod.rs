//! What registration must and must not do.

mod icp;
mod splines;

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

use super::*;
use crate::analysis::alignment::{RigidMotion, rigid_motion};
use crate::mesh::{ClosestPoint, Point3, TriMesh, phantom};
use crate::progress::{Progress, Stopped};

/// A surface without symmetry.
fn heart() -> TriMesh {
    let sphere = phantom::sphere(3, 30.0);
    let bent: Vec<Point3> = (sphere.vertices().iter())
        .map(|p| {
            Point3::new(
                p.x + 0.006 * p.z * p.z,
                0.8 * p.y,
                1.7 * p.z + 0.01 * p.x * p.y,
            )
        })
        .collect();
    TriMesh::new(bent, sphere.faces().clone()).unwrap()
}

fn motion(angles: [f64; 3], shift: [f64; 3]) -> RigidMotion {
    RigidMotion {
        rotation: *Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).matrix(),
        translation: Vector3::from(shift),
    }
}

fn moved(motion: &RigidMotion, points: &[Point3]) -> Vec<Point3> {
    points.iter().map(|p| motion.apply(p)).collect()
}

#[test]
fn percentiles_are_those_of_numpy() {
    let fit = SurfaceFit::of_distances(&[4.0, 1.0, 2.0, 3.0, 10.0]).unwrap();
    assert_eq!((fit.mean, fit.greatest), (4.0, 10.0));
    assert!((fit.p95 - 8.8).abs() < 1e-12);
    assert_eq!(SurfaceFit::of_distances(&[]), None);
    assert_eq!(SurfaceFit::of_distances(&[1.0, f64::NAN]), None);
    let sphere = phantom::sphere(3, 10.0);
    let tree = ClosestPoint::new(sphere.vertices(), sphere.triangles()).unwrap();
    let outside: Vec<Point3> = sphere.vertices().iter().map(|p| p * 1.2).collect();
    let fit = SurfaceFit::of_distances(&distances_to(&tree, &outside)).unwrap();
    assert!((fit.mean - 2.0).abs() < 1e-9 && (fit.p95 - 2.0).abs() < 1e-9);
}

#[test]
fn weights_that_are_none_are_refused() {
    let points = [Point3::origin(), Point3::new(1.0, 0.0, 0.0)];
    let error = |weights: &[f64]| weighted_rigid_motion(&points, &points, weights).unwrap_err();
    assert!(matches!(
        error(&[1.0]),
        WeightsError::CountMismatch { weights: 1, .. }
    ));
    assert_eq!(
        error(&[1.0, -2.0]),
        WeightsError::Weight {
            index: 1,
            value: -2.0
        }
    );
    assert!(matches!(
        error(&[f64::NAN, 1.0]),
        WeightsError::Weight { index: 0, .. }
    ));
    assert_eq!(error(&[0.0, 0.0]), WeightsError::NoWeight);
    assert!(weighted_rigid_motion(&points, &points, &[f64::MAX; 2]).is_ok());
}

proptest! {
    #[test]
    fn equal_weights_change_nothing_and_zero_weights_leave_points_out(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-50.0..50.0_f64),
        weight in 0.01..100.0_f64,
    ) {
        let source = heart().vertices()[..40].to_vec();
        let mut target = moved(&motion(angles, shift), &source);
        for (index, p) in target.iter_mut().enumerate() {
            p.x += (0.7 * index as f64).sin();
        }
        let equal = weighted_rigid_motion(&source, &target, &[weight; 40]).unwrap();
        let plain = rigid_motion(&source, &target).unwrap();
        prop_assert!((equal.rotation - plain.rotation).amax() < 1e-12);
        prop_assert!((equal.translation - plain.translation).amax() < 1e-10);
        let mut weights = [weight; 40];
        weights[30..].fill(0.0);
        let some = weighted_rigid_motion(&source, &target, &weights).unwrap();
        let few = rigid_motion(&source[..30], &target[..30]).unwrap();
        prop_assert!((some.rotation - few.rotation).amax() < 1e-12);
        prop_assert!((some.rotation.determinant() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn moving_both_sides_moves_the_motion(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-50.0..50.0_f64),
    ) {
        let source = heart().vertices()[..40].to_vec();
        let target: Vec<Point3> = source.iter().map(|p| Point3::new(p.y, 0.9 * p.x + 0.01 * p.z * p.z, p.z)).collect();
        let weights: Vec<f64> = (0..40).map(|i| 1.0 + f64::from(i % 7)).collect();
        let here = weighted_rigid_motion(&source, &target, &weights).unwrap();
        let both = motion(angles, shift);
        let there = weighted_rigid_motion(&moved(&both, &source), &moved(&both, &target), &weights).unwrap();
        // There = both ∘ here ∘ both⁻¹.
        let expected = both.inverse().then(&here).then(&both);
        prop_assert!((there.rotation - expected.rotation).amax() < 1e-11);
        prop_assert!((there.translation - expected.translation).amax() < 1e-8);
    }
}
