//! Small patches, ragged ones, and rough positions.

use super::*;

/// A patch of this share of the hemisphere's area, the regular part of it being a little less.
fn share_at(centre: Vector3, share: f64) -> impl Fn(&Vector3) -> f64 {
    patch_at(centre, (1.0 - share).acos())
}

/// Centres of patches at a quarter of the radius and more from the rim.
fn centres() -> Vec<Vector3> {
    (0..12)
        .map(|k| {
            let (z, turn) = (-0.35 - 0.05 * f64::from(k), 2.4 * f64::from(k));
            let across = (1.0 - z * z).sqrt();
            Vector3::new(across * turn.cos(), across * turn.sin(), z)
        })
        .collect()
}

#[test]
fn patches_from_the_limit_on_are_found_and_those_of_half_of_it_are_not() {
    let limit = found(&beat(&CURVE, |_| WELL)).smallest.unwrap();
    assert!((0.02..0.06).contains(&limit.share), "{limit:?}");
    assert!((limit.area_cm2.unwrap() * 100.0 - limit.area).abs() < 1e-9);
    let found_of = |share: f64| {
        (centres().into_iter())
            .filter(|&centre| {
                !found(&beat(&CURVE, share_at(centre, share)))
                    .patches
                    .is_empty()
            })
            .count()
    };
    assert!(found_of(1.3 * limit.share) >= 11, "{limit:?}");
    assert!(found_of(0.5 * limit.share) <= 1, "{limit:?}");
}

#[test]
fn noise_raises_the_limit_and_global_failure_has_none() {
    let mut noisy = beat(&CURVE, |_| WELL);
    for (frame, surface) in noisy.frames.iter_mut().enumerate() {
        for (place, atom) in surface.atoms.iter_mut().enumerate() {
            atom.radius *= (0.3 * noise(10_000 * frame + place)).exp();
        }
    }
    let share = |found: &Thickening| found.smallest.map(|smallest| smallest.share);
    let clean = share(&found(&beat(&CURVE, |_| WELL))).unwrap();
    assert!(share(&found(&noisy)).unwrap() > clean);
    assert_eq!(found(&beat(&CURVE, |_| 0.01)).smallest, None);
}

#[test]
fn a_hole_smaller_than_a_patch_is_filled_and_a_larger_one_stays() {
    for (hole, loops) in [(0.12, 1), (0.5, 2)] {
        let centre = Vector3::new(0.3, 0.0, -0.95).normalize();
        let (outer, inner) = (patch_at(centre, 0.75), hole);
        let beat = beat(&CURVE, |d| {
            if d.dot(&centre) > f64::cos(inner) {
                WELL
            } else {
                outer(d)
            }
        });
        let found = found(&beat);
        assert_eq!(found.patches.len(), 1, "{hole}");
        assert_eq!(found.patches[0].border.len(), loops, "{hole}");
    }
}

#[test]
fn rough_positions_hardly_move_the_centroid_of_a_large_patch() {
    // Half of the hemisphere and its pole: areas there are small, and noise adds most to them.
    let centre = Vector3::new(0.6, 0.0, -0.8);
    let clean = beat(&CURVE, patch_at(centre, 1.0));
    let mut rough = clean.clone();
    for (frame, surface) in rough.frames.iter_mut().enumerate() {
        for (place, atom) in surface.atoms.iter_mut().enumerate() {
            let draw = |axis: usize| noise(50_000 * axis + 1_500 * frame + place);
            atom.position += 2.0 * Vector3::new(draw(0), draw(1), draw(2));
        }
    }
    let [before, after] = [&clean, &rough].map(|beat| found(beat).patches[0].clone());
    let moved = (before.centroid - after.centroid).norm();
    assert!(moved < 1.0, "{moved}");
    assert!(
        (after.area / before.area - 1.0).abs() < 0.1,
        "{} {}",
        before.area,
        after.area
    );
}

#[test]
fn a_strip_along_the_edge_is_no_patch_and_one_that_goes_on_is() {
    let strip = |lowest: f64| {
        found(&beat(&CURVE, |d| {
            if d.x > 0.0 && d.z > lowest { 0.0 } else { WELL }
        }))
    };
    // An eighth of the hemisphere, all of it within a fifth of the way to the apex.
    assert!(strip(-0.25).patches.is_empty());
    let deep = strip(-0.7);
    assert_eq!(deep.patches.len(), 1);
    let mut atoms = deep.patches[0].atoms.iter();
    assert!(atoms.any(|&atom| deep.at_edge[atom as usize]));
}
