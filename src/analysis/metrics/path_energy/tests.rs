//! Energies against sums of pairs, gradients against finite differences.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::analysis::metrics::{MetricParams, PairScratch};
use crate::mesh::{Faces, TriMesh, phantom};

/// Every kind, form, corner, weight, regulariser and number of rings that differ in what they compute.
fn all_settings() -> Vec<MetricParams> {
    use Form::{Additive, Bilinear, Frozen, Printed};
    let kinds: [(MetricKind, &[Form]); 4] = [
        (MetricKind::Isometric, &[Additive]),
        (MetricKind::Rigid, &[Additive]),
        (MetricKind::AnglePreserving, &[Printed, Bilinear]),
        (
            MetricKind::QuasiConformal,
            &[Printed, Bilinear, Frozen, Additive],
        ),
    ];
    let mut all = Vec::new();
    for (kind, forms) in kinds {
        for (&form, corners) in forms
            .iter()
            .flat_map(|form| [(form, Corners::Raw), (form, Corners::ScaleFree)])
        {
            for (area_weights, curvature_rings) in [(false, 0), (true, 0), (true, 3)] {
                if curvature_rings > 0 && kind != MetricKind::QuasiConformal {
                    continue;
                }
                for regulariser in [Regulariser::Area, Regulariser::Uniform] {
                    all.push(MetricParams {
                        kind,
                        form,
                        corners,
                        area_weights,
                        mu: 0.7,
                        curvature_rings,
                        lambda: 0.3,
                        regulariser,
                    });
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
    fn random(mesh: &TriMesh, in_betweens: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            faces: std::sync::Arc::clone(mesh.faces()),
            poses: (0..in_betweens + 2)
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
        for in_betweens in [0, 1, 3, 4, 7] {
            let path = Path::random(&mesh, in_betweens, &mut random);
            for params in all_settings() {
                if params.form == Form::Frozen && in_betweens > 0 {
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
fn gradient_error(path: &Path, params: MetricParams, random: &mut ChaCha8Rng) -> f64 {
    let mut energy = path.energy(params);
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
    for round in 0..50 {
        let path = Path::random(&meshes()[round % 3], [1, 3, 5][round / 3 % 3], &mut random);
        for params in all_settings() {
            let error = gradient_error(&path, params, &mut random);
            assert!(error <= 1e-6, "{params:?}: {error:e}");
        }
    }
}
