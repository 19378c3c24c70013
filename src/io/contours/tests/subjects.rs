//! Folders of images and outlines: who belongs together, and where outlines come to lie.

use std::fs;
use std::path::Path;

use super::samples::{image, samples, structures, sunnybrook, workspace};
use crate::image::ContourPart;
use crate::io::contours::{ContourStudy, ContourStudyError, find_contour_studies, read_contours};
use crate::io::{ContouredImage, Limits};
use crate::mesh::Point3;
use crate::progress::Progress;

fn folder(files: &[(&str, Vec<u8>)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
    folder
}

fn found(path: &Path) -> Vec<ContourStudy> {
    let (found, errors) =
        find_contour_studies(&[path.to_owned()], &Limits::default(), &Progress::default()).unwrap();
    assert!(errors.is_empty(), "{errors:?}");
    found
}

fn read(study: &ContourStudy) -> Result<ContouredImage, ContourStudyError> {
    read_contours(study, &Limits::default(), &Progress::default())
}

/// Two slices at two instants, with the names of their files by number.
fn images(prefix: &str) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for slice in 0..2 {
        for instant in 0..2 {
            let number = 1 + 2 * slice + instant;
            files.push((
                format!("{prefix}{number}.dcm"),
                image(&format!("1.2.3.{number}"), slice, 100 * instant),
            ));
        }
    }
    files
}

fn with<'a>(
    images: &'a [(String, Vec<u8>)],
    more: &[(&'a str, Vec<u8>)],
) -> Vec<(&'a str, Vec<u8>)> {
    let named = images
        .iter()
        .map(|(name, bytes)| (name.as_str(), bytes.clone()));
    named.chain(more.iter().cloned()).collect()
}

#[test]
fn outlines_lie_in_the_images_that_they_name() {
    let images = images("dicom/");
    let text = sunnybrook().into_bytes();
    let files = with(
        &images,
        &[
            ("contours/IM-0001-0002-icontour-manual.txt", text.clone()),
            ("contours/IM-0001-0003-ocontour-manual.txt", text.clone()),
            ("contours/IM-0001-0077-ocontour-manual.txt", text),
            ("ws.cvi42wsx", workspace("1.2.3.4").into_bytes()),
            ("notes.txt", b"nothing".to_vec()),
        ],
    );
    let folder = folder(&files);
    let studies = found(folder.path());
    assert_eq!(studies.len(), 1);
    assert_eq!((studies[0].images.len(), studies[0].contours.len()), (4, 4));
    let drawn = read(&studies[0]).unwrap();
    assert_eq!(drawn.series.as_ref().unwrap().image.volumes().len(), 2);
    let places: Vec<(usize, ContourPart, Point3)> = (drawn.contours.iter())
        .map(|contour| (contour.instant, contour.part, contour.points[0]))
        .collect();
    // Image 2 is slice 0 at instant 1, image 3 slice 1 at instant 0. Sunnybrook counts from 1; cvi42 in quarters from 0.
    let expected = [
        (1, ContourPart::Endocardium, Point3::new(1.0, 1.5, 0.0)),
        (0, ContourPart::Epicardium, Point3::new(1.0, 1.5, 10.0)),
        (1, ContourPart::Endocardium, Point3::new(1.0, 1.0, 10.0)),
    ];
    assert_eq!(places.len(), 3);
    for expected in expected {
        assert!(places.contains(&expected), "{expected:?} in {places:?}");
    }
    let told: Vec<&str> = drawn
        .notices
        .iter()
        .map(|notice| notice.text.as_str())
        .collect();
    assert!(
        told.contains(&"1 outline left out: they were drawn in images that are not in the series"),
        "{told:?}"
    );
}

#[test]
fn structures_lie_at_the_instant_of_their_image() {
    let images = images("");
    let files = with(&images, &[("rtss.dcm", structures("LV_endo"))]);
    let folder = folder(&files);
    let studies = found(folder.path());
    let drawn = read(&studies[0]).unwrap();
    // z = 10 is slice 1, but the structure names image 1: its instant counts.
    assert_eq!(drawn.contours.len(), 1);
    assert_eq!(drawn.contours[0].instant, 0);
    assert_eq!(drawn.contours[0].points[2], Point3::new(3.0, 3.0, 10.0));
    assert!(drawn.series.is_some());
}

#[test]
fn each_folder_with_images_is_a_subject() {
    let [a, b] = [images("a/dicom/"), images("b/")];
    let text = sunnybrook().into_bytes();
    let mut files = with(
        &a,
        &[(
            "a/drawn/deeper/IM-0001-0001-icontour-manual.txt",
            text.clone(),
        )],
    );
    files.extend(with(&b, &[("b/IM-0001-0002-icontour-manual.txt", text)]));
    let folder = folder(&files);
    let studies = found(folder.path());
    let ids: Vec<&str> = studies.iter().map(|study| study.id.as_str()).collect();
    assert_eq!(ids, ["a", "b"]);
    assert!(studies.iter().all(|study| study.images.len() == 4));
    assert!(studies.iter().all(|study| study.contours.len() == 1));
}

#[test]
fn outlines_in_the_world_need_no_image() {
    for sample in samples() {
        let folder = folder(&[(sample.name, sample.bytes)]);
        let studies = found(folder.path());
        assert_eq!(studies.len(), 1, "{}", sample.name);
        match (sample.name, read(&studies[0])) {
            ("GPFile_000.txt", Ok(drawn)) => {
                assert_eq!(drawn.points.apex, Some(Point3::new(1.0, 2.0, 3.0)));
                // Frame 3 is the only one that is drawn.
                assert!(drawn.contours.iter().all(|contour| contour.instant == 0));
                assert!(drawn.series.is_none());
            }
            ("endo_frame0.mrk.json" | "rtss.dcm", Ok(drawn)) => assert!(drawn.series.is_none()),
            (_, Err(error)) => assert!(
                error.to_string().contains("not among those that were read"),
                "{error}"
            ),
            (name, Ok(drawn)) => panic!("{name}: {drawn:?}"),
        }
    }
}

#[test]
fn what_holds_no_outlines_is_told() {
    let folder = folder(&[
        ("a.nii", b"nothing".to_vec()),
        ("b.txt", b"x y z".to_vec()),
        ("rtss.dcm", structures("Left ventricle")),
    ]);
    let studies = found(folder.path());
    assert_eq!(studies.len(), 1);
    let error = read(&studies[0]).unwrap_err().to_string();
    assert!(error.contains("not said to be endo or epi"), "{error}");
    let nothing = folder.path().join("b.txt");
    assert!(found(&nothing).is_empty());
    let stopped = Progress::default();
    stopped.stop();
    let limits = Limits::default();
    assert!(find_contour_studies(&[folder.path().to_owned()], &limits, &stopped).is_err());
    let outcome = read_contours(&studies[0], &limits, &stopped);
    assert!(matches!(outcome, Err(ContourStudyError::Stopped(_))));
}
