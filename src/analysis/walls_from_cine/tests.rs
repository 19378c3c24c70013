//! Phantoms of a beating ventricle, with and without what makes images hard.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use proptest::prelude::*;

use super::{CineError, CineParams, CineSegmentation, segment_cine};
use crate::image::{Contour, ContourPart, Image, MarkedPoints, VolumeFrame};
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};

const BLOOD: f64 = 300.0;
const MUSCLE: f64 = 90.0;
const INSTANTS: usize = 12;
const SLICES: usize = 7;
const SLICE_MM: f64 = 8.0;
const PIXEL_MM: f64 = 1.5;

/// Radii of both surfaces in a slice, 0 at the apex, at an instant: the cavity beats, the wall keeps its area.
fn radii_mm(slice: usize, instant: usize) -> [f64; 2] {
    let beat = 0.5 * (1.0 - (TAU * instant as f64 / INSTANTS as f64).cos());
    let diastole = 16.0 + 1.2 * slice as f64;
    let outer = diastole + 9.0;
    let inner = diastole * (1.0 - 0.35 * beat);
    [
        inner,
        (outer * outer - diastole * diastole + inner * inner).sqrt(),
    ]
}

/// Where the middle of a slice is, in millimetres from the first voxel.
fn middle_mm(slice: usize) -> [f64; 2] {
    [70.0 + 0.8 * slice as f64, 66.0 - 0.5 * slice as f64]
}

fn frame() -> VolumeFrame {
    // An oblique stack, from the base to the apex.
    let turn = nalgebra::Rotation3::from_euler_angles(0.4, -0.3, 1.1);
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis);
    let steps = [x * PIXEL_MM, y * PIXEL_MM, z * -SLICE_MM];
    VolumeFrame::new([96, 92, SLICES], Point3::new(-40.0, 12.0, 80.0), steps).unwrap()
}

/// The position of a place in a slice that is counted from the apex.
fn position(slice: usize, [x, y]: [f64; 2]) -> Point3 {
    frame().position(Point3::new(
        x / PIXEL_MM,
        y / PIXEL_MM,
        (SLICES - 1 - slice) as f64,
    ))
}

/// A ventricle with a right ventricle at one side, lung at the other, and two papillary muscles within.
fn tissue(slice: usize, [inner, outer]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    let middle = middle_mm(slice);
    let (x, y) = (x - middle[0], y - middle[1]);
    let radius = x.hypot(y);
    let papillary = [[0.55, 0.55], [0.1, -0.75]].map(|[a, b]| (x - a * inner).hypot(y - b * inner));
    if papillary.iter().any(|&away| away < 3.0) {
        MUSCLE
    } else if radius < inner {
        BLOOD
    } else if radius < outer {
        MUSCLE
    } else if x < 0.0 && (x + 20.0).hypot(y) < outer {
        1.1 * BLOOD
    } else {
        25.0
    }
}

/// Values of pixels as means over 3 × 3 places within each, with a little noise that is the same each time.
fn phantom(noise: f64) -> Image {
    image_of(noise, radii_mm)
}

/// The phantom with other radii.
fn image_of(noise: f64, radii: impl Fn(usize, usize) -> [f64; 2]) -> Image {
    let mut seed = 1_u64;
    let mut random = move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
    };
    let volumes = (0..INSTANTS).map(|instant| {
        let mut values = Vec::with_capacity(frame().voxel_count());
        for k in 0..SLICES {
            for (j, i) in (0..92).flat_map(|j| (0..96).map(move |i| (j, i))) {
                let parts = (0..9).map(|n| {
                    let within = [n % 3, n / 3].map(|n| (f64::from(n) - 1.0) / 3.0);
                    let place =
                        [f64::from(i) + within[0], f64::from(j) + within[1]].map(|n| n * PIXEL_MM);
                    let slice = SLICES - 1 - k;
                    tissue(slice, radii(slice, instant), place)
                });
                values.push((parts.sum::<f64>() / 9.0 + noise * random()) as f32);
            }
        }
        Arc::from(values)
    });
    Image::new(frame(), volumes.collect(), None).unwrap()
}

fn points() -> MarkedPoints {
    let [x, y] = middle_mm(3);
    MarkedPoints {
        apex: Some(position(0, middle_mm(0))),
        base: Some(position(SLICES - 1, middle_mm(SLICES - 1))),
        septum: None,
        // Neither in the middle nor in a papillary muscle.
        blood: Some(position(3, [x - 4.0, y + 2.0])),
    }
}

fn found(
    image: &Image,
    points: &MarkedPoints,
    edits: &[Contour],
) -> Result<CineSegmentation, CineError> {
    let params = CineParams::default().check().unwrap();
    segment_cine(image, points, edits, &params, &Progress::default())
}

/// Area of an outline in space.
fn area_mm2(points: &[Point3]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let crosses = points
        .iter()
        .zip(next)
        .map(|(a, b)| (a - points[0]).cross(&(b - points[0])));
    0.5 * crosses.sum::<Vector3>().norm()
}

fn slice_of(contour: &Contour) -> usize {
    SLICES - 1 - frame().voxel(contour.points[0]).z.round() as usize
}

fn outline(found: &CineSegmentation, slice: usize, instant: usize, part: ContourPart) -> &Contour {
    let mut all = found.contours.iter();
    all.find(|c| c.instant == instant && c.part == part && slice_of(c) == slice)
        .unwrap()
}

fn circle(slice: usize, instant: usize, part: ContourPart, radius: f64) -> Contour {
    let [x, y] = middle_mm(slice);
    let corner = |n: usize| {
        let (sin, cos) = (TAU * n as f64 / 80.0).sin_cos();
        position(slice, [x + radius * cos, y + radius * sin])
    };
    Contour {
        instant,
        part,
        points: (0..80).map(corner).collect(),
    }
}

fn volume_ml(found: &CineSegmentation, instant: usize, part: ContourPart) -> f64 {
    let own = found
        .contours
        .iter()
        .filter(|c| c.instant == instant && c.part == part);
    own.map(|c| area_mm2(&c.points)).sum::<f64>() * SLICE_MM / 1000.0
}

#[test]
fn a_beating_ventricle_has_its_outlines_volumes_and_ejection_fraction() {
    let found = found(&phantom(40.0), &points(), &[]).unwrap();
    assert_eq!(found.contours.len(), 2 * SLICES * INSTANTS);
    for contour in &found.contours {
        let [inner, outer] = radii_mm(slice_of(contour), contour.instant);
        let radius = if contour.part == ContourPart::Endocardium {
            inner
        } else {
            outer
        };
        let off = (area_mm2(&contour.points) / PI).sqrt() - radius;
        assert!(
            off.abs() < 1.0,
            "{:?} {} {}: {off}",
            contour.part,
            slice_of(contour),
            contour.instant
        );
    }
    let truth = |instant: usize| {
        let areas = (0..SLICES).map(|slice| PI * radii_mm(slice, instant)[0].powi(2));
        areas.sum::<f64>() * SLICE_MM / 1000.0
    };
    let volumes =
        [0, INSTANTS / 2].map(|instant| volume_ml(&found, instant, ContourPart::Endocardium));
    assert!(
        (volumes[0] / truth(0) - 1.0).abs() < 0.05,
        "{volumes:?} {}",
        truth(0)
    );
    let [own, expected] = [volumes, [truth(0), truth(INSTANTS / 2)]].map(|v| 1.0 - v[1] / v[0]);
    assert!((own - expected).abs() < 0.02, "{own} {expected}");
}

#[test]
fn a_slice_above_the_valve_in_systole_has_no_outlines_there() {
    // In systole the highest slice shows the atrium, wide and with a thin wall.
    let above = |slice: usize, instant: usize| slice == SLICES - 1 && (4..=8).contains(&instant);
    let image = image_of(40.0, |slice, instant| {
        if above(slice, instant) {
            [23.5, 27.5]
        } else {
            radii_mm(slice, instant)
        }
    });
    let found = found(&image, &points(), &[]).unwrap();
    for instant in 0..INSTANTS {
        let own = found.contours.iter().filter(|c| c.instant == instant);
        let highest = own.map(slice_of).max().unwrap();
        assert_eq!(
            highest < SLICES - 1,
            above(SLICES - 1, instant),
            "{instant}"
        );
    }
}

#[test]
fn what_is_set_by_hand_stays_and_moves_its_neighbours() {
    let image = phantom(40.0);
    let before = found(&image, &points(), &[]).unwrap();
    let radius = radii_mm(3, 2)[0] + 4.0;
    let set = circle(3, 2, ContourPart::Endocardium, radius);
    let after = found(&image, &points(), std::slice::from_ref(&set)).unwrap();
    assert_eq!(outline(&after, 3, 2, ContourPart::Endocardium), &set);
    let count = |all: &[Contour]| {
        all.iter()
            .filter(|c| c.part == set.part && c.instant == 2)
            .count()
    };
    assert_eq!(count(&after.contours), count(&before.contours));
    let grown = |slice: usize, instant: usize| {
        let radius = |all| {
            (area_mm2(&outline(all, slice, instant, ContourPart::Endocardium).points) / PI).sqrt()
        };
        radius(&after) - radius(&before)
    };
    let [next, later, far] = [grown(3, 3), grown(3, 5), grown(3, 8)];
    assert!(
        next > 1.5 && next < 4.0 && later < next && far < later && far >= 0.0,
        "{next} {later} {far}"
    );
    assert!(grown(4, 2) > 0.8 && grown(4, 2) < next && grown(5, 2) < grown(4, 2));
}

#[test]
fn points_that_are_no_ventricle_are_refused_with_the_reason() {
    let image = phantom(0.0);
    let usual = points();
    let with = |change: &dyn Fn(&mut MarkedPoints)| {
        let mut points = usual;
        change(&mut points);
        found(&image, &points, &[]).unwrap_err()
    };
    assert_eq!(with(&|p| p.apex = None), CineError::Missing("the apex"));
    assert_eq!(
        with(&|p| p.blood = Some(Point3::new(f64::NAN, 0.0, 0.0))),
        CineError::NotFinite("the point of the blood")
    );
    assert_eq!(
        with(&|p| p.blood = Some(position(3, [-50.0, 20.0]))),
        CineError::Outside("the point of the blood")
    );
    assert!(matches!(
        with(&|p| p.base = p.apex),
        CineError::Length { .. }
    ));
    let beside = Some(position(0, [5.0, 5.0]));
    assert!(matches!(
        with(&|p| p.base = beside),
        CineError::NotShortAxis { .. }
    ));
    // Far in the lung, in the lung beside the heart, and in the wall.
    let far = Some(position(3, [130.0, 20.0]));
    assert!(matches!(with(&|p| p.blood = far), CineError::NoEdge { .. }));
    let [x, y] = middle_mm(3);
    for away in [35.0, 25.5] {
        let dark = Some(position(3, [x + away, y]));
        assert!(matches!(with(&|p| p.blood = dark), CineError::Dark { .. }));
    }
}

#[test]
fn an_image_without_edges_or_numbers_has_no_outlines() {
    let voxels = frame().voxel_count();
    let filled =
        |value: f32| Image::new(frame(), vec![vec![value; voxels].into(); 3], None).unwrap();
    assert!(matches!(
        found(&filled(200.0), &points(), &[]),
        Err(CineError::NoEdge { .. })
    ));
    assert!(matches!(
        found(&filled(0.0), &points(), &[]),
        Err(CineError::Dark { .. })
    ));
    assert!(found(&filled(f32::NAN), &points(), &[]).is_err());
}

#[test]
fn padding_beside_the_heart_changes_nothing() {
    let image = phantom(20.0);
    let padded: Vec<Arc<[f32]>> = (image.volumes().iter())
        .map(|values| {
            let pad = |(n, &value): (usize, &f32)| if n % 96 > 92 { f32::NAN } else { value };
            values.iter().enumerate().map(pad).collect()
        })
        .collect();
    let padded = Image::new(frame(), padded, None).unwrap();
    let volumes = [&image, &padded].map(|image| {
        let found = found(image, &points(), &[]).unwrap();
        volume_ml(&found, 0, ContourPart::Endocardium)
    });
    assert!((volumes[0] / volumes[1] - 1.0).abs() < 0.01, "{volumes:?}");
}

#[test]
fn outlines_set_by_hand_must_lie_in_the_image() {
    let image = phantom(0.0);
    let set = circle(3, 2, ContourPart::Endocardium, 15.0);
    let reason = |edit: Contour| match found(&image, &points(), &[edit]) {
        Err(CineError::Edit { reason, .. }) => reason,
        other => panic!("{other:?}"),
    };
    assert!(
        reason(Contour {
            instant: INSTANTS,
            ..set.clone()
        })
        .contains("no such instant")
    );
    let points = set.points[..2].to_vec();
    assert!(reason(Contour { points, ..set }).contains("corners"));
    let mut points = set.points.clone();
    points[1].x = f64::NAN;
    assert!(reason(Contour { points, ..set }).contains("not numbers"));
    let mut points = set.points.clone();
    points[1] = position(5, middle_mm(5));
    assert!(reason(Contour { points, ..set }).contains("oblique"));
}

#[test]
fn a_stopped_search_says_so() {
    let progress = Progress::default();
    progress.stop();
    let params = CineParams::default().check().unwrap();
    let stopped = segment_cine(&phantom(0.0), &points(), &[], &params, &progress);
    assert_eq!(stopped.unwrap_err(), CineError::Stopped(Stopped));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    #[test]
    fn it_does_not_matter_where_in_the_blood_the_point_is(angle in 0.0..TAU, share in 0.0..0.35_f64) {
        let image = phantom(20.0);
        let [x, y] = middle_mm(2);
        let away = share * radii_mm(2, 6)[0];
        let blood = Some(position(2, [x + away * angle.cos(), y + away * angle.sin()]));
        let found = found(&image, &MarkedPoints { blood, ..points() }, &[]).unwrap();
        let expected = (0..SLICES).map(|slice| PI * radii_mm(slice, 0)[0].powi(2)).sum::<f64>() * SLICE_MM / 1000.0;
        let own = volume_ml(&found, 0, ContourPart::Endocardium);
        prop_assert!((own / expected - 1.0).abs() < 0.05, "{own} {expected}");
    }
}
