//! Blur, isosurfaces, reorientation, registration and normalisation against SciPy, scikit-image and trimesh.

use std::path::Path;

use cardiomorph::analysis::alignment::{RigidMotion, rigid_motion, similarity};
use cardiomorph::analysis::registration::{
    IcpParams, ThinPlateSpline, icp, point_target, weighted_rigid_motion,
};
use cardiomorph::analysis::surface_extraction::{Centre, Normalisation, isosurface};
use cardiomorph::image::{
    Border, Interpolation, Reorientation, Sampler, VolumeFrame, gaussian_blur, principal_axes,
    rotation_to_z,
};
use cardiomorph::mesh::{Point3, TriMesh, Vector3, area, bounding_box, sheets, signed_volume};
use cardiomorph::progress::Progress;
use nalgebra::Matrix3;
use serde_json::Value;

use super::Case;

/// A volume of an oracle: little-endian singles beside a JSON file with its size and spacing.
struct Raw {
    size: [usize; 3],
    spacing: [f64; 3],
    values: Vec<f32>,
}

impl Raw {
    fn load(case: &Case, part: &str, key: &str) -> Self {
        let name = case.value[part][key]["raw"].as_str().unwrap();
        let text = std::fs::read_to_string(case.folder.join(name)).unwrap();
        let header: Value = serde_json::from_str(&text).unwrap();
        let three = |key: &str| [0, 1, 2].map(|axis| header[key][axis].as_f64().unwrap());
        let bytes = std::fs::read(case.folder.join(header["file"].as_str().unwrap())).unwrap();
        let numbers = bytes.as_chunks::<4>().0.iter();
        let raw = Self {
            size: three("dims_xyz").map(|n| n as usize),
            spacing: three("spacing"),
            values: numbers.map(|&four| f32::from_le_bytes(four)).collect(),
        };
        assert_eq!(raw.size.iter().product::<usize>(), raw.values.len());
        raw
    }

    fn frame(&self) -> VolumeFrame {
        let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, self.spacing[axis]));
        VolumeFrame::new(self.size, Point3::origin(), steps).unwrap()
    }
}

fn names_starting(with: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/images");
    let text = std::fs::read_to_string(folder.join("cases.json")).unwrap();
    let all: Value = serde_json::from_str(&text).unwrap();
    let names = all["cases"].as_array().unwrap().iter();
    let names = names.map(|case| case["name"].as_str().unwrap().to_owned());
    names.filter(|name| name.starts_with(with)).collect()
}

fn points(case: &Case, part: &str, key: &str) -> Vec<Point3> {
    let numbers = case.numbers(part, key);
    numbers
        .as_chunks::<3>()
        .0
        .iter()
        .map(|&p| Point3::from(p))
        .collect()
}

fn matrix(case: &Case, part: &str, key: &str) -> Matrix3<f64> {
    Matrix3::from_row_slice(&case.numbers(part, key))
}

fn vector(case: &Case, key: &str) -> Vector3 {
    Vector3::from_row_slice(&case.numbers("expected", key))
}

fn assert_close(name: &str, found: &[Point3], expected: &[Point3], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{name}");
    for (p, q) in found.iter().zip(expected) {
        assert!((p - q).amax() <= tolerance, "{name}: {p}, expected {q}");
    }
}

#[test]
fn a_blur_agrees_with_scipy() {
    let names = names_starting("blur_");
    assert_eq!(names.len(), 4);
    for name in names {
        let case = Case::load("images", &name);
        let [input, expected] = [("inputs", "volume"), ("expected", "blurred")]
            .map(|(part, key)| Raw::load(&case, part, key));
        let params = &case.value["params"];
        let sigma = [0, 1, 2].map(|axis| params["sigma_xyz_voxels"][axis].as_f64().unwrap());
        let border = match params["mode"].as_str().unwrap() {
            "reflect" => Border::Reflect,
            _ => Border::Nearest,
        };
        let found = gaussian_blur(
            input.size,
            &input.values,
            sigma,
            border,
            &Progress::default(),
        );
        let found = found.unwrap();
        for (found, expected) in found.iter().zip(&expected.values) {
            assert!(
                (found - expected).abs() <= 2e-6,
                "{name}: {found}, expected {expected}"
            );
        }
        let sum: f64 = found.iter().map(|&v| f64::from(v)).sum();
        super::close(&name, sum, case.number("sum"), 1e-6);
        let greatest = found.iter().fold(f32::MIN, |m, &v| m.max(v));
        assert!((f64::from(greatest) - case.number("max")).abs() <= 1e-6);
        let [nx, ny, nz] = input.size;
        let middle = nx / 2 + nx * (ny / 2 + ny * (nz / 2));
        let sample = case.numbers("expected", "sample");
        for (voxel, expected) in [0, middle, found.len() - 1].into_iter().zip(sample) {
            assert!((f64::from(found[voxel]) - expected).abs() <= 1e-6, "{name}");
        }
    }
}

fn volume(mesh: &TriMesh) -> f64 {
    let corners = mesh
        .triangles()
        .iter()
        .map(|t| t.map(|v| mesh.vertices()[v as usize]));
    signed_volume(corners, Point3::origin())
}

#[test]
fn isosurfaces_agree_with_marching_cubes_of_scikit_image() {
    let names = names_starting("mc_");
    assert_eq!(names.len(), 4);
    for name in names {
        let case = Case::load("images", &name);
        let input = Raw::load(&case, "inputs", "volume");
        let found = isosurface(&input.frame(), &input.values, 0.0, &Progress::default()).unwrap();
        let is_noise = name.starts_with("mc_noise");
        let tolerances = if is_noise {
            [0.02, 0.01]
        } else {
            [0.01, 0.002]
        };
        let found_area = area(found.vertices(), found.triangles());
        super::close(&name, found_area, case.number("area"), tolerances[0]);
        super::close(&name, volume(&found), case.number("volume"), tolerances[1]);
        for (key, measured) in [
            ("analytic_area", found_area),
            ("analytic_volume", volume(&found)),
        ] {
            let tolerance = case.value["tol"][key][1].as_f64();
            if let Some(tolerance) = tolerance.filter(|_| case.value["expected"][key].is_number()) {
                super::close(key, measured, case.number(key), tolerance);
            }
        }
        let borders = found.faces().borders();
        assert!(
            borders.rims.is_empty() && borders.branching.is_empty(),
            "{name}"
        );
        assert_eq!((borders.turned, borders.pinched), (0, 0), "{name}");
        let vertices = found.vertices().len();
        assert_eq!(
            vertices as f64,
            case.number("sign_changing_grid_edges"),
            "{name}"
        );
        let edges = found.faces().edges().len();
        let euler = (vertices + found.triangles().len()) as f64 - edges as f64;
        let pieces = sheets(found.faces()).unwrap().len();
        if is_noise {
            assert_eq!(euler % 2.0, 0.0);
        } else {
            assert_eq!(euler, case.number("euler"), "{name}");
            assert_eq!(pieces as f64, case.number("components"), "{name}");
            assert_eq!(vertices as f64, case.number("n_vertices"), "{name}");
            assert_eq!(
                found.triangles().len() as f64,
                case.number("n_faces"),
                "{name}"
            );
        }
        let [low, high] = bounding_box(found.vertices()).unwrap();
        let box_of = |key: &str| Point3::from(vector(&case, key));
        assert_close(
            &name,
            &[low, high],
            &[box_of("bbox_min"), box_of("bbox_max")],
            1e-4,
        );
    }
}

#[test]
fn a_turned_volume_agrees_with_scipy() {
    let case = Case::load("images", "reorient_trilinear");
    let (input, expected) = (
        Raw::load(&case, "inputs", "volume"),
        Raw::load(&case, "expected", "result"),
    );
    let frame = input.frame();
    let last = input.size.map(|n| 0.5 * (n - 1) as f64);
    let turn = Reorientation {
        rotation: matrix(&case, "inputs", "rotation"),
        pivot: frame.position(Point3::from(last)),
    };
    let turned = turn.turned_frame(&frame).unwrap();
    let place = |i: f64, j: f64, k: f64| turned.voxel(frame.position(Point3::new(i, j, k)));
    let first = place(0.0, 0.0, 0.0);
    let columns = [
        place(1.0, 0.0, 0.0),
        place(0.0, 1.0, 0.0),
        place(0.0, 0.0, 1.0),
    ]
    .map(|p| p - first);
    let found = Matrix3::from_columns(&columns);
    assert!((found - matrix(&case, "expected", "matrix_out_to_in_xyz")).amax() <= 1e-12);
    assert!((first.coords - vector(&case, "offset_xyz")).amax() <= 1e-12);
    let sampler = Sampler::new(&turned, &input.values).unwrap();
    let found = sampler
        .resampled(&frame, Interpolation::Linear, 0.0, &Progress::default())
        .unwrap();
    let [nx, ny, _] = input.size;
    let mut inside = 0;
    for (voxel, (found, expected)) in found.iter().zip(&expected.values).enumerate() {
        let [i, j, k] = [voxel % nx, voxel / nx % ny, voxel / nx / ny].map(|n| n as f64);
        let depth = (0..3).map(|axis| {
            let at = place(i, j, k)[axis];
            at.min((input.size[axis] - 1) as f64 - at)
        });
        let depth = depth.fold(f64::INFINITY, f64::min);
        inside += usize::from(depth >= 0.0);
        // On the border itself rounding decides.
        if depth.abs() >= 1e-9 {
            assert!(
                (found - expected).abs() <= 5e-5,
                "{i} {j} {k}: {found}, expected {expected}"
            );
        }
    }
    assert_eq!(inside as f64, case.number("n_inside"));
}

#[test]
fn a_long_axis_is_found_and_turned_upright_as_by_scipy() {
    let case = Case::load("images", "long_axis_to_z");
    let axis = Vector3::from_row_slice(&case.numbers("inputs", "axis"));
    let found = rotation_to_z(axis).unwrap();
    assert!((found - matrix(&case, "expected", "R")).amax() <= 1e-12);
    let case = Case::load("images", "pca_long_axis");
    let found = principal_axes(&points(&case, "inputs", "points")).unwrap();
    let expected = case.numbers("expected", "eigenvalues_desc");
    for (found, expected) in found.variances.iter().zip(expected) {
        super::close("eigenvalue", *found, expected, 1e-10);
    }
    let direction = found.directions[0];
    let expected = vector(&case, "long_axis_up_to_sign");
    assert!((direction * direction.dot(&expected).signum() - expected).amax() <= 1e-9);
}

#[test]
fn thin_plate_splines_agree_with_scipy() {
    let names = names_starting("tps_");
    assert_eq!(names.len(), 4);
    for name in names {
        let case = Case::load("images", &name);
        let smoothing = if name.contains("0.05") { 0.05 } else { 0.0 };
        let source = points(&case, "inputs", "source");
        let spline = ThinPlateSpline::new(&source, &points(&case, "inputs", "target"), smoothing);
        let spline = spline.unwrap();
        let query = points(&case, "inputs", "query");
        let is_affine = name.starts_with("tps_affine");
        let tolerance = if is_affine { 1e-9 } else { 1e-8 };
        let value = points(&case, "expected", "value");
        assert_close(&name, &spline.apply_all(&query), &value, tolerance);
        let one_by_one: Vec<Point3> = query.iter().map(|p| spline.apply(p)).collect();
        assert_close(&name, &one_by_one, &value, tolerance);
        if is_affine {
            continue;
        }
        let at_source = points(&case, "expected", "at_source");
        assert_close(&name, &spline.apply_all(&source), &at_source, 1e-8);
        let columns = [0, 1, 2].map(|axis| spline.linear().column(axis).into_owned());
        let rows = [[spline.translation()].as_slice(), columns.as_slice()].concat();
        let rows: Vec<Point3> = rows.into_iter().map(Point3::from).collect();
        assert_close(
            &name,
            &rows,
            &points(&case, "expected", "affine_rows_1_x_y_z"),
            1e-7,
        );
        // Theirs are those of the kernel −r.
        let weights: Vec<Point3> = spline.weights().iter().map(|w| Point3::from(-w)).collect();
        assert_close(&name, &weights, &points(&case, "expected", "weights"), 1e-8);
        super::close(
            &name,
            spline.bending_energy(),
            case.number("bending_trace"),
            1e-8,
        );
    }
}

#[test]
fn rigid_motions_and_similarities_agree_with_scipy_and_scikit_image() {
    let names = names_starting("kabsch_");
    assert_eq!(names.len(), 2);
    for name in names {
        let case = Case::load("images", &name);
        let [source, target] = ["X", "Y"].map(|key| points(&case, "inputs", key));
        let rigid = rigid_motion(&source, &target).unwrap();
        assert!(
            (rigid.rotation - matrix(&case, "expected", "R")).amax() <= 1e-9,
            "{name}"
        );
        assert!(
            (rigid.translation - vector(&case, "t")).amax() <= 1e-9,
            "{name}"
        );
        assert!((rigid.rotation.determinant() - case.number("det")).abs() <= 1e-9);
        let squares = source
            .iter()
            .zip(&target)
            .map(|(p, q)| (rigid.apply(p) - q).norm_squared());
        let rms = (squares.sum::<f64>() / source.len() as f64).sqrt();
        assert!((rms - case.number("rms")).abs() <= 1e-9, "{name}");
        let scaled = similarity(&source, &target).unwrap();
        assert!(
            (scaled.scale - case.number("umeyama_scale")).abs() <= 1e-9,
            "{name}"
        );
        assert!((scaled.rotation - matrix(&case, "expected", "umeyama_R")).amax() <= 1e-9);
        assert!(
            (scaled.translation - vector(&case, "umeyama_t")).amax() <= 1e-9,
            "{name}"
        );
        let weights = case.numbers("inputs", "weights");
        let weighted = weighted_rigid_motion(&source, &target, &weights).unwrap();
        assert!((weighted.rotation - matrix(&case, "expected", "weighted_R")).amax() <= 1e-9);
    }
}

#[test]
fn iterated_closest_points_agree_with_trimesh() {
    let case = Case::load("images", "icp");
    let [moving, target] = ["moving", "target"].map(|key| points(&case, "inputs", key));
    let params = IcpParams {
        tolerance: 1e-12,
        ..IcpParams::default()
    };
    let (tree, params) = (point_target(&target).unwrap(), params.check().unwrap());
    let start = RigidMotion::identity();
    let found = icp(&moving, &tree, &start, &params, &Progress::default()).unwrap();
    assert!(found.converged);
    assert!((found.motion.rotation - matrix(&case, "expected", "R")).amax() <= 1e-6);
    assert!((found.motion.translation - vector(&case, "t")).amax() <= 1e-6);
    assert!(found.rms <= f64::max(1e-6, 1.05 * case.number("rms")));
}

#[test]
fn normalised_points_agree_with_numpy() {
    let case = Case::load("images", "normalise");
    let given = points(&case, "inputs", "points");
    for (key, centre) in [
        ("centroid_then_unit_box", Centre::Mean),
        ("box_centre_then_unit", Centre::Box),
    ] {
        let normalisation = Normalisation::of_sequence(&[&given], centre).unwrap();
        let found: Vec<Point3> = given.iter().map(|p| normalisation.apply(p)).collect();
        assert_close(key, &found, &points(&case, "expected", key), 1e-13);
    }
}
