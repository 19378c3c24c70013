//! Cost of maps: 100 steps of stress majorisation from the classical map, that map, and those of neighbours.

use std::time::Duration;

use cardiomorph::analysis::classification::{ClassesParams, classify};
use cardiomorph::analysis::embedding::{
    LleParams, MapMethod, SmacofParams, classical_mds, embed, isomap, lle, smacof,
};
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
    distances_of(&points)
}

/// Points on the rolled-up sheet that scikit-learn calls a swiss roll.
fn swiss_roll(items: usize) -> Vec<[f64; 3]> {
    let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    (0..items)
        .map(|_| {
            let turn = 1.5 * std::f64::consts::PI * (1.0 + 2.0 * random.random::<f64>());
            let across = 21.0 * random.random::<f64>();
            [turn * turn.cos(), across, turn * turn.sin()]
        })
        .collect()
}

fn distances_of<const N: usize>(points: &[[f64; N]]) -> Option<DistanceMatrix> {
    DistanceMatrix::of_points(&points.concat(), points.len())
}

fn maps(criterion: &mut Criterion) {
    for items in [184, 2_000] {
        let Some(matrix) = distances(items) else {
            return;
        };
        // Tolerance zero: all 100 steps are done.
        let params = SmacofParams {
            max_iterations: 100,
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

/// From points to maps by neighbours, as scikit-learn does it: their distances are part of the work.
fn maps_by_neighbours(criterion: &mut Criterion) {
    let points = swiss_roll(2_000);
    let flat = points.concat();
    let Ok(params) = LleParams::default().check() else {
        return;
    };
    criterion.bench_function("lle_2000", |bencher| {
        bencher.iter(|| lle(&flat, points.len(), &params, &Progress::default()));
    });
    criterion.bench_function("isomap_2000", |bencher| {
        bencher.iter(|| {
            let distances = distances_of(&points)?;
            isomap(&distances, 8, 2, &Progress::default()).ok()
        });
    });
}

/// All that is said of two classes among 23 cases, with 1,000 permutations.
fn classes(criterion: &mut Criterion) {
    let Some(matrix) = distances(23) else {
        return;
    };
    let labels: Vec<Option<&str>> = (0..23).map(|i| Some(["a", "b"][i % 2])).collect();
    let (Ok(params), Ok(plane)) = (
        ClassesParams::default().check(),
        classical_mds(&matrix, 2, &Progress::default()),
    ) else {
        return;
    };
    criterion.bench_function("classes_23", |bencher| {
        bencher.iter(|| classify(&matrix, &plane, &labels, &params, &Progress::default()));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = maps, maps_by_neighbours, classes
}
criterion_main!(benches);
