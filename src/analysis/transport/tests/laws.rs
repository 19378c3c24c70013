//! Laws of the scheme along given samples.

use super::*;
use crate::analysis::metrics::METRICS;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn norm_and_product_with_the_direction_are_kept(seed in 0.0..50.0, kind in 0..METRICS.len()) {
        let mesh = phantom::sphere(1, 1.0);
        let metric = metric(mesh.faces(), METRICS[kind]);
        let path = bent_path(mesh.vertices(), seed, 6);
        let field = wave(mesh.vertices(), seed + 7.0, 0.1);
        let there = transport_along(&metric, &path, &field, true).unwrap();
        let product = |k: usize, field: &[Vector3], velocity: Vec<Vector3>| {
            let at = metric.prepare(&path[k]).unwrap();
            metric.inner_product(&at, field, &velocity) / metric.norm2(&at, &velocity).sqrt()
        };
        let velocity = |from: usize, to: usize| -> Vec<Vector3> {
            path[from].iter().zip(&path[to]).map(|(a, b)| b - a).collect()
        };
        let before = norm2(&metric, &path[0], &field);
        let after = norm2(&metric, &path[6], &there);
        prop_assert!((after - before).abs() <= 1e-10 * before, "{after} {before}");
        let alpha = product(0, &field, velocity(0, 1));
        let end = product(6, &there, velocity(5, 6));
        prop_assert!((alpha - end).abs() <= 1e-10 * before.sqrt(), "{alpha} {end}");
    }

    #[test]
    fn without_the_norm_it_is_linear(seed in 0.0..50.0, factor in -2.0..2.0) {
        let mesh = phantom::torus(2.0, 0.7, 12, 6);
        let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
        let path = bent_path(mesh.vertices(), seed, 4);
        let (x, y) = (wave(mesh.vertices(), seed, 0.1), wave(mesh.vertices(), seed + 1.0, 0.2));
        let sum: Vec<Vector3> = x.iter().zip(&y).map(|(x, y)| x + y * factor).collect();
        let transported = |field: &[Vector3]| transport_along(&metric, &path, field, false).unwrap();
        let (x, y) = (transported(&x), transported(&y));
        let expected: Vec<Vector3> = x.iter().zip(&y).map(|(x, y)| x + y * factor).collect();
        prop_assert!(apart(&transported(&sum), &expected) < 1e-11);
    }

    #[test]
    fn it_turns_with_the_hearts_and_knows_no_places_or_numbers(
        seed in 0.0..50.0, turn in -3.0..3.0, shift in -5.0..5.0,
    ) {
        let mesh = phantom::sphere(1, 1.0);
        let path = bent_path(mesh.vertices(), seed, 3);
        let field = wave(mesh.vertices(), seed + 4.0, 0.1);
        let of = |faces: &Faces, path: &[Vec<Point3>], field: &[Vector3]| {
            let metric = metric(faces, MetricKind::QuasiConformal);
            transport_along(&metric, path, field, true).unwrap()
        };
        let plain = of(mesh.faces(), &path, &field);
        let rotation = Rotation3::from_euler_angles(turn, 0.5 * turn, 1.0);
        let translation = Vector3::new(shift, 2.0 * shift, -shift);
        let motion = |p: &Point3| rotation * p + translation;
        let turned: Vec<Vec<Point3>> = path.iter().map(|m| m.iter().map(motion).collect()).collect();
        let turned_field: Vec<Vector3> = field.iter().map(|x| rotation * x).collect();
        let expected: Vec<Vector3> = plain.iter().map(|x| rotation * x).collect();
        prop_assert!(apart(&of(mesh.faces(), &turned, &turned_field), &expected) < 1e-10);
        // Vertex v becomes vertex (5 v + 3) mod 42; 5 and 42 share no factor.
        let place = |v: usize| (5 * v + 3) % 42;
        let triangles = mesh.faces().triangles().iter();
        let triangles = triangles.map(|t| t.map(|v| place(v as usize) as u32)).collect();
        let faces = Faces::new(42, triangles).unwrap();
        let renumbered: Vec<Vec<Point3>> = path.iter().map(|m| permuted(m, place)).collect();
        let there = of(&faces, &renumbered, &permuted(&field, place));
        prop_assert!(apart(&there, &permuted(&plain, place)) < 1e-10);
    }
}

fn permuted<T: Clone>(items: &[T], place: impl Fn(usize) -> usize) -> Vec<T> {
    let mut out = items.to_vec();
    for (v, item) in items.iter().enumerate() {
        out[place(v)] = item.clone();
    }
    out
}

#[test]
fn a_path_that_goes_nowhere_returns_the_field_as_it_is() {
    let mesh = phantom::sphere(1, 1.0);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let field = wave(mesh.vertices(), 1.0, 0.1);
    let still = vec![mesh.vertices().to_vec(); 4];
    let there = transport_along(&metric, &still, &field, true).unwrap();
    assert_eq!(there, field);
    assert_eq!(
        transport_along(&metric, &still[..1], &field, true).unwrap(),
        field
    );
    let mut trembling = still;
    for (k, pose) in trembling.iter_mut().enumerate() {
        pose[3 * k].x += 1e-15;
    }
    let there = transport_along(&metric, &trembling, &field, true).unwrap();
    assert_eq!(there, field);
}

#[test]
fn the_direction_of_the_path_stays_the_direction_of_the_path() {
    let mesh = phantom::sphere(1, 1.0);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let bent = bent_path(mesh.vertices(), 3.0, 5);
    let along = wave(mesh.vertices(), 3.0, 0.3);
    let straight: Vec<Vec<Point3>> = (0..6)
        .map(|k| moved(mesh.vertices(), &along, 0.2 * f64::from(k)))
        .collect();
    for (path, keep_norm) in [(&bent, true), (&straight, true), (&straight, false)] {
        let step = |k: usize| -> Vec<Vector3> {
            let ends = path[k].iter().zip(&path[k + 1]);
            ends.map(|(a, b)| b - a).collect()
        };
        let there = transport_along(&metric, path, &step(0), keep_norm).unwrap();
        let before = norm2(&metric, &path[0], &step(0));
        let share = (before / norm2(&metric, &path[5], &step(4))).sqrt();
        let expected: Vec<Vector3> = step(4).iter().map(|x| x * share).collect();
        assert!(apart(&there, &expected) < 1e-12);
    }
}

#[test]
fn along_a_straight_path_the_number_of_samples_does_not_matter() {
    let mesh = phantom::torus(2.0, 0.7, 12, 6);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let along = wave(mesh.vertices(), 5.0, 0.4);
    let field = wave(mesh.vertices(), 9.0, 0.1);
    for keep_norm in [true, false] {
        let transported = |steps: usize| {
            let path: Vec<Vec<Point3>> = (0..=steps)
                .map(|k| moved(mesh.vertices(), &along, k as f64 / steps as f64))
                .collect();
            transport_along(&metric, &path, &field, keep_norm).unwrap()
        };
        assert!(apart(&transported(1), &transported(17)) < 1e-11);
    }
}

#[test]
fn there_and_back_differs_by_the_length_of_a_step() {
    let mesh = phantom::sphere(2, 1.0);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let field = wave(mesh.vertices(), 2.0, 0.1);
    let error = |steps: usize| {
        let mut path = bent_path(mesh.vertices(), 6.0, steps);
        let there = transport_along(&metric, &path, &field, true).unwrap();
        path.reverse();
        apart(
            &transport_along(&metric, &path, &there, true).unwrap(),
            &field,
        )
    };
    // With four steps curvature still turns too much in one.
    let errors = [8, 16, 32, 64].map(error);
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.65 * pair[0], "{errors:?}");
    }
}

#[test]
fn finer_sampling_converges() {
    let mesh = phantom::sphere(2, 1.0);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let field = wave(mesh.vertices(), 2.0, 0.1);
    let transported = |steps: usize| {
        let path = bent_path(mesh.vertices(), 6.0, steps);
        transport_along(&metric, &path, &field, true).unwrap()
    };
    let best = transported(256);
    let errors = [4, 8, 16, 32].map(|steps| apart(&transported(steps), &best));
    assert!(errors[0] > 1e-4, "{errors:?}");
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.65 * pair[0], "{errors:?}");
    }
}

#[test]
fn three_products_at_once_are_those_one_by_one() {
    let mesh = phantom::torus(2.0, 0.7, 12, 6);
    let (x, y) = (
        wave(mesh.vertices(), 1.0, 0.1),
        wave(mesh.vertices(), 2.0, 0.1),
    );
    for kind in METRICS {
        for (form, area_weights) in [
            (Form::Additive, true),
            (Form::Additive, false),
            (Form::Printed, true),
        ] {
            let params = MetricParams {
                kind,
                form,
                area_weights,
                ..MetricParams::default()
            };
            let metric = Metric::new(mesh.faces(), params.check().unwrap());
            let at = metric.prepare(mesh.vertices()).unwrap();
            let expected =
                [(&x, &x), (&x, &y), (&y, &y)].map(|(x, y)| metric.inner_product(&at, x, y));
            for (found, expected) in metric.products(&at, &x, &y).into_iter().zip(expected) {
                assert!(
                    (found - expected).abs() <= 1e-12 * expected.abs(),
                    "{kind:?} {form:?}"
                );
            }
        }
    }
}

#[test]
fn damaged_input_is_refused_by_number() {
    let mesh = phantom::sphere(1, 1.0);
    let good = metric(mesh.faces(), MetricKind::QuasiConformal);
    let field = wave(mesh.vertices(), 1.0, 0.1);
    let path = bent_path(mesh.vertices(), 1.0, 2);
    let error = |path: &[Vec<Point3>], field: &[Vector3]| {
        transport_along(&good, path, field, true)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        error(&[], &field),
        "there are no poses to transport a motion along"
    );
    assert_eq!(
        error(&path, &field[..7]),
        "7 displacements for poses of 42 vertices"
    );
    let mut short = path.clone();
    short[2].pop();
    assert_eq!(
        error(&short, &field),
        "41 points for connectivity of 42 vertices"
    );
    let mut broken = path.clone();
    broken[1][5].y = f64::NAN;
    assert_eq!(
        error(&broken, &field),
        "lengths or areas of the pose overflow"
    );
    let mut wild = field.clone();
    wild[0].x = f64::INFINITY;
    assert!(matches!(
        transport_along(&good, &path, &wild, true),
        Err(TransportError::NotFinite { .. })
    ));
    let printed = MetricParams {
        form: Form::Printed,
        ..MetricParams::of(MetricKind::QuasiConformal)
    };
    let printed = Metric::new(mesh.faces(), printed.check().unwrap());
    let refused = transport_along(&printed, &path, &field, true);
    assert_eq!(refused, Err(TransportError::NotAnInnerProduct));
}
