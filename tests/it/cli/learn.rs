//! `learn` and `analyze --rule`: a rule on disk, and files that are none.

use super::*;

/// The rule of the built-in cohort, learnt once for all tests.
fn rule() -> &'static Path {
    static RULE: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = RULE.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rule.json");
        let output = cardiomorph(&["learn", text(demo()), "--out", text(&path)]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        (folder, path)
    });
    path
}

fn analyzed(rule: &Path, out: &Path) -> Output {
    let options = [
        "--figures",
        "off",
        "--distances",
        "none",
        "--out",
        text(out),
    ];
    let options = [
        &["analyze", text(demo()), "--rule", text(rule)],
        &options[..],
    ]
    .concat();
    cardiomorph(&options)
}

#[test]
fn a_rule_holds_units_ranges_and_figures_and_no_subject() {
    let file = fs::read_to_string(rule()).unwrap();
    let json: Value = serde_json::from_str(&file).unwrap();
    assert_eq!(
        (&json["format"], &json["version"]),
        (&"cardiomorph rule".into(), &1.into())
    );
    assert!(json["training"]["auc"].as_f64().unwrap() > 0.9);
    let features = json["features"].as_array().unwrap();
    let ef = features
        .iter()
        .find(|f| f["name"] == "Ejection fraction")
        .unwrap();
    assert!(ef["range"][0].as_f64().unwrap() < ef["range"][1].as_f64().unwrap());
    assert_eq!(
        json["abnormal"]["weights"].as_array().unwrap().len(),
        features.len()
    );
    for subject in rows(&{
        let folder = rule().with_file_name("measures");
        let output = cardiomorph(&["measure", text(demo()), "--out", text(&folder)]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        folder.join("subjects.csv")
    }) {
        assert!(!file.contains(&subject[0]), "{}", &subject[0]);
    }
}

#[test]
fn a_rule_makes_the_verdicts_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let output = analyzed(rule(), folder.path());
    assert_eq!(code(&output), 0, "{}", said(&output));
    let summary: Value =
        serde_json::from_slice(&fs::read(folder.path().join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["verdicts"]["rule"], "file");
    let classifier = &summary["verdicts"]["classifier"];
    assert_eq!(classifier["name"], "rule");
    assert_eq!(classifier["study"], "Built-in cohort");
    // How each motion was transported stands beside.
    let transports = summary["deformations"]["transports"].as_array().unwrap();
    assert_eq!(transports.len(), 23);
    for transport in transports {
        let shares = transport["energy_shares"].as_array().unwrap();
        assert!(
            shares.len() == 1 && shares[0].as_f64().unwrap() <= 1.0,
            "{transport}"
        );
        assert_eq!(transport["converged"], true, "{transport}");
        assert!(transport["norm_change"].as_f64().unwrap() < 1e-6);
    }
    let path = folder.path().join("verdicts.csv");
    let place = |name: &str| header(&path).iter().position(|key| key == name).unwrap();
    let (calibrated, outside) = (place("calibrated"), place("outside_training"));
    for row in rows(&path) {
        // The same subjects: none lies outside what the rule has seen.
        assert_eq!((&row[calibrated], &row[outside]), ("yes", ""), "{row:?}");
    }
}

#[test]
fn what_is_no_rule_is_refused_with_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let whole = fs::read_to_string(rule()).unwrap();
    let path = folder.path().join("damaged.json");
    let out = folder.path().join("out");
    let newer = whole.replacen("\"version\": 1", "\"version\": 9", 1);
    for (damaged, why) in [
        ("", "EOF"),
        (&whole[..whole.len() / 2], "EOF"),
        (&newer, "version 9"),
        ("{\"format\": \"other\"}", "missing field"),
        (&whole.replacen("Ejection fraction", "Colour", 1), "Colour"),
    ] {
        fs::write(&path, damaged).unwrap();
        let output = analyzed(&path, &out);
        let said = said(&output);
        let last = said.trim_end().lines().last().unwrap();
        assert_eq!(code(&output), 1, "{said}");
        assert!(
            last.contains("cannot use the classifier file") && last.contains(why),
            "{last}"
        );
        assert!(
            last.ends_with("damaged.json") && !out.join("verdicts.csv").exists(),
            "{last}"
        );
    }
    let output = analyzed(&folder.path().join("nowhere.json"), &out);
    assert_eq!(code(&output), 1);
}

#[test]
fn a_rule_reads_the_features_that_are_named_and_says_what_its_maker_says() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.json");
    let learn = |features: &str| {
        let out = ["--out", text(&path), "--note", "of a test"];
        cardiomorph(&[&["learn", text(demo()), "--features", features], &out[..]].concat())
    };
    let output = learn("Ejection fraction,akinetic region");
    assert_eq!(code(&output), 0, "{}", said(&output));
    let json: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    let names: Vec<&str> = (json["features"].as_array().unwrap().iter())
        .map(|feature| feature["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["Akinetic region", "Ejection fraction"]);
    assert_eq!(json["origin"]["note"], "of a test");
    let output = learn("Colour");
    assert_eq!(code(&output), 2);
    assert!(said(&output).contains("the model features are Akinetic region, "));
    let output = analyzed(&path, &folder.path().join("out"));
    assert_eq!(code(&output), 0, "{}", said(&output));
}
