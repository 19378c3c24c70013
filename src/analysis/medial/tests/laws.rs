//! What must not matter: place, size, numbering, winding.

use proptest::prelude::*;

use super::*;

/// An uneven open wall.
fn wall() -> [TriMesh; 2] {
    let [endo, epi] = [(1.0, 0.3), (1.4, 0.8)]
        .map(|(radius, seed)| rough(&phantom::bowl(radius, 7, 16), 0.02, seed));
    [
        moved(&endo, |_, p| Point3::new(p.x, 0.9 * p.y, 1.3 * p.z)),
        moved(&epi, |_, p| Point3::new(p.x, p.y, 1.25 * p.z)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn turning_shifting_and_growing_a_wall_does_the_same_to_its_atoms(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-30.0..30.0_f64),
        scale in 0.01..100.0_f64,
    ) {
        let turn = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let motion = |p: Point3| turn * (scale * p) + scale * Vector3::from(shift);
        let [endo, epi] = wall();
        let before = surface(&endo, &[&epi], &usual()).unwrap();
        let there = [&endo, &epi].map(|mesh| moved(mesh, |_, p| motion(p)));
        let after = surface(&there[0], &[&there[1]], &usual()).unwrap();
        for (vertex, (a, b)) in before.atoms.iter().zip(&after.atoms).enumerate() {
            prop_assert!((motion(a.position) - b.position).norm() < 1e-6 * scale);
            prop_assert!((scale * a.radius - b.radius).abs() < 1e-6 * scale);
            prop_assert!((turn * before.normals[vertex] - after.normals[vertex]).norm() < 1e-6);
            prop_assert_eq!(before.end[vertex].is_some(), after.end[vertex].is_some());
        }
    }

    #[test]
    fn renumbering_vertices_and_faces_permutes_the_atoms(seed in 1_u32..1000) {
        let [endo, epi] = wall();
        let before = surface(&endo, &[&epi], &usual()).unwrap();
        let count = endo.vertices().len();
        let mut places: Vec<usize> = (0..count).collect();
        places.sort_by_key(|&v| (v as u32 + 1).wrapping_mul(2_654_435_761 ^ seed));
        let mut number = vec![0_u32; count];
        for (place, &vertex) in places.iter().enumerate() {
            number[vertex] = place as u32;
        }
        let points: Vec<Point3> = places.iter().map(|&v| endo.vertices()[v]).collect();
        let mut triangles: Vec<[u32; 3]> =
            endo.triangles().iter().map(|&[a, b, c]| [b, c, a].map(|v| number[v as usize])).collect();
        triangles.rotate_left(seed as usize % 50);
        let other = TriMesh::new(points, Faces::new(count, triangles).unwrap()).unwrap();
        let after = surface(&other, &[&epi], &usual()).unwrap();
        for (vertex, &place) in number.iter().enumerate() {
            let (a, b) = (before.atoms[vertex], after.atoms[place as usize]);
            prop_assert!((a.position - b.position).norm() < 1e-6 && (a.radius - b.radius).abs() < 1e-6);
            prop_assert_eq!(before.end[vertex].is_some(), after.end[place as usize].is_some());
        }
    }
}

#[test]
fn the_way_faces_are_wound_does_not_matter() {
    let turned = |mesh: &TriMesh, which: fn(usize) -> bool| {
        let triangles = mesh.triangles().iter().enumerate();
        let triangles =
            triangles.map(|(face, &[a, b, c])| if which(face) { [a, c, b] } else { [a, b, c] });
        let faces = Faces::new(mesh.vertices().len(), triangles.collect()).unwrap();
        TriMesh::new(mesh.shared_vertices(), faces).unwrap()
    };
    let [endo, epi] = wall();
    let before = surface(&endo, &[&epi], &usual()).unwrap();
    let both: [fn(usize) -> bool; 2] = [|_| true, |face| face % 3 == 0];
    for which in both {
        let after = surface(&turned(&endo, which), &[&turned(&epi, which)], &usual()).unwrap();
        for (a, b) in before.atoms.iter().zip(&after.atoms) {
            assert!((a.position - b.position).norm() < 1e-9);
        }
    }
    let cup = closed_cup(1.0, 1.4, 7, 16);
    let (a, b) = (
        surface(&cup, &[], &usual()).unwrap(),
        surface(&turned(&cup, |_| true), &[], &usual()).unwrap(),
    );
    assert!(
        a.atoms
            .iter()
            .zip(&b.atoms)
            .all(|(a, b)| (a.position - b.position).norm() < 1e-9)
    );
}
