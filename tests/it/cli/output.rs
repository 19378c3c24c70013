//! What is written and where: names of files, texts that spreadsheets and terminals obey, runs that fail, runs side by side.

use super::*;

/// Subjects with these ids and labels, all with the shape of one of the built-in cohort.
fn study_of(folder: &Path, subjects: &[(&str, &str)]) -> PathBuf {
    let place = folder.join("study");
    fs::create_dir(&place).unwrap();
    for entry in fs::read_dir(demo().join("N01")).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), place.join(entry.file_name())).unwrap();
    }
    let mut manifest = "name = \"test\"\nunits = \"mm\"\n".to_owned();
    for (id, label) in subjects {
        let [id, label] = [id, label].map(|text| serde_json::to_string(text).unwrap());
        manifest += &format!(
            "[[subject]]\nid = {id}\nlabel = {label}\nsurface = \"endo+epi\"\nendo = \"endo_*.ply\"\nepi = \"epi_*.ply\"\nrr_ms = 800.0\n"
        );
    }
    fs::write(place.join("study.toml"), manifest).unwrap();
    place
}

fn summary(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("summary.json")).unwrap()).unwrap()
}

fn analyze(study: &Path, out: &Path, more: &[&str]) -> Output {
    let options = ["analyze", text(study), "--out", text(out)];
    cardiomorph(&[&options[..], more].concat())
}

#[test]
fn every_subject_has_a_figure_of_its_own_whatever_its_id() {
    let folder = tempfile::tempdir().unwrap();
    let long = "x".repeat(300);
    let ids = [
        "ward/3",
        "ward-3",
        "ward:3",
        "../up",
        "CON",
        "ED",
        "ed",
        "Mu\u{308}ller",
        "M\u{fc}ller",
        "心脏",
        "שלום",
        "🫀",
        &long,
        "a. ",
        "line\nend",
    ];
    let study = study_of(folder.path(), &ids.map(|id| (id, "x")));
    let out = folder.path().join("out");
    let output = analyze(&study, &out, &[]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    if without_adapter(&output) {
        return;
    }
    let files = fs::read_dir(out.join("figures")).unwrap();
    let mut names: Vec<String> = (files.map(|entry| entry.unwrap().file_name()))
        .map(|name| name.into_string().unwrap())
        .collect();
    names.retain(|name| !name.ends_with("_patch.png"));
    let read = cardiomorph(&["info", text(&study), "--json"]);
    let read: Value = serde_json::from_slice(&read.stdout).unwrap();
    let subjects = read["subjects"].as_array().unwrap().len();
    assert!(subjects >= ids.len() - 1, "{subjects} of {}", ids.len());
    assert_eq!(names.len(), subjects, "{names:?}");
    let mut folded: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    folded.sort();
    folded.dedup();
    assert_eq!(
        folded.len(),
        subjects,
        "also on a disk without capitals: {names:?}"
    );
    assert!(names.iter().all(|name| name.len() < 140), "{names:?}");
    assert!(names.contains(&"ward-3.png".to_owned()) && names.contains(&"_CON.png".to_owned()));
    let listed = summary(&out)["figures"].clone();
    let of = |id: &str| {
        let figures = listed.as_array().unwrap().iter();
        let mut own = figures.filter(|figure| figure["subject"] == id);
        own.next().unwrap()["file"].as_str().unwrap().to_owned()
    };
    assert_eq!(of("ward-3"), "figures/ward-3.png");
    assert!(out.join(of("ward/3")).exists() && of("ward/3") != of("ward:3"));
    assert!(!folder.path().join("up.png").exists());
}

#[test]
fn names_in_letters_without_a_typeface_are_drawn_apart_and_reported() {
    let folder = tempfile::tempdir().unwrap();
    let study = study_of(
        folder.path(),
        &[("\u{10fff1}\u{10fff2}", "x"), ("\u{10fff3}\u{10fff4}", "x")],
    );
    let mut pictures = Vec::new();
    for (id, file) in [("\u{10fff1}\u{10fff2}", "a"), ("\u{10fff3}\u{10fff4}", "b")] {
        for ending in ["png", "svg", "pdf"] {
            let out = folder.path().join(format!("{file}.{ending}"));
            let options = [
                "figure",
                text(&study),
                "--subject",
                id,
                "--size",
                "400x320",
                "--out",
            ];
            let output = cardiomorph(&[&options[..], &[text(&out)]].concat());
            if without_adapter(&output) {
                return;
            }
            assert_eq!(code(&output), 0, "{}", said(&output));
            assert!(said(&output).contains("U+10FFF1"), "{}", said(&output));
            pictures.push(fs::read(out).unwrap());
        }
    }
    let [a_png, a_svg, _, b_png, b_svg, _] = &pictures[..] else {
        panic!("six pictures");
    };
    assert_ne!(a_png, b_png);
    let svg = |bytes: &Vec<u8>| String::from_utf8(bytes.clone()).unwrap();
    assert!(svg(a_svg).contains("<title>\u{10fff1}</title>"));
    assert_ne!(svg(a_svg), svg(b_svg));
}

#[test]
fn labels_are_no_formulas_and_nothing_moves_the_cursor() {
    let folder = tempfile::tempdir().unwrap();
    let subjects = [
        ("=1+1", "@SUM(A1)"),
        ("-2+3", "+1"),
        ("-7", "\tx\u{1b}[2J"),
        ("a", "-NOR"),
    ];
    let study = study_of(folder.path(), &subjects);
    let out = folder.path().join("out");
    let output = cardiomorph(&["measure", text(&study), "--out", text(&out)]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    let table = rows(&out.join("subjects.csv"));
    let cells =
        |column: usize| -> Vec<String> { table.iter().map(|row| row[column].to_owned()).collect() };
    assert_eq!(cells(0), ["'=1+1", "'-2+3", "-7", "a"]);
    assert_eq!(cells(1)[..2], ["'@SUM(A1)", "+1"]);
    assert_eq!(cells(1)[3], "'-NOR");
    assert!(
        cells(4)
            .iter()
            .all(|edv| edv.parse::<f64>().unwrap() > 10.0)
    );
    let text_of = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let info = cardiomorph(&["info", text(&study)]);
    let json = cardiomorph(&["info", text(&study), "--json"]);
    let printed = [&output.stdout, &output.stderr, &info.stdout, &json.stdout];
    for shown in printed.map(|bytes| String::from_utf8_lossy(bytes).into_owned()) {
        assert!(
            !shown.contains(|c: char| c.is_control() && c != '\n'),
            "{shown:?}"
        );
    }
    assert!(!text_of("subjects.csv").contains(['\t', '\u{1b}']));
}

#[test]
fn frames_have_their_time() {
    let folder = tempfile::tempdir().unwrap();
    let study = study_of(folder.path(), &[("a", "x")]);
    let out = folder.path().join("out");
    let output = cardiomorph(&["measure", text(&study), "--out", text(&out)]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    let times: Vec<f64> = (rows(&out.join("frames.csv")).iter())
        .map(|row| row[9].parse().unwrap())
        .collect();
    assert_eq!(times.len(), 8);
    assert!((times[0], times[4]) == (0.0, 0.4), "{times:?}");
}

#[test]
fn a_run_that_fails_leaves_what_it_did_says_what_is_missing_and_nothing_of_the_run_before() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, out) = (demo(), folder.path().join("out"));
    let output = analyze(whole, &out, &["--figures", "off"]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert_eq!(summary(&out)["complete"], true);
    assert!(out.join("verdicts.csv").exists());
    // A folder stands where a table must go.
    fs::remove_file(out.join("atoms.csv")).unwrap();
    fs::create_dir(out.join("atoms.csv")).unwrap();
    fs::write(out.join("atoms.csv/mine"), "mine").unwrap();
    let output = analyze(whole, &out, &["--figures", "off"]);
    assert_eq!(code(&output), 1, "{}", said(&output));
    assert!(said(&output).contains("atoms.csv"), "{}", said(&output));
    assert!(said(&output).contains("missing: "), "{}", said(&output));
    let said = summary(&out);
    assert_eq!(said["complete"], false);
    assert!(said["reason"].as_str().unwrap().contains("atoms.csv"));
    let missing = said["missing"].to_string();
    for name in ["atoms.csv", "verdicts.csv", "report.pdf"] {
        assert!(missing.contains(name), "{missing}");
    }
    for name in ["frames.csv", "distances.csv", "poses_smacof.csv"] {
        assert!(out.join(name).exists() && !missing.contains(name), "{name}");
    }
    assert!(!out.join("verdicts.csv").exists() && !out.join("report.pdf").exists());
    let leftover = |entry: fs::DirEntry| entry.path().extension() == Some("partial".as_ref());
    assert!(
        !fs::read_dir(&out)
            .unwrap()
            .any(|entry| leftover(entry.unwrap()))
    );
}

#[cfg(unix)]
#[test]
fn a_run_that_is_stopped_says_so_and_stands_beside_nothing_of_the_run_before() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, out) = (demo(), folder.path().join("out"));
    // A run may end before it is stopped; then another is begun.
    for _ in 0..5 {
        let output = analyze(whole, &out, &["--figures", "off"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        let arguments = ["analyze", "--figures", "off", "--threads", "1", "--out"];
        let mut second = Command::new(env!("CARGO_BIN_EXE_cardiomorph"))
            .args(arguments)
            .args([&out, whole])
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let begun = || {
            let text = fs::read_to_string(out.join("summary.json")).unwrap_or_default();
            text.contains("\"complete\": false")
        };
        while !begun() && second.try_wait().unwrap().is_none() {
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        let pid = second.id().to_string();
        Command::new("kill").args(["-INT", &pid]).status().unwrap();
        let ended = second.wait().unwrap();
        if ended.code() == Some(0) {
            continue;
        }
        assert_eq!(ended.code(), Some(3));
        let said = summary(&out);
        assert_eq!(said["complete"], false);
        let files = said["files"].as_array().unwrap();
        let mut listed: Vec<&str> = files.iter().map(|name| name.as_str().unwrap()).collect();
        listed.push("summary.json");
        let mut there: Vec<String> = fs::read_dir(&out)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        listed.sort_unstable();
        there.sort();
        assert_eq!(there, listed, "what stands there is of this run");
        let missing = said["missing"].to_string();
        assert!(missing.contains("verdicts.csv"), "{missing}");
        return;
    }
    panic!("five runs ended before they could be stopped");
}

#[test]
fn distances_are_left_out_or_written_for_numpy() {
    let folder = tempfile::tempdir().unwrap();
    let study = study_of(folder.path(), &[("a", "x"), ("b", "x"), ("c", "y")]);
    let out = folder.path().join("out");
    let run = |word| {
        let output = analyze(&study, &out, &["--figures", "off", "--distances", word]);
        assert_eq!(code(&output), 0, "{}", said(&output));
    };
    run("npy");
    assert!(!out.join("distances.csv").exists());
    let bytes = fs::read(out.join("distances.npy")).unwrap();
    let poses = rows(&out.join("poses_mds.csv")).len();
    assert_eq!(bytes.len(), 128 + 8 * poses * poses);
    let metric: Value =
        serde_json::from_slice(&fs::read(out.join("distances.json")).unwrap()).unwrap();
    assert_eq!(
        (&metric["table"], &metric["rows"]),
        (&"distances.npy".into(), &"poses_mds.csv".into())
    );
    run("none");
    for name in ["distances.csv", "distances.npy", "distances.json"] {
        assert!(!out.join(name).exists(), "{name}");
    }
}

#[test]
fn two_runs_into_one_folder_do_not_disturb_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let study = study_of(folder.path(), &[("a", "x"), ("b", "x"), ("c", "y")]);
    let out = folder.path().join("out");
    let options = [
        "analyze",
        text(&study),
        "--figures",
        "off",
        "--out",
        text(&out),
    ];
    let mut runs: Vec<_> = (0..2)
        .map(|_| {
            command(&options)
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        })
        .collect();
    for run in runs.drain(..) {
        let output = run.wait_with_output().unwrap();
        assert_eq!(code(&output), 0, "{}", said(&output));
    }
    assert_eq!(rows(&out.join("atoms.csv")).len() % 3, 0);
    assert_eq!(summary(&out)["complete"], true);
    let leftover = |entry: fs::DirEntry| entry.path().extension() == Some("partial".as_ref());
    assert!(
        !fs::read_dir(&out)
            .unwrap()
            .any(|entry| leftover(entry.unwrap()))
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_success_without_a_session_says_nothing_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a.png");
    let options = [
        "figure",
        text(demo()),
        "--size",
        "400x320",
        "--out",
        text(&out),
    ];
    let output = command(&options)
        .env_remove("XDG_RUNTIME_DIR")
        .output()
        .unwrap();
    assert!(
        !said(&output).contains("XDG_RUNTIME_DIR"),
        "{}",
        said(&output)
    );
}

#[test]
fn measure_into_the_folder_of_an_analysis_leaves_no_summary_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let study = study_of(folder.path(), &[("A", "x"), ("B", "y")]);
    let out = folder.path().join("out");
    assert_eq!(code(&analyze(&study, &out, &["--figures", "off"])), 0);
    fs::write(out.join("notes.csv"), "mine").unwrap();
    assert!(out.join("summary.json").exists() && out.join("verdicts.csv").exists());
    let output = cardiomorph(&["measure", text(&study), "--out", text(&out)]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    let entries = fs::read_dir(&out).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let expected = ["columns.md", "frames.csv", "notes.csv", "subjects.csv"];
    assert_eq!(names, expected);
}
