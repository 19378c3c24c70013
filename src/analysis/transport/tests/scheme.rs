//! The scheme on paths of one point, written by hand, and what a transport hands on to it.

use super::*;
use crate::analysis::transport::pose_path::transport_nearest;

/// A point that moves with these velocities, seen at these scales, bound to planes with these normals.
struct OnePoint {
    scales: Vec<f64>,
    velocities: Vec<Vec<Vector3>>,
    normals: Vec<Vector3>,
}

impl SampledPath for OnePoint {
    fn samples(&self) -> usize {
        self.scales.len()
    }

    fn velocity(&self, sample: usize) -> &[Vector3] {
        &self.velocities[sample]
    }

    fn products(&self, sample: usize, field: &[Vector3]) -> Products {
        let (x, v) = (field[0], self.velocities[sample][0]);
        let [field, mixed, velocity] = [(x, x), (x, v), (v, v)].map(|(a, b)| a.dot(&b));
        let scale = self.scales[sample];
        Products {
            field: scale * field,
            mixed: scale * mixed,
            velocity: scale * velocity,
        }
    }

    fn lowered_velocity(&self, sample: usize) -> Vec<Vector3> {
        vec![self.velocities[sample][0] * self.scales[sample]]
    }

    fn make_tangent(&self, sample: usize, field: &mut [Vector3]) {
        let normal = self.normals[sample];
        field[0] -= normal * normal.dot(&field[0]);
    }
}

#[test]
fn where_a_path_rests_the_norm_alone_is_kept() {
    let path = OnePoint {
        scales: vec![1.0, 4.0],
        velocities: vec![vec![Vector3::zeros()]; 2],
        normals: vec![Vector3::zeros(); 2],
    };
    let field = [Vector3::new(2.0, -1.0, 0.5)];
    let transported = |keep_norm| parallel_transport(&path, &field, Nearness::Metric, keep_norm);
    assert_eq!(transported(true), [field[0] * 0.5]);
    assert_eq!(transported(false), field);
}

#[test]
fn what_leaves_the_tangent_space_is_taken_off_at_every_sample() {
    let path = OnePoint {
        scales: vec![1.0; 2],
        velocities: vec![vec![Vector3::x()]; 2],
        normals: vec![Vector3::zeros(), Vector3::z()],
    };
    let field = [Vector3::new(3.0, 2.0, 1.0)];
    let transported = parallel_transport(&path, &field, Nearness::Metric, false);
    assert_eq!(transported, [Vector3::new(3.0, 2.0, 0.0)]);
}

#[test]
fn nearness_by_coordinates_keeps_the_product_with_the_direction_too() {
    let mesh = phantom::sphere(1, 1.0);
    let metric = metric(mesh.faces(), MetricKind::QuasiConformal);
    let path = bent_path(mesh.vertices(), 3.0, 6);
    let field = wave(mesh.vertices(), 5.0, 0.1);
    let (there, _) =
        transport_nearest(&metric, &path, &field, Nearness::Coordinates, false).unwrap();
    let product = |k: usize, field: &[Vector3], step: usize| {
        let ends = path[step].iter().zip(&path[step + 1]);
        let velocity: Vec<Vector3> = ends.map(|(a, b)| b - a).collect();
        let at = metric.prepare(&path[k]).unwrap();
        metric.inner_product(&at, field, &velocity) / metric.norm2(&at, &velocity).sqrt()
    };
    let (before, after) = (product(0, &field, 0), product(6, &there, 5));
    assert!(
        (after - before).abs() < 1e-10 * before.abs(),
        "{before} {after}"
    );
}

#[test]
fn a_transport_keeps_the_norm_only_if_it_is_told_to() {
    let mesh = phantom::sphere(1, 1.0);
    let moving = moved(mesh.vertices(), &wave(mesh.vertices(), 1.0, 0.2), 1.0);
    let onto = moved(mesh.vertices(), &wave(mesh.vertices(), 4.0, 0.3), 1.0);
    let field: Vec<Vector3> = (moving.iter().zip(mesh.vertices()))
        .map(|(b, a)| b - a)
        .collect();
    let source = [mesh.vertices().to_vec(), moving];
    let ends = [mesh.vertices().to_vec(), onto.clone()];
    let transported = [true, false].map(|keep_norm| {
        let params = TransportParams {
            interpolated_poses: 0,
            keep_norm,
            ..TransportParams::default()
        };
        let checked = params.check().unwrap();
        let progress = Progress::default();
        let beat =
            transport_deformation(mesh.faces(), &source, &onto, &checked, &progress).unwrap();
        let found: Vec<Vector3> = (beat.poses[1].iter().zip(&onto))
            .map(|(b, a)| b - a)
            .collect();
        let metric = Metric::new(mesh.faces(), params.metric.check().unwrap());
        let (alone, kept) =
            transport_nearest(&metric, &ends, &field, params.nearness, keep_norm).unwrap();
        assert!(apart(&found, &alone) < 1e-12);
        assert_eq!(beat.account.steps, [kept]);
        assert!(beat.account.paths.is_empty(), "straight, as asked for");
        assert!(beat.account.product_change() < 1e-12);
        assert_eq!(beat.account.norm_change() < 1e-12, keep_norm);
        alone
    });
    assert!(apart(&transported[0], &transported[1]) > 1e-6);
}
