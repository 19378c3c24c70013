//! Walls that are hardly any, and being stopped.

use super::*;
use crate::progress::Stopped;

#[test]
fn a_seam_of_doubled_vertices_is_closed() {
    let [endo, epi] = [1.0, 1.4].map(|radius| phantom::bowl(radius, 8, 20));
    // Cut along a meridian: every ring's first vertex twice.
    let cut = |mesh: &TriMesh| {
        let count = mesh.vertices().len() as u32;
        let mut points = mesh.vertices().to_vec();
        points.extend((0..8).map(|ring| mesh.vertices()[1 + 20 * ring]));
        let twin = |v: u32, others: [u32; 3]| {
            let on_seam = v > 0 && (v - 1).is_multiple_of(20);
            let last = others.iter().any(|&o| o > 0 && (o - 1) % 20 == 19);
            if on_seam && last {
                count + (v - 1) / 20
            } else {
                v
            }
        };
        let triangles = mesh.triangles().iter().map(|&t| t.map(|v| twin(v, t)));
        let faces = Faces::new(points.len(), triangles.collect()).unwrap();
        TriMesh::new(points, faces).unwrap()
    };
    let whole = surface(&endo, &[&epi], &usual()).unwrap();
    let seamed = surface(&cut(&endo), &[&cut(&epi)], &usual()).unwrap();
    for (vertex, atom) in whole.atoms.iter().enumerate() {
        assert!((atom.position - seamed.atoms[vertex].position).norm() < 1e-9);
        assert_eq!(whole.end[vertex].is_some(), seamed.end[vertex].is_some());
    }
    let twins = [1, whole.atoms.len()].map(|vertex| seamed.atoms[vertex].position);
    assert!((twins[0] - twins[1]).norm() < 1e-9);
}

#[test]
fn faces_without_area_and_vertices_without_faces_are_survived() {
    let [endo, epi] = [1.0, 1.4].map(|radius| phantom::sphere(2, radius));
    let spoilt = |mesh: &TriMesh| {
        let count = mesh.vertices().len();
        let mut points = mesh.vertices().to_vec();
        let spot = points[7];
        points.extend([spot, spot, Point3::new(9.0, 9.0, 9.0)]);
        let (a, b, c) = (7, count as u32, count as u32 + 1);
        let mut triangles = mesh.triangles().to_vec();
        triangles.push([a, b, c]);
        TriMesh::new(points, Faces::new(count + 3, triangles).unwrap()).unwrap()
    };
    let found = surface(&spoilt(&endo), &[&spoilt(&epi)], &usual()).unwrap();
    assert!(all_finite(&found));
    let radii = found
        .atoms
        .iter()
        .take(endo.vertices().len())
        .map(|a| a.radius);
    assert!(
        radii.clone().all(|r| (r / 0.2 - 1.0).abs() < 0.1),
        "{:?}",
        radii.collect::<Vec<_>>()
    );
}

#[test]
fn where_sides_cross_there_is_no_room_and_the_sheet_ends() {
    let [endo, epi] = [1.0, 1.3].map(|radius| phantom::sphere(3, radius));
    let through = moved(&endo, |_, p| {
        if p.z > 0.93 {
            Point3::from(1.4 * p.coords)
        } else {
            p
        }
    });
    let found = surface(&through, &[&epi], &checked(0.0)).unwrap();
    assert!(all_finite(&found));
    for (vertex, atom) in found.atoms.iter().enumerate() {
        if endo.vertices()[vertex].z > 0.97 {
            assert!(
                atom.radius == 0.0 && found.end[vertex].is_some(),
                "{vertex} {atom:?}"
            );
        } else if endo.vertices()[vertex].z < 0.5 {
            assert!(found.end[vertex].is_none() && (atom.radius / 0.15 - 1.0).abs() < 0.05);
        }
    }
}

#[test]
fn a_wall_without_thickness_or_inside_out_is_refused_with_numbers() {
    let sphere = phantom::sphere(2, 1.0);
    let error = surface(&sphere, &[&sphere], &usual()).unwrap_err();
    let words = "frame 0: 162 of 162 vertices have no ball between the sides";
    assert!(error.to_string().starts_with(words), "{error}");
    let flat = moved(&sphere, |_, _| Point3::origin());
    let error = surface(&sphere, &[&flat], &usual()).unwrap_err();
    assert_eq!(
        error,
        MedialError::NoArea {
            frame: 0,
            surface: 1,
            faces: 320
        }
    );
    let empty = TriMesh::new(Vec::new(), Faces::new(0, Vec::new()).unwrap()).unwrap();
    assert!(surface(&empty, &[], &usual()).is_err());
}

#[test]
fn a_wall_that_branches_has_atoms_all_the_same() {
    let [endo, epi] = [1.0, 1.4].map(|radius| phantom::sphere(2, radius));
    let fin = {
        let mut points = endo.vertices().to_vec();
        points.push(Point3::new(0.2, 0.1, 0.0));
        let mut triangles = endo.triangles().to_vec();
        let [a, b, _] = triangles[0];
        triangles.push([a, b, points.len() as u32 - 1]);
        TriMesh::new(points.clone(), Faces::new(points.len(), triangles).unwrap()).unwrap()
    };
    let found = surface(&fin, &[&epi], &usual()).unwrap();
    assert!(all_finite(&found));
    let right = found
        .atoms
        .iter()
        .filter(|a| (a.radius / 0.2 - 1.0).abs() < 0.05)
        .count();
    assert!(right > 150, "{right}");
}

#[test]
fn huge_and_tiny_coordinates_are_survived() {
    for scale in [1e-9, 1e9] {
        let [endo, epi] = [scale, 1.4 * scale].map(|radius| phantom::sphere(2, radius));
        let found = surface(&endo, &[&epi], &usual()).unwrap();
        assert!(all_finite(&found));
        assert!(
            found
                .atoms
                .iter()
                .all(|a| (a.radius / scale / 0.2 - 1.0).abs() < 0.05)
        );
    }
}

#[test]
fn settings_out_of_range_are_refused() {
    let with = |change: fn(&mut MedialParams)| {
        let mut params = MedialParams::default();
        change(&mut params);
        params.check().unwrap_err().to_string()
    };
    assert_eq!(
        with(|p| p.smoothing = -0.1),
        "smoothing must be between 0 and 2 thicknesses, not -0.1"
    );
    assert!(with(|p| p.smoothing = f64::NAN).contains("NaN"));
    assert!(with(|p| p.separation_rad = 2.5).starts_with("angles must fulfil"));
}

#[test]
fn a_stopped_surface_returns_at_once() {
    let progress = Progress::default();
    progress.stop();
    let [endo, epi] = [1.0, 1.4].map(|radius| phantom::sphere(3, radius));
    let stopped = medial_surface(&endo, &[&epi], &usual(), &progress).unwrap_err();
    assert_eq!(stopped, MedialError::Stopped(Stopped));
}
