//! Shells whose atoms are known.

use super::*;

#[test]
fn between_two_plates_every_ball_is_half_as_wide_as_the_gap() {
    let bowl = phantom::bowl(1.0, 12, 40);
    let plate = |height: f64| moved(&bowl, |_, p| Point3::new(8.0 * p.x, 8.0 * p.y, height));
    let sheet = surface(&plate(0.0), &[&plate(1.5)], &usual()).unwrap();
    for (atom, normal) in sheet.atoms.iter().zip(&sheet.normals) {
        assert!((atom.radius - 0.75).abs() < 1e-9 && (atom.position.z - 0.75).abs() < 1e-9);
        assert!((normal - Vector3::z()).norm() < 1e-9);
        assert!((atom.spokes[0] + Vector3::z()).norm() < 1e-9);
    }
    let ends: Vec<bool> = sheet.end.iter().map(Option::is_some).collect();
    assert_eq!(ends, bowl.faces().boundary_vertices());
}

#[test]
fn errors_between_spheres_fall_with_the_square_of_the_edge() {
    // The outer sphere is turned, so that its vertices do not lie over those of the inner one.
    let turn = nalgebra::Rotation3::from_euler_angles(0.3, 0.5, 0.7);
    let errors: Vec<f64> = (2..5)
        .map(|level| {
            let outer = moved(&phantom::sphere(level, 1.4), |_, p| turn * p);
            let found = surface(&phantom::sphere(level, 1.0), &[&outer], &checked(0.0)).unwrap();
            let miss = found.atoms.iter().map(|atom| 0.2 - atom.radius);
            miss.sum::<f64>() / found.atoms.len() as f64
        })
        .collect();
    for pair in errors.windows(2) {
        assert!((3.4..4.6).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}

#[test]
fn smoothing_loses_the_fourth_power_of_length_over_radius() {
    let shell = |smoothing: f64| {
        let [inner, outer] = [1.0, 1.4].map(|radius| phantom::sphere(4, radius));
        let found = surface(&inner, &[&outer], &checked(smoothing)).unwrap();
        found.atoms.iter().map(|a| a.radius).sum::<f64>() / found.atoms.len() as f64
    };
    let exact = shell(0.0);
    let [some, more] = [0.2, 0.4].map(|smoothing| shell(smoothing) - exact);
    assert!((12.0..18.0).contains(&(more / some)), "{some} {more}");
}

#[test]
fn of_an_open_cup_the_usual_radii_hold_within_two_percent_and_normals_within_three_degrees() {
    let [endo, epi] = [20.0, 28.0].map(|radius| phantom::bowl(radius, 20, 40));
    let found = surface(&endo, &[&epi], &usual()).unwrap();
    for (vertex, atom) in found.atoms.iter().enumerate() {
        if found.end[vertex].is_some() {
            assert!(endo.vertices()[vertex].z.abs() < 1e-9);
            continue;
        }
        let outwards = atom.position.coords.normalize();
        if endo.vertices()[vertex].z < -8.0 {
            assert!((atom.radius / 4.0 - 1.0).abs() < 0.02, "{vertex} {atom:?}");
            assert!(found.normals[vertex].angle(&outwards) < 3_f64.to_radians());
            let [inner, outer] = atom.boundary_points();
            assert!((inner.coords.norm() - 20.0).abs() < 0.2);
            assert!((outer.coords.norm() - 28.0).abs() < 0.2);
        }
    }
}

#[test]
fn of_a_closed_cup_both_sides_have_atoms_and_the_rim_ends_them() {
    let cup = closed_cup(20.0, 28.0, 20, 40);
    let found = surface(&cup, &[], &usual()).unwrap();
    assert!(all_finite(&found));
    let mut ended = 0;
    for (vertex, atom) in found.atoms.iter().enumerate() {
        let outwards = atom.position.coords.normalize();
        if let Some(end) = found.end[vertex] {
            ended += 1;
            // Within a thickness of the rim; b leads to it, in the corner of the outer side outwards.
            assert!(cup.vertices()[vertex].z > -8.0);
            let to_rim = end.direction.z.max(end.direction.dot(&outwards));
            assert!(to_rim > 0.5 || atom.radius < 1.0, "{vertex} {end:?}");
        } else {
            assert!((atom.radius / 4.0 - 1.0).abs() < 0.03, "{vertex} {atom:?}");
            assert!(found.normals[vertex].angle(&outwards) < 5_f64.to_radians());
        }
    }
    assert!((80..=320).contains(&ended), "{ended}");
}

#[test]
fn a_wall_of_two_nested_sheets_is_a_wall() {
    // The outer one is turned, so that no sphere touches a vertex, where several faces are equally near.
    let turn = nalgebra::Rotation3::from_euler_angles(0.3, 0.5, 0.7);
    let inner = phantom::sphere(3, 1.0);
    let outer = moved(&phantom::sphere(3, 1.4), |_, p| turn * p);
    let faces = Faces::joined(&[inner.faces(), outer.faces()]);
    let points: Vec<Point3> = [&inner, &outer]
        .iter()
        .flat_map(|m| m.vertices())
        .copied()
        .collect();
    let wall = TriMesh::new(points, faces).unwrap();
    let both = surface(&wall, &[], &usual()).unwrap();
    let one = surface(&inner, &[&outer], &usual()).unwrap();
    for vertex in 0..inner.vertices().len() {
        // Typical thickness is measured from the other side, which changes smoothing a little.
        let [a, b] = [&both, &one].map(|surface| surface.atoms[vertex].position);
        assert!((a - b).norm() < 1e-3, "{a} {b}");
        assert!(both.normals[vertex].angle(&one.normals[vertex]) < 0.01);
    }
    let outer_side = &both.atoms[inner.vertices().len()];
    assert!((outer_side.radius - 0.2).abs() < 0.004);
    assert!(outer_side.spokes[1].dot(&outer_side.position.coords) > 0.0);
}

#[test]
fn smoothing_takes_most_of_the_noise_off_a_fine_wall() {
    // Edges of a fourth of the thickness, uniform noise of 5 % of it either way.
    let [endo, epi] = [(20.0, 0.5), (28.0, 9.5)]
        .map(|(radius, seed)| rough(&phantom::sphere(4, radius), 0.05 * 8.0, seed));
    let error = |smoothing: f64| {
        let found = surface(&endo, &[&epi], &checked(smoothing)).unwrap();
        let squared = |atom: &Atom| (atom.radius / 4.0 - 1.0).powi(2);
        let mean = found.atoms.iter().map(squared).sum::<f64>() / found.atoms.len() as f64;
        let turned = |(n, a): (&Vector3, &Atom)| n.angle(&a.position.coords);
        let turn = found.normals.iter().zip(&found.atoms).map(turned);
        (mean.sqrt(), turn.sum::<f64>() / found.atoms.len() as f64)
    };
    let (raw, smooth) = (error(0.0), error(MedialParams::default().smoothing));
    assert!(
        smooth.0 < 0.5 * raw.0 && smooth.0 < 0.02,
        "{raw:?} {smooth:?}"
    );
    assert!(
        smooth.1 < 0.5 * raw.1 && smooth.1 < 3_f64.to_radians(),
        "{raw:?} {smooth:?}"
    );
}
