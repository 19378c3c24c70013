//! Directions, atoms, medial surfaces and poses against mpmath, geomstats and numpy.

use cardiomorph::analysis::medial::Atom;
use cardiomorph::analysis::medial_space::{
    AkineticAtom, AtomAction, AtomDifference, AtomNorm, MedialDistance, PoseDescriptor, RatioForm,
    angle, atom_distance, atom_log, atom_log_pole, exp, exp_pole, frechet_mean, log, log_pole,
    mean_direction, mean_radius, medial_distance, pose_descriptor, pose_distance, spoke_angle_rad,
    spokes_from_gradient,
};
use nalgebra::{Matrix3, Rotation3};

use super::*;

fn near(name: &str, found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{name}: {found}, expected {expected}"
    );
}

fn all_near(name: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{name}");
    for (found, expected) in found.iter().zip(expected) {
        near(name, *found, *expected, tolerance);
    }
}

fn vectors(numbers: &[f64]) -> Vec<Vector3> {
    numbers
        .chunks_exact(3)
        .map(Vector3::from_row_slice)
        .collect()
}

fn flat(vectors: &[Vector3]) -> Vec<f64> {
    vectors.iter().flat_map(|v| [v.x, v.y, v.z]).collect()
}

fn atoms(case: &Case, part: &str, key: &str) -> Vec<Atom> {
    (case.numbers(part, key).chunks_exact(10))
        .map(|row| Atom {
            position: Point3::new(row[0], row[1], row[2]),
            radius: row[3],
            spokes: [
                Vector3::from_row_slice(&row[4..7]),
                Vector3::from_row_slice(&row[7..10]),
            ],
        })
        .collect()
}

#[test]
fn exponentials_at_the_pole_agree_with_fifty_digits() {
    let case = Case::load("sphere", "exp_pole");
    let tangents = case.numbers("inputs", "v");
    let found: Vec<Vector3> = (tangents.chunks_exact(2))
        .map(|v| exp_pole([v[0], v[1]]))
        .collect();
    all_near(
        "exp",
        &flat(&found),
        &case.numbers("expected", "point"),
        1e-14,
    );
    let general: Vec<Vector3> = (tangents.chunks_exact(2))
        .map(|v| exp(&Vector3::z(), &Vector3::new(v[0], v[1], 0.0)))
        .collect();
    all_near("exp at z", &flat(&general), &flat(&found), 1e-14);
}

#[test]
fn logarithms_at_the_pole_agree_with_fifty_digits_down_to_the_antipode() {
    let case = Case::load("sphere", "log_pole");
    let points = case.field("x");
    let expected = case.numbers("expected", "v");
    let angles = case.numbers("expected", "theta");
    assert_eq!(2 * points.len(), expected.len());
    for ((point, expected), theta) in points.iter().zip(expected.chunks(2)).zip(angles) {
        let found = log_pole(point);
        all_near("log", &found.tangent, expected, 1e-12);
        let [x, y] = found.tangent;
        near("theta", x.hypot(y), theta, 1e-12);
        assert!(!found.antipodal);
    }
    let case = Case::load("sphere", "antipode");
    let (p, x) = (case.field("p")[0], case.field("x")[0]);
    let opposite = log(&p, &x);
    near(
        "antipode",
        opposite.tangent.norm(),
        case.number("distance"),
        1e-15,
    );
    assert!(opposite.antipodal && log_pole(&x).antipodal);
}

#[test]
fn exponentials_and_logarithms_at_any_base_agree_with_geomstats() {
    let case = Case::load("sphere", "exp_log_general");
    let [p, q, v] = ["p", "q", "v"].map(|key| case.field(key));
    let [exp_v, log_q] = ["exp_v", "log_q"].map(|key| vectors(&case.numbers("expected", key)));
    let distances = case.numbers("expected", "dist");
    for row in 0..p.len() {
        assert!((exp(&p[row], &v[row]) - exp_v[row]).amax() <= 1e-13);
        let tolerance = if row == 7 { 1e-9 } else { 1e-12 };
        let found = log(&p[row], &q[row]).tangent;
        assert!((found - log_q[row]).amax() <= tolerance, "{row}: {found}");
        near("angle", angle(&p[row], &q[row]), distances[row], 1e-12);
    }
}

#[test]
fn means_of_directions_agree_with_geomstats() {
    let case = Case::load("sphere", "mean_directions");
    let points = case.field("points");
    let karcher = frechet_mean(&points, &vec![1.0; points.len()]).unwrap();
    let expected = case.numbers("expected", "karcher_mean");
    all_near("Fréchet", karcher.as_slice(), &expected, 1e-9);
    let (mean, length) = mean_direction(&points).unwrap();
    let expected = case.numbers("expected", "extrinsic_mean");
    all_near("extrinsic", mean.as_slice(), &expected, 1e-14);
    near("length", length, case.number("mean_vector_length"), 1e-14);
}

#[test]
fn atoms_and_medial_surfaces_are_as_far_apart_as_in_numpy() {
    let case = Case::load("sphere", "medial_atoms");
    let (a, b) = (
        atoms(&case, "inputs", "atoms1"),
        atoms(&case, "inputs", "atoms2"),
    );
    let rho = mean_radius(&a, &b);
    near("rho", rho, case.number("rho_mean_radius"), 1e-11);
    let parts = case.numbers("expected", "components");
    let printed = case.numbers("expected", "d_atoms_printed");
    let fletcher = case.numbers("expected", "d_atoms_fletcher");
    for (i, (a, b)) in a.iter().zip(&b).enumerate() {
        let found = AtomDifference::new(a, b);
        let [inner, outer] = found.angles_rad;
        let found = [found.distance, found.log_radius, inner, outer];
        all_near("parts", &found, &parts[4 * i..4 * i + 4], 1e-11);
        near(
            "printed",
            atom_distance(a, b, AtomNorm::Printed, rho),
            printed[i],
            1e-11,
        );
        near(
            "fletcher",
            atom_distance(a, b, AtomNorm::Fletcher, rho),
            fletcher[i],
            1e-11,
        );
        let tangent = atom_log(a, b).tangent;
        near("log", tangent.spokes[0].norm(), found[2], 1e-11);
    }
    let whole = |kind| medial_distance(&a, &b, kind).unwrap();
    let sum = case.number("d_surface_printed");
    near("sum", whole(MedialDistance::PrintedSum), sum, 1e-11);
    let product = case.number("d_surface_fletcher_l2");
    near("product", whole(MedialDistance::Product), product, 1e-11);
    let squares: f64 = printed.iter().map(|d| d * d).sum();
    near(
        "l2",
        squares.sqrt(),
        case.number("d_surface_printed_l2"),
        1e-11,
    );
}

#[test]
fn atoms_at_the_base_and_under_the_group_are_those_of_numpy() {
    let case = Case::load("sphere", "medial_atoms");
    let matrix = |key: &str| {
        Rotation3::from_matrix_unchecked(Matrix3::from_row_slice(&case.numbers("inputs", key)))
    };
    let action = AtomAction {
        translation: Vector3::from_row_slice(&case.numbers("inputs", "g_v")),
        scale: case.numbers("inputs", "g_s")[0],
        rotations: [matrix("g_R0"), matrix("g_R1")],
    };
    let acted = atoms(&case, "expected", "acted");
    let logs = case.numbers("expected", "log_base");
    for (i, atom) in atoms(&case, "inputs", "atoms1").iter().enumerate() {
        let (found, expected) = (action.act(atom), &acted[i]);
        near("radius", found.radius, expected.radius, 1e-11);
        assert!((found.position - expected.position).amax() <= 1e-11);
        for side in 0..2 {
            assert!((found.spokes[side] - expected.spokes[side]).amax() <= 1e-11);
        }
        let (x, log_radius, [inner, outer]) = atom_log_pole(atom);
        let [i0, i1] = inner.tangent;
        let [o0, o1] = outer.tangent;
        let found = [x.x, x.y, x.z, log_radius, i0, i1, o0, o1];
        all_near("log", &found, &logs[8 * i..8 * i + 8], 1e-11);
    }
}

#[test]
fn poses_are_as_far_apart_as_in_numpy() {
    let case = Case::load("sphere", "pose_space");
    let poses: Vec<PoseDescriptor> = (case.numbers("inputs", "poses").chunks_exact(8))
        .map(|row| PoseDescriptor {
            position: Point3::new(row[0], row[1], row[2]),
            log_ratio: row[3].ln(),
            rho: row[4],
            normal: Some(Vector3::from_row_slice(&row[5..8])),
        })
        .collect();
    let found: Vec<f64> = (poses.iter())
        .flat_map(|a| poses.iter().map(move |b| pose_distance(a, b)))
        .collect();
    all_near("D", &found, &case.numbers("expected", "D"), 1e-12);
}

#[test]
fn the_descriptor_of_a_pose_agrees_with_numpy() {
    let case = Case::load("sphere", "pose_from_atoms");
    let (positions, normals) = (case.field("x"), case.field("N"));
    let spokes = case.field("S0");
    let ratios: Vec<f64> = (case.numbers("inputs", "r").chunks_exact(2))
        .map(|r| r[1] / r[0])
        .collect();
    all_near("PT", &ratios, &case.numbers("expected", "PT"), 1e-12);
    let selected = case.numbers("expected", "selected");
    let still: Vec<AkineticAtom> = (0..ratios.len())
        .filter(|&i| (ratios[i] - 1.0).abs() <= 0.05)
        .map(|i| AkineticAtom {
            position: Point3::from(positions[i]),
            log_pt: ratios[i].ln(),
            normal: normals[i],
            spoke_angle_rad: angle(&normals[i], &spokes[i]),
        })
        .collect();
    assert_eq!(still.len() as f64, selected.iter().sum::<f64>());
    let printed = pose_descriptor(&still, RatioForm::Product).unwrap();
    let expected = case.numbers("expected", "MP");
    all_near("MP", printed.position.coords.as_slice(), &expected, 1e-12);
    let expected = case.numbers("expected", "ANV");
    all_near("ANV", printed.normal.unwrap().as_slice(), &expected, 1e-12);
    near("r̂", printed.ratio(), case.number("r_hat_product"), 1e-12);
    near("ρ", printed.rho, case.number("rho_mean_norm"), 1e-12);
    near(
        "ρ ln r̂",
        printed.rho * printed.log_ratio,
        case.number("rho_log_rhat"),
        1e-12,
    );
    let mean = pose_descriptor(&still, RatioForm::GeometricMean).unwrap();
    near(
        "mean",
        mean.ratio(),
        case.number("r_hat_geometric_mean"),
        1e-12,
    );
}

#[test]
fn spokes_from_the_gradient_of_the_radius_are_those_of_the_envelope() {
    let case = Case::load("envelope", "envelope");
    let [x, normals, gradients] = ["x", "normal", "grad_r"].map(|key| case.field(key));
    let radii = case.numbers("inputs", "r");
    let [s0, s1, y0, y1] =
        ["S0", "S1", "y0", "y1"].map(|key| vectors(&case.numbers("expected", key)));
    let angles = case.numbers("expected", "angle_normal_spoke");
    let mut sum = 0.0;
    for i in 0..x.len() {
        let spokes = spokes_from_gradient(&normals[i], &gradients[i]).unwrap();
        for (spoke, [expected, foot]) in spokes.iter().zip([[s0[i], y0[i]], [s1[i], y1[i]]]) {
            assert!((spoke - expected).amax() <= 1e-12);
            assert!((x[i] + spoke * radii[i] - foot).amax() <= 1e-12);
        }
        let found = spoke_angle_rad(&normals[i], &spokes);
        near("angle", found, angles[i], 1e-12);
        sum += found;
    }
    near("rho", sum / x.len() as f64, case.number("rho"), 1e-12);
}
