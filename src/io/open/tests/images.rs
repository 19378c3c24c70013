//! Images in folders: what is found, what is left out, and how large all may be.

use std::fs;
use std::path::Path;

use crate::io::Limits;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::image_samples::{Nifti, counted_up, metaimage};
use crate::io::open::{FoundImage, ImageReport, read_images};
use crate::progress::Progress;

fn found_in(paths: &[&Path], limits: &Limits) -> (Vec<FoundImage>, ImageReport) {
    let paths: Vec<_> = paths.iter().map(|path| path.to_path_buf()).collect();
    read_images(&paths, limits, &Progress::default()).unwrap()
}

fn names(found: &[FoundImage]) -> Vec<String> {
    let name = |image: &FoundImage| {
        let path = image.path.as_ref().unwrap();
        path.file_name().unwrap().to_str().unwrap().to_owned()
    };
    found.iter().map(name).collect()
}

/// A folder of three images, one of them broken, and files that are no images.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    fs::create_dir(place("deep")).unwrap();
    let file = Nifti::default();
    fs::write(place("deep/a.nii"), file.bytes()).unwrap();
    let pair = Nifti {
        pair: true,
        offset: 0.0,
        ..file.clone()
    };
    fs::write(place("b.hdr"), pair.bytes()).unwrap();
    fs::write(place("b.img"), &pair.values).unwrap();
    let lines = [
        "NDims = 3",
        "DimSize = 2 3 2",
        "ElementType = MET_SHORT",
        "ElementSpacing = 1 2 3",
    ];
    fs::write(place("c.mhd"), metaimage(&lines, "c.raw", b"")).unwrap();
    fs::write(
        place("c.raw"),
        counted_up(12, Scalar::I16, ByteOrder::Little),
    )
    .unwrap();
    fs::write(place("broken.nii"), &file.bytes()[..380]).unwrap();
    fs::write(place("notes.txt"), "no image").unwrap();
    fs::write(place(".hidden"), "no image").unwrap();
    folder
}

#[test]
fn a_folder_gives_its_images_and_says_what_it_left_out() {
    let folder = folder();
    let (found, report) = found_in(&[folder.path()], &Limits::default());
    assert_eq!(names(&found), ["b.hdr", "c.mhd", "a.nii"]);
    assert_eq!(report.errors.len(), 1);
    assert!(
        report.errors[0]
            .to_string()
            .starts_with("the values of the voxels take 48 bytes")
    );
    let notes: Vec<&str> = report
        .notices
        .iter()
        .map(|note| note.text.as_str())
        .collect();
    assert_eq!(notes, ["1 file of other formats left out"]);
}

#[test]
fn files_that_are_named_must_be_images_and_count_once() {
    let folder = folder();
    let place = |name: &str| folder.path().join(name);
    let (a, img, hdr, text, none) = (
        place("deep/a.nii"),
        place("b.img"),
        place("b.hdr"),
        place("notes.txt"),
        place("nowhere"),
    );
    let (found, report) = found_in(&[&a, &img, &hdr, &a, &text, &none], &Limits::default());
    assert_eq!(names(&found), ["a.nii", "b.hdr"]);
    let errors: Vec<String> = report.errors.iter().map(ToString::to_string).collect();
    assert!(
        errors[0]
            .starts_with("not an image format that can be read (NIfTI, NRRD, MetaImage, DICOM)")
    );
    assert!(errors[1].starts_with("there is no such file"));
    let empty = tempfile::tempdir().unwrap();
    let (_, report) = found_in(&[empty.path()], &Limits::default());
    assert!(
        report.errors[0]
            .to_string()
            .starts_with("no images were found here")
    );
}

#[test]
fn all_images_together_and_each_alone_have_a_limit() {
    let folder = folder();
    let limits = Limits {
        voxels_in_all: 36,
        ..Limits::default()
    };
    let (found, report) = found_in(&[folder.path()], &limits);
    assert_eq!(names(&found), ["b.hdr", "c.mhd"]);
    assert!(
        report
            .errors
            .iter()
            .any(|error| error.to_string().contains("the limit is 36"))
    );
    let limits = Limits {
        voxels: 12,
        ..Limits::default()
    };
    let (found, report) = found_in(&[folder.path()], &limits);
    assert_eq!(names(&found), ["c.mhd"]);
    assert!(
        report.errors[0]
            .to_string()
            .starts_with("24 voxels; the limit is 12")
    );
    let limits = Limits {
        image_files: 2,
        ..Limits::default()
    };
    let (_, report) = found_in(&[folder.path()], &limits);
    assert!(
        report
            .notices
            .iter()
            .any(|note| note.text.contains("too many files"))
    );
}

#[cfg(unix)]
#[test]
fn a_header_names_files_beside_it_only_and_links_stay_inside() {
    let folder = folder();
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("o.nii"), Nifti::default().bytes()).unwrap();
    std::os::unix::fs::symlink(outside.path().join("o.nii"), folder.path().join("link.nii"))
        .unwrap();
    let lines = [
        "NDims = 3",
        "DimSize = 2 3 2",
        "ElementType = MET_SHORT",
        "ElementSpacing = 1 2 3",
    ];
    fs::write(
        folder.path().join("up.mhd"),
        metaimage(&lines, "../c.raw", b""),
    )
    .unwrap();
    let (found, report) = found_in(&[folder.path()], &Limits::default());
    assert_eq!(found.len(), 3);
    let has = |words: &str| {
        report
            .errors
            .iter()
            .any(|error| error.to_string().contains(words))
    };
    assert!(has("a link out of the study") && has("it lies in another folder"));
    let limits = Limits {
        follow_links: true,
        ..Limits::default()
    };
    assert_eq!(found_in(&[folder.path()], &limits).0.len(), 4);
}

#[test]
fn reading_stops_when_asked_to() {
    let folder = folder();
    let progress = Progress::default();
    progress.stop();
    let outcome = read_images(&[folder.path().to_owned()], &Limits::default(), &progress);
    assert!(outcome.is_err());
}
