//! What cannot be computed is refused with numbers; what is stopped is the best so far.

use super::*;

#[test]
fn ends_that_do_not_fit_are_refused_with_their_numbers() {
    let mesh = bowl();
    let params = GeodesicParams::default().check().unwrap();
    let ask = |start: &[Point3], end: &[Point3]| {
        geodesic(mesh.faces(), start, end, &params, &Progress::default()).unwrap_err()
    };
    assert_eq!(
        ask(&mesh.vertices()[1..], mesh.vertices()),
        GeodesicError::VertexCounts {
            start: 84,
            end: 85,
            expected: 85
        }
    );
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let mut end = mesh.vertices().to_vec();
        end[7].y = bad;
        let error = ask(mesh.vertices(), &end);
        assert!(
            matches!(
                error,
                GeodesicError::NotFinite {
                    end: "end",
                    vertex: 7,
                    ..
                }
            ),
            "{error}"
        );
    }
    let point = vec![Point3::new(1.0, 2.0, 3.0); 85];
    assert_eq!(
        ask(&point, mesh.vertices()),
        GeodesicError::Degenerate {
            end: "start",
            faces: mesh.triangles().len(),
            vertices: 85
        }
    );
    let nothing = Faces::new(0, Vec::new()).unwrap();
    assert!(geodesic(&nothing, &[], &[], &params, &Progress::default()).is_err());
}

#[test]
fn a_path_through_a_point_does_not_panic() {
    // The straight line from a sphere to the sphere turned inside out meets the centre half-way.
    let ball = phantom::sphere(1, 1.0);
    let end: Vec<Point3> = ball
        .vertices()
        .iter()
        .map(|p| Point3::from(-p.coords))
        .collect();
    for interpolated_poses in [1, 2, 3] {
        let params = GeodesicParams {
            interpolated_poses,
            ..GeodesicParams::default()
        };
        let params = params.check().unwrap();
        let found = geodesic(
            ball.faces(),
            ball.vertices(),
            &end,
            &params,
            &Progress::default(),
        );
        if let Ok(path) = found {
            assert!(path.energy.is_finite() && path.energy <= path.energy_linear);
        }
    }
}

#[test]
fn squeezed_faces_do_not_panic() {
    let ball = phantom::sphere(2, 1.0);
    let mut end = bent(ball.vertices(), 0.2, 1.0);
    for v in 40..60 {
        end[v] = end[3];
    }
    let params = GeodesicParams::default().check().unwrap();
    let found = geodesic(
        ball.faces(),
        ball.vertices(),
        &end,
        &params,
        &Progress::default(),
    );
    if let Ok(path) = found {
        assert!(path.energy <= path.energy_linear);
        assert!(
            path.poses
                .iter()
                .flatten()
                .all(|p| p.iter().all(|x| x.is_finite()))
        );
    }
}

#[test]
fn forms_that_collapse_are_refused_from_two_interpolated_poses_on() {
    let asked = |metric: MetricParams, interpolated_poses| {
        GeodesicParams {
            metric: MetricParams {
                lambda: 0.0,
                ..metric
            },
            interpolated_poses,
            ..GeodesicParams::default()
        }
        .check()
    };
    for form in [Form::Printed, Form::Bilinear] {
        let metric = MetricParams {
            form,
            ..MetricParams::of(MetricKind::QuasiConformal)
        };
        assert_eq!(
            asked(metric, 2).unwrap_err(),
            GeodesicParamError::NoLeastPath {
                interpolated_poses: 2
            }
        );
        assert!(asked(metric, 1).is_ok());
    }
    let raw = MetricParams {
        kind: MetricKind::AnglePreserving,
        form: Form::Bilinear,
        corners: Corners::Raw,
        ..MetricParams::default()
    };
    assert!(asked(raw, 3).is_err());
    assert!(asked(MetricParams::default(), 7).is_ok());
    let isometric = MetricParams {
        kind: MetricKind::Isometric,
        ..MetricParams::default()
    };
    assert!(asked(isometric, 7).is_ok());
}

#[test]
fn settings_out_of_range_are_refused() {
    let default = GeodesicParams::default();
    for wrong in [
        GeodesicParams {
            interpolated_poses: 5_000,
            ..default
        },
        GeodesicParams {
            tolerance: f64::NAN,
            ..default
        },
        GeodesicParams {
            tolerance: -1.0,
            ..default
        },
        GeodesicParams {
            max_vertices: Some(3),
            ..default
        },
        GeodesicParams {
            metric: MetricParams {
                mu: -1.0,
                ..default.metric
            },
            ..default
        },
    ] {
        assert!(wrong.check().is_err(), "{wrong:?}");
    }
}

#[test]
fn a_stopped_path_is_the_straight_line_or_better() {
    let ball = phantom::sphere(3, 1.0);
    let end = bent(ball.vertices(), 0.3, 1.0);
    let params = GeodesicParams {
        interpolated_poses: 7,
        ..exact()
    };
    let params = params.check().unwrap();
    let progress = Progress::default();
    progress.stop();
    let at_once = geodesic(ball.faces(), ball.vertices(), &end, &params, &progress).unwrap();
    assert!(at_once.stopped && !at_once.converged);
    assert_eq!(at_once.poses.len(), 9);
    assert!(at_once.energy <= at_once.energy_linear);
}

#[test]
fn a_path_stopped_on_its_way_is_the_best_so_far_and_ends_at_once() {
    let ball = phantom::sphere(3, 1.0);
    let end = bent(ball.vertices(), 0.3, 1.0);
    let params = exact().check().unwrap();
    let solver = GeodesicSolver::new(ball.faces(), ball.vertices(), &params).unwrap();
    let ask = |most: usize| {
        let asked = std::cell::Cell::new(0);
        let path = solver.path(ball.vertices(), &end, &|| {
            asked.set(asked.get() + 1);
            asked.get() <= most
        });
        (path.unwrap(), asked.get())
    };
    let whole = found(ball.faces(), ball.vertices(), &end, exact());
    let mut before = whole.energy_linear;
    for most in [4, 12, 20] {
        let (path, asked) = ask(most);
        assert!(path.stopped && !path.converged);
        // Once by the search, and once for each pose whose crossings are not counted.
        assert!(asked <= most + 1 + 3, "{asked}");
        assert!(path.energy <= before && path.energy >= whole.energy * (1.0 - 1e-9));
        before = path.energy;
    }
    assert!(before < whole.energy_linear);
}
