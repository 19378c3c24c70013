//! Curvature of surfaces whose curvature is known.

use std::sync::Arc;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom, vertex_areas};
use crate::progress::Progress;

fn curvatures(mesh: &TriMesh) -> Vec<Option<Curvature>> {
    surface_curvature(mesh, 2, &Progress::default())
        .unwrap()
        .vertices
}

/// Root of the mean square error of the two principal curvatures, inside the boundary.
fn error(mesh: &TriMesh, known: impl Fn(Point3) -> [f64; 2]) -> f64 {
    let boundary = mesh.faces().boundary_vertices();
    let squares: Vec<f64> = (curvatures(mesh).iter().zip(mesh.vertices()).zip(boundary))
        .filter(|(_, boundary)| !boundary)
        .flat_map(|((curvature, &point), _)| {
            let [k1, k2] = known(point);
            let curvature = curvature.unwrap();
            [curvature.greatest - k1, curvature.least - k2].map(|error| error * error)
        })
        .collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Principal curvatures of a torus around z with radii 2 and 0.8.
fn of_torus(point: Point3) -> [f64; 2] {
    let cosine = (point.x.hypot(point.y) - 2.0) / 0.8;
    [1.0 / 0.8, cosine / (2.0 + 0.8 * cosine)]
}

/// Half a spheroid, open at the top, as a ventricle is; its curvatures follow from its height.
fn half_spheroid(rings: u32) -> (TriMesh, impl Fn(Point3) -> [f64; 2]) {
    const LONG: f64 = 2.0;
    let bowl = phantom::bowl(1.0, rings, 4 * rings);
    let stretched = bowl
        .vertices()
        .iter()
        .map(|p| Point3::new(p.x, p.y, LONG * p.z));
    let mesh = TriMesh::new(stretched.collect::<Vec<_>>(), Arc::clone(bowl.faces())).unwrap();
    let known = |p: Point3| {
        // Of x² + y² + z²/c² = 1: across 1/(|∇|), along c⁻²/|∇|³ with ∇ = (x, y, z/c²).
        let length = (p.x * p.x + p.y * p.y + p.z * p.z / LONG.powi(4)).sqrt();
        let across = 1.0 / length;
        let along = 1.0 / (LONG * LONG * length.powi(3));
        [across.max(along), across.min(along)]
    };
    (mesh, known)
}

#[test]
fn a_sphere_bends_the_same_everywhere() {
    let sphere = phantom::sphere(3, 25.0);
    for curvature in curvatures(&sphere) {
        let curvature = curvature.unwrap();
        assert!(
            (curvature.greatest * 25.0 - 1.0).abs() < 0.01,
            "{curvature:?}"
        );
        assert!((curvature.least * 25.0 - 1.0).abs() < 0.01, "{curvature:?}");
        assert!(curvature.shape_index().unwrap() > 0.9);
    }
}

#[test]
fn errors_fall_with_the_square_of_the_edges() {
    let tori = [16, 32, 64].map(|n| error(&phantom::torus(2.0, 0.8, 2 * n, n), of_torus));
    let hearts = [8, 16, 32].map(|n| {
        let (mesh, known) = half_spheroid(n);
        error(&mesh, known)
    });
    for errors in [tori, hearts] {
        for pair in errors.windows(2) {
            assert!(pair[0] / pair[1] > 3.0, "{errors:?}");
        }
    }
}

#[test]
fn the_boundary_of_an_open_surface_has_a_curvature_too() {
    let (mesh, known) = half_spheroid(24);
    let boundary = mesh.faces().boundary_vertices();
    let found = curvatures(&mesh);
    let rim = found
        .iter()
        .zip(mesh.vertices())
        .zip(boundary)
        .filter(|(_, on)| *on);
    let mut count = 0;
    for ((curvature, &point), _) in rim {
        let [k1, k2] = known(point);
        let curvature = curvature.unwrap();
        assert!(
            (curvature.greatest - k1).abs() < 0.05 * k1,
            "{curvature:?} {k1}"
        );
        assert!(
            (curvature.least - k2).abs() < 0.05 * k1,
            "{curvature:?} {k2}"
        );
        count += 1;
    }
    assert_eq!(count, 96);
}

#[test]
fn directions_of_a_torus_run_around_its_tube() {
    let torus = phantom::torus(2.0, 0.8, 60, 30);
    for (curvature, point) in curvatures(&torus).iter().zip(torus.vertices()) {
        let curvature = curvature.unwrap();
        let around_axis = Vector3::z()
            .cross(&Vector3::new(point.x, point.y, 0.0))
            .normalize();
        assert!(curvature.direction.dot(&around_axis).abs() < 0.02);
        assert!(curvature.direction.dot(&curvature.normal).abs() < 1e-12);
        assert!((curvature.normal.norm() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn curvature_moves_with_the_surface_and_scales_against_it() {
    let torus = phantom::torus(2.0, 0.8, 24, 12);
    let turn = nalgebra::Rotation3::from_euler_angles(0.4, -1.1, 2.0);
    let moved: Vec<Point3> = (torus.vertices().iter())
        .map(|p| turn * (p * 10.0) + Vector3::new(1e3, -50.0, 7.0))
        .collect();
    let moved = TriMesh::new(moved, Arc::clone(torus.faces())).unwrap();
    for (here, there) in curvatures(&torus).iter().zip(curvatures(&moved)) {
        let (here, there) = (here.unwrap(), there.unwrap());
        assert!((here.greatest - 10.0 * there.greatest).abs() < 1e-9);
        assert!((here.least - 10.0 * there.least).abs() < 1e-9);
        assert!((turn * here.direction).dot(&there.direction).abs() > 1.0 - 1e-9);
    }
}

#[test]
fn a_surface_turned_inside_out_bends_the_same() {
    let sphere = phantom::sphere(2, 1.0);
    let turned = sphere
        .triangles()
        .iter()
        .map(|&[a, b, c]| [a, c, b])
        .collect();
    let faces = Arc::new(Faces::new(sphere.vertices().len(), turned).unwrap());
    let turned = TriMesh::new(sphere.vertices().to_vec(), faces).unwrap();
    for (one, other) in curvatures(&sphere).iter().zip(curvatures(&turned)) {
        assert!((one.unwrap().mean() - other.unwrap().mean()).abs() < 1e-12);
    }
}

#[test]
fn a_plane_does_not_bend_and_has_no_shape() {
    let side = 8_u32;
    let points =
        (0..side * side).map(|n| Point3::new(f64::from(n % side), f64::from(n / side), 3.0));
    let squares = (0..side - 1).flat_map(|j| (0..side - 1).map(move |i| i + side * j));
    let triangles = squares.flat_map(|a| [[a, a + 1, a + side], [a + 1, a + side + 1, a + side]]);
    let faces = Arc::new(Faces::new(64, triangles.collect()).unwrap());
    let plane = TriMesh::new(points.collect::<Vec<_>>(), faces).unwrap();
    let found = curvatures(&plane);
    for curvature in &found {
        assert!(curvature.unwrap().curvedness() < 1e-9);
    }
    let flat = vec![
        found[0].map(|c| Curvature {
            greatest: 0.0,
            least: 0.0,
            ..c
        });
        64
    ];
    assert_eq!(shape_spectrum(&flat, &[1.0; 64]), None);
}

#[test]
fn a_spectrum_shares_out_the_whole_area() {
    let torus = phantom::torus(2.0, 0.8, 60, 30);
    let areas = vertex_areas(torus.vertices(), torus.triangles());
    let shares = shape_spectrum(&curvatures(&torus), &areas).unwrap();
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    // Shapes from the inner side, s = 2/π atan(5/12 …) up to the outer: nothing bends inward.
    assert!(shares[..10].iter().all(|share| *share == 0.0), "{shares:?}");
}

#[test]
fn too_few_vertices_give_nothing_rather_than_a_guess() {
    let faces = Arc::new(Faces::new(5, vec![[0, 1, 2], [0, 2, 3]]).unwrap());
    let points = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.2],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.3],
        [9.0; 3],
    ];
    let few = TriMesh::new(points.map(Point3::from).to_vec(), faces).unwrap();
    assert!(curvatures(&few).iter().all(Option::is_none));
    let one_place = TriMesh::new(vec![Point3::origin(); 5], Arc::clone(few.faces())).unwrap();
    assert!(curvatures(&one_place).iter().all(Option::is_none));
}

#[test]
fn wrong_questions_are_refused() {
    let sphere = phantom::sphere(1, 1.0);
    let progress = Progress::default();
    for rings in [0, 9] {
        let refused = surface_curvature(&sphere, rings, &progress);
        assert_eq!(refused, Err(CurvatureError::Rings(rings)));
    }
    let nothing = TriMesh::new(Vec::new(), Arc::new(Faces::new(0, Vec::new()).unwrap())).unwrap();
    assert_eq!(
        surface_curvature(&nothing, 2, &progress),
        Err(CurvatureError::NoFaces)
    );
    progress.stop();
    assert!(matches!(
        surface_curvature(&sphere, 2, &progress),
        Err(CurvatureError::Stopped(_))
    ));
}
