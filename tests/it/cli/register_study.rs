//! `register --template` from outside: frames of different meshes become a study in correspondence.

use std::fs;
use std::path::Path;

use cardiomorph::io::write_obj;
use cardiomorph::mesh::{Decimation, Faces, TriMesh, phantom};
use cardiomorph::study::built_in::{BuiltInParams, cohort};

use super::{cardiomorph, code, json_of, said, text};

/// One subject with two frames of both surfaces, each decimated for itself, with its vertices in reverse.
fn loose_frames(folder: &Path) {
    let params = BuiltInParams {
        vertices: 5_000,
        ..BuiltInParams::default()
    };
    let study = cohort(&params).unwrap().study;
    let subject = folder.join("S1");
    fs::create_dir(&subject).unwrap();
    for (surface, name) in study.subjects[3]
        .sequence
        .surfaces()
        .iter()
        .zip(["endo", "epi"])
    {
        for (frame, mesh) in surface.frames()[..2].iter().enumerate() {
            let coarse =
                Decimation::new(mesh.vertices(), mesh.faces(), 1_400 + 100 * frame, || true);
            let coarse = coarse.unwrap();
            let mut points = coarse.restricted(mesh.vertices());
            points.reverse();
            let last = points.len() as u32 - 1;
            let faces = coarse.faces().triangles().iter();
            let faces = Faces::new(points.len(), faces.map(|t| t.map(|v| last - v)).collect());
            let mesh = TriMesh::new(points, faces.unwrap()).unwrap();
            let mut bytes = Vec::new();
            write_obj(&mut bytes, &mesh).unwrap();
            fs::write(subject.join(format!("{name}_{frame:02}.obj")), bytes).unwrap();
        }
    }
}

#[test]
fn frames_that_do_not_correspond_are_refused_with_the_way_out_which_then_works() {
    let [loose, made] = [0; 2].map(|_| tempfile::tempdir().unwrap());
    loose_frames(loose.path());
    let refused = cardiomorph(&["info", text(loose.path())]);
    assert_eq!(code(&refused), 1);
    let reason = String::from_utf8_lossy(&refused.stdout);
    assert!(reason.contains("register"), "{reason}");
    let answer = json_of(&cardiomorph(&[
        "register",
        text(loose.path()),
        "--template",
        "built-in",
        "--out",
        text(made.path()),
        "--json",
    ]));
    assert_eq!(answer["template"], "N01");
    assert_eq!(answer["subjects"][0]["frames"], 2);
    let table = fs::read_to_string(made.path().join("fit.csv")).unwrap();
    let head = "subject,frame,surface,mean_mm,p95_mm,foldovers,volume_ml,mask_volume_ml";
    assert_eq!(table.lines().next(), Some(head));
    assert_eq!(table.lines().count(), 5);
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |cell: usize| cells[cell].parse::<f64>().unwrap();
        assert!(number(3) < 0.1 && number(4) < 0.3, "{row}");
        assert_eq!(cells[5], "0", "{row}");
        assert!((number(6) / number(7) - 1.0).abs() < 0.01, "{row}");
    }
    let manifest = made.path().join("study.toml");
    let info = json_of(&cardiomorph(&["info", text(&manifest), "--json"]));
    assert_eq!(info["subjects"][0]["frames"], 2);
}

#[test]
fn a_study_that_cannot_be_registered_is_refused_with_a_reason() {
    let [input, out] = [0; 2].map(|_| tempfile::tempdir().unwrap());
    let mut bytes = Vec::new();
    write_obj(&mut bytes, &phantom::sphere(3, 30.0)).unwrap();
    let ball = input.path().join("endo_00.obj");
    fs::write(&ball, &bytes).unwrap();
    let result = out.path().join("made");
    for (arguments, expected, reason) in [
        (vec!["--template", "built-in"], 1, "mark both"),
        (vec!["--template", text(&ball)], 1, "of the template"),
        (vec!["--template", "/nowhere.ply"], 1, "/nowhere.ply"),
        (
            vec!["--template", "built-in", "--method", "icp"],
            2,
            "--method",
        ),
        (vec![], 2, "--method"),
    ] {
        let mut all = vec!["register", text(input.path()), "--out", text(&result)];
        all.extend(&arguments);
        let ran = cardiomorph(&all);
        assert_eq!(code(&ran), expected, "{arguments:?}: {}", said(&ran));
        assert!(said(&ran).contains(reason), "{arguments:?}: {}", said(&ran));
        assert!(!result.exists());
    }
}
