//! Input that cannot be used, wrong words, and readers that go away.

use super::*;

#[test]
fn unusable_input_is_one_and_wrong_usage_is_two() {
    let folder = tempfile::tempdir().unwrap();
    let out = text(folder.path()).to_owned() + "/out.csv";
    let picture = text(folder.path()).to_owned() + "/out.png";
    let broken = folder.path().join("broken_0.ply");
    fs::write(&broken, "ply\nformat ascii 1.0\nelement vertex 3\n").unwrap();
    let crooked = folder.path().join("crooked.csv");
    fs::write(&crooked, "0,1\n2,0\n").unwrap();
    let demo = text(demo()).to_owned();
    let cases: &[(&[&str], i32, &str)] = &[
        (&["info", "/nowhere/at/all"], 1, "unusable"),
        (&["info", text(&broken)], 1, "unusable"),
        (
            &["measure", text(&broken), "--out", &out],
            1,
            "broken_0.ply",
        ),
        (
            &[
                "embed",
                text(&crooked),
                "--input",
                "distances",
                "--out",
                &out,
            ],
            1,
            "row 0, column 1",
        ),
        (
            &["metric", "/nowhere.ply", "/nowhere.ply"],
            1,
            "/nowhere.ply",
        ),
        (
            &["figure", &demo, "--subject", "X", "--out", &picture],
            2,
            "no such subject",
        ),
        (
            &["figure", &demo, "--out", &out],
            2,
            "must end in .png, .svg or .pdf",
        ),
        (
            &["figure", &demo, "--frame", "8", "--out", &picture],
            2,
            "frames 0 to 7",
        ),
        (
            &["figure", &demo, "--size", "9x9", "--out", &picture],
            2,
            "320x240",
        ),
        (
            &[
                "embed",
                text(&crooked),
                "--input",
                "distances",
                "--method",
                "pca",
                "--out",
                &out,
            ],
            2,
            "pca",
        ),
        (&["embed", text(&crooked), "--out", &out], 2, "--input"),
        (
            &["demo", "--vertices", "50", "--out", &out],
            2,
            "50 vertices",
        ),
        (&["info"], 2, "PATH"),
        (&["--threads", "0", "info", &demo], 2, "threads"),
        (&["measure", &demo], 2, "--out"),
    ];
    for (arguments, expected, words) in cases {
        let output = cardiomorph(arguments);
        assert_eq!(code(&output), *expected, "{arguments:?}: {}", said(&output));
        assert!(
            said(&output).contains(words),
            "{arguments:?}: {}",
            said(&output)
        );
        assert!(
            output.stdout.is_empty() || arguments[0] == "info",
            "{arguments:?}"
        );
    }
    assert!(!Path::new(&out).exists());
}

#[test]
fn one_broken_file_does_not_take_the_other_hearts_with_it() {
    let folder = tempfile::tempdir().unwrap();
    for (case, from) in [("a", "N01"), ("b", "N02")] {
        let to = folder.path().join(case);
        fs::create_dir(&to).unwrap();
        for entry in fs::read_dir(demo().join(from)).unwrap() {
            let entry = entry.unwrap();
            fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
        }
    }
    fs::write(folder.path().join("b/endo_004.ply"), "ply\nnonsense\n").unwrap();
    let output = cardiomorph(&["info", text(folder.path()), "--json"]);
    assert_eq!(code(&output), 1);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["subjects"][0]["id"], "a");
    assert_eq!(found["subjects"][0]["frames"], 8);
    let errors = found["errors"].to_string();
    assert!(errors.contains("endo_004.ply"), "{errors}");
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let mut child = command(&["info", text(demo())])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
