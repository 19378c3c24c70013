//! Known answers and laws.

use super::*;

#[test]
fn the_ejection_fraction_of_a_known_heart_beside_a_liver_is_found() {
    for subject in [0, 4, 9, 12] {
        let (study, truth) = study(subject, &Scene::default());
        let found = segmented(&study.image, &[]).unwrap();
        let found = ejection_fraction(&found.masks);
        assert!((found - truth).abs() < 0.04, "{subject}: {found} {truth}");
    }
}

#[test]
fn a_liver_that_outshines_the_heart_is_taken_away_by_a_plane_or_a_sphere() {
    let scene = Scene {
        liver: 3.0,
        ..Scene::default()
    };
    let (study, truth) = study(0, &scene);
    let sphere = VolumeEdit::SphereEraser {
        centre: study.liver_centre,
        radius_mm: study.liver_radius_mm + 7.0,
    };
    let plane = VolumeEdit::CutPlane {
        point: study.liver_centre - Vector3::y() * (study.liver_radius_mm + 4.0),
        normal: Vector3::y(),
    };
    for edit in [sphere, plane] {
        let found = segmented(&study.image, &[edit]).unwrap();
        let found = ejection_fraction(&found.masks);
        assert!((found - truth).abs() < 0.04, "{edit:?}: {found} {truth}");
    }
}

#[test]
fn what_is_edited_away_is_not_found() {
    let (study, _) = study(0, &Scene::default());
    let away = VolumeEdit::CutPlane {
        point: study.liver_centre - Vector3::y() * study.liver_radius_mm,
        normal: -Vector3::y(),
    };
    let error = segmented(&study.image, &[away]).unwrap_err();
    assert!(matches!(error, SpectError::NoVentricle { .. }), "{error}");
}

#[test]
fn neither_the_unit_of_counts_nor_the_place_of_the_patient_changes_the_masks() {
    let (study, _) = study(1, &Scene::default());
    let image = &study.image;
    let usual = segmented(image, &[]).unwrap();
    // Powers of two, so that no number is rounded.
    let brighter = image.volumes().iter();
    let brighter = brighter.map(|volume| volume.iter().map(|counts| counts * 1024.0).collect());
    let brighter = Image::new(*image.frame(), brighter.collect(), None).unwrap();
    assert_eq!(segmented(&brighter, &[]).unwrap().masks, usual.masks);
    let frame = image.frame();
    let by = Vector3::new(120.0, -60.0, 33.0);
    let moved = VolumeFrame::new(frame.size(), frame.origin() + by, frame.steps()).unwrap();
    let moved = Image::new(moved, image.volumes().to_vec(), None).unwrap();
    let moved = segmented(&moved, &[]).unwrap();
    assert!((moved.points.apex.unwrap() - usual.points.apex.unwrap() - by).norm() < 0.5);
    let difference = ejection_fraction(&moved.masks) - ejection_fraction(&usual.masks);
    assert!(difference.abs() < 0.005, "{difference}");
}

#[test]
fn marked_ends_of_the_axis_give_the_heart_that_is_found_without() {
    let (study, truth) = study(2, &Scene::default());
    let alone = segmented(&study.image, &[]).unwrap();
    let apex = alone.points.apex.unwrap();
    let base = apex + alone.masks.frame().directions()[2] * 80.0;
    let points = MarkedPoints {
        apex: Some(apex),
        base: Some(base),
        ..MarkedPoints::default()
    };
    let params = CheckedSpectParams::default();
    let marked = segment_spect(&study.image, &points, &[], &params, &Progress::default()).unwrap();
    assert_eq!(marked.points.base, Some(base));
    assert!(alone.points.base.is_some());
    let found = ejection_fraction(&marked.masks);
    assert!((found - truth).abs() < 0.04, "{found} {truth}");
}

/// Planes through a long axis, as programs for gated SPECT store them: the axis along i, the radius along j, the turn along k.
fn turned(image: &Image, apex: Point3, frame: &VolumeFrame) -> Image {
    let [x, y, up] = frame.directions();
    let (size, step) = ([32, 32, 32], 3.3);
    let at = |values: &[f32], voxel: usize| {
        let [row, column, plane] = [voxel % 32, voxel / 32 % 32, voxel / 1024].map(|n| n as f64);
        let (sin, cos) = (std::f64::consts::PI * plane / 32.0).sin_cos();
        let across = (x * cos + y * sin) * (column - 16.0) * step;
        let sampler = Sampler::new(image.frame(), values).unwrap();
        let counts = sampler.at(apex + across + up * ((row - 5.0) * step));
        counts.unwrap_or(0.0) as f32
    };
    let volumes = image.volumes().iter();
    let volumes = volumes.map(|values| (0..32 * 32 * 32).map(|voxel| at(values, voxel)).collect());
    let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, step));
    let frame = VolumeFrame::new(size, Point3::new(5.0, 6.0, 7.0), steps).unwrap();
    Image::new(frame, volumes.collect(), None).unwrap()
}

#[test]
fn planes_through_the_long_axis_are_recognised_and_give_the_same_heart() {
    let (study, _) = study(0, &Scene::default());
    let volume = segmented(&study.image, &[]).unwrap();
    let apex = volume.points.apex.unwrap();
    let planes = turned(&study.image, apex, volume.masks.frame());
    let planes = segmented(&planes, &[]).unwrap();
    assert!(planes.notices[0].text.starts_with("the image is planes"));
    assert!(!volume.notices[0].text.starts_with("the image is planes"));
    // The axis is where the middle of the first plane is stored: along i, at j = 16 and k = 0.
    let expected = Point3::new(5.0 + 5.0 * 3.3, 6.0 + 16.0 * 3.3, 7.0);
    let away = planes.points.apex.unwrap() - expected;
    assert!(away.norm() < 6.0, "{away}");
    let [planes, volume] = [planes, volume].map(|found| ejection_fraction(&found.masks));
    assert!((planes - volume).abs() < 0.03, "{planes} {volume}");
}
