//! What people's folders look like: copies, links, lists beside their files, names of other systems.

use super::*;

pub(super) fn reports(opened: &Opened, words: &str) -> bool {
    let of_subjects = opened
        .study
        .subjects
        .iter()
        .flat_map(|subject| &subject.notices);
    opened
        .notices
        .iter()
        .chain(of_subjects)
        .any(|notice| notice.text.contains(words))
}

fn frames(opened: &Opened) -> Vec<usize> {
    let subjects = opened.study.subjects.iter();
    subjects
        .map(|subject| subject.sequence.frame_count())
        .collect()
}

fn csv(mesh: &TriMesh) -> String {
    let points = mesh
        .vertices()
        .iter()
        .map(|p| format!("v,{},{},{}\n", p.x, p.y, p.z));
    let faces = mesh
        .triangles()
        .iter()
        .map(|[a, b, c]| format!("f,{a},{b},{c}\n"));
    points.chain(faces).collect()
}

fn put_csv(folder: &Path, frame: usize) {
    let text = csv(&ball(30.0 - frame as f64));
    fs::write(folder.join(format!("endo_{frame}.csv")), text).unwrap();
}

#[test]
fn a_table_among_frames_that_cannot_be_read_costs_its_subject_and_is_named() {
    for damage in ["nan", "empty", "bars", "words"] {
        let root = tempfile::tempdir().unwrap();
        (0..4).for_each(|frame| put_csv(root.path(), frame));
        let path = root.path().join("endo_2.csv");
        let text = fs::read_to_string(&path).unwrap();
        let damaged = match damage {
            "nan" => text.replacen("v,", "v,nan,", 1),
            "empty" => String::new(),
            "bars" => text.replace(',', "|"),
            _ => "<html>not found</html>".to_owned(),
        };
        fs::write(&path, damaged).unwrap();
        fs::write(root.path().join("volumes.csv"), "frame,ml\n0,74\n").unwrap();
        let opened = open(&[root.path().to_owned()]);
        assert!(opened.study.subjects.is_empty(), "{damage}");
        assert_eq!(opened.errors.len(), 1, "{damage}: {:?}", opened.errors);
        assert_eq!(opened.errors[0].path, path, "{damage}");
    }
}

#[test]
fn a_copy_of_a_frame_is_no_frame_and_is_told() {
    let root = tempfile::tempdir().unwrap();
    for name in [
        "endo_0.obj",
        "endo_1.obj",
        "endo_1 (1).obj",
        "._endo_0.obj",
        ".DS_Store",
    ] {
        put(
            root.path(),
            name,
            &ball(if name == "endo_0.obj" { 30.0 } else { 25.0 }),
        );
    }
    let opened = open(&[root.path().to_owned()]);
    assert_eq!((frames(&opened), opened.errors.len()), (vec![2], 0));
    assert!(reports(&opened, "endo_1 (1).obj is not read"));
    let toml = "[[subject]]\nid = \"a\"\nendo = \"endo_*.obj\"\n";
    fs::write(root.path().join("study.toml"), toml).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(frames(&opened), [2]);
    assert!(reports(&opened, "endo_1 (1).obj is not read"));
}

#[test]
fn a_packed_frame_is_told() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "endo_0.obj", &ball(30.0));
    put(root.path(), "endo_1.obj", &ball(29.0));
    fs::write(root.path().join("endo_2.obj.gz"), "x").unwrap();
    fs::write(root.path().join("endo_1.obj.gz"), "x").unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert!(reports(&opened, "endo_2.obj.gz is not read"));
    assert!(!reports(&opened, "endo_1.obj.gz"));
}

#[test]
fn a_list_beside_the_folder_of_its_files_is_one_subject() {
    let root = tempfile::tempdir().unwrap();
    let entry = |time: &str, part: usize, file: &str| {
        format!("<DataSet timestep=\"{time}\" part=\"{part}\" file=\"{file}\"/>\n")
    };
    let mut entries = String::new();
    for (frame, time) in [(0, "0"), (1, "0.4")] {
        for (part, surface, radius) in [(0, "endo", 20.0), (1, "epi", 30.0)] {
            let name = format!("heart/{surface}_{frame}.obj");
            put(root.path(), &name, &ball(radius + frame as f64));
            entries += &entry(time, part, &name);
        }
    }
    let text = format!("<VTKFile><Collection>{entries}</Collection></VTKFile>");
    fs::write(root.path().join("heart.pvd"), &text).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(
        (frames(&opened), opened.errors.as_slice()),
        (vec![2], &[][..])
    );
    assert_eq!(opened.study.subjects[0].sequence.surfaces().len(), 2);
    // the list in the folder below its files
    let inner = text.replace("heart/", "../heart/");
    fs::create_dir(root.path().join("z")).unwrap();
    fs::rename(
        root.path().join("heart.pvd"),
        root.path().join("z/heart.pvd"),
    )
    .unwrap();
    fs::write(root.path().join("z/heart.pvd"), &inner).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(
        (frames(&opened), opened.errors.as_slice()),
        (vec![2], &[][..])
    );
    // a second list of the same files
    fs::write(root.path().join("z/second.pvd"), inner).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(frames(&opened), [2]);
    assert!(reports(&opened, "they are read once"));
}

#[test]
fn files_of_a_list_that_cannot_be_used_are_no_subject_of_their_own() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "endo_0.obj", &ball(30.0));
    put(root.path(), "endo_2.obj", &ball(29.0));
    let list = "{\"files\":[{\"name\":\"endo_0.obj\",\"time\":0},\n{\"name\":\"endo_1.obj\",\"time\":0.1},\n{\"name\":\"endo_2.obj\",\"time\":0.2}]}";
    fs::write(root.path().join("endo.obj.series"), list).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert!(opened.study.subjects.is_empty());
    assert_eq!(opened.errors.len(), 1);
    assert_eq!(
        opened.errors[0].reason,
        "line 2: there is no file \"endo_1.obj\""
    );
}

#[test]
fn surfaces_of_a_manifest_are_paired_by_frame_and_not_by_place() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..4 {
        put(
            root.path(),
            &format!("endo_{frame}.obj"),
            &ball(20.0 - f64::from(frame)),
        );
        put(
            root.path(),
            &format!("epi_{frame}.obj"),
            &ball(30.0 - f64::from(frame)),
        );
    }
    let opened = |endo: &str, epi: &str| {
        let toml = format!("[[subject]]\nid = \"a\"\nendo = {endo}\nepi = {epi}\n");
        fs::write(root.path().join("study.toml"), toml).unwrap();
        open(&[root.path().to_owned()])
    };
    let apart = opened("\"endo_[0-2].obj\"", "\"epi_[1-3].obj\"");
    assert_eq!(
        apart.errors[0].reason,
        "line 1: epicardium has no file 0, which endocardium has"
    );
    let listed = opened(
        "[\"endo_0.obj\", \"endo_1.obj\"]",
        "[\"epi_1.obj\", \"epi_2.obj\"]",
    );
    assert!(listed.study.subjects.is_empty());
    let swapped = opened(
        "[\"endo_0.obj\", \"endo_1.obj\"]",
        "[\"epi_1.obj\", \"epi_0.obj\"]",
    );
    assert!(swapped.errors[0].reason.contains("different orders"));
    let twice = opened(
        "[\"endo_*.obj\", \"endo_0.obj\", \"endo_?.obj\"]",
        "\"epi_*.obj\"",
    );
    assert!(
        !twice.errors.is_empty(),
        "a file that is named again is a frame again"
    );
    let overlapping = opened("[\"endo_*.obj\", \"endo_?.obj\"]", "\"epi_*.obj\"");
    assert_eq!(frames(&overlapping), [4]);
    assert!(reports(&overlapping, "read once"));
}

#[test]
fn a_manifest_names_its_phases_and_times_by_the_files_too() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "endo_ES.obj", &ball(20.0));
    for (place, time) in ["0.0", "0.05", "0.1", "0.15"].iter().enumerate() {
        put(
            root.path(),
            &format!("wall_{time}.obj"),
            &ball(30.0 - place as f64),
        );
    }
    let toml = "[[subject]]\nid = \"a\"\nendo = \"endo_*.obj\"\n[[subject]]\nid = \"b\"\ncavity = \"wall_*.obj\"\n";
    fs::write(root.path().join("study.toml"), toml).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(opened.errors, []);
    let [first, second] = [&opened.study.subjects[0], &opened.study.subjects[1]];
    assert_eq!((first.end_diastole, first.end_systole), (None, Some(0)));
    assert_eq!(radii(&opened, 1), [30.0, 29.0, 28.0, 27.0]);
    assert_eq!(
        second.timing.frame_times_s,
        Some(vec![0.0, 0.05, 0.1, 0.15])
    );
    assert!(reports(&opened, "times in the file names read as s"));
}

#[test]
fn one_heart_under_two_ids_is_told_and_read_once() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "a_0.obj", &ball(30.0));
    put(root.path(), "b_0.obj", &ball(30.0));
    put(root.path(), "c_0.obj", &ball(31.0));
    let subject =
        |id: &str, file: &str| format!("[[subject]]\nid = \"{id}\"\ncavity = \"{file}\"\n");
    let toml = [
        ("x", "a_0.obj"),
        ("y", "a_0.obj"),
        ("z", "b_0.obj"),
        ("w", "c_0.obj"),
    ]
    .map(|(id, file)| subject(id, file))
    .concat();
    fs::write(root.path().join("study.toml"), toml).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert!(
        reports(&opened, "the same meshes under several ids: x = y = z;"),
        "{:?}",
        opened.notices
    );
}

#[test]
fn a_name_composed_in_another_way_is_the_same_name() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "Mu\u{308}ller/endo_0.obj", &ball(30.0));
    put(root.path(), "Mu\u{308}ller/endo_1.obj", &ball(29.0));
    for pattern in ["M\u{fc}ller/endo_*.obj", "M\u{fc}*/endo_?.obj"] {
        let toml = format!("[[subject]]\nid = \"a\"\nendo = \"{pattern}\"\n");
        fs::write(root.path().join("study.toml"), toml).unwrap();
        assert_eq!(frames(&open(&[root.path().to_owned()])), [2], "{pattern}");
    }
    fs::write(
        root.path().join("study.toml"),
        "[[subject]]\nid = \"M\u{fc}ller\"\n",
    )
    .unwrap();
    assert_eq!(ids(&open(&[root.path().to_owned()])), ["M\u{fc}ller"]);
    fs::remove_file(root.path().join("study.toml")).unwrap();
    assert_eq!(ids(&open(&[root.path().to_owned()])), ["M\u{fc}ller"]);
}

#[test]
fn patients_and_folders_named_as_surfaces_or_chambers_are_told_apart() {
    let root = tempfile::tempdir().unwrap();
    for patient in ["Endo", "Miller"] {
        put(
            root.path(),
            &format!("cohort/{patient}/endo_0.obj"),
            &ball(20.0),
        );
        put(
            root.path(),
            &format!("cohort/{patient}/epi_0.obj"),
            &ball(30.0),
        );
    }
    assert_eq!(
        ids(&open(&[root.path().join("cohort")])),
        ["Endo", "Miller"]
    );
    for side in ["LV", "RV"] {
        put(root.path(), &format!("p1/{side}/endo_0.obj"), &ball(20.0));
        put(root.path(), &format!("p1/{side}/endo_1.obj"), &ball(18.0));
    }
    let opened = open(&[root.path().join("p1")]);
    assert_eq!((ids(&opened), frames(&opened)), (vec!["p1"], vec![2]));
    assert!(
        reports(&opened, "2 files of the right ventricle not read"),
        "{opened:?}"
    );
    for surface in ["endo", "epi"] {
        for patient in ["a", "b"] {
            let radius = if surface == "endo" { 20.0 } else { 30.0 };
            put(
                root.path(),
                &format!("turned/{surface}/{patient}/0.obj"),
                &ball(radius),
            );
        }
    }
    let opened = open(&[root.path().join("turned")]);
    assert_eq!(ids(&opened), ["a", "b"]);
    assert_eq!(opened.study.subjects[0].sequence.surfaces().len(), 2);
}

#[test]
fn folders_named_by_frames_hold_the_frames_of_one_subject() {
    for names in [
        ["ED", "ES"],
        ["frame_0", "frame_1"],
        ["0.0", "0.1"],
        ["0ms", "40ms"],
        ["phase 1", "phase 2"],
    ] {
        let root = tempfile::tempdir().unwrap();
        for (frame, name) in names.iter().enumerate() {
            for (surface, radius) in [("endo", 20.0), ("epi", 30.0)] {
                let mesh = ball(radius - frame as f64);
                put(root.path(), &format!("p1/{name}/{surface}.obj"), &mesh);
                put(root.path(), &format!("p2/{name}/{surface}.obj"), &mesh);
            }
        }
        let opened = open(&[root.path().to_owned()]);
        assert_eq!(ids(&opened), ["p1", "p2"], "{names:?}: {:?}", opened.errors);
        let subject = &opened.study.subjects[0];
        assert_eq!(
            (
                subject.sequence.frame_count(),
                subject.sequence.surfaces().len()
            ),
            (2, 2)
        );
        let first = subject.sequence.surfaces()[0].frames()[0].vertices()[0]
            .coords
            .norm();
        let second = subject.sequence.surfaces()[0].frames()[1].vertices()[0]
            .coords
            .norm();
        assert!(first > second, "{names:?}");
    }
    // Numbers alone may be patients.
    let root = tempfile::tempdir().unwrap();
    for patient in ["1", "2"] {
        put(root.path(), &format!("{patient}/endo.obj"), &ball(20.0));
    }
    assert_eq!(ids(&open(&[root.path().to_owned()])), ["1", "2"]);
}
