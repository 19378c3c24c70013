//! Images without a heart, and being stopped.

use std::sync::Arc;

use super::*;

fn image(size: [usize; 3], value: impl Fn(Point3) -> f32) -> Image {
    let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, 4.0));
    let frame = VolumeFrame::new(size, Point3::origin(), steps).unwrap();
    let [nx, ny, _] = size;
    let at = |voxel: usize| {
        let place = [voxel % nx, voxel / nx % ny, voxel / nx / ny].map(|n| n as f64);
        value(frame.position(Point3::from(place)))
    };
    let values: Arc<[f32]> = (0..frame.voxel_count()).map(at).collect();
    Image::new(frame, vec![values; 8], None).unwrap()
}

#[test]
fn an_image_without_counts_says_so() {
    let without =
        |image: &Image| assert_eq!(segmented(image, &[]).unwrap_err(), SpectError::NoCounts);
    without(&image([30; 3], |_| 7.0));
    without(&image([30; 3], |_| 0.0));
    without(&image([30; 3], |_| f32::NAN));
    without(&image([1; 3], |_| 7.0));
}

#[test]
fn an_organ_without_a_cavity_is_no_heart() {
    let middle = Point3::new(60.0, 60.0, 60.0);
    let liver = image([30; 3], |place| {
        if (place - middle).norm() < 40.0 {
            100.0
        } else {
            5.0
        }
    });
    let error = segmented(&liver, &[]).unwrap_err();
    assert!(matches!(error, SpectError::NoVentricle { .. }), "{error}");
    let slope = image([30; 3], |place| place.x as f32);
    let error = segmented(&slope, &[]).unwrap_err();
    assert!(matches!(error, SpectError::NoVentricle { .. }), "{error}");
    for size in [[1, 1, 9], [2, 2, 2], [1, 40, 40]] {
        assert!(segmented(&image(size, |place| (place.x + place.z) as f32), &[]).is_err());
    }
}

#[test]
fn voxels_that_are_missing_at_the_rim_change_little() {
    let (study, truth) = study(0, &Scene::default());
    let [nx, ny, _] = study.image.frame().size();
    let volumes = study.image.volumes().iter().map(|volume| {
        let padded = volume.iter().enumerate().map(|(voxel, &counts)| {
            let rim = voxel % nx < 2 || voxel / nx % ny < 2;
            if rim { f32::NAN } else { counts }
        });
        padded.collect()
    });
    let image = Image::new(*study.image.frame(), volumes.collect(), None).unwrap();
    let found = ejection_fraction(&segmented(&image, &[]).unwrap().masks);
    assert!((found - truth).abs() < 0.04, "{found} {truth}");
}

#[test]
fn ends_of_the_axis_in_one_place_are_refused() {
    let (study, _) = study(0, &Scene::default());
    for place in [study.liver_centre, Point3::new(f64::NAN, 0.0, 0.0)] {
        let points = MarkedPoints {
            apex: Some(place),
            base: Some(place),
            ..MarkedPoints::default()
        };
        let (params, progress) = (CheckedSpectParams::default(), Progress::default());
        let error = segment_spect(&study.image, &points, &[], &params, &progress).unwrap_err();
        assert_eq!(error, SpectError::NoAxis);
    }
}

#[test]
fn a_stopped_search_says_so() {
    let (study, _) = study(0, &Scene::default());
    let progress = Progress::default();
    progress.stop();
    let (points, params) = (MarkedPoints::default(), CheckedSpectParams::default());
    let error = segment_spect(&study.image, &points, &[], &params, &progress).unwrap_err();
    assert!(matches!(error, SpectError::Stopped(_)), "{error}");
}
