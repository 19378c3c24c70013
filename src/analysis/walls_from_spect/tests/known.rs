//! Known answers and laws.

use super::*;

#[test]
fn the_ejection_fraction_of_a_known_heart_beside_a_liver_is_found() {
    for subject in [0, 4, 9, 12] {
        let (study, truth) = study(subject, &Scene::default());
        let found = segmented(&study.image, &[]).unwrap();
        let found = ejection_fraction(&found.masks);
        println!("subject {subject}: {found:.3}, truth {truth:.3}");
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
        println!("{edit:?}: {found:.3}, truth {truth:.3}");
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
