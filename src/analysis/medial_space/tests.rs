//! Laws of the space of medial surfaces and of poses.

use nalgebra::Rotation3;
use proptest::prelude::*;

use crate::analysis::medial::{Atom, EndSpoke, MedialSurface};
use crate::mesh::{Point3, Vector3};

use super::*;

fn vector() -> impl Strategy<Value = Vector3> {
    proptest::array::uniform3(-1.0..1.0_f64).prop_map(Vector3::from)
}

fn direction() -> impl Strategy<Value = Vector3> {
    vector()
        .prop_filter("a direction", |v| v.norm() > 1e-2)
        .prop_map(|v| v.normalize())
}

fn atom() -> impl Strategy<Value = Atom> {
    (vector(), 0.1..4.0_f64, direction(), direction()).prop_map(|(x, radius, s0, s1)| Atom {
        position: Point3::from(10.0 * x),
        radius,
        spokes: [s0, s1],
    })
}

fn atoms() -> impl Strategy<Value = Vec<Atom>> {
    proptest::collection::vec(atom(), 5)
}

const KINDS: [MedialDistance; 2] = [MedialDistance::PrintedSum, MedialDistance::Product];

fn moved(atoms: &[Atom], turn: &Rotation3<f64>, shift: &Vector3) -> Vec<Atom> {
    let place = |atom: &Atom| Atom {
        position: turn * atom.position + shift,
        radius: atom.radius,
        spokes: atom.spokes.map(|spoke| turn * spoke),
    };
    atoms.iter().map(place).collect()
}

fn pose(x: Vector3, log_ratio: f64, rho: f64, normal: Option<Vector3>) -> PoseDescriptor {
    PoseDescriptor {
        position: Point3::from(x),
        log_ratio,
        rho,
        normal,
    }
}

proptest! {
    #[test]
    fn the_way_to_an_atom_ends_there(a in atom(), b in atom()) {
        let there = atom_log(&a, &b);
        let end = atom_exp(&a, &there.tangent);
        prop_assert!((end.position - b.position).norm() < 1e-12);
        prop_assert!((end.radius / b.radius - 1.0).abs() < 1e-12);
        for side in 0..2 {
            prop_assert!((end.spokes[side] - b.spokes[side]).norm() < 1e-12);
        }
    }

    #[test]
    fn distances_are_even_and_rigid_motions_change_none(
        a in atoms(), b in atoms(), turn in vector(), shift in vector(),
    ) {
        let turn = Rotation3::from_scaled_axis(3.0 * turn);
        for kind in KINDS {
            let distance = medial_distance(&a, &b, kind).unwrap();
            let back = medial_distance(&b, &a, kind).unwrap();
            prop_assert!((distance - back).abs() < 1e-12 * distance);
            let (a, b) = (moved(&a, &turn, &shift), moved(&b, &turn, &shift));
            let same = medial_distance(&a, &b, kind).unwrap();
            prop_assert!((distance - same).abs() < 1e-11 * distance);
            prop_assert!(medial_distance(&a, &a, kind).unwrap() < 1e-15);
        }
    }

    #[test]
    fn the_product_distance_scales_as_a_length_and_the_printed_one_does_not(a in atoms(), b in atoms()) {
        let larger = |atoms: &[Atom]| -> Vec<Atom> {
            let scaled = |atom: &Atom| Atom {
                position: atom.position * 3.0,
                radius: atom.radius * 3.0,
                ..*atom
            };
            atoms.iter().map(scaled).collect()
        };
        let grown = |kind| {
            medial_distance(&larger(&a), &larger(&b), kind).unwrap()
                / medial_distance(&a, &b, kind).unwrap()
        };
        prop_assert!((grown(MedialDistance::Product) - 3.0).abs() < 1e-9);
        prop_assert!(grown(MedialDistance::PrintedSum) < 3.0);
    }

    #[test]
    fn the_way_between_has_the_length_of_its_parts(a in atom(), b in atom(), t in 0.0..1.0_f64) {
        let middle = atom_between(&a, &b, t);
        let length = |a: &Atom, b: &Atom| atom_distance(a, b, AtomNorm::Fletcher, 1.0);
        let whole = length(&a, &b);
        prop_assert!((length(&a, &middle) - t * whole).abs() < 1e-9 * whole.max(1.0));
        prop_assert!((length(&middle, &b) - (1.0 - t) * whole).abs() < 1e-9 * whole.max(1.0));
    }

    #[test]
    fn the_mean_of_two_atoms_lies_half_way(a in atom(), b in atom()) {
        prop_assume!((0..2).all(|side| a.spokes[side].dot(&b.spokes[side]) > -0.9));
        let (mean, middle) = (mean_atom(&[a, b]).unwrap(), atom_between(&a, &b, 0.5));
        prop_assert!(atom_distance(&mean, &middle, AtomNorm::Fletcher, 1.0) < 1e-9);
    }

    #[test]
    fn pose_distances_obey_the_triangle(
        x in proptest::array::uniform3(vector()), n in proptest::array::uniform3(direction()),
        ratios in proptest::array::uniform3(-2.0..2.0_f64), rho in 0.0..0.5_f64,
    ) {
        let poses = [0, 1, 2].map(|i| pose(x[i], ratios[i], rho, Some(n[i])));
        let [a, b, c] = &poses;
        prop_assert!(pose_distance(a, c) <= pose_distance(a, b) + pose_distance(b, c) + 1e-12);
        prop_assert!((pose_distance(a, b) - pose_distance(b, a)).abs() < 1e-14);
        prop_assert_eq!(pose_distance(a, a), 0.0);
    }
}

#[test]
fn surfaces_that_do_not_correspond_are_refused_with_their_numbers() {
    let atom = Atom {
        position: Point3::origin(),
        radius: 1.0,
        spokes: [-Vector3::z(), Vector3::z()],
    };
    for kind in KINDS {
        let error = medial_distance(&[atom; 3], &[atom; 2], kind).unwrap_err();
        assert_eq!(error.to_string(), "3 atoms cannot be compared with 2");
    }
    assert_eq!(mean_atoms(&[]), Err(MedialSpaceError::NoSurface));
}

#[test]
fn radii_that_are_none_and_numbers_that_are_none_are_refused() {
    let good = Atom {
        position: Point3::origin(),
        radius: 1.0,
        spokes: [-Vector3::z(), Vector3::z()],
    };
    let mut bad = [good; 3];
    bad[1].radius = 0.0;
    let expected = Err(MedialSpaceError::BadAtom { atom: 1 });
    assert_eq!(
        medial_distance(&bad, &[good; 3], MedialDistance::Product),
        expected
    );
    bad[1].radius = 1.0;
    bad[1].position.x = f64::NAN;
    assert_eq!(
        medial_distance(&[good; 3], &bad, MedialDistance::Product),
        expected
    );
    let opposite = Atom {
        spokes: [Vector3::z(), -Vector3::z()],
        ..good
    };
    let none = mean_atoms(&[&[good], &[opposite]]);
    assert_eq!(none, Err(MedialSpaceError::NoMean { atom: 0 }));
}

#[test]
fn half_way_between_surfaces_walls_are_as_thick_as_their_geometric_mean() {
    let surface = |radius: f64, end: Option<EndSpoke>| MedialSurface {
        atoms: vec![Atom {
            position: Point3::new(radius, 0.0, 0.0),
            radius,
            spokes: [-Vector3::z(), Vector3::z()],
        }],
        normals: vec![Vector3::z()],
        end: vec![end],
    };
    let end = EndSpoke {
        direction: Vector3::x(),
        eta: 1.25,
    };
    let (thin, thick) = (surface(4.0, None), surface(9.0, Some(end)));
    let middle = interpolate(&thin, &thick, 0.5).unwrap();
    assert!((middle.atoms[0].radius - 6.0).abs() < 1e-14);
    assert!((middle.atoms[0].position.x - 6.5).abs() < 1e-14);
    assert_eq!(middle.normals, [Vector3::z()]);
    assert_eq!(middle.end[0].map(|end| end.eta), Some(1.25));
    let end = interpolate(&thin, &thick, 1.0).unwrap();
    assert!((end.atoms[0].radius - 9.0).abs() < 1e-14);
}

#[test]
fn a_product_over_thousands_of_atoms_stays_a_number() {
    let atom = AkineticAtom {
        position: Point3::origin(),
        log_pt: 0.05,
        normal: Vector3::z(),
        spoke_angle_rad: 0.1,
    };
    let many = vec![atom; 20_000];
    let printed = pose_descriptor(&many, RatioForm::Product).unwrap();
    assert!((printed.log_ratio - 1000.0).abs() < 1e-9);
    let still = pose_descriptor(&many[..1], RatioForm::Product).unwrap();
    assert!((pose_distance(&printed, &still) - 0.1 * (1000.0 - 0.05)).abs() < 1e-9);
    let mean = pose_descriptor(&many, RatioForm::GeometricMean).unwrap();
    assert!((mean.ratio() - 0.05_f64.exp()).abs() < 1e-12);
    assert_eq!(pose_descriptor(&[], RatioForm::Product), None);
}

#[test]
fn without_a_direction_a_right_angle_stands_for_the_turn() {
    let with = pose(Vector3::zeros(), 0.0, 0.1, Some(Vector3::x()));
    let without = pose(Vector3::zeros(), 0.0, 0.1, None);
    let right = std::f64::consts::FRAC_PI_2;
    assert!((pose_distance(&with, &without) - right).abs() < 1e-15);
    assert_eq!(pose_distance(&without, &without), 0.0);
    let shares = pose(Vector3::new(30.0, 0.0, 0.0), 0.0, 0.1, None)
        .relative_to(&Point3::new(10.0, 0.0, 0.0), 80.0);
    assert_eq!(shares.position, Point3::new(0.25, 0.0, 0.0));
}
