//! `analyze` and the wall: atoms, patches and segments of every heart, and what is said of the others.

use cardiomorph::study::built_in::{BuiltInParams, cohort};

use super::*;

/// A whole analysis of the built-in cohort at 400 vertices, done once for all tests.
fn report() -> &'static Path {
    static REPORT: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = REPORT.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let [demo, out] = ["demo", "report"].map(|name| folder.path().join(name));
        let output = cardiomorph(&["demo", "--out", text(&demo), "--vertices", "400"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        let options = [
            "analyze",
            text(&demo),
            "--figures",
            "off",
            "--out",
            text(&out),
        ];
        let output = cardiomorph(&options);
        assert_eq!(code(&output), 0, "{}", said(&output));
        (folder, out)
    });
    path
}

fn summary(report: &Path) -> Value {
    serde_json::from_slice(&fs::read(report.join("summary.json")).unwrap()).unwrap()
}

#[test]
fn analyze_writes_atoms_patches_and_segments_with_their_columns() {
    let atoms = report().join("atoms.csv");
    assert_eq!(
        header(&atoms)[..9],
        [
            "subject", "frame", "vertex", "x", "y", "z", "r", "pt", "in_patch"
        ]
    );
    let patches = report().join("patches.csv");
    assert_eq!(
        header(&patches)[..9],
        [
            "subject",
            "patch",
            "area_cm2",
            "share",
            "segments",
            "x",
            "y",
            "z",
            "confidence"
        ]
    );
    let segments = rows(&report().join("segments.csv"));
    assert_eq!(segments.len(), 23 * 17);
    let files = summary(report())["files"].clone();
    for name in ["atoms.csv", "patches.csv", "segments.csv"] {
        assert!(
            files.as_array().unwrap().contains(&Value::from(name)),
            "{name}"
        );
    }
    let leftover = |entry: fs::DirEntry| entry.path().extension() == Some("partial".as_ref());
    assert!(
        !fs::read_dir(report())
            .unwrap()
            .any(|entry| leftover(entry.unwrap()))
    );
}

#[test]
fn pt_is_the_ratio_to_end_diastole_and_patches_are_of_atoms() {
    let rows = rows(&report().join("atoms.csv"));
    let number = |row: &csv::StringRecord, cell: usize| row[cell].parse::<f64>().unwrap();
    let at_rest: std::collections::HashMap<(&str, &str), f64> = (rows.iter())
        .filter(|row| &row[1] == "0")
        .map(|row| ((&row[0], &row[2]), number(row, 6)))
        .collect();
    for row in &rows {
        let ratio = number(row, 6) / at_rest[&(&row[0], &row[2])];
        assert!((number(row, 7) - ratio).abs() < 1e-12, "{row:?}");
    }
    let marked: std::collections::BTreeSet<&str> = (rows.iter())
        .filter(|row| &row[8] == "1")
        .map(|row| &row[0])
        .collect();
    let patches = super::rows(&report().join("patches.csv"));
    let listed: std::collections::BTreeSet<&str> = patches.iter().map(|row| &row[0]).collect();
    assert_eq!(marked, listed);
}

#[test]
fn every_heart_has_the_patches_that_it_was_made_with_and_no_other() {
    let params = BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    };
    let truths = cohort(&params).unwrap();
    let patches = rows(&report().join("patches.csv"));
    let said = summary(report());
    let subjects = said["thickening"]["subjects"].as_array().unwrap();
    assert_eq!(subjects.len(), 23);
    for ((subject, truth), heart) in
        (subjects.iter().zip(&truths.truths)).zip(&truths.study.subjects)
    {
        assert_eq!(subject["subject"], heart.id.as_str());
        assert_eq!(subject["assessed"], true, "{}", heart.id);
        let listed: Vec<_> = patches.iter().filter(|row| row[0] == heart.id).collect();
        assert_eq!(subject["patches"].as_array().unwrap().len(), listed.len());
        assert_eq!(listed.len(), truth.patches, "{}", heart.id);
        for row in listed {
            let most: u8 = row[4].split(' ').next().unwrap().parse().unwrap();
            assert!(truth.segments.contains(&most), "{}: {row:?}", heart.id);
        }
    }
    assert_eq!(said["thickening"]["parameters"]["seed"], 2009);
}

#[test]
fn a_cohort_of_cavities_is_analysed_and_said_to_be_without_walls() {
    let folder = tempfile::tempdir().unwrap();
    let study = folder.path().join("cavities");
    for id in ["N01", "N02", "P02"] {
        fs::create_dir_all(study.join(id)).unwrap();
        for frame in 0..8 {
            let from = demo().join(format!("{id}/endo_{frame:03}.ply"));
            let to = study.join(format!("{id}/cavity_{frame:03}.ply"));
            fs::copy(from, to).unwrap();
        }
    }
    let out = folder.path().join("report");
    let options = [
        "analyze",
        text(&study),
        "--figures",
        "off",
        "--out",
        text(&out),
    ];
    let output = cardiomorph(&options);
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert!(
        said(&output).contains("3 of 3 walls not assessed"),
        "{}",
        said(&output)
    );
    for subject in summary(&out)["thickening"]["subjects"].as_array().unwrap() {
        assert_eq!(subject["assessed"], false);
        assert!(subject["reason"].as_str().unwrap().starts_with("no wall"));
    }
    for name in ["atoms.csv", "patches.csv", "segments.csv"] {
        assert_eq!(rows(&out.join(name)).len(), 0, "{name}");
    }
}

#[test]
fn settings_of_patches_change_what_is_found_and_wrong_ones_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let analyzed = |name: &str, more: &[&str]| {
        let out = folder.path().join(name);
        let mut options = vec![
            "analyze",
            text(demo()),
            "--figures",
            "off",
            "--out",
            text(&out),
        ];
        options.extend(more);
        (cardiomorph(&options), out)
    };
    let (output, out) = analyzed("none", &["--patch-core", "0", "--patch-redraws", "0"]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    let few = rows(&out.join("patches.csv")).len();
    assert!(few < rows(&report().join("patches.csv")).len(), "{few}");
    for wrong in [["--patch-border", "0.1"], ["--medial-smoothing", "9"]] {
        let (output, out) = analyzed("wrong", &wrong);
        assert_eq!(code(&output), 2, "{}", said(&output));
        assert!(!out.exists());
    }
}
