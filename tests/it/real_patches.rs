//! The patch of each heart with an infarction, and where it lies; run with `--nocapture` for the table.

use std::fs;
use std::path::Path;

use cardiomorph::analysis::measures::measure_subject;
use cardiomorph::analysis::medial::MedialBeat;
use cardiomorph::analysis::segments::{Segment, long_axis, segment};
use cardiomorph::analysis::thickening::{Thickening, WallThickening, thickening_of_segments};
use cardiomorph::io::read_mesh;
use cardiomorph::io::{Limits, open_paths};
use cardiomorph::mesh::{Point3, Vector3};
use cardiomorph::progress::Progress;
use cardiomorph::study::{Study, Subject};
use rayon::prelude::*;

use crate::shared::{shared_data, thickened};

/// Vertices of a ring of the meshes, and rings (SOURCE.md); the apex is the last vertex.
const AROUND: usize = 32;
const RINGS: usize = 15;

/// Apex, base, a point to the septum and one to the anterior wall of a heart of `acdc_walls`.
///
/// Septum: SOURCE.md says that angle 0 of the rings points to the right ventricle. Anterior wall: at right angles to it,
/// on the side of (apex → base) × septum, as in the body; so the frame of the meshes must not be a mirror. It is that of
/// the short-axis images, x to the left of the patient, y down to the diaphragm, z from apex to base, as the images
/// in `acdc` show (lungs above, liver and stomach below). The masks agree: from the middle to the base the right
/// ventricle turns to that side, that of its outflow, in 96 of 100 hearts.
fn landmarks(endo: &[Point3], epi: &[Point3]) -> [Point3; 4] {
    assert_eq!(
        (endo.len(), epi.len()),
        (AROUND * RINGS + 1, AROUND * RINGS + 1)
    );
    let centre = |points: &[Point3]| {
        Point3::from(points.iter().map(|p| p.coords).sum::<Vector3>() / points.len() as f64)
    };
    let (base, apex) = (centre(&endo[..AROUND]), epi[AROUND * RINGS]);
    let septum: Vector3 = (0..RINGS)
        .map(|ring| {
            let ring = &endo[AROUND * ring..AROUND * (ring + 1)];
            ring[0] - centre(ring)
        })
        .sum();
    let anterior = (base - apex).cross(&septum);
    [apex, base, base + septum, base + anterior]
}

/// The cohort with orientation: its own manifest with a line of landmarks more for each heart, beside the patterns of
/// the files where they lie.
fn oriented() -> Study {
    let folder = shared_data("acdc_walls");
    let manifest = fs::read_to_string(folder.join("study.toml")).unwrap();
    let mut lines = Vec::new();
    for line in manifest.lines() {
        let [key, value] = match line.split_once(" = ") {
            Some((key, value)) => [key, value.trim_matches('"')],
            None => [line, ""],
        };
        match key {
            "endo" | "epi" => lines.push(format!("{key} = \"{}\"", folder.join(value).display())),
            _ => lines.push(line.to_owned()),
        }
        if key == "id" {
            let [endo, epi] = ["endo", "epi"]
                .map(|side| vertices(&folder.join(value).join(format!("{side}_0.obj"))));
            let places = landmarks(&endo, &epi).map(|p| format!("[{}, {}, {}]", p.x, p.y, p.z));
            let [apex, base, septum, anterior] = places;
            lines.push(format!(
                "orientation = {{ apex = {apex}, base = {base}, septum = {septum}, anterior = {anterior} }}"
            ));
        }
    }
    let written = tempfile::tempdir().unwrap();
    let path = written.path().join("study.toml");
    fs::write(&path, lines.join("\n")).unwrap();
    let opened = open_paths(&[path], &Limits::default(), &Progress::default()).unwrap();
    assert!(opened.errors.is_empty(), "{:?}", opened.errors);
    assert_eq!(opened.study.subjects.len(), 100);
    opened.study
}

fn vertices(path: &Path) -> Vec<Point3> {
    let file = read_mesh("a.obj", &fs::read(path).unwrap(), &Limits::default()).unwrap();
    file.frames[0].vertices().to_vec()
}

fn with_label<'a>(study: &'a Study, label: &str) -> Vec<&'a Subject> {
    let subjects = study.subjects.iter().map(|subject| &**subject);
    subjects
        .filter(|subject| subject.label.as_deref() == Some(label))
        .collect()
}

fn all_thickened<'a>(hearts: &[&'a Subject]) -> Vec<(&'a Subject, MedialBeat, Thickening)> {
    (hearts.par_iter())
        .map(|&subject| {
            let (beat, found) = thickened(subject).unwrap();
            (subject, beat, found)
        })
        .collect()
}

/// The segment of each atom at end-diastole.
fn segments_of(subject: &Subject, beat: &MedialBeat, found: &Thickening) -> Vec<Option<Segment>> {
    let axis = long_axis(subject, found.end_diastole).unwrap();
    assert!(axis.is_oriented(), "{}", subject.id);
    (beat.frames[found.end_diastole].atoms.iter())
        .map(|atom| segment(&axis, atom.position))
        .collect()
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn each_infarcted_heart_has_patches_with_segments_area_and_centroid() {
    let study = oriented();
    let hearts = all_thickened(&with_label(&study, "MINF"));
    assert_eq!(hearts.len(), 20);
    println!(
        "heart, EF: share, area, centroid in mm, PT, stability: segments with their share of the patch"
    );
    let mut without = 0;
    for (subject, beat, found) in &hearts {
        let ef = 100.0 * measure_subject(subject).ef.unwrap();
        if found.patches.is_empty() {
            println!(
                "{}, {ef:.0} %: no patch, {:?}",
                subject.id, found.wall_thickening
            );
            assert_eq!(
                found.wall_thickening,
                WallThickening::HardlyAnywhere,
                "{}",
                subject.id
            );
            without += 1;
        }
        let told = segments_of(subject, beat, found);
        for patch in &found.patches {
            let area = patch.area_cm2.unwrap();
            let segments: Vec<String> = (patch.segments.iter())
                .map(|part| format!("{} {:.0} %", part.segment.name(), 100.0 * part.of_patch))
                .collect();
            let [x, y, z] = [patch.centroid.x, patch.centroid.y, patch.centroid.z];
            println!(
                "{}, {ef:.0} %: {:.0} %, {area:.1} cm², ({x:.0} {y:.0} {z:.0}), {:.2}, {:.2}: {}",
                subject.id,
                100.0 * patch.share,
                patch.thickening.exp(),
                patch.stability,
                segments.join(", ")
            );
            assert!((area - 0.01 * patch.share * found.regular_area).abs() < 1e-9 * area);
            // What lies above the base has no segment.
            let whole: f64 = patch.segments.iter().map(|part| part.of_patch).sum();
            assert!(whole > 0.9 && whole < 1.0 + 1e-9, "{}: {whole}", subject.id);
            for part in &patch.segments {
                let atoms = patch
                    .atoms
                    .iter()
                    .filter(|&&atom| told[atom as usize] == Some(part.segment));
                assert!(atoms.count() > 0, "{}: {:?}", subject.id, part.segment);
            }
            // It stands still beside the rest of the wall.
            assert!(patch.thickening < 0.5 * found.remote, "{}", subject.id);
        }
    }
    assert!(without <= 1, "{without}");
}

/// Hypertrophic hearts are thick at the septum: were it elsewhere, no group would be. Thickness of the septal segments over
/// that of the lateral ones, basal and mid.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn hypertrophy_is_thickest_where_the_landmarks_say_that_the_septum_is() {
    let study = oriented();
    let ratio = |label: &str| {
        let mut ratios: Vec<f64> = (all_thickened(&with_label(&study, label)).iter())
            .map(|(subject, beat, found)| {
                let places =
                    thickening_of_segments(beat, found, &segments_of(subject, beat, found));
                let mean = |numbers: [usize; 4]| {
                    let told = numbers.map(|n| places[n - 1].unwrap().thickness.end_diastole);
                    told.iter().sum::<f64>() / 4.0
                };
                mean([2, 3, 8, 9]) / mean([5, 6, 11, 12])
            })
            .collect();
        ratios.sort_by(f64::total_cmp);
        println!("{label}: septal over lateral thickness {ratios:.2?}");
        0.5 * (ratios[9] + ratios[10])
    };
    let [ill, well] = ["HCM", "NOR"].map(ratio);
    println!("medians: HCM {ill:.2}, NOR {well:.2}");
    assert!(ill > 1.1 && ill > well + 0.1, "{ill} {well}");
}
