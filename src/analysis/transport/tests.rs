//! Laws of transport: what stays, what turns along, what converges.

use std::sync::Arc;

use nalgebra::Rotation3;
use proptest::prelude::*;

use super::*;
use crate::analysis::metrics::{Form, Metric, MetricKind, MetricParams};
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};
use crate::progress::{Progress, Stopped};
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

mod beats;
mod laws;
mod scheme;

/// A smooth field of displacements; numbers say which.
fn wave(points: &[Point3], seed: f64, size: f64) -> Vec<Vector3> {
    let axis = Vector3::new((3.1 * seed).sin(), (1.7 * seed).cos(), 0.4 + seed.sin());
    points
        .iter()
        .map(|p| {
            let t = axis.dot(&p.coords);
            size * Vector3::new((t + seed).sin(), (1.3 * t).cos(), (0.7 * t - seed).sin())
        })
        .collect()
}

fn moved(points: &[Point3], field: &[Vector3], share: f64) -> Vec<Point3> {
    points
        .iter()
        .zip(field)
        .map(|(p, x)| p + x * share)
        .collect()
}

/// A bent path that starts at a mesh, in as many steps.
fn bent_path(start: &[Point3], seed: f64, steps: usize) -> Vec<Vec<Point3>> {
    let (along, aside) = (wave(start, seed, 0.3), wave(start, seed + 2.0, 0.2));
    (0..=steps)
        .map(|i| {
            let t = i as f64 / steps as f64;
            moved(&moved(start, &along, t), &aside, t * (1.0 - t))
        })
        .collect()
}

fn metric(faces: &Faces, kind: MetricKind) -> Metric {
    let params = MetricParams::of(kind);
    Metric::new(faces, params.check().unwrap())
}

fn length(field: &[Vector3]) -> f64 {
    field.iter().map(Vector3::norm_squared).sum::<f64>().sqrt()
}

fn apart(a: &[Vector3], b: &[Vector3]) -> f64 {
    let gap: Vec<Vector3> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    length(&gap) / length(a).max(length(b))
}

fn norm2(metric: &Metric, at: &[Point3], field: &[Vector3]) -> f64 {
    metric.norm2(&metric.prepare(at).unwrap(), field)
}

/// A heart-like bowl that squeezes and twists over `frames` frames; sizes and amounts differ with `who`.
fn heart(who: f64, frames: usize) -> Subject {
    let rest = phantom::bowl(30.0 + 3.0 * who, 6, 10);
    let meshes = (0..frames)
        .map(|frame| {
            let t = (std::f64::consts::TAU * frame as f64 / frames as f64).cos() - 1.0;
            let points: Vec<Point3> = (rest.vertices().iter())
                .map(|p| {
                    let (squeeze, height) = (1.0 + 0.1 * t, 1.5 + 0.1 * who);
                    let twist = Rotation3::from_axis_angle(&Vector3::z_axis(), 0.004 * t * p.z);
                    let bulge = 1.0 + 0.05 * who * (p.x / 20.0).sin();
                    twist * Point3::new(squeeze * bulge * p.x, 0.9 * squeeze * p.y, height * p.z)
                })
                .collect();
            TriMesh::new(points, Arc::clone(rest.faces())).unwrap()
        })
        .collect();
    let surface = SurfaceSequence::new(SurfaceKind::Endocardium, meshes).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    Subject::new(format!("heart {who}"), sequence, LengthUnit::Millimetre)
}

fn study(subjects: Vec<Subject>) -> Study {
    Study {
        subjects: subjects.into_iter().map(Arc::new).collect(),
        ..Study::default()
    }
}

fn straight() -> CheckedTransportParams {
    let params = TransportParams {
        interpolated_poses: 0,
        ..TransportParams::default()
    };
    params.check().unwrap()
}
