//! Curvature of surfaces against their exact values, within what libigl's quadric fit attains on the same meshes.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot read its input fails"
)]

use std::path::{Path, PathBuf};

use cardiomorph::analysis::curvature::{Curvature, shape_spectrum, surface_curvature};
use cardiomorph::io::{Limits, read_mesh};
use cardiomorph::mesh::{TriMesh, vertex_areas};
use cardiomorph::progress::Progress;
use serde_json::Value;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/clinical")
}

fn expected(name: &str) -> Value {
    let text = std::fs::read_to_string(folder().join("cases.json")).unwrap();
    let cases: Value = serde_json::from_str(&text).unwrap();
    let all = cases["cases"].as_array().unwrap();
    let case = all.iter().find(|case| case["name"] == name).unwrap();
    case["expected"].clone()
}

fn mesh(name: &str) -> TriMesh {
    let file = format!("{name}.in_mesh.obj");
    let bytes = std::fs::read(folder().join(&file)).unwrap();
    read_mesh(&file, &bytes, &Limits::default())
        .unwrap()
        .frames
        .remove(0)
}

fn numbers(file: &str) -> Vec<f64> {
    let text = std::fs::read_to_string(folder().join(file)).unwrap();
    text.lines().map(|line| line.parse().unwrap()).collect()
}

fn curvatures(mesh: &TriMesh) -> Vec<Option<Curvature>> {
    surface_curvature(mesh, 2, &Progress::default())
        .unwrap()
        .vertices
}

/// Root mean square of the error as a share of that of the exact values.
fn relative_error(found: impl Iterator<Item = f64>, exact: &[f64]) -> f64 {
    let error: f64 = found.zip(exact).map(|(a, b)| (a - b).powi(2)).sum();
    (error / exact.iter().map(|b| b * b).sum::<f64>()).sqrt()
}

#[test]
fn curvatures_are_as_near_to_the_truth_as_those_of_libigl() {
    for name in ["curv_0_sphere", "curv_1_torus", "curv_2_ellipsoid"] {
        let peer = expected(name);
        let peer = |key: &str| peer[key].as_f64().unwrap();
        let found: Vec<Curvature> = curvatures(&mesh(name))
            .into_iter()
            .map(Option::unwrap)
            .collect();
        let [k1, k2] = ["k1", "k2"].map(|k| numbers(&format!("{name}.ex_{k}.csv")));
        let pairs = || k1.iter().zip(&k2);
        let mean: Vec<f64> = pairs().map(|(a, b)| 0.5 * (a + b)).collect();
        let gaussian: Vec<f64> = pairs().map(|(a, b)| a * b).collect();
        let mean = relative_error(found.iter().map(Curvature::mean), &mean);
        let gaussian = relative_error(found.iter().map(Curvature::gaussian), &gaussian);
        assert!(mean <= peer("igl_rel_rms_H_quadric"), "{name}: H {mean}");
        assert!(
            mean <= f64::max(0.02, 2.0 * peer("igl_rel_rms_H_cotan")),
            "{name}: H {mean}"
        );
        assert!(
            gaussian <= peer("igl_rel_rms_K_quadric"),
            "{name}: K {gaussian}"
        );
        assert!(
            gaussian <= f64::max(0.03, 2.0 * peer("igl_rel_rms_K_deficit")),
            "{name}: K {gaussian}"
        );
        let [greatest, least] = [k1, k2].map(|exact| exact);
        let greatest = relative_error(found.iter().map(|c| c.greatest), &greatest);
        let least = relative_error(found.iter().map(|c| c.least), &least);
        assert!(
            greatest.max(least) <= 0.08,
            "{name}: k1 {greatest}, k2 {least}"
        );
    }
}

#[test]
fn the_spectrum_of_a_torus_is_that_of_its_exact_area() {
    let torus = mesh("shape_spectrum_torus");
    let areas = vertex_areas(torus.vertices(), torus.triangles());
    let found = shape_spectrum(&curvatures(&torus), &areas).unwrap();
    let exact = expected("shape_spectrum_torus");
    let exact = exact["area_fraction"].as_array().unwrap();
    let distance: f64 = (found.iter().zip(exact))
        .map(|(found, exact)| (found - exact.as_f64().unwrap()).abs())
        .sum();
    assert!(distance <= 0.25, "{distance}");
}

#[test]
fn shape_indices_are_those_of_numpy() {
    let case = std::fs::read_to_string(folder().join("cases.json")).unwrap();
    let case: Value = serde_json::from_str(&case).unwrap();
    let cases = case["cases"].as_array().unwrap();
    let case = cases
        .iter()
        .find(|case| case["name"] == "shape_index_points")
        .unwrap();
    let points = case["inputs"]["k1k2"].as_array().unwrap();
    let of = |key: &str, n: usize| case["expected"][key][n].as_f64().unwrap();
    assert!(points.len() > 5);
    for (n, point) in points.iter().enumerate() {
        let [greatest, least] = [0, 1].map(|k| point[k].as_f64().unwrap());
        let curvature = Curvature {
            greatest,
            least,
            direction: cardiomorph::mesh::Vector3::x(),
            normal: cardiomorph::mesh::Vector3::z(),
        };
        assert!((curvature.shape_index().unwrap() - of("s", n)).abs() < 1e-12);
        assert!((curvature.curvedness() - of("c", n)).abs() < 1e-12);
    }
}
