//! Cost of stress majorisation: 100 steps from the classical map, and that map.

use std::time::Duration;

use cardiomorph::analysis::embedding::{MapMethod, SmacofParams, classical_mds, embed, smacof};
use cardiomorph::analysis::pose_distances::DistanceMatrix;
use cardiomorph::progress::Progress;
use criterion::{Criterion, criterion_group, criterion_main};
use rand::{Rng, SeedableRng};

/// Distances of points in five dimensions, which no map of two can keep.
fn distances(items: usize) -> Option<DistanceMatrix> {
    let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    let points: Vec<[f64; 5]> = (0..items)
        .map(|_| [1.0, 0.8, 0.6, 0.4, 0.2].map(|width| width * random.random_range(-1.0..1.0)))
        .collect();
    let mut upper = Vec::with_capacity(items * (items - 1) / 2);
    for (i, p) in points.iter().enumerate() {
        for q in &points[i + 1..] {
            let square: f64 = p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum();
            upper.push(square.sqrt());
        }
    }
    DistanceMatrix::from_upper(items, upper)
}

fn maps(criterion: &mut Criterion) {
    for items in [184, 2_000] {
        let Some(matrix) = distances(items) else {
            return;
        };
        // Tolerance zero: all 100 steps are done.
        let params = SmacofParams {
            most_iterations: 100,
            tolerance: 0.0,
            ..SmacofParams::default()
        };
        let Ok(params) = params.check() else {
            return;
        };
        criterion.bench_function(&format!("smacof_100_steps_{items}"), |bencher| {
            bencher.iter(|| smacof(&matrix, 2, &params, &Progress::default()));
        });
        criterion.bench_function(&format!("classical_{items}"), |bencher| {
            bencher.iter(|| classical_mds(&matrix, 2, &Progress::default()));
        });
        criterion.bench_function(&format!("map_of_the_window_{items}"), |bencher| {
            bencher.iter(|| embed(&matrix, MapMethod::Smacof, 2, &Progress::default()));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = maps
}
criterion_main!(benches);
