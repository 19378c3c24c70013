//! Cost of the energy of a path and its gradient, and of the cheapest path, on one core.

use std::time::Duration;

use cardiomorph::analysis::geodesics::{GeodesicParams, GeodesicSolver, geodesic};
use cardiomorph::analysis::metrics::{Metric, MetricParams, PathEnergy};
use cardiomorph::mesh::{Point3, TriMesh, phantom};
use cardiomorph::progress::Progress;
use criterion::{Criterion, criterion_group, criterion_main};

mod egg;
use egg::egg;

/// The default metric, straight paths.
fn energy_and_gradient(criterion: &mut Criterion) {
    for (vertices, level, interpolated_poses) in
        [(642, 3, 1), (642, 3, 3), (642, 3, 7), (2_562, 4, 3)]
    {
        let sphere = phantom::sphere(level, 1.0);
        let Ok(params) = MetricParams::default().check() else {
            return;
        };
        let metric = Metric::new(sphere.faces(), params);
        let poses = interpolated_poses + 2;
        let amount = |k: usize| k as f64 / (poses - 1) as f64;
        let Ok(mut path) = PathEnergy::new(
            &metric,
            &egg(&sphere, 0.0),
            &egg(&sphere, 1.0),
            interpolated_poses,
        ) else {
            return;
        };
        let inner: Vec<f64> = (1..=interpolated_poses)
            .flat_map(|k| egg(&sphere, amount(k)))
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

/// The upper half of a ball bulges, as in the oracles.
fn bulged(sphere: &TriMesh) -> Vec<Point3> {
    (sphere.vertices().iter())
        .map(|p| Point3::from(p.coords * (1.0 + 0.6 * p.z.max(0.0).powi(2))))
        .collect()
}

/// The whole path with 3 interpolated poses, and one of many on the same faces for the transport: 1 interpolated pose,
/// on all vertices and on 500.
fn whole_paths(criterion: &mut Criterion) {
    for (vertices, level) in [(642, 3), (2_562, 4)] {
        let sphere = phantom::sphere(level, 1.0);
        let (start, end) = (sphere.vertices(), bulged(&sphere));
        let Ok(params) = GeodesicParams::default().check() else {
            return;
        };
        let progress = Progress::default();
        if let Ok(path) = geodesic(sphere.faces(), start, &end, &params, &progress) {
            eprintln!(
                "path over {vertices} vertices: energy {:.9} of the straight line's, {} iterations, converged {}",
                path.energy / path.energy_linear,
                path.iterations,
                path.converged
            );
        }
        criterion.bench_function(&format!("geodesic_3_in_betweens_{vertices}"), |bencher| {
            bencher.iter(|| geodesic(sphere.faces(), start, &end, &params, &progress));
        });
        for max_vertices in [None, Some(500)] {
            let params = GeodesicParams {
                interpolated_poses: 1,
                max_vertices,
                ..GeodesicParams::default()
            };
            let Ok(params) = params.check() else {
                return;
            };
            let Ok(solver) = GeodesicSolver::new(sphere.faces(), start, &params) else {
                return;
            };
            let on = max_vertices.map_or_else(|| "all".to_owned(), |most| most.to_string());
            criterion.bench_function(
                &format!("shared_geodesic_1_in_between_{vertices}_on_{on}"),
                |bencher| bencher.iter(|| solver.between(start, &end, &progress)),
            );
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = energy_and_gradient, whole_paths
}
criterion_main!(benches);
