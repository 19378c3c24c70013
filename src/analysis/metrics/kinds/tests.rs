//! Laws that every metric of the list obeys, and the invariances that each states.

use nalgebra::Rotation3;

use crate::analysis::metrics::{
    Corners, CurvatureMean, Form, METRICS, Metric, MetricKind, MetricParams, PairScratch,
    PathEnergy, Regulariser, bent,
};
use crate::mesh::{Point3, TriMesh, Vector3, phantom};

const FORMS: [Form; 4] = [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive];

/// Every metric in every form, corner and weighting, without a regulariser.
fn all_params() -> Vec<MetricParams> {
    let mut all = Vec::new();
    for kind in METRICS {
        for form in FORMS {
            for corners in [Corners::Raw, Corners::ScaleFree] {
                for area_weights in [true, false] {
                    all.push(MetricParams {
                        kind,
                        form,
                        corners,
                        area_weights,
                        mu: 0.5,
                        curvature: CurvatureMean::Rings(1),
                        lambda: 0.0,
                        regulariser: Regulariser::Area,
                    });
                }
            }
        }
    }
    all
}

fn bowl() -> TriMesh {
    let mesh = phantom::bowl(1.0, 4, 9);
    let points = bent(mesh.vertices(), 0.1, 0.3);
    TriMesh::new(points, std::sync::Arc::clone(mesh.faces())).unwrap()
}

fn norm2(params: MetricParams, mesh: &TriMesh, field: &[Vector3]) -> f64 {
    let metric = Metric::new(mesh.faces(), params.check().unwrap());
    metric.norm2(&metric.prepare(mesh.vertices()).unwrap(), field)
}

fn field(mesh: &TriMesh, of: impl Fn(Vector3) -> Vector3) -> Vec<Vector3> {
    mesh.vertices().iter().map(|p| of(p.coords)).collect()
}

#[test]
fn names_are_unique_and_words_are_there() {
    for (index, kind) in METRICS.iter().enumerate() {
        let words = kind.words();
        assert!(!words.name.is_empty() && !words.summary.is_empty());
        assert!(!words.ignores.is_empty() && !words.penalises.is_empty());
        assert_eq!(words.id, words.name.to_lowercase());
        assert!(
            METRICS[..index]
                .iter()
                .all(|other| other.words().id != words.id)
        );
        assert_eq!(words.ignores.contains("scaling"), kind.ignores_scale());
    }
}

#[test]
fn coordinates_of_fields_have_the_products_of_every_metric() {
    let mesh = bowl();
    let (x, y) = (
        field(&mesh, |p| Vector3::new(p.y * p.z, 0.3 * p.x, p.y * p.y)),
        field(&mesh, |p| Vector3::new(p.z.sin(), p.x * p.y, -p.x)),
    );
    for params in all_params() {
        let params = MetricParams {
            lambda: 0.7,
            ..params
        };
        if !params.is_inner_product() {
            continue;
        }
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let pose = metric.prepare(mesh.vertices()).unwrap();
        let [of_x, of_y] = [&x, &y].map(|field| metric.coordinates(&pose, field));
        let product: f64 = of_x.iter().zip(&of_y).map(|(x, y)| x * y).sum();
        let [norm2, expected, _] = metric.products(&pose, &x, &y);
        assert!((product - expected).abs() < 1e-12 * norm2, "{params:?}");
        assert!(metric.coordinates(&pose, &x[1..]).is_empty());
    }
}

#[test]
fn a_pose_is_at_no_distance_from_itself() {
    let mesh = bowl();
    for params in all_params() {
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let pose = metric.prepare(mesh.vertices()).unwrap();
        let pair = metric.pair(&pose, &pose, &mut PairScratch::default());
        assert_eq!(pair.energy(), 0.0, "{params:?}");
    }
}

#[test]
fn distances_are_symmetric_and_not_zero_for_a_bend() {
    let mesh = bowl();
    for params in all_params() {
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let a = metric.prepare(mesh.vertices()).unwrap();
        let b = metric.prepare(&bent(mesh.vertices(), 0.1, 2.0)).unwrap();
        let mut scratch = PairScratch::default();
        let there = metric.pair(&a, &b, &mut scratch).distance();
        let back = metric.pair(&b, &a, &mut scratch).distance();
        assert!((there - back).abs() <= 1e-12 * there, "{params:?}");
        assert!(there > 0.0, "{params:?}");
    }
}

/// A pair is compared where a rigid motion lays the second pose, without moving it: the same as moving it first.
#[test]
fn a_pose_that_is_laid_costs_what_it_costs_where_it_lies() {
    let (mesh, turn) = (bowl(), Rotation3::new(Vector3::new(0.4, -1.1, 0.7)));
    let shift = Vector3::new(0.3, 2.0, -0.5);
    let there = bent(mesh.vertices(), 0.1, 2.0);
    let laid: Vec<Point3> = there.iter().map(|p| turn * p + shift).collect();
    for params in all_params() {
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let [a, b, moved] = [mesh.vertices(), &there, &laid].map(|p| metric.prepare(p).unwrap());
        let mut scratch = PairScratch::default();
        let found = metric.pair_moved(&a, &b, turn.matrix(), &shift, &mut scratch);
        let known = metric.pair(&a, &moved, &mut scratch);
        for (found, known) in [
            (found.norm2_a, known.norm2_a),
            (found.norm2_b, known.norm2_b),
        ] {
            assert!(
                (found - known).abs() <= 1e-10 * known,
                "{found} {known} {params:?}"
            );
        }
        if params.kind == MetricKind::Displacement {
            let way = |from: &[Point3], to: &[Point3]| -> Vec<Vector3> {
                from.iter().zip(to).map(|(p, q)| q - p).collect()
            };
            let at_a = metric.norm2(&a, &way(mesh.vertices(), &laid));
            let at_b = metric.norm2(&moved, &way(&laid, mesh.vertices()));
            assert!((found.norm2_a - at_a).abs() <= 1e-10 * at_a, "{params:?}");
            assert!((found.norm2_b - at_b).abs() <= 1e-10 * at_b, "{params:?}");
        }
    }
}

/// The field of a turn is a rigid motion to first order: it costs nothing, and for a metric that ignores scale
/// neither does the field of even growth. What is not ignored costs something.
#[test]
fn translation_and_rotation_cost_nothing_and_scaling_only_where_it_is_not_ignored() {
    let mesh = bowl();
    let shift = field(&mesh, |_| Vector3::new(0.3, -0.2, 0.5));
    let turn = field(&mesh, |p| Vector3::new(0.2, 0.7, -0.4).cross(&p));
    let growth = field(&mesh, |p| p * 0.3);
    for params in all_params() {
        let scale = norm2(
            params,
            &mesh,
            &field(&mesh, |p| Vector3::new(p.x, 0.0, 0.0)),
        );
        assert!(scale > 0.0, "{params:?}");
        // With curvature as a factor even the printed forms multiply zero angle terms.
        for rigid in [&shift, &turn] {
            assert!(
                norm2(params, &mesh, rigid) < 1e-20 * (1.0 + scale),
                "{params:?}"
            );
        }
        let grown = norm2(params, &mesh, &growth);
        if params.kind.ignores_scale() {
            assert!(grown < 1e-20 * (1.0 + scale), "{params:?} {grown:e}");
        } else {
            assert!(grown > 1e-3 * scale, "{params:?}");
        }
    }
}

#[test]
fn products_are_linear_where_they_are_said_to_be_and_only_there() {
    let mesh = bowl();
    let [x, y] = [2.0, 4.0].map(|phase| {
        let moved = bent(mesh.vertices(), 0.1, phase);
        let field = moved.iter().zip(mesh.vertices()).map(|(b, a)| b - a);
        field.collect::<Vec<Vector3>>()
    });
    let minus: Vec<Vector3> = x.iter().map(|x| -x).collect();
    for params in all_params() {
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let pose = metric.prepare(mesh.vertices()).unwrap();
        let (there, back) = (
            metric.inner_product(&pose, &x, &y),
            metric.inner_product(&pose, &minus, &y),
        );
        let size = (metric.norm2(&pose, &x) * metric.norm2(&pose, &y)).sqrt();
        let odd = (there + back).abs() <= 1e-9 * size;
        assert_eq!(odd, params.is_inner_product(), "{params:?} {there} {back}");
        let products = metric.products(&pose, &x, &y);
        assert!((products[1] - there).abs() <= 1e-12 * size, "{params:?}");
    }
}

#[test]
fn gradients_agree_with_finite_differences() {
    let mesh = bowl();
    let end = bent(mesh.vertices(), 0.1, 2.0);
    let inner: Vec<f64> = (bent(mesh.vertices(), 0.06, 1.0).iter())
        .flat_map(|p| [p.x, p.y, p.z])
        .collect();
    let direction: Vec<f64> = (0..inner.len()).map(|k| (1.7 * k as f64).sin()).collect();
    for params in all_params() {
        let metric = Metric::new(mesh.faces(), params.check().unwrap());
        let mut path = PathEnergy::new(&metric, mesh.vertices(), &end, 1).unwrap();
        let mut gradient = vec![0.0; inner.len()];
        path.evaluate(&inner, &mut gradient);
        let slope: f64 = gradient.iter().zip(&direction).map(|(g, d)| g * d).sum();
        let mut moved = |h: f64| {
            let points: Vec<f64> = (inner.iter().zip(&direction))
                .map(|(x, d)| x + h * d)
                .collect();
            path.energy(&points)
        };
        let differences = (moved(1e-6) - moved(-1e-6)) / 2e-6;
        let apart = (slope - differences).abs();
        assert!(
            apart <= 1e-5 * slope.abs(),
            "{params:?}: {slope} {differences}"
        );
    }
}
