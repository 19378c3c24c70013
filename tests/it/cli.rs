//! The headless door from outside: options, exit codes, columns, keys, and the same bytes for any number of threads.

#[cfg(test)]
mod columns;
mod curvature;
#[cfg(test)]
mod figures;
#[cfg(test)]
mod image;
#[cfg(test)]
mod learn;
#[cfg(test)]
mod medial;
#[cfg(test)]
pub mod mesh;
#[cfg(test)]
mod mesh_images;
mod metrics;
#[cfg(test)]
mod noise_medial;
#[cfg(test)]
mod output;
#[cfg(test)]
pub mod patch_figures;
#[cfg(test)]
mod refusals;
#[cfg(test)]
mod register;
#[cfg(test)]
mod register_study;
#[cfg(test)]
mod shape_space;
#[cfg(test)]
mod walls;
#[cfg(test)]
mod wrong_numbers;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use serde_json::Value;

fn cardiomorph(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cardiomorph"));
    command.args(arguments).stdin(Stdio::null());
    for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(variable);
    }
    command.env("XDG_RUNTIME_DIR", std::env::temp_dir());
    command
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn json_of(output: &Output) -> Value {
    assert_eq!(code(output), 0, "{}", said(output));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The built-in cohort on disk, coarse, written once for all tests.
fn demo() -> &'static Path {
    static DEMO: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = DEMO.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("demo");
        let out = path.to_str().unwrap();
        let output = cardiomorph(&["demo", "--out", out, "--vertices", "300", "--seed", "7"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        (folder, path)
    });
    path
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

fn header(path: &Path) -> Vec<String> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect()
}

fn rows(path: &Path) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.records().map(Result::unwrap).collect()
}

/// Whether figures cannot be drawn here; says so.
fn without_adapter(output: &Output) -> bool {
    let none = said(output).contains("no graphics adapter");
    if none {
        println!("skipped: no graphics adapter, not even a software one");
    }
    none
}

#[test]
fn info_lists_what_was_written_by_demo() {
    let found = json_of(&cardiomorph(&["info", text(demo()), "--json"]));
    let subjects = found["subjects"].as_array().unwrap();
    assert_eq!(subjects.len(), 23);
    assert_eq!(found["errors"].as_array().unwrap().len(), 0);
    let first = &subjects[0];
    assert_eq!(first["id"], "N01");
    assert_eq!(first["label"], "normal");
    assert_eq!(first["frames"], 8);
    assert_eq!(first["surfaces"][0], "endocardium");
    assert!(first["vertices"].as_u64().unwrap() <= 300);
    assert!(first["faces"].as_u64().unwrap() > 0);
    assert!(first["notices"].is_array());
}

#[test]
fn every_format_of_demo_is_read_back_as_the_same_hearts() {
    let folder = tempfile::tempdir().unwrap();
    let mut volumes = Vec::new();
    for format in ["ply", "obj", "vtp"] {
        let out = folder.path().join(format);
        let options = [
            "demo",
            "--vertices",
            "200",
            "--format",
            format,
            "--out",
            text(&out),
        ];
        let output = cardiomorph(&options);
        assert_eq!(code(&output), 0, "{}", said(&output));
        let tables = folder.path().join(format!("{format}_tables"));
        let output = cardiomorph(&["measure", text(&out), "--out", text(&tables)]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        volumes.push(fs::read_to_string(tables.join("frames.csv")).unwrap());
    }
    assert_eq!(volumes[0], volumes[1]);
    assert_eq!(volumes[0], volumes[2]);
}

#[test]
fn measure_writes_the_columns_that_scripts_rely_on() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("tables");
    let printed = json_of(&cardiomorph(&[
        "measure",
        text(demo()),
        "--out",
        text(&out),
        "--json",
    ]));
    assert_eq!(
        header(&out.join("frames.csv"))[..5],
        [
            "subject",
            "frame",
            "endo_volume",
            "epi_volume",
            "volume_unit"
        ]
    );
    assert_eq!(
        header(&out.join("subjects.csv"))[..9],
        [
            "subject",
            "label",
            "end_diastole",
            "end_systole",
            "edv",
            "esv",
            "sv",
            "ef",
            "mass_g"
        ]
    );
    assert_eq!(rows(&out.join("frames.csv")).len(), 23 * 8);
    let subjects = rows(&out.join("subjects.csv"));
    assert_eq!(subjects.len(), 23);
    for (row, object) in subjects.iter().zip(printed["subjects"].as_array().unwrap()) {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let (edv, esv, sv, ef) = (number(4), number(5), number(6), number(7));
        assert!((sv - (edv - esv)).abs() < 1e-9);
        assert!((ef - sv / edv).abs() < 1e-12);
        assert!((0.05..0.85).contains(&ef), "{ef}");
        // Both are printed to the last bit; reading JSON here may lose that one.
        assert!((object["ef"].as_f64().unwrap() - ef).abs() < 1e-15);
        assert_eq!(&row[2], "0", "end-diastole is the first frame of the model");
    }
}

#[test]
fn analyze_writes_the_same_bytes_with_one_thread_and_with_two() {
    let folder = tempfile::tempdir().unwrap();
    let mut reports = Vec::new();
    for threads in ["1", "2"] {
        let out = folder.path().join(threads);
        let options = [
            "analyze",
            text(demo()),
            "--figures",
            "off",
            "--threads",
            threads,
            "--out",
            text(&out),
        ];
        let output = cardiomorph(&options);
        assert_eq!(code(&output), 0, "{}", said(&output));
        reports.push(out);
    }
    for name in [
        "frames.csv",
        "subjects.csv",
        "measures.csv",
        "distances.csv",
        "poses_mds.csv",
        "poses_smacof.csv",
        "medial_mds.csv",
        "atoms.csv",
        "patches.csv",
        "segments.csv",
        "summary.json",
    ] {
        let read = |report: &PathBuf| fs::read(report.join(name)).unwrap();
        assert!(read(&reports[0]) == read(&reports[1]), "{name} differs");
    }
    let poses = reports[0].join("poses_mds.csv");
    assert_eq!(header(&poses), ["subject", "frame", "x", "y"]);
    assert_eq!(rows(&poses).len(), 184);
    let medial = reports[0].join("medial_mds.csv");
    let columns = ["subject", "step_from", "step_to", "patch", "x", "y"];
    assert_eq!(header(&medial), columns);
    let (steps, patches) = (rows(&medial), rows(&reports[0].join("patches.csv")));
    for patch in &patches {
        let own = |row: &&csv::StringRecord| (&row[0], &row[3]) == (&patch[0], &patch[1]);
        assert_eq!(steps.iter().filter(own).count(), 8, "{patch:?}");
    }
    assert!(
        steps
            .iter()
            .any(|row| &row[0] == "N01" && row[3].is_empty())
    );
    let distances = rows(&reports[0].join("distances.csv"));
    assert_eq!((distances.len(), distances[0].len()), (184, 186));
    let summary: Value =
        serde_json::from_slice(&fs::read(reports[0].join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["poses"], 184);
    assert_eq!(summary["labels"]["abnormal"], 14);
    assert!(summary["maps"]["mds"]["stress"].as_f64().unwrap() < 0.5);
}

#[test]
fn a_distance_is_zero_to_itself_symmetric_and_blind_to_rigid_motion_where_asked() {
    let [a, b] = [0, 3].map(|frame| demo().join(format!("N01/endo_{frame:03}.ply")));
    let distance = |a: &Path, b: &Path, more: &[&str]| {
        let mut options = vec!["metric", text(a), text(b), "--json"];
        options.extend(more);
        json_of(&cardiomorph(&options))
    };
    let both = ["--metric", "quasi-conformal"];
    let there = distance(&a, &b, &both);
    let back = distance(&b, &a, &both);
    for key in ["norm2_a", "norm2_b", "energy", "distance"] {
        assert!(there[key].as_f64().unwrap() > 0.0, "{key}");
    }
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap();
    assert!(
        (number(&there, "energy") - number(&there, "norm2_a") - number(&there, "norm2_b")).abs()
            < 1e-12
    );
    assert!((number(&there, "distance") - (number(&there, "energy") / 2.0).sqrt()).abs() < 1e-12);
    assert!((number(&there, "distance") - number(&back, "distance")).abs() < 1e-9);
    assert_eq!(number(&distance(&a, &a, &[]), "distance"), 0.0);
    assert_eq!(distance(&a, &a, &[])["shares"], Value::Null);
    let shares = ["own", "curvature", "displacement"].map(|part| number(&there["shares"], part));
    assert!(
        (shares.iter().sum::<f64>() - 1.0).abs() < 1e-12,
        "{shares:?}"
    );
    assert!(shares.iter().all(|share| *share > 0.0), "{shares:?}");
    // Frames of one heart lie almost aligned: alignment can only bring the displacement down.
    let rigid = ["--metric", "rigid"];
    let aligned = ["--metric", "rigid", "--align", "rigid"];
    let (as_is, laid_on) = (distance(&a, &b, &rigid), distance(&a, &b, &aligned));
    assert!(number(&laid_on, "distance") > 0.0);
    assert!(number(&laid_on, "distance") <= number(&as_is, "distance") * 1.1);
}

#[test]
fn every_metric_form_and_alignment_that_is_named_can_be_asked_for() {
    let [a, b] = [0, 3].map(|frame| demo().join(format!("P02/endo_{frame:03}.ply")));
    let mut seen = Vec::new();
    for metric in [
        "isometric",
        "displacement",
        "angle-preserving",
        "quasi-conformal",
    ] {
        for form in ["printed", "bilinear", "frozen", "additive"] {
            let options = [
                "metric",
                text(&a),
                text(&b),
                "--metric",
                metric,
                "--form",
                form,
                "--corners",
                "raw",
                "--area-weights",
                "off",
                "--mu",
                "0.5",
                "--lambda",
                "0",
                "--regulariser",
                "uniform",
                "--align",
                "similarity",
                "--json",
            ];
            let answer = json_of(&cardiomorph(&options));
            seen.push(answer["distance"].as_f64().unwrap());
        }
    }
    assert!(seen.iter().all(|d| d.is_finite() && *d > 0.0), "{seen:?}");
    assert_ne!(
        seen[12], seen[13],
        "forms of the quasi-conformal metric differ"
    );
}

#[test]
fn embed_keeps_the_distances_of_a_square() {
    let folder = tempfile::tempdir().unwrap();
    let (points, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    fs::write(&points, "0,0\n3,0\n3,4\n0,4\n").unwrap();
    for method in ["mds", "smacof", "pca"] {
        let options = [
            "embed",
            text(&points),
            "--input",
            "points",
            "--method",
            method,
            "--dimensions",
            "2",
            "--seed",
            "1",
            "--out",
            text(&out),
            "--json",
        ];
        let answer = json_of(&cardiomorph(&options));
        match method {
            "pca" => assert!(answer["eigenvalues"].is_array()),
            _ => assert!(answer["stress"].as_f64().unwrap() < 1e-3, "{method}"),
        }
        assert_eq!(header(&out), ["x", "y"]);
        let map: Vec<[f64; 2]> = rows(&out)
            .iter()
            .map(|row| [row[0].parse().unwrap(), row[1].parse().unwrap()])
            .collect();
        let between = |i: usize, j: usize| {
            ((map[i][0] - map[j][0]).powi(2) + (map[i][1] - map[j][1]).powi(2)).sqrt()
        };
        assert!((between(0, 2) - 5.0).abs() < 1e-3, "{method}");
        assert!((between(0, 1) - 3.0).abs() < 1e-3, "{method}");
    }
}
