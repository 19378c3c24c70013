//! Energies against sums of pairs, gradients against finite differences.

use proptest::prelude::{ProptestConfig, prop_assert, prop_assume, proptest};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::analysis::metrics::{
    Corners, CurvatureMean, CurvatureRole, Form, METRICS, MetricKind, MetricParams, PairScratch,
    Regulariser,
};
use crate::mesh::{Faces, TriMesh, phantom};

/// Every kind, form, corner, weight, regulariser and number of rings that differ in what they compute.
fn all_settings() -> Vec<MetricParams> {
    use Form::{Additive, Bilinear, Frozen, Printed};
    let mut all = Vec::new();
    for kind in METRICS {
        let forms: &[Form] = if kind.has_forms() {
            &[Printed, Bilinear, Frozen, Additive]
        } else {
            &[Additive]
        };
        for (&form, corners) in forms
            .iter()
            .flat_map(|form| [(form, Corners::Raw), (form, Corners::ScaleFree)])
        {
            for (area_weights, curvature_rings) in [(false, 0), (true, 0), (true, 3)] {
                for regulariser in [Regulariser::Area, Regulariser::Uniform] {
                    let params = MetricParams {
                        kind,
                        form,
                        corners,
                        area_weights,
                        mu: 0.7,
                        curvature: CurvatureMean::Rings(curvature_rings),
                        lambda: 0.3,
                        regulariser,
                    };
                    let averages = params.curvature_role() != CurvatureRole::Unused;
                    if averages || curvature_rings == 0 {
                        all.push(params);
                    }
                }
            }
        }
    }
    all
}

/// Meshes with and without a boundary.
fn meshes() -> [TriMesh; 3] {
    [
        phantom::sphere(1, 1.2),
        phantom::bowl(1.0, 3, 7),
        phantom::torus(1.5, 0.6, 7, 5),
    ]
}

fn shaken(mesh: &TriMesh, amount: f64, random: &mut ChaCha8Rng) -> Vec<Point3> {
    (mesh.vertices().iter())
        .map(|p| p + Vector3::from_fn(|_, _| random.random_range(-amount..amount)))
        .collect()
}

struct Path {
    faces: std::sync::Arc<Faces>,
    poses: Vec<Vec<Point3>>,
}

impl Path {
    fn random(mesh: &TriMesh, interpolated_poses: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            faces: std::sync::Arc::clone(mesh.faces()),
            poses: (0..interpolated_poses + 2)
                .map(|_| shaken(mesh, 0.1, random))
                .collect(),
        }
    }

    fn metric(&self, params: MetricParams) -> Metric {
        Metric::new(&self.faces, params.check().unwrap())
    }

    fn energy(&self, params: MetricParams) -> PathEnergy {
        let (start, end) = (&self.poses[0], &self.poses[self.poses.len() - 1]);
        PathEnergy::new(&self.metric(params), start, end, self.poses.len() - 2).unwrap()
    }

    fn inner(&self) -> Vec<f64> {
        (self.poses[1..self.poses.len() - 1].iter().flatten())
            .flat_map(|p| p.iter().copied())
            .collect()
    }
}

#[test]
fn the_energy_is_the_sum_over_pairs_to_round_off() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for mesh in meshes() {
        for interpolated_poses in [0, 1, 3, 4, 7] {
            let path = Path::random(&mesh, interpolated_poses, &mut random);
            for params in all_settings() {
                if params.form == Form::Frozen && interpolated_poses > 0 {
                    continue; // Weights of the ends here, of each pair there.
                }
                let metric = path.metric(params);
                let poses: Vec<_> = (path.poses.iter())
                    .map(|p| metric.prepare(p).unwrap())
                    .collect();
                let mut energy = path.energy(params);
                let found = energy.energy(&path.inner());
                let mut expected = 0.0;
                for (step, pair) in poses.windows(2).enumerate() {
                    let pair = metric.pair(&pair[0], &pair[1], &mut PairScratch::default());
                    expected += pair.energy();
                    let apart = energy.step_energies()[step] - pair.energy();
                    assert!(apart.abs() <= 1e-12 * pair.energy(), "{params:?} {apart}");
                }
                assert!((found - expected).abs() <= 1e-12 * expected, "{params:?}");
            }
        }
    }
}

/// How far the gradient along a random direction is from central differences of fourth order.
fn gradient_error(
    path: &Path,
    params: MetricParams,
    mut energy: PathEnergy,
    random: &mut ChaCha8Rng,
) -> f64 {
    let inner = path.inner();
    let direction: Vec<f64> = inner
        .iter()
        .map(|_| random.random_range(-1.0..1.0))
        .collect();
    let mut gradient = vec![f64::NAN; inner.len()];
    energy.evaluate(&inner, &mut gradient);
    let exact: f64 = gradient.iter().zip(&direction).map(|(g, d)| g * d).sum();
    let mut at = |step: f64| {
        let moved: Vec<f64> = (inner.iter().zip(&direction))
            .map(|(x, d)| x + step * d)
            .collect();
        energy.energy(&moved)
    };
    let mut error = |h: f64| {
        let near = 8.0 * (at(h) - at(-h));
        let differences = (near - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
        (differences - exact).abs() / differences.abs()
    };
    if params.form == Form::Printed {
        // Somewhere a kink is always near: shorter steps do not reach it. A wrong gradient fails them all.
        [1e-6, 1e-7, 3e-8, 1e-8]
            .map(error)
            .into_iter()
            .fold(f64::INFINITY, f64::min)
    } else {
        error(1e-4)
    }
}

#[test]
fn gradients_agree_with_finite_differences_on_fifty_random_paths() {
    let mut random = ChaCha8Rng::seed_from_u64(2);
    let mut other = ChaCha8Rng::seed_from_u64(20);
    for round in 0..50 {
        let path = Path::random(&meshes()[round % 3], [1, 3, 5][round / 3 % 3], &mut random);
        for params in all_settings() {
            let error = gradient_error(&path, params, path.energy(params), &mut random);
            assert!(error <= 1e-6, "{params:?}: {error:e}");
            if params.form != Form::Printed {
                let of_ends = path.energy(params).with_size_of_ends();
                assert!(
                    gradient_error(&path, params, of_ends, &mut other) <= 1e-6,
                    "{params:?}"
                );
            }
        }
    }
}

#[test]
fn the_gradient_of_a_pair_agrees_with_finite_differences_at_both_poses() {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    for mesh in meshes() {
        let [a, b] = [0; 2].map(|_| shaken(&mesh, 0.1, &mut random));
        for params in all_settings() {
            if params.form != Form::Additive {
                continue; // Kinks, and weights that differences would move with the poses.
            }
            let metric = Metric::new(mesh.faces(), params.check().unwrap());
            let norms = |a: &[Point3], b: &[Point3]| {
                let (a, b) = (metric.prepare(a).unwrap(), metric.prepare(b).unwrap());
                metric.pair(&a, &b, &mut PairScratch::default())
            };
            let (found, [at_a, at_b]) = metric.pair_gradient(&a, &b).unwrap();
            let expected = norms(&a, &b);
            assert!((found.norm2_a - expected.norm2_a).abs() <= 1e-12 * expected.norm2_a);
            assert!((found.norm2_b - expected.norm2_b).abs() <= 1e-12 * expected.norm2_b);
            let moves = shaken(&mesh, 1.0, &mut random);
            let along = |points: &[Point3], h: f64| -> Vec<Point3> {
                points
                    .iter()
                    .zip(&moves)
                    .map(|(p, x)| p + h * x.coords)
                    .collect()
            };
            let h = 1e-5;
            for (slopes, of) in [
                (at_a, [norms(&along(&a, h), &b), norms(&along(&a, -h), &b)]),
                (at_b, [norms(&a, &along(&b, h)), norms(&a, &along(&b, -h))]),
            ] {
                let differences = (of[0].energy() - of[1].energy()) / (2.0 * h);
                let exact: f64 = slopes
                    .iter()
                    .zip(&moves)
                    .map(|(g, x)| g.dot(&x.coords))
                    .sum();
                let apart = (differences - exact).abs();
                assert!(
                    apart <= 1e-6 * exact.abs(),
                    "{params:?}: {apart} of {exact}"
                );
            }
        }
    }
}

#[test]
fn with_the_size_of_the_ends_swelling_makes_no_step_shorter() {
    let ball = phantom::sphere(2, 1.0);
    let moved = |by: f64, scale: f64| -> Vec<Point3> {
        let shift = Vector3::new(by, 0.0, 0.0);
        ball.vertices().iter().map(|p| p * scale + shift).collect()
    };
    let path = |scale: f64| Path {
        faces: std::sync::Arc::clone(ball.faces()),
        poses: [(0.0, 1.0), (1.0, scale), (2.0, scale), (3.0, 1.0)]
            .map(|(by, scale)| moved(by, scale))
            .to_vec(),
    };
    let params = MetricParams {
        lambda: 100.0,
        ..MetricParams::of(MetricKind::QuasiConformal)
    };
    let cost = |path: &Path, of_ends: bool| {
        let energy = path.energy(params);
        match of_ends {
            true => energy.with_size_of_ends().energy(&path.inner()),
            false => { energy }.energy(&path.inner()),
        }
    };
    assert!(
        cost(&path(1.2), false) < cost(&path(1.0), false),
        "relative to each pose it does"
    );
    assert!(cost(&path(1.2), true) > cost(&path(1.0), true));
    let unmoved = cost(&path(1.0), true) / cost(&path(1.0), false);
    assert!((unmoved - 1.0).abs() < 1e-12, "equal sizes, equal energies");
}

#[test]
fn a_path_that_waits_costs_nothing_and_pulls_at_nothing() {
    let mesh = phantom::bowl(1.0, 3, 7);
    let poses = vec![mesh.vertices().to_vec(); 5];
    let path = Path {
        faces: std::sync::Arc::clone(mesh.faces()),
        poses,
    };
    for params in all_settings() {
        let inner = path.inner();
        let mut gradient = vec![f64::NAN; inner.len()];
        let energy = path.energy(params).evaluate(&inner, &mut gradient);
        assert!(energy.abs() < 1e-24, "{params:?}: {energy:e}");
        assert!(gradient.iter().all(|g| g.abs() < 1e-11), "{params:?}");
    }
}

#[test]
fn faces_without_area_give_the_energy_of_their_pairs_and_no_nan() {
    let mesh = phantom::bowl(1.0, 3, 7);
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut path = Path::random(&mesh, 2, &mut random);
    let [p, q, r] = mesh.triangles()[5].map(|v| v as usize);
    path.poses[1][q] = path.poses[1][p]; // two corners in one place
    path.poses[2][r] = nalgebra::center(&path.poses[2][p], &path.poses[2][q]); // three on a line
    for params in all_settings() {
        if params.form == Form::Frozen {
            continue;
        }
        let metric = path.metric(params);
        let expected: f64 = (path.poses.windows(2))
            .map(|pair| {
                let [a, b] = [0, 1].map(|k| metric.prepare(&pair[k]).unwrap());
                metric.pair(&a, &b, &mut PairScratch::default()).energy()
            })
            .sum();
        let inner = path.inner();
        let mut gradient = vec![f64::NAN; inner.len()];
        let found = path.energy(params).evaluate(&inner, &mut gradient);
        assert!(
            (found - expected).abs() <= 1e-9 * expected,
            "{params:?}: {found}, {expected}"
        );
        assert!(gradient.iter().all(|g| g.is_finite()), "{params:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn moving_a_path_turns_its_gradient_and_keeps_its_energy(seed in 0..1000_u64, angle in -3.0..3.0_f64) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let path = Path::random(&phantom::bowl(1.0, 3, 7), 2, &mut random);
        let turn = nalgebra::Rotation3::from_euler_angles(angle, 0.4, -1.1);
        let moved = Path {
            faces: std::sync::Arc::clone(&path.faces),
            poses: (path.poses.iter())
                .map(|pose| pose.iter().map(|p| turn * p + Vector3::new(1.0, -0.5, 2.0)).collect())
                .collect(),
        };
        for params in all_settings() {
            let (there, back) = (path.inner(), moved.inner());
            let (mut before, mut after) = (vec![0.0; there.len()], vec![0.0; there.len()]);
            let energy = path.energy(params).evaluate(&there, &mut before);
            let other = moved.energy(params).evaluate(&back, &mut after);
            prop_assert!((energy - other).abs() <= 1e-10 * energy, "{params:?}");
            let size = before.iter().map(|g| g.abs()).fold(0.0, f64::max);
            for (g, turned) in before.chunks_exact(3).zip(after.chunks_exact(3)) {
                let apart = turn * Vector3::from_column_slice(g) - Vector3::from_column_slice(turned);
                prop_assert!(apart.amax() <= 1e-9 * size, "{params:?}");
            }
        }
    }

    #[test]
    fn scaling_a_path_changes_no_scale_free_energy(seed in 0..1000_u64, scale in 0.02..50.0_f64) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let path = Path::random(&phantom::sphere(1, 1.0), 3, &mut random);
        let scaled = Path {
            faces: std::sync::Arc::clone(&path.faces),
            poses: (path.poses.iter()).map(|pose| pose.iter().map(|p| p * scale).collect()).collect(),
        };
        for params in all_settings() {
            let free = params.corners == Corners::ScaleFree
                && params.regulariser == Regulariser::Area
                && params.kind != MetricKind::Displacement;
            if free {
                let before = path.energy(params).energy(&path.inner());
                let after = scaled.energy(params).energy(&scaled.inner());
                // A distance is a square root: half as far apart.
                prop_assert!((before - after).abs() <= 1e-12 * before, "{params:?}");
            }
        }
    }

    #[test]
    fn renumbering_vertices_and_faces_permutes_the_gradient(seed in 0..1000_u64, step in 1..22_usize) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mesh = phantom::bowl(1.0, 3, 7);
        let count = mesh.vertices().len();
        prop_assume!((2..=step).all(|d| !(step.is_multiple_of(d) && count.is_multiple_of(d))));
        let path = Path::random(&mesh, 2, &mut random);
        let place = |v: usize| (v * step) % count;
        let mut triangles: Vec<[u32; 3]> = (mesh.triangles().iter())
            .map(|t| [t[1], t[2], t[0]].map(|v| place(v as usize) as u32))
            .collect();
        triangles.reverse();
        let renumbered = Path {
            faces: std::sync::Arc::new(Faces::new(count, triangles).unwrap()),
            poses: (path.poses.iter())
                .map(|pose| {
                    let mut moved = pose.clone();
                    for (v, p) in pose.iter().enumerate() {
                        moved[place(v)] = *p;
                    }
                    moved
                })
                .collect(),
        };
        for params in all_settings() {
            let (there, back) = (path.inner(), renumbered.inner());
            let (mut before, mut after) = (vec![0.0; there.len()], vec![0.0; there.len()]);
            let energy = path.energy(params).evaluate(&there, &mut before);
            let other = renumbered.energy(params).evaluate(&back, &mut after);
            prop_assert!((energy - other).abs() <= 1e-11 * energy, "{params:?}");
            let size = before.iter().map(|g| g.abs()).fold(0.0, f64::max);
            for (k, g) in before.iter().enumerate() {
                let (pose, v, axis) = (k / (3 * count), k / 3 % count, k % 3);
                let other = after[3 * count * pose + 3 * place(v) + axis];
                prop_assert!((g - other).abs() <= 1e-9 * size, "{params:?}");
            }
        }
    }
}
