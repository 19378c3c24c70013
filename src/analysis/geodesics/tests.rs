//! Laws of cheapest paths on spheres and bowls, damage, and stopping.

use nalgebra::Rotation3;
use proptest::prelude::*;

use super::*;
use crate::analysis::metrics::{Corners, Form, METRICS, MetricKind, MetricParams, bent};
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};
use crate::progress::Progress;

fn found(faces: &Faces, start: &[Point3], end: &[Point3], params: GeodesicParams) -> GeodesicPath {
    let params = params.check().unwrap();
    geodesic(faces, start, end, &params, &Progress::default()).unwrap()
}

fn farthest(a: &[Vec<Point3>], b: &[Vec<Point3>]) -> f64 {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
}

fn exact() -> GeodesicParams {
    GeodesicParams {
        tolerance: 1e-13,
        ..GeodesicParams::default()
    }
}

fn bowl() -> TriMesh {
    phantom::bowl(1.0, 6, 14)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn a_path_costs_no_more_than_the_straight_line(amount in 0.05..0.4_f64, phase in 0.0..6.0_f64) {
        let mesh = bowl();
        let end = bent(mesh.vertices(), amount, phase);
        for interpolated_poses in [1, 2, 3, 5] {
            let params = GeodesicParams { interpolated_poses, ..GeodesicParams::default() };
            let path = found(mesh.faces(), mesh.vertices(), &end, params);
            prop_assert!(path.converged && !path.stopped);
            prop_assert!(path.energy > 0.0 && path.energy <= path.energy_linear);
            prop_assert_eq!(path.poses.len(), usize::from(interpolated_poses) + 2);
            let of_steps: f64 = path.step_lengths.iter().map(|l| 2.0 * l * l).sum();
            prop_assert!((of_steps / path.energy - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn moving_both_ends_moves_the_path(amount in 0.05..0.3_f64, phase in 0.0..6.0_f64, angle in 0.1..3.0_f64) {
        let mesh = bowl();
        let end = bent(mesh.vertices(), amount, phase);
        let turn = Rotation3::from_euler_angles(angle, 0.4 * angle, -0.7 * angle);
        let moved = |points: &[Point3]| -> Vec<Point3> {
            points.iter().map(|p| turn * p + Vector3::new(2.0, -1.0, 0.5)).collect()
        };
        let path = found(mesh.faces(), mesh.vertices(), &end, exact());
        let other = found(mesh.faces(), &moved(mesh.vertices()), &moved(&end), exact());
        let expected: Vec<_> = path.poses.iter().map(|pose| moved(pose)).collect();
        prop_assert!((path.energy / other.energy - 1.0).abs() < 1e-10);
        let apart = farthest(&expected, &other.poses);
        prop_assert!(apart < 1e-5, "{apart:e}");
    }

    #[test]
    fn the_way_back_is_the_way_there_reversed(amount in 0.05..0.3_f64, phase in 0.0..6.0_f64) {
        let mesh = bowl();
        let end = bent(mesh.vertices(), amount, phase);
        let there = found(mesh.faces(), mesh.vertices(), &end, exact());
        let mut back = found(mesh.faces(), &end, mesh.vertices(), exact());
        back.poses.reverse();
        prop_assert!((there.energy / back.energy - 1.0).abs() < 1e-10);
        prop_assert!(farthest(&there.poses, &back.poses) < 1e-5);
    }

    #[test]
    fn scaling_both_ends_scales_the_path(scale in 0.02..50.0_f64, phase in 0.0..6.0_f64) {
        let mesh = bowl();
        let end = bent(mesh.vertices(), 0.2, phase);
        let scaled = |points: &[Point3]| points.iter().map(|p| p * scale).collect::<Vec<_>>();
        let path = found(mesh.faces(), mesh.vertices(), &end, exact());
        let other = found(mesh.faces(), &scaled(mesh.vertices()), &scaled(&end), exact());
        let expected: Vec<_> = path.poses.iter().map(|pose| scaled(pose)).collect();
        prop_assert!((path.energy / other.energy - 1.0).abs() < 1e-10);
        prop_assert!(farthest(&expected, &other.poses) < 1e-5 * scale);
    }

    #[test]
    fn renumbering_vertices_renumbers_the_path(step in 1..85_usize) {
        let mesh = bowl();
        let count = mesh.vertices().len();
        prop_assume!((2..=step).all(|d| !(step.is_multiple_of(d) && count.is_multiple_of(d))));
        let end = bent(mesh.vertices(), 0.2, 1.0);
        let new = |v: usize| (v * step + 3) % count;
        let renumbered = |points: &[Point3]| {
            let mut out = vec![Point3::origin(); count];
            for (v, p) in points.iter().enumerate() {
                out[new(v)] = *p;
            }
            out
        };
        let triangles = mesh.triangles().iter().map(|t| t.map(|v| new(v as usize) as u32)).collect();
        let faces = Faces::new(count, triangles).unwrap();
        let path = found(mesh.faces(), mesh.vertices(), &end, exact());
        let other = found(&faces, &renumbered(mesh.vertices()), &renumbered(&end), exact());
        let expected: Vec<_> = path.poses.iter().map(|pose| renumbered(pose)).collect();
        prop_assert!((path.energy / other.energy - 1.0).abs() < 1e-10);
        prop_assert!(farthest(&expected, &other.poses) < 1e-5);
    }
}

#[test]
fn growing_by_a_factor_goes_in_equal_steps() {
    // A similarity costs only the regulariser, whose unit of length is that of the ends: the way is
    // straight, and swelling on it gains nothing.
    let ball = phantom::sphere(2, 1.0);
    let end: Vec<Point3> = ball.vertices().iter().map(|p| p * 2.0).collect();
    let params = GeodesicParams {
        metric: MetricParams::of(MetricKind::AnglePreserving),
        interpolated_poses: 15,
        ..exact()
    };
    let path = found(ball.faces(), ball.vertices(), &end, params);
    for (k, pose) in path.poses.iter().enumerate() {
        let expected = 1.0 + k as f64 / 16.0;
        for point in pose {
            assert!((point.coords.norm() - expected).abs() < 1e-6, "{k}");
        }
    }
}

#[test]
fn equal_ends_need_no_iteration() {
    let mesh = bowl();
    let path = found(mesh.faces(), mesh.vertices(), mesh.vertices(), exact());
    assert_eq!((path.iterations, path.energy), (0, 0.0));
    assert!(path.converged && path.step_lengths.iter().all(|&l| l == 0.0));
    for pose in &path.poses {
        assert_eq!(pose, mesh.vertices());
    }
}

#[test]
fn without_interpolated_poses_the_path_is_its_ends() {
    let mesh = bowl();
    let end = bent(mesh.vertices(), 0.2, 1.0);
    let params = GeodesicParams {
        interpolated_poses: 0,
        ..exact()
    };
    let path = found(mesh.faces(), mesh.vertices(), &end, params);
    assert_eq!(path.poses, [mesh.vertices().to_vec(), end]);
    assert_eq!(path.energy, path.energy_linear);
}

#[test]
fn every_metric_finds_a_path_that_is_no_dearer() {
    let mesh = bowl();
    let end = bent(mesh.vertices(), 0.2, 2.0);
    for kind in METRICS {
        for form in [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive] {
            for corners in [Corners::Raw, Corners::ScaleFree] {
                let metric = MetricParams {
                    kind,
                    form,
                    corners,
                    lambda: 1e-2,
                    ..MetricParams::default()
                };
                let params = GeodesicParams {
                    metric,
                    max_iterations: 60,
                    ..GeodesicParams::default()
                };
                let path = found(mesh.faces(), mesh.vertices(), &end, params);
                assert!(path.energy <= path.energy_linear, "{metric:?}");
                assert!(
                    path.poses
                        .iter()
                        .flatten()
                        .all(|p| p.iter().all(|x| x.is_finite()))
                );
            }
        }
    }
}

#[test]
fn a_path_begun_on_few_vertices_is_that_of_all() {
    let ball = phantom::sphere(3, 1.0);
    let end = bent(ball.vertices(), 0.3, 1.0);
    // Displacement counts enough for one minimum.
    let exact = GeodesicParams {
        metric: MetricParams {
            lambda: 3.0,
            ..MetricParams::of(MetricKind::AnglePreserving)
        },
        ..exact()
    };
    let whole = found(ball.faces(), ball.vertices(), &end, exact);
    let params = GeodesicParams {
        max_vertices: Some(300),
        ..exact
    };
    let few = found(ball.faces(), ball.vertices(), &end, params);
    assert!(few.converged && !few.fell_back && few.energy < 0.999 * few.energy_linear);
    assert!((few.energy / whole.energy - 1.0).abs() < 1e-9);
    assert!(farthest(&few.poses, &whole.poses) < 1e-4);
}

mod damage;
