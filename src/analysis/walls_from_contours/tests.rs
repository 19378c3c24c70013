//! Phantoms of circles in slices: known areas, known muscle, and what is refused.
#![allow(clippy::unwrap_used)] // A test that fails here says so.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::analysis::walls_from_masks::{CheckedWallParams, Masks, Tissue, walls_from_masks};
use crate::image::{Contour, ContourPart, VolumeFrame};
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;
use crate::study::SurfaceKind;

use ContourPart::{Endocardium, Epicardium, RightCavity};

const STEP_MM: f64 = 8.0;

/// Ten slices of a tilted image with pixels of 1.4 mm.
fn tilted() -> VolumeFrame {
    let u = Vector3::new(0.8, 0.6, 0.0);
    let v = Vector3::new(-0.36, 0.48, 0.8);
    let steps = [1.4 * u, 1.4 * v, STEP_MM * u.cross(&v)];
    VolumeFrame::new([100, 90, 10], Point3::new(-30.0, 20.0, 55.0), steps).unwrap()
}

/// A circle in a slice, its middle in pixels.
fn circle(
    frame: &VolumeFrame,
    (instant, part): (usize, ContourPart),
    slice: usize,
    middle: [f64; 2],
    radius_mm: f64,
) -> Contour {
    let corner = |n: usize| {
        let angle = TAU * n as f64 / 200.0;
        let radius = radius_mm / 1.4;
        let place = [
            middle[0] + radius * angle.cos(),
            middle[1] + radius * angle.sin(),
        ];
        frame.position(Point3::new(place[0], place[1], slice as f64))
    };
    Contour {
        instant,
        part,
        points: (0..200).map(corner).collect(),
    }
}

/// Radius of a bowl of slices from the apex (slice 1) to the base (slice 8).
fn bowl(slice: usize, widest: f64) -> f64 {
    widest * (slice as f64 / 8.5).sqrt()
}

/// A beat of two instants: 25 mm within 34 mm, then 17 mm within what keeps the muscle.
fn beat(frame: &VolumeFrame) -> Vec<Contour> {
    let mut contours = Vec::new();
    for slice in 1..=8 {
        let wall = bowl(slice, 34.0).powi(2) - bowl(slice, 25.0).powi(2);
        let inner = [bowl(slice, 25.0), bowl(slice, 17.0)];
        for (instant, radius) in inner.into_iter().enumerate() {
            let middle = [50.3, 44.6];
            let outer = (radius * radius + wall).sqrt();
            contours.push(circle(frame, (instant, Endocardium), slice, middle, radius));
            contours.push(circle(frame, (instant, Epicardium), slice, middle, outer));
        }
    }
    contours
}

fn volume_ml(masks: &Masks, instant: usize, tissue: Tissue) -> f64 {
    masks.count(instant, tissue) as f64 * masks.frame().voxel_mm3() / 1000.0
}

#[test]
fn masks_have_the_areas_of_their_outlines() {
    let frame = tilted();
    let masks = masks_of_contours(&frame, 3, &beat(&frame)).unwrap();
    // The polygon of 200 corners has 1.6e-4 less than the circle.
    for (instant, widest) in [25.0, 17.0].into_iter().enumerate() {
        let areas = (1..=8).map(|slice| PI * bowl(slice, widest).powi(2));
        let expected = areas.sum::<f64>() * STEP_MM / 1000.0;
        let found = volume_ml(&masks, instant, Tissue::Cavity);
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
    let muscle = [0, 1].map(|instant| volume_ml(&masks, instant, Tissue::Wall));
    assert!((muscle[0] / muscle[1] - 1.0).abs() < 2e-3, "{muscle:?}");
    assert_eq!(masks.count(2, Tissue::Cavity), 0);
    assert_eq!(masks.drawn().unwrap().1, [0, 1]);
}

#[test]
fn small_outlines_have_their_areas_too() {
    let frame = tilted();
    // Six pixels of the image.
    let contour = circle(&frame, (0, Endocardium), 3, [50.3, 44.6], 2.0);
    let masks = masks_of_contours(&frame, 1, &[contour]).unwrap();
    let expected = PI * 4.0 * STEP_MM / 1000.0;
    let found = volume_ml(&masks, 0, Tissue::Cavity);
    assert!((found / expected - 1.0).abs() < 0.003, "{found} {expected}");
}

#[test]
fn what_is_drawn_later_does_not_cover_what_lies_within() {
    let frame = tilted();
    let mut contours = beat(&frame);
    contours.reverse();
    contours.push(circle(&frame, (0, RightCavity), 5, [20.0, 44.6], 20.0));
    let masks = masks_of_contours(&frame, 2, &contours).unwrap();
    let straight = masks_of_contours(&frame, 2, &beat(&frame)).unwrap();
    let [found, expected] = [&masks, &straight].map(|m| volume_ml(m, 0, Tissue::Cavity));
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    assert!(masks.count(0, Tissue::RightCavity) > 0);
}

#[test]
fn a_missing_epicardium_keeps_the_muscle_of_every_layer() {
    let frame = tilted();
    let all = beat(&frame);
    let drawn: Vec<Contour> = (all.iter())
        .filter(|c| c.instant == 0 || c.part == Endocardium)
        .cloned()
        .collect();
    let whole = with_epicardium(&frame, 2, &drawn).unwrap();
    assert_eq!(whole.contours.len(), all.len());
    assert_eq!(whole.notices.len(), 1);
    assert!(
        whole.notices[0].text.contains("volume 2: it was added"),
        "{:?}",
        whole.notices
    );
    for added in &whole.contours[drawn.len()..] {
        assert_eq!((added.instant, added.part), (1, Epicardium));
        let voxels: Vec<Point3> = added.points.iter().map(|&p| frame.voxel(p)).collect();
        let slice = voxels[0].z.round() as usize;
        let wall = bowl(slice, 34.0).powi(2) - bowl(slice, 25.0).powi(2);
        let expected = (bowl(slice, 17.0).powi(2) + wall).sqrt();
        for voxel in voxels {
            let radius = 1.4 * (voxel.x - 50.3).hypot(voxel.y - 44.6);
            assert!(
                (radius - expected).abs() < 0.01,
                "{slice}: {radius} {expected}"
            );
        }
    }
}

#[test]
fn muscle_is_kept_where_the_base_comes_down_and_the_heart_moves() {
    let frame = tilted();
    let mut drawn: Vec<Contour> = (beat(&frame).into_iter())
        .filter(|c| c.instant == 0)
        .collect();
    for slice in 1..=6 {
        let middle = [46.0, 48.0];
        drawn.push(circle(
            &frame,
            (1, Endocardium),
            slice,
            middle,
            bowl(slice, 18.0),
        ));
    }
    let whole = with_epicardium(&frame, 2, &drawn).unwrap();
    let masks = masks_of_contours(&frame, 2, &whole.contours).unwrap();
    let muscle = [0, 1].map(|instant| volume_ml(&masks, instant, Tissue::Wall));
    assert!((muscle[1] / muscle[0] - 1.0).abs() < 3e-3, "{muscle:?}");
}

#[test]
fn nothing_is_added_where_nothing_is_missing_and_nothing_can_be() {
    let frame = tilted();
    let all = beat(&frame);
    let whole = with_epicardium(&frame, 2, &all).unwrap();
    assert_eq!((whole.contours, whole.notices), (all.clone(), Vec::new()));
    let inner: Vec<Contour> = all.into_iter().filter(|c| c.part == Endocardium).collect();
    assert_eq!(
        with_epicardium(&frame, 2, &inner),
        Err(ContourError::NoEpicardium)
    );
}

#[test]
fn contours_without_an_image_make_their_own_grid() {
    let frame = tilted();
    let mut contours = beat(&frame);
    // One slice that nobody drew.
    contours.retain(|c| frame.voxel(c.points[0]).z.round() != 4.0);
    let stack = stack_of_contours(&contours).unwrap();
    assert_eq!(stack.size()[2], 8);
    assert!((stack.spacing()[2] - STEP_MM).abs() < 1e-9);
    let volumes = [frame, stack].map(|frame| {
        let masks = masks_of_contours(&frame, 2, &contours).unwrap();
        volume_ml(&masks, 0, Tissue::Cavity)
    });
    assert!((volumes[0] / volumes[1] - 1.0).abs() < 2e-3, "{volumes:?}");
    let reason = |contours: &[Contour]| stack_of_contours(contours).unwrap_err().to_string();
    assert!(reason(&contours[..2]).contains("in one plane"));
    let mut uneven = contours.clone();
    for point in &mut uneven[0].points {
        *point += frame.directions()[2] * 3.0;
    }
    assert!(
        reason(&uneven).contains("even distances"),
        "{}",
        reason(&uneven)
    );
    for (n, point) in uneven[0].points.iter_mut().enumerate() {
        *point += frame.directions()[2] * n as f64;
    }
    assert!(reason(&uneven).contains("parallel"), "{}", reason(&uneven));
    assert_eq!(stack_of_contours(&[]), Err(ContourError::Empty));
}

#[test]
fn what_cannot_be_placed_is_refused_with_its_name() {
    let frame = tilted();
    let made = |change: &dyn Fn(&mut Contour)| {
        let mut contours = beat(&frame);
        change(&mut contours[1]);
        masks_of_contours(&frame, 2, &contours).unwrap_err()
    };
    let across = frame.directions()[2];
    let moved = |by: Vector3| move |c: &mut Contour| c.points.iter_mut().for_each(|p| *p += by);
    let name = ContourName {
        contour: 1,
        instant: 0,
        part: Epicardium,
    };
    assert!(matches!(
        made(&moved(across * 4.0)),
        ContourError::BetweenSlices { which, .. } if which == name
    ));
    assert_eq!(made(&moved(across * 100.0)), ContourError::Outside(name));
    assert_eq!(
        made(&moved(frame.directions()[0] * 100.0)),
        ContourError::Outside(name)
    );
    let tilt = |c: &mut Contour| {
        let points = c.points.iter_mut().enumerate();
        points.for_each(|(n, p)| *p += across * (n % 100) as f64 * 0.1);
    };
    assert!(matches!(made(&tilt), ContourError::Oblique { .. }));
    assert_eq!(made(&|c| c.points.truncate(2)), ContourError::NoArea(name));
    assert_eq!(
        made(&|c| c.points[7].x = f64::NAN),
        ContourError::NoArea(name)
    );
    assert!(matches!(
        made(&|c| c.instant = 2),
        ContourError::Instant { instants: 2, .. }
    ));
    assert_eq!(masks_of_contours(&frame, 2, &[]), Err(ContourError::Empty));
    let flat = |c: &mut Contour| c.points.iter_mut().for_each(|p| *p = frame.origin());
    assert_eq!(made(&flat), ContourError::NoArea(name));
    let wide = VolumeFrame::new([1 << 15, 1 << 15, 10], frame.origin(), frame.steps()).unwrap();
    let corners = [[0.0, 0.0], [32_000.0, 0.0], [32_000.0, 32_000.0]];
    let huge = Contour {
        instant: 0,
        part: Endocardium,
        points: corners
            .map(|[x, y]| wide.position(Point3::new(x, y, 1.0)))
            .to_vec(),
    };
    assert!(matches!(
        masks_of_contours(&wide, 1, &[huge]),
        Err(ContourError::TooLarge { .. })
    ));
}

#[test]
fn walls_of_outlines_have_their_volumes() {
    let frame = tilted();
    let contours = beat(&frame);
    let masks = masks_of_contours(&frame, 2, &contours).unwrap();
    let params = CheckedWallParams::default();
    let walls = walls_from_masks(&masks, &params, &Progress::default()).unwrap();
    for fit in &walls.fits {
        let off = fit.volume_ml / fit.mask_volume_ml - 1.0;
        assert!(off.abs() < 0.02, "{off}");
    }
    let kinds: Vec<SurfaceKind> = walls.sequence.surfaces().iter().map(|s| s.kind()).collect();
    assert_eq!(kinds.len(), 2, "{kinds:?}");
}
