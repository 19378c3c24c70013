//! The stages: what was typed, the preview, lids.

use super::phantom::{counts, labels};
use crate::analysis::preparation::*;
use crate::image::VolumeEdit;
use crate::mesh::{Point3, Vector3, signed_volume};
use crate::progress::Progress;

fn progress() -> Progress {
    Progress::default()
}

#[test]
fn typed_distances_and_times_take_the_place_of_the_files() {
    let image = labels();
    let mut settings = Preparation::default();
    assert_eq!(stated_image(&image, &settings).unwrap(), image);
    settings.spacing_mm = Some([2.0, 3.0, 10.0]);
    settings.times = Some(TypedTimes::Cycle(900.0));
    let stated = stated_image(&image, &settings).unwrap();
    assert_eq!(stated.frame().steps()[2], -Vector3::z() * 10.0);
    assert_eq!(stated.frame().origin(), image.frame().origin());
    assert_eq!(stated.times_ms(), Some(&[0.0, 450.0][..]));
    settings.times = Some(TypedTimes::Each(vec![0.0]));
    let error = stated_image(&image, &settings).unwrap_err();
    assert!(matches!(error, PreparationError::Typed(_)), "{error}");
}

#[test]
fn the_preview_is_what_is_bright_and_edits_take_the_liver_away() {
    let image = counts();
    let mut settings = Preparation::of_road(Road::Spect);
    let lowest = |settings: &Preparation| {
        let mesh = preview(&image, 0, settings, &progress()).unwrap();
        let far = mesh.vertices().iter().map(|p| p.x).fold(f64::MIN, f64::max);
        assert!(mesh.faces().boundary_loops().is_empty());
        far
    };
    assert!(lowest(&settings) > 55.0);
    settings.edits = vec![VolumeEdit::SphereEraser {
        centre: Point3::new(52.0, 0.0, -70.0),
        radius_mm: 16.0,
    }];
    let without = lowest(&settings);
    assert!((30.0..40.0).contains(&without), "{without}");
    settings.edits = vec![VolumeEdit::ComponentAt(Point3::new(30.0, 0.0, -10.0))];
    assert!((30.0..40.0).contains(&lowest(&settings)));
}

#[test]
fn a_kept_blur_gives_the_same_surfaces() {
    let image = counts();
    let mut settings = Preparation::of_road(Road::Spect);
    let bright = BrightSurface::new(&image, 1, &settings, &progress()).unwrap();
    for threshold in [0.3, 0.6] {
        settings.threshold = Some(threshold);
        let kept = bright.surface(&settings, &progress()).unwrap();
        assert_eq!(kept, preview(&image, 1, &settings, &progress()).unwrap());
    }
}

#[test]
fn a_lid_closes_each_surface_and_leaves_its_vertices_where_they_are() {
    let image = labels();
    let mut settings = Preparation::default();
    let open = prepared(&image, &settings, &progress())
        .unwrap()
        .walls
        .sequence;
    settings.base = BaseEnd::Closed;
    let closed = prepared(&image, &settings, &progress())
        .unwrap()
        .walls
        .sequence;
    for (open, closed) in open.surfaces().iter().zip(closed.surfaces()) {
        assert_eq!(open.faces().boundary_loops().len(), 1);
        assert!(closed.faces().boundary_loops().is_empty());
        assert_eq!(
            closed.faces().vertex_count(),
            open.faces().vertex_count() + 1
        );
        for (instant, (open, closed)) in open.frames().iter().zip(closed.frames()).enumerate() {
            assert_eq!(open.vertices(), &closed.vertices()[..open.vertices().len()]);
            let corners = closed.triangles().iter();
            let corners = corners.map(|face| face.map(|v| closed.vertices()[v as usize]));
            let volume = signed_volume(corners, Point3::origin()) / 1000.0;
            assert!(volume > 30.0, "instant {instant}: {volume} ml");
        }
    }
}

#[test]
fn a_volume_that_is_not_there_or_dark_is_an_error_and_stop_is_heard() {
    let image = counts();
    let settings = Preparation::of_road(Road::Spect);
    let error = preview(&image, 9, &settings, &progress()).unwrap_err();
    assert_eq!(
        error,
        PreparationError::Instant {
            instant: 9,
            instants: 2
        }
    );
    let dark = super::phantom::image([4.0, 4.0], |_, _| 0.0);
    let error = preview(&dark, 0, &settings, &progress()).unwrap_err();
    assert_eq!(error, PreparationError::Dark(0));
    let stopped = progress();
    stopped.stop();
    for error in [
        preview(&image, 0, &settings, &stopped).unwrap_err(),
        prepared(&image, &settings, &stopped).unwrap_err(),
        prepared(&labels(), &Preparation::default(), &stopped).unwrap_err(),
    ] {
        assert!(matches!(error, PreparationError::Stopped(_)), "{error}");
    }
}
