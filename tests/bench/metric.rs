//! Cost of one quasi-conformal distance, prepared and not, and of all pairs of a cohort.

use std::sync::Arc;
use std::time::Duration;

use cardiomorph::analysis::alignment::{cross_covariance, rotation_from_covariance};
use cardiomorph::analysis::metrics::{Metric, MetricParams, PairScratch, PreparedPose};
use cardiomorph::analysis::pose_distances::{PoseDistanceParams, pose_distances};
use cardiomorph::mesh::{TriMesh, phantom};
use cardiomorph::progress::Progress;
use cardiomorph::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use cardiomorph::units::LengthUnit;
use criterion::{Criterion, criterion_group, criterion_main};

mod egg;
use egg::egg;

fn aligned(metric: &Metric, a: &PreparedPose, b: &PreparedPose, scratch: &mut PairScratch) -> f64 {
    let covariance = cross_covariance(b.axes(), b.centroid(), a.axes(), a.centroid());
    let (rotation, _) = rotation_from_covariance(&covariance);
    let translation = a.centroid() - rotation * b.centroid();
    metric
        .pair_moved(a, b, &rotation, &translation, scratch)
        .distance()
}

fn one_pair(criterion: &mut Criterion) {
    for (vertices, level) in [(2_562, 4), (40_962, 6)] {
        let sphere = phantom::sphere(level, 1.0);
        let Ok(params) = MetricParams::default().check() else {
            return;
        };
        let metric = Metric::new(sphere.faces(), params);
        let (before, after) = (egg(&sphere, 0.0), egg(&sphere, 1.0));
        let (Ok(a), Ok(b)) = (metric.prepare(&before), metric.prepare(&after)) else {
            return;
        };
        let mut scratch = PairScratch::default();
        // The peers print theirs beside it: so both are seen to do the same work.
        let distance = metric.pair(&a, &b, &mut scratch).distance();
        eprintln!("distance at {vertices} vertices: {distance:.12}");
        criterion.bench_function(&format!("quasi_conformal_pair_{vertices}"), |bencher| {
            bencher.iter(|| metric.pair(&a, &b, &mut scratch).distance());
        });
        criterion.bench_function(&format!("aligned_pair_{vertices}"), |bencher| {
            bencher.iter(|| aligned(&metric, &a, &b, &mut scratch));
        });
        criterion.bench_function(&format!("unprepared_pair_{vertices}"), |bencher| {
            bencher.iter(|| {
                let (Ok(a), Ok(b)) = (metric.prepare(&before), metric.prepare(&after)) else {
                    return f64::NAN;
                };
                metric.pair(&a, &b, &mut scratch).distance()
            });
        });
    }
}

/// 23 hearts of 8 poses, 2,562 vertices each.
fn cohort() -> Study {
    let sphere = phantom::sphere(4, 1.0);
    let subjects = (0..23)
        .filter_map(|subject| {
            let frames = (0..8)
                .filter_map(|frame| {
                    let phase = std::f64::consts::TAU * f64::from(frame) / 8.0;
                    let amount = (0.5 + 0.03 * f64::from(subject)) * (1.0 - phase.cos());
                    TriMesh::new(egg(&sphere, amount), Arc::clone(sphere.faces())).ok()
                })
                .collect();
            let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).ok()?;
            let sequence = MeshSequence::new(vec![surface]).ok()?;
            let id = format!("s{subject:02}");
            Some(Arc::new(Subject::new(id, sequence, LengthUnit::Millimetre)))
        })
        .collect();
    Study {
        subjects,
        ..Study::default()
    }
}

fn all_pairs(criterion: &mut Criterion) {
    let study = cohort();
    let Ok(params) = PoseDistanceParams::default().check() else {
        return;
    };
    criterion.bench_function("all_pairs_184_poses", |bencher| {
        bencher.iter(|| pose_distances(&study, &params, &Progress::default()));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = one_pair, all_pairs
}
criterion_main!(benches);
