//! Curvature from the command line: columns that scripts rely on, a known surface, and refusals.

use cardiomorph::io::write_obj;
use cardiomorph::mesh::{TriMesh, phantom};

use super::{cardiomorph, code, header, json_of, rows, said, text};

const COLUMNS: [&str; 7] = [
    "vertex",
    "gaussian",
    "mean",
    "k1",
    "k2",
    "shape_index",
    "curvedness",
];

fn written(mesh: &TriMesh, path: &std::path::Path) {
    let mut bytes = Vec::new();
    write_obj(&mut bytes, mesh).unwrap();
    std::fs::write(path, bytes).unwrap();
}

#[test]
fn curvature_of_a_sphere_is_one_over_its_radius() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, out] = ["sphere.obj", "curvature.csv"].map(|name| folder.path().join(name));
    written(&phantom::sphere(3, 25.0), &mesh);
    let options = ["curvature", text(&mesh), "--out", text(&out), "--json"];
    let answer = json_of(&cardiomorph(&options));
    assert_eq!(answer["vertices"], 642);
    assert_eq!(answer["without_curvature"], 0);
    assert!((answer["median_mean_curvature"].as_f64().unwrap() - 0.04).abs() < 1e-6);
    let total = answer["total_gaussian_curvature"].as_f64().unwrap();
    assert!((total - 4.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(answer["shape_spectrum"].as_array().unwrap().len(), 20);
    assert_eq!(header(&out), COLUMNS);
    let rows = rows(&out);
    assert_eq!(rows.len(), 642);
    for (vertex, row) in rows.iter().enumerate() {
        let numbers: Vec<f64> = row.iter().map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(numbers[0], vertex as f64);
        let known = [0.0016, 0.04, 0.04, 0.04, 1.0, 0.04];
        for (number, known) in numbers[1..].iter().zip(known) {
            assert!((number / known - 1.0).abs() < 1e-2, "{row:?}");
        }
    }
}

#[test]
fn what_cannot_be_asked_is_refused_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, out, absent] =
        ["sphere.obj", "curvature.csv", "absent.obj"].map(|name| folder.path().join(name));
    written(&phantom::sphere(1, 1.0), &mesh);
    let rings = [
        "curvature",
        text(&mesh),
        "--rings",
        "9",
        "--out",
        text(&out),
    ];
    let refused = cardiomorph(&rings);
    assert_eq!(code(&refused), 2);
    assert!(
        said(&refused).contains("9 is not in 1..=8"),
        "{}",
        said(&refused)
    );
    let missing = cardiomorph(&["curvature", text(&absent), "--out", text(&out)]);
    assert_eq!(code(&missing), 1);
    assert!(!out.exists());
}
