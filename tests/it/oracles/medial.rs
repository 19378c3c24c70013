//! Atoms of shells against closed forms and against scipy's medial points of an ellipsoidal wall.

use super::*;
use cardiomorph::analysis::medial::{Atom, MedialParams, MedialSurface, medial_surface};
use cardiomorph::mesh::TriMesh;

fn mesh_named(case: &Case, key: &str) -> TriMesh {
    let (points, faces) = case.input_mesh(key);
    TriMesh::new(points, faces).unwrap()
}

fn atoms_of(template: &TriMesh, others: &[&TriMesh]) -> MedialSurface {
    let params = MedialParams::default().check().unwrap();
    medial_surface(template, others, &params, &Progress::default()).unwrap()
}

/// The sphere of this mesh with another radius.
fn of_radius(mesh: &TriMesh, radius: f64) -> TriMesh {
    let points: Vec<Point3> = (mesh.vertices().iter())
        .map(|p| Point3::from(radius * p.coords.normalize()))
        .collect();
    TriMesh::new(points, mesh.faces().clone()).unwrap()
}

#[test]
fn atoms_between_spheres_are_where_theory_has_them() {
    for (name, of_thickness, relative, degrees) in [
        ("concentric_0", 0.02, 0.02, 3.0),
        ("concentric_1", 0.06, 0.06, 8.0),
    ] {
        let case = Case::load("medial", name);
        let (endo, epi) = (mesh_named(&case, "endo"), mesh_named(&case, "epi"));
        let radius = case.number("atom_radius");
        let thickness = case.number("wall_thickness");
        let found = atoms_of(&endo, &[&epi]);
        for (atom, normal) in found.atoms.iter().zip(&found.normals) {
            let far = atom.position.coords.norm() - case.number("medial_sphere_radius");
            assert!(far.abs() <= of_thickness * thickness, "{name}: {far}");
            close(name, atom.radius, radius, relative);
            let outwards = atom.position.coords.normalize();
            let turned = [-atom.spokes[0], atom.spokes[1], *normal];
            let most = turned.map(|s| s.angle(&outwards).to_degrees());
            assert!(
                most.iter().all(|&angle| angle <= degrees),
                "{name}: {most:?}"
            );
        }
        assert!(found.end.iter().all(Option::is_none));
        let param = |key: &str| case.value["params"][key].as_f64().unwrap();
        let later = atoms_of(
            &of_radius(&endo, param("r1_t2")),
            &[&of_radius(&epi, param("r2_t2"))],
        );
        for (a, b) in found.atoms.iter().zip(&later.atoms) {
            close(name, b.radius / a.radius, case.number("PT"), 0.02);
        }
    }
}

#[test]
fn atoms_between_plates_are_exact() {
    let case = Case::load("medial", "slab");
    let (lower, upper) = (mesh_named(&case, "lower"), mesh_named(&case, "upper"));
    let width = case.value["params"]["width"].as_f64().unwrap();
    let half = 0.5 * case.number("wall_thickness");
    let found = atoms_of(&lower, &[&upper]);
    let mut inside = 0;
    for (vertex, atom) in lower.vertices().iter().zip(&found.atoms) {
        if [vertex.x, vertex.y]
            .iter()
            .all(|x| (half..width - half).contains(x))
        {
            inside += 1;
            assert!((atom.position.z - case.number("medial_z")).abs() <= 1e-9);
            assert!((atom.radius - case.number("atom_radius")).abs() <= 1e-9);
        }
    }
    assert!(inside > 60);
}

#[test]
fn both_sides_of_a_closed_half_shell_have_the_radius_of_theory_below_the_rim() {
    let case = Case::load("medial", "half_shell_open");
    let found = atoms_of(&mesh_named(&case, "mesh"), &[]);
    let places: Vec<Point3> = (case.numbers("inputs", "probe").chunks_exact(3))
        .map(|x| Point3::new(x[0], x[1], x[2]))
        .collect();
    let flags = case.numbers("expected", "probe_is_interior_sheet");
    let deep: Vec<usize> = (0..places.len()).filter(|&k| flags[k] == 1.0).collect();
    assert!(deep.len() > 400);
    for &place in &deep {
        // Vertices of both sides lie in the order of the places.
        for side in [0, places.len()] {
            close(
                "half shell",
                found.atoms[place + side].radius,
                case.number("atom_radius"),
                0.03,
            );
            assert!(found.end[place + side].is_none());
        }
        let nearest = (found.atoms.iter())
            .min_by(|a, b| {
                let far = |atom: &Atom| (atom.position - places[place]).norm();
                far(a).total_cmp(&far(b))
            })
            .unwrap();
        close(
            "half shell at a place",
            nearest.radius,
            case.number("atom_radius"),
            0.03,
        );
    }
    assert!(
        found.end.iter().flatten().count() >= 80,
        "the rim ends the sheet"
    );
}

/// The medial sheet where a ray from the origin meets it: distance, radius and spokes.
fn at_ray(sheet: &MedialSurface, triangles: &[[u32; 3]], ray: Vector3) -> (f64, f64, [Vector3; 2]) {
    triangles
        .iter()
        .find_map(|triangle| {
            let atoms = triangle.map(|v| sheet.atoms[v as usize]);
            let columns = atoms.map(|atom| atom.position.coords);
            let weights = nalgebra::Matrix3::from_columns(&columns).try_inverse()? * ray;
            let whole = weights.sum();
            if whole <= 0.0 || weights.min() < -1e-9 * whole {
                return None;
            }
            let shares: Vec<f64> = weights.iter().map(|w| w / whole).collect();
            let radius = (0..3).map(|k| shares[k] * atoms[k].radius).sum();
            let spoke = |side: usize| -> Vector3 {
                let sum: Vector3 = (0..3).map(|k| shares[k] * atoms[k].spokes[side]).sum();
                sum.normalize()
            };
            Some((1.0 / whole, radius, [spoke(0), spoke(1)]))
        })
        .unwrap()
}

#[test]
fn atoms_of_an_ellipsoidal_wall_lie_where_scipy_finds_the_distances_equal() {
    let case = Case::load("medial", "lv_shell_0");
    let (endo, epi) = (mesh_named(&case, "endo"), mesh_named(&case, "epi"));
    let sheet = atoms_of(&endo, &[&epi]);
    let base = case.value["params"]["base_z"].as_f64().unwrap();
    let meridian = case.numbers("expected", "meridian");
    let mut rays = 0;
    for row in meridian.chunks_exact(12) {
        let (rho, z, radius) = (row[1], row[2], row[3]);
        if z >= base - 2.0 * radius {
            continue;
        }
        for step in 0..16 {
            rays += 1;
            let (sin, cos) = (std::f64::consts::TAU * (f64::from(step) + 0.3) / 16.0).sin_cos();
            let around = |rho: f64, z: f64| Vector3::new(rho * cos, rho * sin, z);
            let exact = around(rho, z);
            let (far, found, spokes) = at_ray(&sheet, endo.triangles(), exact.normalize());
            assert!(
                (far - exact.norm()).abs() <= 0.03 * 2.0 * radius,
                "{row:?} {far}"
            );
            close("radius", found, radius, 0.04);
            for (side, spoke) in spokes.iter().enumerate() {
                let expected = around(row[8 + 2 * side], row[9 + 2 * side]);
                assert!(
                    spoke.angle(&expected).to_degrees() <= 6.0,
                    "{row:?} {spoke:?}"
                );
            }
        }
    }
    assert!(rays > 250, "{rays}");
}
