//! Synthetic gated SPECT studies, for tests that go through the program. The tests within the crate use the same generator.

use cardiomorph::image::{Border, Image, VolumeFrame, gaussian_blur};
use cardiomorph::mesh::{CappedSheet, Point3, ScanGrid, Vector3, scan_lines, sheets};
use cardiomorph::progress::Progress;
use cardiomorph::study::MeshSequence;
use cardiomorph::study::built_in::{BuiltInParams, cohort};

#[path = "../../src/analysis/walls_from_spect/tests/synthetic.rs"]
mod synthetic;

pub use synthetic::{Scene, Study, gated_spect};

#[test]
fn a_synthetic_study_has_eight_gates_a_bright_wall_and_a_dark_cavity() {
    let cohort = cohort(&BuiltInParams::default()).unwrap();
    let subject = &cohort.study.subjects[0];
    let scene = Scene::default();
    let Study {
        image,
        liver_centre,
        liver_radius_mm,
    } = gated_spect(&subject.sequence, &scene);
    assert_eq!(image.volumes().len(), 8);
    let endo = subject.sequence.surfaces()[0].frames()[0].vertices();
    let epi = subject.sequence.surfaces()[1].frames()[0].vertices();
    let sampler = cardiomorph::image::Sampler::new(image.frame(), &image.volumes()[0]).unwrap();
    let mean = |points: &[Point3]| {
        let counts = points.iter().filter_map(|&point| sampler.at(point));
        counts.sum::<f64>() / points.len() as f64
    };
    let middle = cardiomorph::mesh::mean_point(endo.iter().copied());
    let wall: Vec<Point3> = endo
        .iter()
        .zip(epi)
        .map(|(a, b)| nalgebra::center(a, b))
        .collect();
    let liver = sampler.at(liver_centre + Vector3::x() * (0.5 * liver_radius_mm));
    assert!(liver.unwrap() > mean(&wall));
    assert!(mean(&wall) > 2.0 * sampler.at(middle).unwrap());
}
