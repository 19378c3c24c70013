//! The parts: the tree of faces, smoothing, seams.

use super::*;
use crate::analysis::medial::connectivity::Connectivity;
use crate::analysis::medial::face_tree::{FacesOfPose, Facing, TreePlan};
use crate::analysis::medial::smoothing::smooth;
use crate::mesh::face_normals;

#[test]
fn the_tree_finds_the_nearest_face_that_looking_at_each_finds() {
    let mesh = rough(&phantom::torus(2.0, 0.7, 24, 12), 0.05, 0.2);
    let normals = face_normals(mesh.vertices(), mesh.triangles());
    let faces = FacesOfPose {
        points: mesh.vertices(),
        triangles: mesh.triangles(),
        normals: &normals,
    };
    let plan = TreePlan::new(faces.points, faces.triangles);
    let tree = plan.around(faces);
    let count = mesh.triangles().len() as u32;
    for trial in 0..200 {
        let point = Point3::from(3.0 * roughness(trial, 3.0));
        let facing = Facing {
            direction: roughness(trial, 7.0).normalize(),
            cos_min_angle: 0.5,
            faces: Some([trial as u32, count - 5]),
        };
        let found = tree.nearest(point, &facing, f64::INFINITY, Some(trial as u32 + 9));
        let allowed = (trial as u32..count - 5)
            .filter(|&face| normals[face as usize].dot(&facing.direction) <= facing.cos_min_angle);
        // Of one face alone the tree has nothing to leave out.
        let least = allowed.map(|face| {
            let alone = Facing::any(Some([face, face + 1]));
            tree.nearest(point, &alone, f64::INFINITY, None)
                .unwrap()
                .squared
        });
        let least = least.fold(f64::INFINITY, f64::min);
        assert!((found.unwrap().squared - least).abs() < 1e-12, "{trial}");
    }
}

#[test]
fn the_tree_finds_every_face_of_few_whatever_the_place_and_size_of_the_mesh() {
    let whole = rough(&phantom::torus(2.0, 0.7, 24, 12), 0.05, 0.2);
    for (count, size, away) in [
        (1, 1.0, 0.0),
        (2, 1e-9, 0.0),
        (3, 1e9, 0.0),
        (5, 1.0, 1e6),
        (13, 1e-3, 50.0),
        (49, 1e3, -1e7),
        (200, 1.0, 300.0),
    ] {
        let place = |p: &Point3| Point3::from(size * p.coords + Vector3::repeat(away));
        let points: Vec<Point3> = whole.vertices().iter().map(place).collect();
        let triangles = &whole.triangles()[..count];
        let normals = face_normals(&points, triangles);
        let faces = FacesOfPose {
            points: &points,
            triangles,
            normals: &normals,
        };
        let plan = TreePlan::new(&points, triangles);
        let tree = plan.around(faces);
        for trial in 0..40 {
            let point = place(&Point3::from(3.0 * roughness(trial, 3.0)));
            let all = Facing::any(None);
            let found = tree.nearest(point, &all, f64::INFINITY, None).unwrap();
            let least = (0..count as u32).map(|face| {
                let alone = Facing::any(Some([face, face + 1]));
                let found = tree.nearest(point, &alone, f64::INFINITY, None);
                found.unwrap().squared
            });
            assert_eq!(
                found.squared,
                least.fold(f64::INFINITY, f64::min),
                "{count} {trial}"
            );
        }
    }
    let none = FacesOfPose {
        points: &[],
        triangles: &[],
        normals: &[],
    };
    let plan = TreePlan::new(&[], &[]);
    let found = plan
        .around(none)
        .nearest(Point3::origin(), &Facing::any(None), 1.0, None);
    assert!(found.is_none());
}

#[test]
fn the_nearest_point_of_a_triangle_is_right_in_every_region() {
    let points = [
        Point3::origin(),
        Point3::new(1.0, 0.0, 0.0),
        Point3::new(0.0, 1.0, 0.0),
    ];
    let triangles = [[0, 1, 2]];
    let normals = face_normals(&points, &triangles);
    let faces = FacesOfPose {
        points: &points,
        triangles: &triangles,
        normals: &normals,
    };
    let plan = TreePlan::new(faces.points, faces.triangles);
    let tree = plan.around(faces);
    for (from, to) in [
        ([0.2, 0.3, 2.0], [0.2, 0.3, 0.0]),
        ([-1.0, -1.0, 1.0], [0.0, 0.0, 0.0]),
        ([2.0, -0.5, 0.0], [1.0, 0.0, 0.0]),
        ([-0.5, 3.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.4, -1.0, 0.3], [0.4, 0.0, 0.0]),
        ([-1.0, 0.4, 0.3], [0.0, 0.4, 0.0]),
        ([1.0, 1.0, 0.5], [0.5, 0.5, 0.0]),
    ] {
        let found = tree
            .nearest(Point3::from(from), &Facing::any(None), f64::INFINITY, None)
            .unwrap();
        assert!((found.point - Point3::from(to)).norm() < 1e-12, "{from:?}");
        let weighted: Vector3 = (0..3).map(|k| found.weights[k] * points[k].coords).sum();
        assert!((weighted - found.point.coords).norm() < 1e-12);
    }
}

#[test]
fn smoothing_leaves_a_plane_plane_and_takes_roughness_off_it() {
    let disc = moved(&phantom::bowl(1.0, 20, 60), |_, p| {
        Point3::new(p.x, p.y, 0.0)
    });
    let frames = [vec![&disc]];
    let connectivity = Connectivity::new(&frames).unwrap();
    let flat = smooth(&connectivity, disc.vertices(), 0.2, 0);
    assert!(flat.points.iter().all(|p| p.z == 0.0));
    let height = |points: &[Point3]| {
        let inner = points.iter().filter(|p| p.x.hypot(p.y) < 0.7);
        inner.map(|p| p.z * p.z).sum::<f64>().sqrt()
    };
    let rough = moved(&disc, |v, p| {
        Point3::new(p.x, p.y, 0.02 * roughness(v, 0.1).z)
    });
    let smoothed = smooth(&connectivity, rough.vertices(), 0.2, 0);
    assert!(height(&smoothed.points) < 0.4 * height(rough.vertices()));
    assert!(height(&smoothed.once) < height(&smoothed.points));
}

#[test]
fn vertices_of_both_sides_on_one_place_stay_two() {
    // A closed wall whose sides touch at the pole.
    let cup = closed_cup(1.0, 1.4, 6, 12);
    let pole = cup.vertices()[0];
    let count = cup.vertices().len() / 2;
    let touching = moved(&cup, |v, p| if v == count { pole } else { p });
    let connectivity = Connectivity::new(&[vec![&touching]]).unwrap();
    assert_eq!(connectivity.representative[count], count as u32);
    assert_eq!(connectivity.sheet_count(), 1);
}
