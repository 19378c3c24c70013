//! Input from which a number could be wrong without a word: no number, or a word.

use std::path::Path;

use super::{cardiomorph, code, demo, json_of, rows, said, text};

fn printed(arguments: &[&str]) -> String {
    let output = cardiomorph(arguments);
    assert_eq!(code(&output), 0, "{arguments:?}: {}", said(&output));
    String::from_utf8_lossy(&output.stdout).into_owned() + &said(&output)
}

/// Embeds what a file says by a method, and returns what was printed and the map.
fn embedded(folder: &Path, content: &str, options: &[&str]) -> (String, Vec<Vec<f64>>) {
    let (file, out) = (folder.join("in.csv"), folder.join("out.csv"));
    std::fs::write(&file, content).unwrap();
    let arguments = [&["embed", text(&file), "--out", text(&out)], options].concat();
    let said = printed(&arguments);
    let map = rows(&out)
        .iter()
        .map(|row| row.iter().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    (said, map)
}

#[test]
fn embeddings_of_huge_and_tiny_items_are_those_of_moderate_ones() {
    let folder = tempfile::tempdir().unwrap();
    for method in ["mds", "smacof", "isomap", "pca", "lle"] {
        let of = |unit: f64| {
            let points: Vec<String> = (0..12)
                .map(f64::from)
                .map(|i| [(0.7 * i).sin() * 3.0, (1.3 * i).cos(), 0.1 * i].map(|x| x * unit))
                .map(|[x, y, z]| format!("{x:e},{y:e},{z:e}"))
                .collect();
            let options = ["--input", "points", "--method", method, "--neighbours", "5"];
            embedded(folder.path(), &points.join("\n"), &options).1
        };
        let moderate = of(1.0);
        let span = |map: &[Vec<f64>]| {
            let first = |pick: fn(f64, f64) -> f64| map.iter().map(|p| p[0]).reduce(pick).unwrap();
            first(f64::max) - first(f64::min)
        };
        for unit in [1e-200, 1e200] {
            let map = of(unit);
            assert!(
                map.iter().flatten().all(|x| x.is_finite()),
                "{method} {unit:e}"
            );
            // Maps by local linearity have a size of their own.
            let expected = if method == "lle" { 1.0 } else { unit };
            let ratio = span(&map) / expected / span(&moderate);
            assert!((ratio - 1.0).abs() < 1e-6, "{method} {unit:e}: {ratio}");
        }
    }
}

#[test]
fn a_graph_of_neighbours_in_parts_is_told_with_what_was_done() {
    let folder = tempfile::tempdir().unwrap();
    let points: Vec<String> = (0..16)
        .map(|i| format!("{},{}", 100 * (i / 8) + i % 4, (i * 7) % 5))
        .collect();
    let points = points.join("\n");
    let options = |method| ["--input", "points", "--method", method, "--neighbours", "3"];
    let (isomap, _) = embedded(folder.path(), &points, &options("isomap"));
    assert!(
        isomap.contains("2 parts") && isomap.contains("joined"),
        "{isomap}"
    );
    let (lle, map) = embedded(folder.path(), &points, &options("lle"));
    assert!(
        lle.contains("2 parts") && lle.contains("nearest neighbours were used instead"),
        "{lle}"
    );
    assert!(map.iter().flatten().all(|x| x.is_finite()));
    let whole = points
        .replace("100", "3")
        .lines()
        .take(8)
        .collect::<Vec<_>>()
        .join("\n");
    let (connected, _) = embedded(folder.path(), &whole, &options("isomap"));
    assert!(!connected.contains("parts"), "{connected}");
}

#[test]
fn items_that_coincide_have_a_map_of_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let same = ["1,2,3"; 8].join("\n");
    let doubled = ["0,0", "0,0", "1,0", "1,0", "0,1", "0,1", "3,3", "3,3"].join("\n");
    for points in [&same, &doubled] {
        for method in ["mds", "smacof", "isomap", "pca", "lle"] {
            let options = ["--input", "points", "--method", method, "--neighbours", "3"];
            let (_, map) = embedded(folder.path(), points, &options);
            assert!(
                map.iter().flatten().all(|x| x.is_finite()),
                "{method}: {map:?}"
            );
        }
    }
}

#[test]
fn a_transport_says_how_it_was_aligned() {
    let folder = tempfile::tempdir().unwrap();
    let (beat, onto) = (folder.path().join("beat"), demo().join("P02/endo_000.ply"));
    std::fs::create_dir(&beat).unwrap();
    for frame in 0..3 {
        let name = format!("endo_{frame:03}.ply");
        std::fs::copy(demo().join("N01").join(&name), beat.join(&name)).unwrap();
    }
    let out = folder.path().join("out");
    let arguments = |more: &[&'static str]| -> String {
        let options = [
            "transfer",
            "--from",
            text(&beat),
            "--onto",
            text(&onto),
            "--out",
            text(&out),
        ];
        printed(&[&options[..], more].concat())
    };
    assert!(arguments(&[]).contains("best similarity"));
    assert!(arguments(&["--align", "none"]).contains("not aligned"));
}

/// A mesh file with its faces in reverse order, each beginning with another corner.
fn relisted(mesh: &str) -> String {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for line in mesh.lines() {
        match line.split_once(' ') {
            Some(("f", corners)) => {
                let [a, b, c] = corners.split(' ').collect::<Vec<_>>()[..] else {
                    panic!("{line}");
                };
                faces.push(format!("f {b} {c} {a}"));
            }
            _ => points.push(line.to_owned()),
        }
    }
    faces.reverse();
    [points, faces].concat().join("\n") + "\n"
}

#[test]
fn frames_and_subjects_that_list_their_faces_in_another_way_correspond() {
    let folder = tempfile::tempdir().unwrap();
    let (study, plain) = (folder.path().join("study"), folder.path().join("plain"));
    let demo = folder.path().join("demo");
    let out = text(&demo);
    printed(&["demo", "--vertices", "200", "--format", "obj", "--out", out]);
    for id in ["N01", "N02", "N03", "P01"] {
        for folder in [&study, &plain] {
            std::fs::create_dir_all(folder.join(id)).unwrap();
        }
        for entry in std::fs::read_dir(demo.join(id)).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            let mesh = std::fs::read_to_string(&path).unwrap();
            // Of N02 all frames, of N01 one.
            let other = id == "N02" || (id == "N01" && name.ends_with("_002.obj"));
            let content = if other { relisted(&mesh) } else { mesh.clone() };
            std::fs::write(study.join(id).join(name), content).unwrap();
            std::fs::write(plain.join(id).join(name), mesh).unwrap();
        }
    }
    let notices = printed(&["info", text(&study)]);
    assert!(
        notices.contains("in another order, in frame 2"),
        "{notices}"
    );
    assert!(
        notices.contains("all 4 subjects have the same faces"),
        "{notices}"
    );
    let tables = |study: &Path, name: &str| {
        let out = folder.path().join(name);
        printed(&[
            "analyze",
            text(study),
            "--figures",
            "off",
            "--out",
            text(&out),
        ]);
        ["subjects.csv", "frames.csv", "poses_mds.csv"].map(|table| rows(&out.join(table)))
    };
    let (found, expected) = (tables(&study, "a"), tables(&plain, "b"));
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        for (a, b) in found.iter().zip(expected) {
            match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(a), Ok(b)) => assert!((a - b).abs() < 1e-6 * (1.0 + a.abs()), "{a} {b}"),
                _ => assert_eq!(a, b),
            }
        }
    }
}

#[test]
fn a_unit_that_the_study_does_not_give_can_be_stated() {
    let folder = tempfile::tempdir().unwrap();
    let (heart, out) = (folder.path().join("heart"), folder.path().join("out"));
    std::fs::create_dir(&heart).unwrap();
    for frame in ["000", "003"] {
        let name = format!("endo_{frame}.ply");
        std::fs::copy(demo().join("N01").join(&name), heart.join(&name)).unwrap();
    }
    let measured = |unit: &str| {
        let options = [
            "measure",
            text(&heart),
            "--out",
            text(&out),
            "--json",
            "--unit",
            unit,
        ];
        let found = json_of(&cardiomorph(&options));
        let subject = &found["subjects"][0];
        (
            subject["volume_unit"].as_str().unwrap().to_owned(),
            subject["edv"].as_f64().unwrap(),
        )
    };
    let (ml, cubic) = (measured("mm"), measured("file"));
    assert_eq!((ml.0.as_str(), cubic.0.as_str()), ("ml", "units³"));
    assert!((cubic.1 / ml.1 - 1000.0).abs() < 1e-6);
}

/// A mesh file in which each face has corners of its own.
fn face_by_face(mesh: &str) -> String {
    let points: Vec<&str> = mesh.lines().filter(|line| line.starts_with("v ")).collect();
    let faces = mesh.lines().filter_map(|line| line.strip_prefix("f "));
    let corners: Vec<usize> = faces
        .flat_map(|face| face.split(' ').map(|corner| corner.parse().unwrap()))
        .collect();
    let mut text: String = (corners.iter())
        .map(|&corner: &usize| format!("{}\n", points[corner - 1]))
        .collect();
    for first in (1..=corners.len()).step_by(3) {
        text += &format!("f {first} {} {}\n", first + 1, first + 2);
    }
    text
}

#[test]
fn a_heart_written_face_by_face_has_the_measures_of_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (demo, cut) = (folder.path().join("demo"), folder.path().join("cut/P01"));
    printed(&[
        "demo",
        "--vertices",
        "200",
        "--format",
        "obj",
        "--out",
        text(&demo),
    ]);
    std::fs::create_dir_all(&cut).unwrap();
    for entry in std::fs::read_dir(demo.join("P01")).unwrap() {
        let path = entry.unwrap().path();
        let mesh = std::fs::read_to_string(&path).unwrap();
        std::fs::write(cut.join(path.file_name().unwrap()), face_by_face(&mesh)).unwrap();
    }
    let measured = |study: &Path| {
        let out = folder.path().join("out");
        printed(&["measure", text(study), "--out", text(&out)]);
        rows(&out.join("subjects.csv"))
    };
    assert_eq!(measured(&cut), measured(&demo.join("P01")));
    let notices = printed(&["info", text(&cut)]);
    assert!(notices.contains("along seams joined"), "{notices}");
}
