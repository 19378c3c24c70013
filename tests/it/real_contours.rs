//! Outlines that experts drew in real images, from files to walls: volumes are those that the sources state.

use std::path::PathBuf;

use cardiomorph::analysis::walls_from_contours::{
    WithEpicardium, masks_of_contours, stack_of_contours, with_epicardium,
};
use cardiomorph::analysis::walls_from_masks::{CheckedWallParams, Walls, walls_from_masks};
use cardiomorph::image::{Contour, ContourPart, VolumeFrame};
use cardiomorph::io::{
    ContourStudyError, ContouredImage, Limits, find_contour_studies, read_contours,
};
use cardiomorph::mesh::{Point3, Vector3};
use cardiomorph::progress::Progress;
use cardiomorph::study::SurfaceKind;

use crate::shared::shared_data;

/// What the one subject of paths has.
fn drawn(paths: &[PathBuf]) -> Result<ContouredImage, ContourStudyError> {
    let (limits, progress) = (Limits::default(), Progress::default());
    let (found, errors) = find_contour_studies(paths, &limits, &progress).unwrap();
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(found.len(), 1, "{found:?}");
    read_contours(&found[0], &limits, &progress)
}

fn images(place: &str) -> PathBuf {
    shared_data(&format!("images/{place}"))
}

fn frame_of(found: &ContouredImage) -> (VolumeFrame, usize) {
    match &found.series {
        Some(series) => (*series.image.frame(), series.image.volumes().len()),
        None => {
            let instants = found.contours.iter().map(|contour| contour.instant + 1);
            (
                stack_of_contours(&found.contours).unwrap(),
                instants.max().unwrap(),
            )
        }
    }
}

/// Walls, and which instants they are of.
fn walls(found: &ContouredImage) -> (Walls, Vec<usize>, WithEpicardium) {
    let (frame, instants) = frame_of(found);
    let whole = with_epicardium(&frame, instants, &found.contours).unwrap();
    let masks = masks_of_contours(&frame, instants, &whole.contours).unwrap();
    let (masks, numbers) = masks.drawn().unwrap();
    let params = CheckedWallParams::default();
    let walls = walls_from_masks(&masks, &params, &Progress::default()).unwrap();
    (walls, numbers, whole)
}

/// Area of a planar polygon in mm².
fn area(points: &[Point3]) -> f64 {
    let first = points[0];
    let edges = points.iter().zip(points.iter().cycle().skip(1));
    let twice: Vector3 = edges.map(|(a, b)| (a - first).cross(&(b - first))).sum();
    0.5 * twice.norm()
}

/// Areas of the outlines of a part at an instant times the distance of slices, in ml.
fn slices_ml(found: &ContouredImage, instant: usize, part: ContourPart) -> (usize, f64) {
    let own = |contour: &&Contour| contour.instant == instant && contour.part == part;
    let own: Vec<&Contour> = found.contours.iter().filter(own).collect();
    let step = frame_of(found).0.spacing()[2];
    let areas: f64 = own.iter().map(|contour| area(&contour.points)).sum();
    (own.len(), areas * step / 1000.0)
}

/// Volume in ml of a surface of the walls at an instant: (frame among the walls).
fn surface_ml(walls: &Walls, frame: usize, kind: SurfaceKind) -> f64 {
    let fit = walls
        .fits
        .iter()
        .find(|fit| fit.frame == frame && fit.kind == kind);
    fit.unwrap().volume_ml
}

#[track_caller]
fn assert_near(found: f64, expected: f64, share: f64) {
    assert!(
        (found / expected - 1.0).abs() < share,
        "{found} and not {expected}"
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn outlines_of_sunnybrook_become_walls_of_their_volumes() {
    let found = drawn(&[images("sunnybrook_scd/SC-HF-I-4")]).unwrap();
    let series = found.series.as_ref().unwrap();
    assert_eq!(series.image.volumes().len(), 2);
    // Phases 7 and 20 of 20.
    let (slices, es_ml) = slices_ml(&found, 0, ContourPart::Endocardium);
    assert_eq!(slices, 10);
    assert_near(es_ml, 179.58, 0.001);
    assert_near(
        slices_ml(&found, 1, ContourPart::Endocardium).1,
        229.70,
        0.001,
    );
    assert_near(
        slices_ml(&found, 1, ContourPart::Epicardium).1,
        355.49,
        0.001,
    );
    assert_eq!(slices_ml(&found, 0, ContourPart::Epicardium).0, 0);
    let (walls, numbers, whole) = walls(&found);
    assert_eq!(numbers, [0, 1]);
    assert_eq!(whole.notices.len(), 1, "{:?}", whole.notices);
    let volume = |frame, kind| surface_ml(&walls, frame, kind);
    let endo = [0, 1].map(|frame| volume(frame, SurfaceKind::Endocardium));
    assert_near(endo[0], 179.58, 0.05);
    assert_near(endo[1], 229.70, 0.05);
    let muscle = [0, 1].map(|frame| volume(frame, SurfaceKind::Epicardium) - endo[frame]);
    assert_near(muscle[1], 125.8, 0.05);
    // No epicardium was drawn at end-systole: the muscle is the same by construction.
    assert_near(muscle[0], muscle[1], 0.05);
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_workspace_of_cvi42_finds_its_images_by_their_names() {
    let paths = [
        images("contour_formats/SC-HF-I-4.cvi42wsx"),
        images("sunnybrook_scd/SC-HF-I-4/dicom"),
    ];
    let found = drawn(&paths).unwrap();
    for (instant, part, expected) in [
        (0, ContourPart::Endocardium, 179.32),
        (1, ContourPart::Endocardium, 229.67),
        (1, ContourPart::Epicardium, 355.28),
    ] {
        let (slices, volume) = slices_ml(&found, instant, part);
        assert_eq!(slices, 10);
        assert_near(volume, expected, 0.001);
    }
    let alone = drawn(&paths[..1]).unwrap_err();
    assert!(
        matches!(alone, ContourStudyError::NoImages { .. }),
        "{alone}"
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn guide_points_lie_in_the_cine_that_they_were_drawn_in() {
    let found = drawn(&[images("bivme_cine")]).unwrap();
    let series = found.series.as_ref().unwrap();
    assert_eq!(series.image.volumes().len(), 25);
    let (walls, numbers, whole) = walls(&found);
    assert_eq!(numbers, [0, 9]);
    assert!(whole.notices.is_empty(), "{:?}", whole.notices);
    // Slices are 17.7 mm apart: volumes of the fitted model (174.5 and 72.0 ml) are met only so far.
    let endo = [0, 1].map(|frame| surface_ml(&walls, frame, SurfaceKind::Endocardium));
    assert_near(endo[0], 174.49, 0.25);
    assert!(endo[1] < 0.6 * endo[0], "{endo:?}");
    let apex = found.points.apex.unwrap();
    assert!((apex - Point3::new(38.5456, -21.73175, -101.13437)).norm() < 1e-9);
    assert!(found.points.base.is_some() && found.points.septum.is_some());
    // The right cavity was drawn, so that the septum is known.
    assert!(walls.anatomy.is_some());
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn guide_points_need_no_images() {
    let found = drawn(&[images("bivme_cine/guidepoints")]).unwrap();
    assert!(found.series.is_none());
    let (frame, instants) = frame_of(&found);
    assert_eq!(instants, 2);
    assert!(
        (frame.spacing()[2] - 17.7).abs() < 0.05,
        "{:?}",
        frame.spacing()
    );
    let (own, _, _) = walls(&found);
    let (with_images, _, _) = walls(&drawn(&[images("bivme_cine")]).unwrap());
    for frame in 0..2 {
        let volumes = [&own, &with_images].map(|w| surface_ml(w, frame, SurfaceKind::Endocardium));
        assert_near(volumes[0], volumes[1], 0.02);
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn markups_of_slicer_are_outlines_and_landmarks() {
    let curve = drawn(&[images("contour_formats/endo_slice3_frame0.mrk.json")]).unwrap();
    assert_eq!(curve.contours.len(), 1);
    assert_eq!(curve.contours[0].part, ContourPart::Endocardium);
    assert_eq!(curve.contours[0].points.len(), 61);
    // The outline of the guide points that it was made of.
    let points = drawn(&[images("bivme_cine/guidepoints")]).unwrap();
    let nearest = points.contours.iter().map(|contour| {
        let same = |a: &&Point3| contour.points.iter().any(|b| (**a - b).norm() < 1e-3);
        curve.contours[0].points.iter().filter(same).count()
    });
    assert_eq!(nearest.max(), Some(61));
    let landmarks = ["landmarks_frame0.mrk.json", "landmarks_frame0_ras.mrk.json"];
    let both = landmarks.map(|name| {
        let paths = [
            images(&format!("contour_formats/{name}")),
            images("contour_formats/endo_slice3_frame0.mrk.json"),
        ];
        drawn(&paths).unwrap().points
    });
    for points in [both[0].apex, both[1].apex] {
        let off = points.unwrap() - Point3::new(38.5456, -21.73175, -101.13437);
        assert!(off.norm() < 1e-9, "{off}");
    }
    assert_eq!(both[0], both[1]);
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn structures_that_are_no_heart_are_told_as_such() {
    let error = drawn(&[images("seg_rtstruct/pydicom/rtstruct.dcm")]).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("no outlines of endocardium or epicardium"),
        "{error}"
    );
}
