//! Known answers on hemispheres whose thickness is a function, and laws.

use std::sync::Arc;

use nalgebra::Rotation3;
use proptest::prelude::*;

use crate::analysis::measures::{PhaseSource, SubjectMeasures};
use crate::analysis::medial::{Atom, MedialBeat, MedialSurface};
use crate::analysis::segments::LongAxis;
use crate::mesh::{Faces, Point3, Vector3, phantom};
use crate::progress::Progress;
use crate::study::SurfaceKind;
use crate::units::LengthUnit;

use super::*;

mod damage;
mod small;

/// ln of how much thicker the wall is at each of eight poses, as a share of what it is at end-systole (pose 3).
const CURVE: [f64; 8] = [0.0, 0.35, 0.8, 1.0, 0.7, 0.3, 0.1, 0.05];
/// What remote myocardium thickens by: PT = e^0.45 = 1.57.
const WELL: f64 = 0.45;

fn measures(end_diastole: usize, end_systole: usize) -> SubjectMeasures {
    SubjectMeasures {
        unit: LengthUnit::Millimetre,
        frames: Vec::new(),
        end_diastole: Some(end_diastole),
        end_systole: Some(end_systole),
        phase_source: PhaseSource::Stated,
        edv: None,
        esv: None,
        sv: None,
        ef: None,
        mass: None,
        notes: Vec::new(),
    }
}

/// A hemisphere of radius 30, pole at −z, that shrinks by a tenth towards end-systole, of a wall 8 thick
/// at rest whose ln r grows by what `thickening` says of each direction.
fn beat(curve: &[f64], thickening: impl Fn(&Vector3) -> f64) -> MedialBeat {
    let bowl = phantom::bowl(30.0, 22, 44);
    let directions: Vec<Vector3> = bowl
        .vertices()
        .iter()
        .map(|point| point.coords.normalize())
        .collect();
    let frames = (curve.iter())
        .map(|&c| MedialSurface {
            atoms: (directions.iter())
                .map(|d| Atom {
                    position: Point3::from(d * (30.0 - 3.0 * c)),
                    radius: 4.0 * (c * thickening(d)).exp(),
                    spokes: [-d, *d],
                })
                .collect(),
            normals: directions.clone(),
            end: vec![None; directions.len()],
        })
        .collect();
    let rim = bowl.faces().boundary_vertices();
    MedialBeat {
        surface: SurfaceKind::Endocardium,
        vertices: (0..directions.len() as u32).collect(),
        faces: Arc::clone(bowl.faces()),
        frames,
        regular: rim.iter().map(|rim| !rim).collect(),
    }
}

/// Thickening that vanishes within an angle of a direction.
fn patch_at(centre: Vector3, radius_rad: f64) -> impl Fn(&Vector3) -> f64 {
    let limit = radius_rad.cos();
    move |d| if d.dot(&centre) > limit { 0.0 } else { WELL }
}

fn found(beat: &MedialBeat) -> Thickening {
    let params = ThickeningParams::default().check().unwrap();
    thickening(beat, &measures(0, 3), None, &params, &Progress::default()).unwrap()
}

/// 2 |A ∩ B| / (|A| + |B|) in atoms.
fn dice(patch: &Patch, inside: impl Fn(usize) -> bool, beat: &MedialBeat) -> f64 {
    let truth = (0..beat.regular.len())
        .filter(|&i| beat.regular[i] && inside(i))
        .count();
    let common = patch.atoms.iter().filter(|&&i| inside(i as usize)).count();
    2.0 * common as f64 / (truth + patch.atoms.len()) as f64
}

const SIDE: Vector3 = Vector3::new(0.8, 0.0, -0.6);

#[test]
fn a_wall_that_thickens_evenly_has_no_patch_and_the_curve_is_its_own() {
    let beat = beat(&CURVE, |_| WELL);
    let found = found(&beat);
    assert_eq!(found.wall_thickening, WallThickening::Everywhere);
    assert!(found.patches.is_empty());
    assert!((found.remote - WELL).abs() < 1e-12 && found.noise < 1e-12);
    assert!((found.tolerance - 1.05_f64.ln()).abs() < 1e-15);
    assert!(
        found
            .ed_to_es
            .iter()
            .all(|pt| (pt - WELL.exp()).abs() < 1e-12)
    );
    assert_eq!(found.steps.len(), 8);
    let contracting = found
        .steps
        .iter()
        .filter(|step| step.half == HalfBeat::Contraction);
    assert_eq!(contracting.count(), 3);
    // From pose 6 on the wall thins by less than the tolerance: all is akinetic there, and MP lies off it.
    let wells: Vec<f64> = found
        .steps
        .iter()
        .map(|step| step.remote_share.round())
        .collect();
    assert_eq!(wells, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
    assert!(found.steps[6].gap.unwrap() > 5.0 && found.steps[0].descriptor.is_none());
}

#[test]
fn a_patch_is_found_where_it_is_with_its_area_and_steady_path() {
    for (radius, most_off) in [(0.35, 0.06), (0.6, 0.04), (0.9, 0.03)] {
        let beat = beat(&CURVE, patch_at(SIDE, radius));
        let found = found(&beat);
        assert_eq!(found.wall_thickening, WallThickening::AllButPatches);
        let [patch] = found.patches.as_slice() else {
            panic!("{radius}")
        };
        let limit = f64::cos(radius);
        let inside = |i: usize| beat.frames[0].normals[i].dot(&SIDE) > limit;
        assert!(
            dice(patch, inside, &beat) > 0.93,
            "{radius}: {}",
            dice(patch, inside, &beat)
        );
        if radius < 0.6 {
            let cap = 1.0 - limit;
            assert!(
                (patch.share / cap - 1.0).abs() < 0.15,
                "{} {cap}",
                patch.share
            );
            let area = std::f64::consts::TAU * 9.0 * cap;
            assert!((patch.area_cm2.unwrap() / area - 1.0).abs() < 0.12);
        }
        assert!((patch.centroid - SIDE * 30.0).coords.norm() < 30.0 * radius);
        assert_eq!(patch.border.len(), 1);
        assert_eq!(patch.stability, 1.0);
        assert_eq!(patch.path.len(), 8);
        assert!(patch.thickening < most_off * 10.0 * WELL);
        assert!(patch.temporal_consistency.normal_spread_rad.unwrap() < 1e-9);
        assert!(patch.temporal_consistency.position_spread.unwrap() < 0.05);
    }
}

#[test]
fn two_patches_are_two_with_a_path_each() {
    let other = Vector3::new(-0.6, 0.5, -0.39_f64.sqrt());
    let (first, second) = (patch_at(SIDE, 0.45), patch_at(other, 0.35));
    let beat = beat(&CURVE, |d| first(d).min(second(d)));
    let found = found(&beat);
    let [large, small] = found.patches.as_slice() else {
        panic!()
    };
    assert!(large.share > small.share);
    let towards = |patch: &Patch| patch.path[0].unwrap().normal.unwrap();
    assert!(towards(large).dot(&SIDE) > 0.99 && towards(small).dot(&other) > 0.99);
}

#[test]
fn a_patch_of_three_fifths_of_the_wall_is_a_patch_and_a_whole_wall_is_none() {
    // Down to z = −0.4 of the radius: 60 % of the hemisphere.
    let down = -Vector3::z();
    let large = beat(&CURVE, patch_at(down, 0.4_f64.acos()));
    let large = found(&large);
    assert_eq!(large.patches.len(), 1);
    assert!((0.5..0.72).contains(&large.patches[0].share));
    // ANV of so large a patch still points one way, but its MP lies off the surface (4.6.3).
    assert!(large.patches[0].temporal_consistency.gap.unwrap() > 0.1);
    let akinetic = found(&beat(&CURVE, |_| 0.02));
    assert_eq!(akinetic.wall_thickening, WallThickening::HardlyAnywhere);
    assert!(akinetic.patches.is_empty());
}

#[test]
fn with_two_poses_thickening_is_the_logarithm_of_pt() {
    let beat = beat(&[0.0, 1.0], patch_at(SIDE, 0.5));
    let params = ThickeningParams {
        smoothing: 0.0,
        ..ThickeningParams::default()
    };
    let params = params.check().unwrap();
    let found = thickening(&beat, &measures(0, 1), None, &params, &Progress::default()).unwrap();
    for atom in (0..beat.regular.len()).filter(|&atom| beat.regular[atom]) {
        assert!((found.averaged[atom] - found.ed_to_es[atom].ln()).abs() < 1e-9);
    }
    assert_eq!(found.patches.len(), 1);
    assert_eq!(found.steps[0].akinetic, found.patches[0].atoms);
}

#[test]
fn segments_of_a_patch_are_named_where_the_axis_knows_them() {
    let septum = Vector3::new(-1.0, 0.0, 0.0);
    let beat = beat(
        &CURVE,
        patch_at(Vector3::new(-0.9, 0.0, -0.19_f64.sqrt()), 0.4),
    );
    let axis = LongAxis::oriented(
        Point3::new(0.0, 0.0, -30.0),
        Point3::origin(),
        septum,
        Vector3::y(),
    );
    let params = ThickeningParams::default().check().unwrap();
    let progress = Progress::default();
    let found = thickening(&beat, &measures(0, 3), axis.as_ref(), &params, &progress).unwrap();
    let segments = &found.patches[0].segments;
    let parts: f64 = segments.iter().map(|s| s.of_patch).sum();
    assert!((parts - 1.0).abs() < 1e-9);
    assert!(segments.iter().all(|s| s.of_segment <= 1.0 + 1e-12));
    assert!(segments[0].segment.name().contains("septal"));
}

/// Numbers in −1..1 that look random and are always the same.
fn noise(index: usize) -> f64 {
    2.0 * ((index + 1) as f64 * 0.754_877_666_246_692_8).fract() - 1.0
}

#[test]
fn noise_is_estimated_and_widens_the_tolerance() {
    let mut noisy = beat(&CURVE, patch_at(SIDE, 0.6));
    let mut drawn = 0;
    for frame in &mut noisy.frames {
        for atom in &mut frame.atoms {
            // Uniform in ±0.3: standard deviation 0.3/√3.
            atom.radius *= (0.3 * noise(drawn)).exp();
            drawn += 1;
        }
    }
    let found = found(&noisy);
    let truth = 0.3 / 3.0_f64.sqrt();
    assert!(
        (found.noise / truth - 1.0).abs() < 0.15,
        "{} {truth}",
        found.noise
    );
    assert!((found.tolerance - 2.0 * 2.0_f64.sqrt() * found.noise).abs() < 1e-12);
    assert_eq!(found.patches.len(), 1);
    assert!(found.averaged_noise < 0.35 * truth);
    let limit = 0.6_f64.cos();
    let inside = |i: usize| noisy.frames[0].normals[i].dot(&SIDE) > limit;
    assert!(dice(&found.patches[0], inside, &noisy) > 0.85);
    assert!(found.patches[0].stability > 0.9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    #[test]
    fn rigid_motion_and_scale_change_no_patch(
        turn in proptest::array::uniform3(-3.0..3.0_f64), shift in -50.0..50.0_f64, scale in 0.2..5.0_f64,
    ) {
        let placed = beat(&CURVE, patch_at(SIDE, 0.5));
        let turn = Rotation3::from_scaled_axis(Vector3::from(turn));
        let mut moved = placed.clone();
        for frame in &mut moved.frames {
            for atom in &mut frame.atoms {
                atom.position = Point3::from(turn * (atom.position.coords * scale)) + Vector3::repeat(shift);
                atom.radius *= scale;
                atom.spokes = atom.spokes.map(|spoke| turn * spoke);
            }
            frame.normals.iter_mut().for_each(|normal| *normal = turn * *normal);
        }
        let (a, b) = (found(&placed), found(&moved));
        prop_assert_eq!(&a.patches[0].atoms, &b.patches[0].atoms);
        prop_assert_eq!(&a.patches[0].border, &b.patches[0].border);
        prop_assert!((a.patches[0].share - b.patches[0].share).abs() < 1e-9);
        prop_assert!((a.patches[0].area * scale * scale / b.patches[0].area - 1.0).abs() < 1e-9);
        let (from, to) = (a.patches[0].temporal_consistency, b.patches[0].temporal_consistency);
        prop_assert!((from.gap.unwrap() - to.gap.unwrap()).abs() < 0.02);
        prop_assert!((a.remote - b.remote).abs() < 1e-9);
    }

    #[test]
    fn pt_of_two_steps_is_the_product_and_around_the_beat_it_is_one(amount in 0.05..0.6_f64) {
        let found = found(&beat(&CURVE, |d| amount * (1.0 + 0.3 * d.x)));
        for atom in 0..found.ed_to_es.len() {
            let along: f64 = found.steps[..3].iter().map(|step| step.pt[atom]).product();
            prop_assert!((along / found.ed_to_es[atom] - 1.0).abs() < 1e-12);
            let around: f64 = found.steps.iter().map(|step| step.pt[atom]).product();
            prop_assert!((around - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn renumbering_the_atoms_renumbers_the_patch() {
    let straight = beat(&CURVE, patch_at(SIDE, 0.5));
    let count = straight.regular.len();
    let turned = |atom: u32| (count - 1) as u32 - atom;
    let reversed = |surface: &MedialSurface| MedialSurface {
        atoms: surface.atoms.iter().rev().copied().collect(),
        normals: surface.normals.iter().rev().copied().collect(),
        end: vec![None; count],
    };
    let triangles = straight
        .faces
        .triangles()
        .iter()
        .map(|t| t.map(turned))
        .collect();
    let other = MedialBeat {
        faces: Arc::new(Faces::new(count, triangles).unwrap()),
        frames: straight.frames.iter().map(reversed).collect(),
        regular: straight.regular.iter().rev().copied().collect(),
        ..straight.clone()
    };
    let (a, b) = (found(&straight), found(&other));
    let mut back: Vec<u32> = b.patches[0]
        .atoms
        .iter()
        .map(|&atom| turned(atom))
        .collect();
    back.sort_unstable();
    assert_eq!(a.patches[0].atoms, back);
    assert!((a.patches[0].share - b.patches[0].share).abs() < 1e-12);
}

#[test]
fn without_volumes_the_area_of_the_medial_surface_tells_the_phases() {
    let beat = beat(&CURVE, |_| WELL);
    let mut untold = measures(0, 3);
    (untold.end_diastole, untold.end_systole) = (None, None);
    let params = ThickeningParams::default().check().unwrap();
    let found = thickening(&beat, &untold, None, &params, &Progress::default()).unwrap();
    assert_eq!([found.end_diastole, found.end_systole], [0, 3]);
}
