//! Shares of faces add up, and lie where the poses differ.

use nalgebra::Rotation3;

use super::*;
use crate::analysis::metrics::{Corners, CurvatureMean, Form, METRICS, MetricKind, MetricParams};
use crate::mesh::{TriMesh, phantom};

fn bent(mesh: &TriMesh) -> Vec<Point3> {
    (mesh.vertices().iter())
        .map(|p| p + Vector3::new((2.0 * p.y).sin(), 0.4 * p.x * p.z, p.x) * 0.2)
        .collect()
}

fn shares(mesh: &TriMesh, params: MetricParams, b: &[Point3]) -> (Vec<f64>, f64) {
    let metric = Metric::new(mesh.faces(), params.check().unwrap());
    let (a, b) = (
        metric.prepare(mesh.vertices()).unwrap(),
        metric.prepare(b).unwrap(),
    );
    let rotation: Matrix3<f64> = *Rotation3::from_euler_angles(0.1, -0.2, 0.3).matrix();
    let translation = Vector3::new(0.1, 0.0, -0.2);
    let mut scratch = PairScratch::default();
    let pair = metric.pair_moved(&a, &b, &rotation, &translation, &mut scratch);
    let shares = metric.face_contributions(&a, &b, &rotation, &translation, &mut scratch);
    (shares, pair.energy())
}

#[test]
fn shares_of_faces_add_up_to_half_the_energy_for_every_setting() {
    for mesh in [phantom::bowl(1.0, 5, 9), phantom::torus(1.5, 0.5, 9, 6)] {
        for kind in METRICS {
            for form in [Form::Printed, Form::Bilinear, Form::Frozen, Form::Additive] {
                for corners in [Corners::Raw, Corners::ScaleFree] {
                    for area_weights in [true, false] {
                        for regulariser in [Regulariser::Area, Regulariser::Uniform] {
                            let params = MetricParams {
                                kind,
                                form,
                                corners,
                                area_weights,
                                regulariser,
                                mu: 0.5,
                                lambda: 0.2,
                                ..MetricParams::default()
                            };
                            let (shares, energy) = shares(&mesh, params, &bent(&mesh));
                            let apart = shares.iter().sum::<f64>() - 0.5 * energy;
                            assert!(apart.abs() <= 1e-12 * energy, "{params:?} {apart}");
                            assert!(shares.iter().all(|&share| share >= 0.0));
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_dent_is_charged_to_the_faces_around_it() {
    let sphere = phantom::sphere(3, 1.0);
    let mut dented = sphere.vertices().to_vec();
    dented[17] = Point3::from(dented[17].coords * 0.9);
    let params = MetricParams {
        mu: 1.0,
        curvature: CurvatureMean::Rings(0),
        ..MetricParams::of(MetricKind::QuasiConformal)
    };
    let metric = Metric::new(sphere.faces(), params.check().unwrap());
    let (a, b) = (
        metric.prepare(sphere.vertices()).unwrap(),
        metric.prepare(&dented).unwrap(),
    );
    let shares = metric.face_contributions(
        &a,
        &b,
        &Matrix3::identity(),
        &Vector3::zeros(),
        &mut PairScratch::default(),
    );
    let near: f64 = (sphere.triangles().iter().zip(&shares))
        .filter(|(triangle, _)| triangle.contains(&17))
        .map(|(_, share)| share)
        .sum();
    assert!(near > 0.8 * shares.iter().sum::<f64>(), "{near}");
}
