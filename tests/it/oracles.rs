//! Metrics and maps against numbers from independent programs, see the folders of `tests/oracles`.

#[cfg(test)]
mod classes;
#[cfg(test)]
mod explicit_paths;
#[cfg(test)]
mod images;
#[cfg(test)]
mod maps;
#[cfg(test)]
mod medial;
#[cfg(test)]
mod noise;
#[cfg(test)]
mod paths;
#[cfg(test)]
mod products;
#[cfg(test)]
mod sphere;
#[cfg(test)]
mod thickness;
#[cfg(test)]
mod transport;

use std::path::{Path, PathBuf};

use cardiomorph::analysis::embedding::{
    Embedding, MapMethod, SmacofParams, classical_mds, embed, raw_stress, smacof,
};
use cardiomorph::analysis::metrics::{
    Corners, Form, Metric, MetricKind, MetricParams, PairScratch, PreparedPose, rigid_part,
};
use cardiomorph::analysis::pose_distances::DistanceMatrix;
use cardiomorph::mesh::{Faces, Point3, Vector3, angle_deficits_rad, flat_angles_rad};
use cardiomorph::progress::Progress;
use serde_json::Value;

/// One case with the folder its files lie in.
struct Case {
    folder: PathBuf,
    value: Value,
}

impl Case {
    fn load(topic: &str, name: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/oracles")
            .join(topic);
        let text = std::fs::read_to_string(folder.join("cases.json")).unwrap();
        let all: Value = serde_json::from_str(&text).unwrap();
        let cases = all["cases"].as_array().unwrap();
        let value = cases.iter().find(|case| case["name"] == name).unwrap();
        Self {
            value: value.clone(),
            folder,
        }
    }

    fn number(&self, key: &str) -> f64 {
        self.value["expected"][key].as_f64().unwrap()
    }

    /// Numbers of an input or expected array, inline or from its CSV file.
    fn numbers(&self, part: &str, key: &str) -> Vec<f64> {
        let value = &self.value[part][key];
        if let Some(file) = value["csv"].as_str() {
            let text = std::fs::read_to_string(self.folder.join(file)).unwrap();
            return text
                .split([',', '\n'])
                .filter(|field| !field.trim().is_empty())
                .map(|field| field.trim().parse().unwrap())
                .collect();
        }
        let mut found = Vec::new();
        flatten(value, &mut found);
        found
    }

    fn field(&self, key: &str) -> Vec<Vector3> {
        (self.numbers("inputs", key).chunks_exact(3))
            .map(|x| Vector3::new(x[0], x[1], x[2]))
            .collect()
    }

    fn mesh(&self) -> (Vec<Point3>, Faces) {
        self.input_mesh("mesh")
    }

    fn input_mesh(&self, key: &str) -> (Vec<Point3>, Faces) {
        let file = self.value["inputs"][key]["obj"].as_str().unwrap();
        mesh_of(&self.folder.join(file))
    }
}

/// Reads the OBJ files of the oracles: triangles only.
fn mesh_of(file: &Path) -> (Vec<Point3>, Faces) {
    let text = std::fs::read_to_string(file).unwrap();
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let fields: Vec<&str> = line.split_whitespace().collect();
        match fields.first() {
            Some(&"v") => {
                let x: Vec<f64> = fields[1..].iter().map(|f| f.parse().unwrap()).collect();
                points.push(Point3::new(x[0], x[1], x[2]));
            }
            Some(&"f") => {
                let corners: Vec<u32> = fields[1..].iter().map(|f| f.parse().unwrap()).collect();
                triangles.push([corners[0] - 1, corners[1] - 1, corners[2] - 1]);
            }
            _ => {}
        }
    }
    let faces = Faces::new(points.len(), triangles).unwrap();
    (points, faces)
}

fn flatten(value: &Value, found: &mut Vec<f64>) {
    match value {
        Value::Array(entries) => entries.iter().for_each(|entry| flatten(entry, found)),
        other => found.push(other.as_f64().unwrap()),
    }
}

fn close(name: &str, found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{name}: {found}, expected {expected}"
    );
}

/// The sums of the text: no weights of area, no regulariser.
fn as_printed(kind: MetricKind, form: Form, corners: Corners) -> MetricParams {
    MetricParams {
        kind,
        form,
        corners,
        area_weights: false,
        lambda: 0.0,
        ..MetricParams::default()
    }
}

struct Prepared {
    metric: Metric,
    pose: PreparedPose,
}

impl Prepared {
    fn new(faces: &Faces, points: &[Point3], params: MetricParams) -> Self {
        let metric = Metric::new(faces, params.check().unwrap());
        let pose = metric.prepare(points).unwrap();
        Self { metric, pose }
    }

    fn product(&self, x: &[Vector3], y: &[Vector3]) -> f64 {
        self.metric.inner_product(&self.pose, x, y)
    }

    /// What a pair of poses M, M + X gives at M.
    fn of_pair(&self, points: &[Point3], x: &[Vector3]) -> f64 {
        let moved: Vec<Point3> = points.iter().zip(x).map(|(p, x)| p + x).collect();
        let after = self.metric.prepare(&moved).unwrap();
        let mut scratch = PairScratch::default();
        self.metric.pair(&self.pose, &after, &mut scratch).norm2_a
    }
}

const MESHES: [&str; 3] = ["ico42", "torus200", "bowl"];

#[test]
fn angle_deficits_agree_with_libigl() {
    for name in MESHES {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let flat = flat_angles_rad(&faces);
        let moved: Vec<Point3> = points
            .iter()
            .zip(case.field("X"))
            .map(|(p, x)| p + x)
            .collect();
        for (key, points) in [("K", &points), ("K_after_X", &moved)] {
            let found = angle_deficits_rad(points, faces.triangles(), &flat);
            for (found, expected) in found.iter().zip(case.numbers("expected", key)) {
                assert!((found - expected).abs() <= 1e-11, "{name} {key}");
            }
        }
        let boundary = faces.boundary_vertices().iter().filter(|&&b| b).count();
        assert_eq!(boundary as f64, case.number("n_boundary_vertices"));
        assert_eq!(faces.edges().len() as f64, case.number("n_edges"));
    }
}

#[test]
fn corner_terms_agree_with_the_formula_in_numpy() {
    for name in MESHES {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let params = as_printed(MetricKind::AnglePreserving, Form::Bilinear, Corners::Raw);
        let prepared = Prepared::new(&faces, &points, params);
        let found = prepared
            .metric
            .corner_terms(&prepared.pose, &case.field("X"));
        let expected = case.numbers("expected", "T_X");
        let largest = expected.iter().fold(0.0_f64, |m, t| m.max(t.abs()));
        assert_eq!(expected.len(), 3 * found.len());
        for (found, expected) in found.iter().flatten().zip(expected) {
            assert!((found - expected).abs() <= 1e-12 * largest, "{name}");
        }
    }
}

#[test]
fn isometric_and_rigid_products_agree_with_numpy() {
    for name in MESHES {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let (x, y) = (case.field("X"), case.field("Y"));
        let of = |kind, corners| {
            Prepared::new(&faces, &points, as_printed(kind, Form::Additive, corners))
        };
        let isometric = of(MetricKind::Isometric, Corners::Raw);
        close(
            "iso_XX",
            isometric.product(&x, &x),
            case.number("iso_XX"),
            1e-9,
        );
        close(
            "iso_XY",
            isometric.product(&x, &y),
            case.number("iso_XY"),
            1e-9,
        );
        close(
            "pair",
            isometric.of_pair(&points, &x),
            case.number("iso_XX"),
            1e-9,
        );
        let relative = of(MetricKind::Isometric, Corners::ScaleFree);
        close(
            "iso_norm_XY",
            relative.product(&x, &y),
            case.number("iso_norm_XY"),
            1e-9,
        );
        let rigid = of(MetricKind::Displacement, Corners::ScaleFree);
        close(
            "rigid_XX",
            rigid.product(&x, &x),
            case.number("rigid_XX"),
            1e-8,
        );
        close(
            "rigid_XY",
            rigid.product(&x, &y),
            case.number("rigid_XY"),
            1e-8,
        );
        close(
            "pair",
            rigid.of_pair(&points, &x),
            case.number("rigid_XX"),
            1e-8,
        );
        let part = rigid_part(&points, &vec![1.0; points.len()], &x);
        for (key, found) in [("k1_X", part.k1), ("k2_X", part.k2)] {
            for (found, expected) in found.iter().zip(case.numbers("expected", key)) {
                assert!(
                    (found - expected).abs() <= 1e-8 * found.abs().max(1e-3),
                    "{key}"
                );
            }
        }
    }
}

#[test]
fn angle_preserving_and_quasi_conformal_products_agree_with_numpy() {
    for name in MESHES {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let (x, y) = (case.field("X"), case.field("Y"));
        for (short, kind, tolerance) in [
            ("ap", MetricKind::AnglePreserving, 1e-9),
            ("qc", MetricKind::QuasiConformal, 1e-8),
        ] {
            for (form_name, form) in [("printed", Form::Printed), ("bilinear", Form::Bilinear)] {
                for (suffix, corners) in [("", Corners::Raw), ("_norm", Corners::ScaleFree)] {
                    let prepared = Prepared::new(&faces, &points, as_printed(kind, form, corners));
                    let key = |pair: &str| format!("{short}_{form_name}{suffix}_{pair}");
                    for (pair, found) in [
                        ("XX", prepared.product(&x, &x)),
                        ("XY", prepared.product(&x, &y)),
                        ("YY", prepared.product(&y, &y)),
                        ("XX", prepared.of_pair(&points, &x)),
                        ("YY", prepared.of_pair(&points, &y)),
                    ] {
                        let expected = case.number(&key(pair));
                        // The sum of XY cancels: its tolerance is relative to its terms.
                        let terms = (case.number(&key("XX")) * case.number(&key("YY"))).sqrt();
                        assert!(
                            (found - expected).abs() <= tolerance * expected.abs().min(terms)
                                || (found - expected).abs() <= 1e-14 * terms,
                            "{name} {}: {found}, expected {expected}",
                            key(pair)
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn the_printed_form_is_no_inner_product_by_as_much_as_in_numpy() {
    for name in MESHES {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let (x, y) = (case.field("X"), case.field("Y"));
        let params = as_printed(MetricKind::AnglePreserving, Form::Printed, Corners::Raw);
        let prepared = Prepared::new(&faces, &points, params);
        let sum: Vec<Vector3> = x.iter().zip(&y).map(|(x, y)| x + y).collect();
        let back: Vec<Vector3> = x.iter().map(|x| -x).collect();
        let defect =
            prepared.product(&sum, &x) - prepared.product(&x, &x) - prepared.product(&y, &x);
        let expected = case.number("ap_printed_bilinearity_defect");
        close("defect", defect, expected, 1e-9);
        let mirrored = prepared.product(&x, &back);
        close("X, −X", mirrored, case.number("ap_printed_X_minusX"), 1e-9);
    }
}

#[test]
fn rigid_and_similarity_fields_cost_nothing() {
    for (zeros, generic) in [("ico42_zeros", "ico42"), ("bowl_zeros", "bowl")] {
        let (case, generic) = (Case::load("metrics", zeros), Case::load("metrics", generic));
        let (points, faces) = case.mesh();
        let (rigid, similar) = (case.field("rigid_field"), case.field("similarity_field"));
        let x = generic.field("X");
        let size = |field: &[Vector3]| field.iter().map(Vector3::norm_squared).sum::<f64>();
        let check = |kind, corners, field: &[Vector3]| {
            let prepared = Prepared::new(&faces, &points, as_printed(kind, Form::Printed, corners));
            let scale = prepared.product(&x, &x) * size(field) / size(&x);
            let found = prepared.product(field, field);
            assert!(
                found.abs() <= 1e-18 * scale,
                "{zeros} {kind:?}: {found} of {scale}"
            );
        };
        check(MetricKind::Isometric, Corners::Raw, &rigid);
        check(MetricKind::Displacement, Corners::Raw, &rigid);
        for field in [&rigid, &similar] {
            check(MetricKind::AnglePreserving, Corners::Raw, field);
            check(MetricKind::AnglePreserving, Corners::ScaleFree, field);
        }
        check(MetricKind::QuasiConformal, Corners::Raw, &similar);
    }
}

#[test]
fn a_triangle_gives_the_numbers_of_a_hand_calculation() {
    let case = Case::load("metrics", "hand_triangle");
    let (points, faces) = case.mesh();
    let (x, y) = (case.field("X"), case.field("Y"));
    let of = |kind, form| Prepared::new(&faces, &points, as_printed(kind, form, Corners::Raw));
    let isometric = of(MetricKind::Isometric, Form::Additive);
    close("iso_XX", isometric.product(&x, &x), 8.0, 1e-13);
    close("iso_XY", isometric.product(&x, &y), 2.0, 1e-13);
    let printed = of(MetricKind::AnglePreserving, Form::Printed);
    close("ap_printed_XX", printed.product(&x, &x), 36.0, 1e-13);
    close("ap_printed_XY", printed.product(&x, &y), 72.0, 1e-13);
    let bilinear = of(MetricKind::AnglePreserving, Form::Bilinear);
    close("ap_bilinear_XY", bilinear.product(&x, &y), -24.0, 1e-13);
    let quasi_conformal = of(MetricKind::QuasiConformal, Form::Printed);
    let expected = case.number("qc_printed_XX");
    close(
        "qc_printed_XX",
        quasi_conformal.product(&x, &x),
        expected,
        1e-13,
    );
}
