//! Noise on medial surfaces from the command line: files, columns, and the same bytes for the same seed.

use super::{cardiomorph, code, header, json_of, rows, said, text};

#[test]
fn noisy_medial_surfaces_are_told_apart_and_patches_are_placed() {
    let folder = tempfile::tempdir().unwrap();
    let run = |name: &str| {
        let out = folder.path().join(name);
        let options = [
            "experiment",
            "noise-medial",
            "--redraws",
            "1",
            "--per-class",
            "2",
            "--per-size",
            "1",
            "--out",
            text(&out),
            "--json",
        ];
        (json_of(&cardiomorph(&options)), out)
    };
    let (answer, out) = run("first");
    assert!(!answer["protocol"].as_array().unwrap().is_empty());
    // Four ways; clean, and two families at four levels.
    assert_eq!(answer["cells"].as_array().unwrap().len(), 4 * 9);
    assert_eq!(answer["cells"][0]["tau"], 1.0);
    let noise = out.join("noise_medial.csv");
    assert_eq!(
        header(&noise)[..4],
        ["method", "family", "percent", "tau_percent"]
    );
    assert_eq!(rows(&noise).len(), 36);
    // None, eight sizes, and two patches.
    let places = out.join("localisation.csv");
    assert_eq!(rows(&places).len(), 10 * 9);
    assert_eq!(header(&places)[..3], ["patches", "patch_percent", "family"]);
    for table in [&noise, &places] {
        super::columns::check(table);
    }
    let figure = std::fs::read_to_string(out.join("noise_medial.svg")).unwrap();
    assert!(figure.ends_with("</svg>\n"));
    let (_, again) = run("second");
    for name in ["noise_medial.csv", "localisation.csv", "summary.json"] {
        let bytes = |folder: &std::path::Path| std::fs::read(folder.join(name)).unwrap();
        assert_eq!(bytes(&out), bytes(&again), "{name}");
    }
    let none = cardiomorph(&[
        "experiment",
        "noise-medial",
        "--redraws",
        "0",
        "--out",
        text(&out),
    ]);
    assert_eq!(code(&none), 2, "{}", said(&none));
}
