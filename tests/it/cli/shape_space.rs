//! Geodesics and transport from the command line: files that scripts rely on, and laws that hold for every heart.

use std::path::{Path, PathBuf};

use cardiomorph::io::{Limits, read_mesh_with_siblings};
use cardiomorph::mesh::Point3;
use serde_json::Value;

use super::{cardiomorph, code, demo, json_of, said, text};

fn vertices(path: &Path) -> Vec<Point3> {
    let bytes = std::fs::read(path).unwrap();
    let name = path.file_name().unwrap().to_str().unwrap();
    let file = read_mesh_with_siblings(name, &bytes, &Limits::default(), &|_| None).unwrap();
    file.frames[0].vertices().to_vec()
}

fn farthest(a: &[Point3], b: &[Point3]) -> f64 {
    assert_eq!(a.len(), b.len());
    (a.iter().zip(b)).fold(0.0, |most, (p, q)| (p - q).norm().max(most))
}

/// One surface of one subject of the demo, frame by frame, in a folder of its own.
fn beat_of(subject: &str, folder: &Path) -> PathBuf {
    let beat = folder.join(subject);
    std::fs::create_dir(&beat).unwrap();
    for frame in 0..8 {
        let name = format!("endo_{frame:03}.ply");
        std::fs::copy(demo().join(subject).join(&name), beat.join(&name)).unwrap();
    }
    beat
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap()
}

#[test]
fn interpolate_writes_both_ends_and_a_path_no_longer_than_the_straight_line() {
    let [a, b] = [0, 3].map(|frame| demo().join(format!("N01/endo_{frame:03}.ply")));
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("poses");
    let options = [
        "interpolate",
        text(&a),
        text(&b),
        "--poses",
        "3",
        "--out",
        text(&out),
        "--json",
    ];
    let answer = json_of(&cardiomorph(&options));
    assert!(number(&answer, "energy") <= number(&answer, "energy_linear"));
    assert!(number(&answer, "energy") > 0.0);
    assert!(
        answer["iterations"].as_u64().is_some() && answer["self_intersections"].as_u64().is_some()
    );
    let poses: Vec<_> = (0..5)
        .map(|k| vertices(&out.join(format!("pose_{k:03}.ply"))))
        .collect();
    assert!(!out.join("pose_005.ply").exists());
    assert!(farthest(&poses[0], &vertices(&a)) < 1e-4 && farthest(&poses[4], &vertices(&b)) < 1e-4);
    assert!(poses.windows(2).all(|two| farthest(&two[0], &two[1]) > 0.0));
}

#[test]
fn a_form_without_a_least_path_is_wrong_usage_and_says_what_to_do() {
    let [a, b] = [0, 3].map(|frame| demo().join(format!("N01/endo_{frame:03}.ply")));
    let folder = tempfile::tempdir().unwrap();
    let mut options = vec![
        "interpolate",
        text(&a),
        text(&b),
        "--out",
        text(folder.path()),
    ];
    options.extend([
        "--metric",
        "quasi-conformal",
        "--form",
        "printed",
        "--corners",
        "raw",
        "--lambda",
        "0",
        "--poses",
        "2",
    ]);
    let refused = cardiomorph(&options);
    assert_eq!(code(&refused), 2);
    assert!(
        said(&refused).contains("lambda above 0"),
        "{}",
        said(&refused)
    );
    let last = options.len() - 1;
    options[last] = "1";
    assert_eq!(
        code(&cardiomorph(&options)),
        0,
        "one interpolated pose has a shortest path"
    );
}

#[test]
fn a_motion_transported_to_its_own_subject_comes_back_and_to_another_one_starts_there() {
    let folder = tempfile::tempdir().unwrap();
    let beat = beat_of("N01", folder.path());
    let transported = |onto: &Path, name: &str| {
        let out = folder.path().join(name);
        let options = [
            "transfer",
            "--from",
            text(&beat),
            "--onto",
            text(onto),
            "--out",
            text(&out),
            "--json",
        ];
        assert_eq!(json_of(&cardiomorph(&options))["poses"], 8);
        let poses: Vec<_> = (0..8)
            .map(|k| vertices(&out.join(format!("pose_{k:03}.ply"))))
            .collect();
        assert!(!out.join("pose_008.ply").exists());
        poses
    };
    let own = transported(&beat.join("endo_000.ply"), "own");
    for (frame, pose) in own.iter().enumerate() {
        let there = vertices(&beat.join(format!("endo_{frame:03}.ply")));
        assert!(farthest(pose, &there) < 1e-4, "frame {frame}");
    }
    let other = demo().join("P02/endo_000.ply");
    let moved = transported(&other, "other");
    assert!(
        farthest(&moved[0], &vertices(&other)) < 1e-4,
        "pose 0 is the mesh"
    );
    assert!(
        farthest(&moved[3], &moved[0]) > 1.0,
        "it moves by millimetres"
    );
}

#[test]
fn a_mesh_of_other_faces_is_refused_with_both_counts() {
    let folder = tempfile::tempdir().unwrap();
    let beat = beat_of("N01", folder.path());
    let single = folder.path().join("triangle.obj");
    std::fs::write(&single, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let out = folder.path().join("out");
    let refused = cardiomorph(&[
        "transfer",
        "--from",
        text(&beat),
        "--onto",
        text(&single),
        "--out",
        text(&out),
    ]);
    assert_eq!(code(&refused), 1);
    assert!(
        said(&refused).contains("3 vertices and 1 faces"),
        "{}",
        said(&refused)
    );
    assert!(!out.exists());
}

#[test]
fn embed_unrolls_a_strip_by_isomap_and_by_local_linearity() {
    let folder = tempfile::tempdir().unwrap();
    let (points, out) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    // A strip rolled once about an axis: 60 steps of angle, 5 across.
    let lines: Vec<String> = (0..300)
        .map(|i| {
            let (angle, across) = (f64::from(i / 5) * 0.08, f64::from(i % 5));
            format!("{},{across},{}", 10.0 * angle.cos(), 10.0 * angle.sin())
        })
        .collect();
    std::fs::write(&points, lines.join("\n")).unwrap();
    for method in ["isomap", "lle"] {
        let options = [
            "embed",
            text(&points),
            "--input",
            "points",
            "--method",
            method,
            "--neighbours",
            "8",
            "--out",
            text(&out),
            "--json",
        ];
        let answer = json_of(&cardiomorph(&options));
        assert!(
            answer["reconstruction_error"].as_f64().is_some(),
            "{method}: {answer}"
        );
        assert!(answer["neighbours"].as_u64() >= Some(8));
        let along: Vec<f64> = super::rows(&out)
            .iter()
            .map(|row| row[0].parse().unwrap())
            .collect();
        let means: Vec<f64> = along
            .chunks(5)
            .map(|chunk| chunk.iter().sum::<f64>() / 5.0)
            .collect();
        let rises = means.windows(2).filter(|two| two[1] > two[0]).count();
        assert!(
            rises <= 1 || rises >= 58,
            "{method}: the first axis runs along the strip, {rises}"
        );
    }
    let refused = cardiomorph(&[
        "embed",
        text(&points),
        "--input",
        "points",
        "--method",
        "lle",
        "--regularisation",
        "-1",
        "--out",
        text(&out),
    ]);
    assert_eq!(code(&refused), 2);
}

#[test]
fn a_small_noise_study_says_its_protocol_and_writes_tables_and_a_figure() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("noise");
    let options = [
        "experiment",
        "noise-deformation",
        "--redraws",
        "1",
        "--per-class",
        "3",
        "--out",
        text(&out),
        "--json",
    ];
    let answer = json_of(&cardiomorph(&options));
    assert!(!answer["protocol"].as_array().unwrap().is_empty());
    let cells = answer["cells"].as_array().unwrap();
    // Three methods; clean, and three families at five levels.
    assert_eq!(cells.len(), 3 * (1 + 3 * 5));
    assert!(cells[0]["tau"].as_f64().unwrap() > cells[0]["baseline"].as_f64().unwrap());
    assert_eq!(answer["transferred"], 72);
    assert!(super::rows(&out.join("noise.csv")).len() >= cells.len());
    assert!(
        std::fs::read_to_string(out.join("noise.svg"))
            .unwrap()
            .ends_with("</svg>\n")
    );
    for name in ["noise.csv", "transfer.csv", "interpolation.csv"] {
        super::columns::check(&out.join(name));
    }
    for name in ["transfer.csv", "interpolation.csv", "summary.json"] {
        assert!(out.join(name).exists(), "{name}");
    }
}

#[test]
fn every_metric_is_compared_on_a_labelled_study_beside_ejection_fraction_and_displacement() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("metrics");
    let answer = json_of(&cardiomorph(&[
        "experiment",
        "metrics",
        text(demo()),
        "--redraws",
        "1",
        "--out",
        text(&out),
        "--json",
    ]));
    let rows = answer["classification"].as_array().unwrap();
    // Nine ways of comparing poses, three of comparing deformations, and EF, on the study and on copies at three levels.
    assert_eq!(rows.len(), 13 * 4);
    for name in [
        "EF alone",
        "displacement from end-diastole",
        "deformation + shape",
    ] {
        let row = rows.iter().find(|row| row["method"] == name).unwrap();
        assert_eq!(row["labelled"], 23);
        assert!(
            row["nearest_neighbour"]["accuracy"].as_f64().unwrap() > 0.5,
            "{name}"
        );
    }
    assert_eq!(super::rows(&out.join("metrics.csv")).len(), rows.len());
    super::columns::check(&out.join("metrics.csv"));
}

/// Folder `from` of the built-in cohort under another name, so that it opens as a subject of that id.
fn renamed(folder: &Path, from: &str, id: &str) {
    let target = folder.join(id);
    std::fs::create_dir_all(&target).unwrap();
    for entry in std::fs::read_dir(demo().join(from)).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        std::fs::copy(entry.path(), target.join(name.replace(from, id))).unwrap();
    }
}

#[test]
fn partners_with_one_motion_are_nearest_by_every_metric_and_are_refused_where_there_are_none() {
    let folder = tempfile::tempdir().unwrap();
    let study = folder.path().join("study");
    for (patient, from) in ["N01", "N02", "N03"].into_iter().enumerate() {
        for state in ["rest", "stress"] {
            renamed(&study, from, &format!("P{patient}_{state}"));
        }
    }
    let out = folder.path().join("partners");
    let answer = json_of(&cardiomorph(&[
        "experiment",
        "partners",
        text(&study),
        "--out",
        text(&out),
        "--json",
    ]));
    let rows = answer["partners"].as_array().unwrap();
    // Ten ways of comparing after five of transport, and five on hearts as they are or with a transport of their own.
    assert_eq!(rows.len(), 10 * 5 + 5);
    for row in rows {
        assert_eq!(row["pairs"], 6, "{row}");
        assert_eq!(row["nearest"], 6, "{row}");
        assert_eq!(row["mean_rank"], 1.0, "{row}");
    }
    assert_eq!(super::rows(&out.join("partners.csv")).len(), rows.len());
    super::columns::check(&out.join("partners.csv"));
    assert!(out.join("summary.json").exists());
    let none = cardiomorph(&["experiment", "partners", text(demo()), "--out", text(&out)]);
    assert_eq!(code(&none), 1);
    assert!(
        said(&none).contains("up to their last `_`"),
        "{}",
        said(&none)
    );
}
