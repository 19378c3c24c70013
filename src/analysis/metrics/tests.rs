//! Laws of the metrics, on bowls and spheres bent at random.

mod refinement;
mod shares;

use nalgebra::{Matrix3, Rotation3};
use proptest::prelude::*;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};

/// Every kind and form with a name; `lambda` as given.
fn all_params(corners: Corners, area_weights: bool, lambda: f64) -> Vec<MetricParams> {
    let mut all = Vec::new();
    for kind in METRICS {
        for form in [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive] {
            all.push(MetricParams {
                kind,
                form,
                corners,
                area_weights,
                lambda,
                ..MetricParams::default()
            });
        }
    }
    all
}

/// A smooth bend of size `amount`, other for each phase.
pub(in crate::analysis) fn bent(points: &[Point3], amount: f64, phase: f64) -> Vec<Point3> {
    points
        .iter()
        .map(|p| {
            let wave = |a: f64, b: f64| (1.3 * a - 0.8 * b + phase).sin();
            p + Vector3::new(wave(p.x, p.z), wave(p.y, p.x), wave(p.z, p.y)) * amount
        })
        .collect()
}

fn between(from: &[Point3], to: &[Point3]) -> Vec<Vector3> {
    to.iter().zip(from).map(|(b, a)| b - a).collect()
}

fn moved(points: &[Point3], scale: f64) -> Vec<Point3> {
    let turn = Rotation3::from_euler_angles(0.7, -0.4, 1.9);
    points
        .iter()
        .map(|p| turn * (p * scale) + Vector3::new(3.0, -1.0, 2.0) * scale)
        .collect()
}

fn norms(faces: &Faces, params: MetricParams, a: &[Point3], b: &[Point3]) -> PairNorms {
    let metric = Metric::new(faces, params.check().unwrap());
    let (a, b) = (metric.prepare(a).unwrap(), metric.prepare(b).unwrap());
    metric.pair(&a, &b, &mut PairScratch::default())
}

fn near(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * a.abs().max(b.abs())
}

fn bowl() -> TriMesh {
    let mesh = phantom::bowl(1.0, 6, 11);
    let points = bent(mesh.vertices(), 0.15, 0.3);
    TriMesh::new(points, std::sync::Arc::clone(mesh.faces())).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn moving_both_poses_together_changes_nothing(amount in 0.01..0.2_f64, phase in 0.0..6.0_f64) {
        let a = bowl();
        let b = bent(a.vertices(), amount, phase);
        for corners in [Corners::Raw, Corners::ScaleFree] {
            for params in all_params(corners, true, 1e-3) {
                let before = norms(a.faces(), params, a.vertices(), &b);
                let after = norms(a.faces(), params, &moved(a.vertices(), 1.0), &moved(&b, 1.0));
                prop_assert!(near(before.norm2_a, after.norm2_a, 1e-10), "{params:?}");
                prop_assert!(near(before.norm2_b, after.norm2_b, 1e-10), "{params:?}");
            }
        }
    }

    #[test]
    fn scaling_both_poses_changes_no_scale_free_form(scale in 0.02..50.0_f64, phase in 0.0..6.0_f64) {
        let a = bowl();
        let b = bent(a.vertices(), 0.1, phase);
        let scaled = |points: &[Point3]| points.iter().map(|p| p * scale).collect::<Vec<_>>();
        for params in all_params(Corners::ScaleFree, true, 1e-3) {
            if params.kind == MetricKind::Displacement {
                continue; // A squared length by definition.
            }
            let before = norms(a.faces(), params, a.vertices(), &b);
            let after = norms(a.faces(), params, &scaled(a.vertices()), &scaled(&b));
            prop_assert!(near(before.energy(), after.energy(), 1e-12), "{params:?}");
        }
    }

    #[test]
    fn exchanging_the_poses_exchanges_the_norms(amount in 0.01..0.2_f64, phase in 0.0..6.0_f64) {
        let a = bowl();
        let b = bent(a.vertices(), amount, phase);
        for params in all_params(Corners::ScaleFree, true, 1e-4) {
            let there = norms(a.faces(), params, a.vertices(), &b);
            let back = norms(a.faces(), params, &b, a.vertices());
            prop_assert!(near(there.norm2_a, back.norm2_b, 1e-12), "{params:?}");
            prop_assert!(near(there.distance(), back.distance(), 1e-12), "{params:?}");
        }
    }

    #[test]
    fn renumbering_vertices_and_faces_changes_nothing(step in 1..66_usize, turn in 0..3_usize) {
        let a = bowl();
        let count = a.vertices().len();
        prop_assume!(num_coprime(step, count));
        let b = bent(a.vertices(), 0.1, 1.0);
        let place = |v: usize| (v * step) % count;
        let renumbered = |points: &[Point3]| {
            let mut moved = points.to_vec();
            for (v, p) in points.iter().enumerate() {
                moved[place(v)] = *p;
            }
            moved
        };
        let mut triangles: Vec<[u32; 3]> = a
            .triangles()
            .iter()
            .map(|t| t.map(|v| place(v as usize) as u32))
            .map(|mut t| { t.rotate_left(turn); t })
            .collect();
        triangles.reverse();
        let faces = Faces::new(count, triangles).unwrap();
        for params in all_params(Corners::ScaleFree, true, 1e-4) {
            let before = norms(a.faces(), params, a.vertices(), &b);
            let after = norms(&faces, params, &renumbered(a.vertices()), &renumbered(&b));
            prop_assert!(near(before.energy(), after.energy(), 1e-11), "{params:?}");
        }
    }

    #[test]
    fn laying_b_onto_a_by_a_motion_is_the_same_as_moving_its_points(phase in 0.0..6.0_f64) {
        let a = bowl();
        let b = bent(a.vertices(), 0.1, phase);
        let rotation: Matrix3<f64> = *Rotation3::from_euler_angles(0.2, 0.5, -0.3).matrix();
        let translation = Vector3::new(0.1, -0.2, 0.4);
        let laid: Vec<Point3> =
            b.iter().map(|p| Point3::from(rotation * p.coords + translation)).collect();
        for params in all_params(Corners::Raw, true, 1e-2) {
            let metric = Metric::new(a.faces(), params.check().unwrap());
            let of = |points: &[Point3]| metric.prepare(points).unwrap();
            let mut scratch = PairScratch::default();
            let moving = metric
                .pair_moved(&of(a.vertices()), &of(&b), &rotation, &translation, &mut scratch);
            let before = metric.pair(&of(a.vertices()), &of(&laid), &mut scratch);
            prop_assert!(near(moving.energy(), before.energy(), 1e-10), "{params:?}");
        }
    }

    #[test]
    fn all_but_the_printed_forms_are_linear_in_each_field(factor in -3.0..3.0_f64, phase in 0.0..6.0_f64) {
        let a = bowl();
        let [x, y, z] = [0.1, 0.07, 0.05]
            .map(|amount| between(a.vertices(), &bent(a.vertices(), amount, phase + amount * 50.0)));
        let sum: Vec<Vector3> = x.iter().zip(&y).map(|(x, y)| x * factor + y).collect();
        for params in all_params(Corners::ScaleFree, true, 1e-3) {
            let quasi = params.kind == MetricKind::QuasiConformal;
            if params.form == Form::Printed || (quasi && params.form != Form::Additive) {
                continue;
            }
            let metric = Metric::new(a.faces(), params.check().unwrap());
            let pose = metric.prepare(a.vertices()).unwrap();
            let of = |x: &[Vector3], y: &[Vector3]| metric.inner_product(&pose, x, y);
            let apart = of(&sum, &z) - factor * of(&x, &z) - of(&y, &z);
            let scale = metric.norm2(&pose, &sum).sqrt() * metric.norm2(&pose, &z).sqrt();
            prop_assert!(apart.abs() <= 1e-11 * (scale + of(&x, &x)), "{params:?} {apart}");
            prop_assert!(near(of(&x, &y), of(&y, &x), 1e-9) || of(&x, &y).abs() < 1e-12 * scale);
        }
    }
}

fn num_coprime(a: usize, b: usize) -> bool {
    if b == 0 {
        a == 1
    } else {
        num_coprime(b, a % b)
    }
}

#[test]
fn a_pair_gives_what_the_inner_product_gives() {
    let a = bowl();
    let b = bent(a.vertices(), 0.1, 2.0);
    let x = between(a.vertices(), &b);
    for corners in [Corners::Raw, Corners::ScaleFree] {
        for area_weights in [true, false] {
            for params in all_params(corners, area_weights, 1e-3) {
                if params.kind == MetricKind::QuasiConformal && params.form == Form::Additive {
                    continue; // Differences there, rates here; see the next test.
                }
                let metric = Metric::new(a.faces(), params.check().unwrap());
                let pose = metric.prepare(a.vertices()).unwrap();
                let pair = norms(a.faces(), params, a.vertices(), &b);
                assert!(
                    near(pair.norm2_a, metric.norm2(&pose, &x), 1e-11),
                    "{params:?}"
                );
            }
        }
    }
}

#[test]
fn curvature_differences_approach_its_rate_linearly() {
    let a = bowl();
    for area_weights in [true, false] {
        let params = MetricParams {
            area_weights,
            mu: 10.0,
            ..MetricParams::of(MetricKind::QuasiConformal)
        };
        let metric = Metric::new(a.faces(), params.check().unwrap());
        let pose = metric.prepare(a.vertices()).unwrap();
        let error = |amount: f64| {
            let b = bent(a.vertices(), amount, 2.0);
            let exact = metric.norm2(&pose, &between(a.vertices(), &b));
            (norms(a.faces(), params, a.vertices(), &b).norm2_a / exact - 1.0).abs()
        };
        let ratio = error(1e-3) / error(1e-4);
        assert!((ratio - 10.0).abs() < 1.0, "{ratio}");
    }
}

#[test]
fn frozen_weights_of_a_pair_give_its_frozen_norm() {
    let a = bowl();
    let b = bent(a.vertices(), 0.1, 2.0);
    let params = MetricParams {
        form: Form::Frozen,
        ..MetricParams::of(MetricKind::QuasiConformal)
    };
    let metric = Metric::new(a.faces(), params.check().unwrap());
    let (pose, after) = (
        metric.prepare(a.vertices()).unwrap(),
        metric.prepare(&b).unwrap(),
    );
    let weights = metric.frozen_weights(&pose, &after);
    let x = between(a.vertices(), &b);
    let frozen = metric.frozen_inner_product(&pose, &weights, &x, &x);
    let pair = metric.pair(&pose, &after, &mut PairScratch::default());
    assert!(near(frozen, pair.norm2_a, 1e-12));
}

#[test]
fn curvature_density_of_a_sphere_is_one_at_any_size_and_rings() {
    for (radius, rings) in [(1.0, 0), (70.0, 0), (70.0, 5)] {
        let sphere = phantom::sphere(4, radius);
        let params = MetricParams {
            curvature: CurvatureMean::Rings(rings),
            ..MetricParams::of(MetricKind::QuasiConformal)
        };
        let metric = Metric::new(sphere.faces(), params.check().unwrap());
        let pose = metric.prepare(sphere.vertices()).unwrap();
        let worst = metric
            .curvature(&pose)
            .iter()
            .fold(0.0_f64, |m, k| m.max((k - 1.0).abs()));
        // Thirds of faces are too much area for the twelve vertices of valence five; averaging mends it.
        assert!(
            worst < if rings == 0 { 0.16 } else { 0.05 },
            "{rings}: {worst}"
        );
    }
}

#[test]
fn what_cannot_be_used_is_refused_with_its_numbers() {
    let wrong = MetricParams {
        mu: -1.0,
        ..MetricParams::default()
    };
    assert_eq!(
        wrong.check().unwrap_err().to_string(),
        "mu must be zero or positive and finite, not -1"
    );
    let far = MetricParams {
        curvature: CurvatureMean::Rings(401),
        ..MetricParams::default()
    };
    assert!(far.check().is_err());
    let sphere = phantom::sphere(0, 1.0);
    let metric = Metric::new(sphere.faces(), MetricParams::default().check().unwrap());
    assert_eq!(
        metric.prepare(&sphere.vertices()[1..]).unwrap_err(),
        MetricError::VertexCount {
            points: 11,
            expected: 12
        }
    );
    for bad in [f64::NAN, f64::INFINITY, 1e90] {
        let mut points = sphere.vertices().to_vec();
        points[3].y = bad;
        assert_eq!(metric.prepare(&points).unwrap_err(), MetricError::Overflow);
    }
}

/// A flat square of right triangles.
fn sheet(cells: u32) -> (Faces, Vec<Point3>) {
    let side = cells + 1;
    let points = (0..side * side)
        .map(|v| Point3::new(f64::from(v % side), f64::from(v / side), 0.0))
        .collect();
    let triangles = (0..cells * cells)
        .map(|cell| cell % cells + (cell / cells) * side)
        .flat_map(|v| [[v, v + 1, v + side + 1], [v, v + side + 1, v + side]])
        .collect();
    let count = (side * side) as usize;
    (Faces::new(count, triangles).unwrap(), points)
}

#[test]
fn stretching_a_sheet_along_one_axis_costs_what_paper_says() {
    // Rates ε, 0 and ε/2 along the sides of each triangle: t = ε, ε/2, ε/2, and Σ t² = 1.5 ε².
    // At B the sides are (1 + ε) times longer along x, so that the rates are ε/(1 + ε), 0 and
    // ε (1 + ε) / ((1 + ε)² + 1).
    let (faces, a) = sheet(5);
    let epsilon = 0.1;
    let b: Vec<Point3> = (a.iter())
        .map(|p| Point3::new(p.x * (1.0 + epsilon), p.y, p.z))
        .collect();
    let (long, diagonal) = (
        epsilon / (1.0 + epsilon),
        epsilon * (1.0 + epsilon) / ((1.0 + epsilon).powi(2) + 1.0),
    );
    let at_b = long.powi(2) + diagonal.powi(2) + (long - diagonal).powi(2);
    for kind in [MetricKind::AnglePreserving, MetricKind::QuasiConformal] {
        let params = MetricParams {
            kind,
            lambda: 0.0,
            ..MetricParams::default()
        };
        let found = norms(&faces, params, &a, &b);
        assert!(near(found.norm2_a, 1.5 * epsilon * epsilon, 1e-12));
        assert!(near(found.norm2_b, at_b, 1e-12));
    }
}

#[test]
fn inflating_a_sphere_costs_only_the_regulariser() {
    let sphere = phantom::sphere(3, 2.0);
    let larger = phantom::sphere(3, 2.2);
    let params = |lambda| MetricParams {
        lambda,
        ..MetricParams::of(MetricKind::QuasiConformal)
    };
    let (a, b) = (sphere.vertices(), larger.vertices());
    assert!(norms(sphere.faces(), params(0.0), a, b).distance() < 1e-13);
    // |X| = 0.2 against the radius of the sphere of equal area, which is that of the facets.
    let found = norms(sphere.faces(), params(1.0), a, b).norm2_a;
    assert!(near(found, 0.01, 0.01), "{found}");
}

#[test]
fn the_cost_of_a_smooth_bend_converges_as_the_mesh_is_refined() {
    let of = |level: u32| {
        let sphere = phantom::sphere(level, 1.0);
        let params = MetricParams {
            mu: 0.0,
            lambda: 0.0,
            ..MetricParams::of(MetricKind::QuasiConformal)
        };
        let squeezed: Vec<Point3> = (sphere.vertices().iter())
            .map(|p| Point3::new(p.x, p.y, p.z * (1.0 + 0.2 * p.x)))
            .collect();
        norms(sphere.faces(), params, sphere.vertices(), &squeezed).norm2_a
    };
    let levels = [2, 3, 4, 5].map(of);
    let steps = [0, 1, 2].map(|i| (levels[i + 1] - levels[i]).abs());
    // Second order: each refinement leaves about a quarter of the error.
    assert!(
        steps[1] < 0.4 * steps[0] && steps[2] < 0.4 * steps[1],
        "{levels:?}"
    );
}
