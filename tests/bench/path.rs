//! Cost of the energy of a path and its gradient, on one core.

use std::time::Duration;

use cardiomorph::analysis::metrics::{Metric, MetricParams, PathEnergy};
use cardiomorph::mesh::{Point3, TriMesh, phantom};
use criterion::{Criterion, criterion_group, criterion_main};

/// An egg that narrows and bends with `amount`.
fn pose(sphere: &TriMesh, amount: f64) -> Vec<Point3> {
    sphere
        .vertices()
        .iter()
        .map(|p| {
            let narrow = 1.0 - 0.3 * amount * (1.0 - p.z * p.z);
            Point3::new(
                narrow * p.x + 0.1 * amount * (2.0 * p.z).sin(),
                narrow * p.y,
                1.6 * p.z,
            )
        })
        .collect()
}

/// The default metric, straight paths.
fn energy_and_gradient(criterion: &mut Criterion) {
    for (vertices, level, in_betweens) in [(642, 3, 1), (642, 3, 3), (642, 3, 7), (2_562, 4, 3)] {
        let sphere = phantom::sphere(level, 1.0);
        let Ok(params) = MetricParams::default().check() else {
            return;
        };
        let metric = Metric::new(sphere.faces(), params);
        let poses = in_betweens + 2;
        let amount = |k: usize| k as f64 / (poses - 1) as f64;
        let Ok(mut path) = PathEnergy::new(
            &metric,
            &pose(&sphere, 0.0),
            &pose(&sphere, 1.0),
            in_betweens,
        ) else {
            return;
        };
        let inner: Vec<f64> = (1..=in_betweens)
            .flat_map(|k| pose(&sphere, amount(k)))
            .flat_map(|p| [p.x, p.y, p.z])
            .collect();
        let mut gradient = vec![0.0; inner.len()];
        // The peers print theirs beside it: so both are seen to do the same work.
        eprintln!(
            "energy of {poses} poses of {vertices} vertices: {:.12}",
            path.energy(&inner)
        );
        criterion.bench_function(
            &format!("path_energy_and_gradient_{poses}_poses_{vertices}"),
            |bencher| bencher.iter(|| path.evaluate(&inner, &mut gradient)),
        );
        criterion.bench_function(
            &format!("path_energy_{poses}_poses_{vertices}"),
            |bencher| bencher.iter(|| path.energy(&inner)),
        );
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = energy_and_gradient
}
criterion_main!(benches);
