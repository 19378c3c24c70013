//! Parallel transport against geomstats on the sphere and against numpy on meshes.

use cardiomorph::analysis::metrics::Regulariser;
use cardiomorph::analysis::transport::{
    Nearness, PosePath, Products, SampledPath, parallel_transport, transport_along,
};

use super::*;

/// Points along a great circle, as a path with the tangent planes of the sphere.
struct GreatCircle {
    points: Vec<Vector3>,
    velocities: Vec<[Vector3; 1]>,
}

impl GreatCircle {
    fn new(p: Vector3, q: Vector3, steps: usize) -> Self {
        let angle = p.cross(&q).norm().atan2(p.dot(&q));
        let (points, velocities) = (0..=steps)
            .map(|i| {
                let t = i as f64 / steps as f64;
                let (before, after) = (((1.0 - t) * angle).sin(), (t * angle).sin());
                let point = (p * before + q * after) / angle.sin();
                // Towards the next sample, at the last one away from the one before.
                let ahead = if i < steps {
                    q - point * point.dot(&q)
                } else {
                    point * point.dot(&p) - p
                };
                (point, [ahead.normalize() * (angle / steps as f64)])
            })
            .unzip();
        Self { points, velocities }
    }

    fn transport(&self, field: Vector3, nearness: Nearness, keep_norm: bool) -> Vector3 {
        parallel_transport(self, &[field], nearness, keep_norm)[0]
    }
}

impl SampledPath for GreatCircle {
    fn samples(&self) -> usize {
        self.points.len()
    }

    fn velocity(&self, sample: usize) -> &[Vector3] {
        &self.velocities[sample]
    }

    fn products(&self, sample: usize, field: &[Vector3]) -> Products {
        let velocity = self.velocities[sample][0];
        Products {
            field: field[0].norm_squared(),
            mixed: field[0].dot(&velocity),
            velocity: velocity.norm_squared(),
        }
    }

    fn lowered_velocity(&self, sample: usize) -> Vec<Vector3> {
        self.velocities[sample].to_vec()
    }

    fn make_tangent(&self, sample: usize, field: &mut [Vector3]) {
        let normal = self.points[sample];
        field[0] -= normal * normal.dot(&field[0]);
    }
}

fn vector(case: &Case, part: &str, key: &str) -> Vector3 {
    Vector3::from_row_slice(&case.numbers(part, key))
}

#[test]
fn along_great_circles_the_scheme_is_the_transport_of_geomstats() {
    for name in ["sphere_0", "sphere_1", "sphere_2", "sphere_3"] {
        let case = Case::load("transport", name);
        let [p, q, x] = ["p", "q", "X"].map(|key| vector(&case, "inputs", key));
        let expected = vector(&case, "expected", "transported");
        let path = GreatCircle::new(p, q, 8);
        for nearness in [Nearness::Metric, Nearness::Coordinates] {
            for keep_norm in [false, true] {
                let there = path.transport(x, nearness, keep_norm);
                assert!(
                    (there - expected).amax() <= 1e-12,
                    "{name}: {there} {expected}"
                );
            }
        }
    }
}

#[test]
fn around_a_triangle_a_vector_turns_by_its_area() {
    for name in ["holonomy_0", "holonomy_1"] {
        let case = Case::load("transport", name);
        let [a, b, c, x] = ["a", "b", "c", "X"].map(|key| vector(&case, "inputs", key));
        let there = [[a, b], [b, c], [c, a]].iter().fold(x, |x, &[p, q]| {
            GreatCircle::new(p, q, 8).transport(x, Nearness::Metric, true)
        });
        let expected = vector(&case, "expected", "transported");
        assert!(
            (there - expected).amax() <= 1e-12,
            "{name}: {there} {expected}"
        );
        let turned = a.dot(&x.cross(&there)).atan2(x.dot(&there));
        assert!((turned - case.number("rotation_angle")).abs() <= 1e-11);
        let ways_apart = (turned.abs() - case.number("area")).sin().abs();
        let other_way = (turned.abs() + case.number("area")).sin().abs();
        assert!(ways_apart.min(other_way) <= 1e-11, "{name}: {turned}");
    }
}

struct MeshCase {
    case: Case,
    metric: Metric,
    path: Vec<Vec<Point3>>,
    field: Vec<Vector3>,
}

impl MeshCase {
    fn load(name: &str) -> Self {
        let case = Case::load("transport", name);
        let (start, faces) = case.input_mesh("start");
        let (end, _) = case.input_mesh("end");
        let steps = case.value["params"]["steps"].as_u64().unwrap();
        let path = (0..=steps)
            .map(|i| {
                let t = i as f64 / steps as f64;
                (start.iter().zip(&end))
                    .map(|(a, b)| a + (b - a) * t)
                    .collect()
            })
            .collect();
        let params = MetricParams {
            lambda: case.value["params"]["lam"].as_f64().unwrap(),
            regulariser: Regulariser::Uniform,
            ..as_printed(MetricKind::Isometric, Form::Additive, Corners::Raw)
        };
        Self {
            metric: Metric::new(&faces, params.check().unwrap()),
            field: case.field("X"),
            case,
            path,
        }
    }

    /// ⟨⟨X, X⟩⟩ and ⟨⟨X, γ'⟩⟩ at a sample, the velocity being the straight line's.
    fn norm2_and_inner(&self, sample: usize, field: &[Vector3]) -> [f64; 2] {
        let at = self.metric.prepare(&self.path[sample]).unwrap();
        let line = self.path[0].iter().zip(&self.path[1]);
        let velocity: Vec<Vector3> = line.map(|(a, b)| b - a).collect();
        let [norm2, mixed, speed2] = self.metric.products(&at, field, &velocity);
        [norm2, mixed / speed2.sqrt()]
    }

    fn transport(&self, sample: usize, nearness: Nearness, keep_norm: bool) -> Vec<Vector3> {
        let path = PosePath::new(&self.metric, &self.path[..=sample]).unwrap();
        parallel_transport(&path, &self.field, nearness, keep_norm)
    }

    /// Largest difference relative to the largest component of X.
    fn gap(&self, found: &[Vector3], key: &str) -> f64 {
        let expected = self.case.numbers("expected", key);
        assert_eq!(expected.len(), 3 * found.len());
        let largest = self.field.iter().fold(0.0_f64, |m, x| m.max(x.amax()));
        let differences = found.iter().flat_map(|x| x.iter()).zip(&expected);
        differences.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / largest
    }
}

#[test]
fn between_meshes_the_scheme_of_the_text_agrees_with_numpy() {
    for name in ["ico42_ellipsoid", "torus72_smooth"] {
        let mesh = MeshCase::load(name);
        let [norm2, alpha] = mesh.norm2_and_inner(0, &mesh.field);
        close("alpha", alpha, mesh.case.number("alpha0"), 1e-8);
        close("norm²", norm2, mesh.case.number("norm2_0"), 1e-8);
        let last = mesh.path.len() - 1;
        for (nearness, keep_norm, key) in [
            (Nearness::Metric, false, "metric"),
            (Nearness::Metric, true, "metric_keepnorm"),
            (Nearness::Coordinates, false, "euclid"),
            (Nearness::Coordinates, true, "euclid_keepnorm"),
        ] {
            let there = mesh.transport(last, nearness, keep_norm);
            assert!(
                mesh.gap(&there, key) <= 1e-8,
                "{name} {key}: {}",
                mesh.gap(&there, key)
            );
            let table = format!("{key}_norm2_and_inner_per_step");
            let rows = mesh.case.numbers("expected", &table);
            assert_eq!(rows.len(), 2 * last);
            for sample in 1..=last {
                let found =
                    mesh.norm2_and_inner(sample, &mesh.transport(sample, nearness, keep_norm));
                for (found, expected) in found.iter().zip(&rows[2 * (sample - 1)..]) {
                    let scale = norm2.max(1.0);
                    assert!(
                        (found - expected).abs() <= 1e-10 * scale,
                        "{name} {key} {sample}"
                    );
                }
            }
        }
        let first = mesh.transport(1, Nearness::Coordinates, false);
        assert!(mesh.gap(&first, "first_step_euclid") <= 1e-8);
        let short = transport_along(&mesh.metric, &mesh.path, &mesh.field, true).unwrap();
        assert!(mesh.gap(&short, "metric_keepnorm") <= 1e-8);
    }
}
