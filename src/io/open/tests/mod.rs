//! Paths of every kind, small and made on the spot.

mod faults;
mod habits;
mod images;
#[cfg(unix)]
mod links;
mod stages;

use std::fs;

use super::*;
use crate::io::write_obj;
use crate::mesh::{Point3, TriMesh, phantom};
use crate::study::{Severity, SurfaceKind};
use crate::units::LengthUnit;

fn ball(radius: f64) -> TriMesh {
    phantom::sphere(1, radius)
}

fn put(folder: &Path, name: &str, mesh: &TriMesh) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let mut bytes = Vec::new();
    write_obj(&mut bytes, mesh).unwrap();
    fs::write(path, bytes).unwrap();
}

fn open(paths: &[PathBuf]) -> Opened {
    open_paths(paths, &Limits::default(), &Progress::default()).unwrap()
}

fn ids(opened: &Opened) -> Vec<&str> {
    opened
        .study
        .subjects
        .iter()
        .map(|s| s.id.as_str())
        .collect()
}

/// Radius of each frame, to see their order.
fn radii(opened: &Opened, subject: usize) -> Vec<f64> {
    let surface = &opened.study.subjects[subject].sequence.surfaces()[0];
    surface
        .frames()
        .iter()
        .map(|mesh| mesh.vertices()[0].coords.norm().round())
        .collect()
}

#[test]
fn a_folder_of_folders_is_a_cohort_and_other_files_are_passed_over() {
    let root = tempfile::tempdir().unwrap();
    for (subject, factor) in [("p10", 1.0), ("p2", 1.1)] {
        for frame in [10, 9, 8] {
            let radius = factor * f64::from(20 + frame);
            put(
                root.path(),
                &format!("{subject}/endo_g{frame}.obj"),
                &ball(radius),
            );
            put(
                root.path(),
                &format!("{subject}/epi_g{frame}.obj"),
                &ball(radius + 9.0),
            );
        }
    }
    fs::write(root.path().join("subjects.csv"), "id,ef\np2,0.6\n").unwrap();
    fs::write(root.path().join("p2/notes.md"), "# hello").unwrap();
    fs::write(root.path().join("p2/index.csv"), "0\n1\n2\n").unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(opened.errors, []);
    assert_eq!(ids(&opened), ["p2", "p10"]);
    assert_eq!(radii(&opened, 1), [28.0, 29.0, 30.0]);
    assert_eq!(opened.study.subjects[0].unit, LengthUnit::Millimetre);
    assert_eq!(
        opened.notices,
        [Notice::info(
            "both subjects have the same faces: their vertices correspond"
        )]
    );
}

#[test]
fn a_manifest_rules_its_folder() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..3 {
        put(
            root.path(),
            &format!("n01/x{frame}.obj"),
            &ball(30.0 - f64::from(frame)),
        );
        put(
            root.path(),
            &format!("n02/cavity_{frame}.obj"),
            &ball(31.0 - f64::from(frame)),
        );
    }
    let manifest = root.path().join("study.toml");
    fs::write(
        &manifest,
        "name = \"Trial\"\nunits = \"mm\"\n\n[[subject]]\nid = \"one\"\nlabel = \"normal\"\ncavity = \"n01/*.obj\"\n\
         time_ms = [0, 300, 600]\nend_systole = 2\n\n[[subject]]\nid = \"two\"\nwall = \"n03/*.obj\"\n\n\
         [[subject]]\nid = \"n02\"\nend_systole = 7\ntime_ms = [0, 300]\n",
    )
    .unwrap();
    for path in [root.path().to_owned(), manifest.clone()] {
        let opened = open(&[path]);
        assert_eq!(opened.study.name, "Trial");
        assert_eq!(ids(&opened), ["one", "n02"]);
        assert_eq!(
            opened.errors[0].to_string(),
            format!(
                "line 11: no file matches \"n03/*.obj\": {}",
                manifest.display()
            )
        );
        assert_eq!(opened.errors.len(), 1);
        let one = &opened.study.subjects[0];
        assert_eq!(one.timing.frame_times_s, Some(vec![0.0, 0.3, 0.6]));
        assert_eq!((one.end_diastole, one.end_systole), (None, Some(2)));
        assert_eq!(one.label.as_deref(), Some("normal"));
        let found = &opened.study.subjects[1];
        assert_eq!(found.end_systole, None);
        let warnings: Vec<&str> = found
            .notices
            .iter()
            .filter(|n| n.severity == Severity::Warning)
            .map(|n| n.text.as_str())
            .collect();
        assert_eq!(
            warnings,
            [
                "2 times for 3 frames: times are ignored",
                "end-systole is set to frame 7, but the last frame is 2; it is computed from the volumes"
            ]
        );
    }
}

#[test]
fn centimetres_become_millimetres_with_a_notice() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "a/cavity_0.obj", &ball(3.0));
    fs::write(root.path().join("study.toml"), "units = \"cm\"\n").unwrap();
    let opened = open(&[root.path().to_owned()]);
    let subject = &opened.study.subjects[0];
    assert_eq!(subject.unit, LengthUnit::Millimetre);
    assert_eq!(radii(&opened, 0), [30.0]);
    assert!(
        subject
            .notices
            .iter()
            .any(|n| n.text.contains("multiplied by 10"))
    );
}

#[test]
fn files_and_folders_dropped_together_are_one_study() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "loose/endo_1.obj", &ball(20.0));
    put(root.path(), "loose/epi_1.obj", &ball(30.0));
    put(root.path(), "loose/endo_2.obj", &ball(18.0));
    put(root.path(), "folder/cavity_1.obj", &ball(30.0));
    let at = |name: &str| root.path().join(name);
    let opened = open(&[at("loose/epi_1.obj"), at("folder"), at("loose/endo_1.obj")]);
    assert_eq!(opened.errors, []);
    assert_eq!(ids(&opened), ["folder", "loose"]);
    assert_eq!(opened.study.subjects[1].sequence.surfaces().len(), 2);
    assert_eq!(opened.study.subjects[1].sequence.frame_count(), 1);
    let single = open(&[at("loose/endo_2.obj")]);
    assert_eq!(
        (ids(&single), single.study.name.as_str()),
        (vec!["endo_2"], "endo_2")
    );
}

#[test]
fn sheets_may_lie_in_folders_of_their_own() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..2 {
        put(root.path(), &format!("p1/endo/{frame}.obj"), &ball(20.0));
        put(root.path(), &format!("p1/epi/{frame}.obj"), &ball(30.0));
    }
    let opened = open(&[root.path().join("p1")]);
    assert_eq!((ids(&opened), opened.errors.len()), (vec!["p1"], 0));
    assert_eq!(
        opened.study.subjects[0].sequence.surfaces()[1].kind(),
        SurfaceKind::Epicardium
    );
}

#[test]
fn a_series_file_gives_order_and_times() {
    let root = tempfile::tempdir().unwrap();
    for (name, radius) in [("cavity_b.obj", 28.0), ("cavity_a.obj", 30.0)] {
        put(root.path(), name, &ball(radius));
    }
    let list = "{\"files\": [{\"name\": \"cavity_b.obj\", \"time\": 0.25}, {\"name\": \"cavity_a.obj\", \"time\": 0}]}";
    fs::write(root.path().join("heart.obj.series"), list).unwrap();
    for path in [root.path().to_owned(), root.path().join("heart.obj.series")] {
        let opened = open(&[path]);
        assert_eq!(opened.errors, []);
        assert_eq!(radii(&opened, 0), [30.0, 28.0]);
        let subject = &opened.study.subjects[0];
        assert_eq!(subject.sequence.surfaces()[0].kind(), SurfaceKind::Cavity);
        assert_eq!(subject.timing.frame_times_s, Some(vec![0.0, 0.25]));
    }
}

#[test]
fn morph_targets_of_one_file_are_frames() {
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":2}]}]}],
        "buffers":[{"byteLength":78,"uri":"data:application/octet-stream;base64,BYTES"}],
        "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":72,"byteLength":6},
        {"buffer":0,"byteOffset":36,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
        {"bufferView":2,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,2]}]}"#;
    let rest = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let moves = [0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0];
    let mut bytes: Vec<u8> = rest
        .iter()
        .chain(&moves)
        .flat_map(|x: &f32| x.to_le_bytes())
        .collect();
    bytes.extend([0_u16, 1, 2].iter().flat_map(|i| i.to_le_bytes()));
    use base64::Engine;
    let text = base64::engine::general_purpose::STANDARD.encode(bytes);
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("lv_endo.gltf");
    fs::write(&path, gltf.replace("BYTES", &text)).unwrap();
    let opened = open(std::slice::from_ref(&path));
    assert_eq!(opened.errors, []);
    let sequence = &opened.study.subjects[0].sequence;
    assert_eq!(sequence.surfaces()[0].kind(), SurfaceKind::Endocardium);
    assert_eq!(sequence.frame_count(), 2);
    assert_eq!(sequence.pose(1).unwrap()[1], Point3::new(1.0, 0.0, 2.0));
}

#[test]
fn subjects_of_one_name_are_told_apart() {
    let root = tempfile::tempdir().unwrap();
    for patient in ["p1", "p2"] {
        put(
            root.path(),
            &format!("{patient}/rest/cavity_0.obj"),
            &ball(30.0),
        );
    }
    assert_eq!(
        ids(&open(&[root.path().to_owned()])),
        ["p1/rest", "p2/rest"]
    );
    fs::write(
        root.path().join("study.toml"),
        "[[subject]]\nid = \"x\"\ncavity = \"p1/rest/*.obj\"\n[[subject]]\nid = \"x\"\ncavity = \"p2/rest/*.obj\"\n",
    )
    .unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(ids(&opened), ["x", "x (2)"]);
    assert!(
        opened.study.subjects[1].notices[0]
            .text
            .contains("another subject")
    );
}
