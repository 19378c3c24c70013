//! `figure --patch` and `report.pdf`: what a clinician takes away.

use super::*;

/// The built-in cohort at 400 vertices on disk, written once for all tests.
fn cohort() -> &'static Path {
    static COHORT: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = COHORT.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let demo = folder.path().join("demo");
        let output = cardiomorph(&["demo", "--out", text(&demo), "--vertices", "400"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        (folder, demo)
    });
    path
}

/// A patch figure of a heart with an abnormal patch; `None` without a graphics driver.
pub fn figure(out: &Path, more: &[&str]) -> Option<String> {
    let options = ["figure", text(cohort()), "--subject", "P05", "--patch"];
    let options = [&options[..], &["--out", text(out)], more].concat();
    let output = cardiomorph(&options);
    if without_adapter(&output) {
        return None;
    }
    assert_eq!(code(&output), 0, "{}", said(&output));
    Some(String::from_utf8(output.stdout).unwrap())
}

#[test]
fn a_patch_figure_names_the_heart_the_patch_and_how_it_was_told() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("P05.svg");
    if figure(&out, &["--size", "800x600", "--patch-border", "0.5"]).is_none() {
        return;
    }
    let file = fs::read_to_string(&out).unwrap();
    let document = roxmltree::Document::parse(&file).unwrap();
    let texts: Vec<&str> = (document.descendants())
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text())
        .collect();
    let has = |words: &str| texts.iter().any(|text| text.contains(words));
    for words in [
        "P05",
        "EF ",
        "EDV ",
        "ES",
        "Abnormal patch",
        "Predicted probability of abnormal",
        "anteroseptal",
        "inferolateral",
        " cm²",
        "apical",
        "PT, thickness ratio",
        "Thickening ED to ES, %",
        " mm",
        "extent threshold 0.5",
        "not for diagnosis",
        env!("CARGO_PKG_VERSION"),
    ] {
        assert!(has(words), "{words} in {texts:?}");
    }
    for number in 1..=17 {
        assert!(texts.contains(&&*number.to_string()), "segment {number}");
    }
    let images = document
        .descendants()
        .filter(|node| node.has_tag_name("image"));
    assert!(images.count() >= 2, "the heart and the bull's-eye");
    let metadata = document
        .descendants()
        .find(|node| node.has_tag_name("metadata"));
    let metadata = metadata.and_then(|node| node.text()).unwrap();
    assert!(metadata.contains("Cardiomorph view: {"));
    let paths = [env!("CARGO_MANIFEST_DIR"), text(cohort())];
    assert!(
        paths.iter().all(|path| !file.contains(path)),
        "no path on disk"
    );
}

#[test]
fn the_three_kinds_of_file_are_what_their_names_say() {
    let folder = tempfile::tempdir().unwrap();
    for (name, start) in [
        ("a.png", &b"\x89PNG"[..]),
        ("a.svg", b"<svg"),
        ("a.pdf", b"%PDF"),
    ] {
        let out = folder.path().join(name);
        if figure(&out, &["--size", "800x600"]).is_none() {
            return;
        }
        assert!(fs::read(&out).unwrap().starts_with(start), "{name}");
    }
    let out = folder.path().join("a.jpg");
    let output = cardiomorph(&["figure", "--patch", "--out", text(&out)]);
    assert_eq!(code(&output), 2);
    assert!(said(&output).contains("must end in .png, .svg or .pdf"));
    let small = ["figure", "--patch", "--size", "640x480", "--out", "a.png"];
    let output = cardiomorph(&small);
    assert_eq!(code(&output), 2);
    assert!(said(&output).contains("at least 800x600"));
}

#[test]
fn a_heart_without_a_wall_has_no_patch_figure_and_the_reason_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("heart.obj");
    fs::write(
        &mesh,
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
    )
    .unwrap();
    let out = folder.path().join("a.png");
    let output = cardiomorph(&["figure", text(&mesh), "--patch", "--out", text(&out)]);
    assert_eq!(code(&output), 1, "{}", said(&output));
    assert!(said(&output).contains("wall"), "{}", said(&output));
    assert!(!out.exists());
}

#[test]
fn analyze_writes_a_report_and_the_patch_figures_of_hearts_that_have_a_patch() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report");
    let output = cardiomorph(&["analyze", text(cohort()), "--out", text(&report)]);
    if without_adapter(&output) {
        return;
    }
    assert_eq!(code(&output), 0, "{}", said(&output));
    let pdf = fs::read(report.join("report.pdf")).unwrap();
    assert!(pdf.starts_with(b"%PDF"));
    let verdicts = rows(&report.join("verdicts.csv"));
    let names = header(&report.join("verdicts.csv"));
    let column = |name: &str| names.iter().position(|other| other == name).unwrap();
    let (subject, finding) = (column("subject"), column("finding"));
    let mut patched = 0;
    for row in &verdicts {
        let file = report.join(format!("figures/{}_patch.png", &row[subject]));
        let expected = &row[finding] == "abnormal patch";
        assert_eq!(file.is_file(), expected, "{row:?}");
        patched += usize::from(expected);
    }
    assert!(patched >= 8, "{patched}");
    let whole = String::from_utf8_lossy(&pdf);
    let pages = whole.matches("/Type /Page\n").count() + whole.matches("/Type/Page/").count();
    // A page of verdicts, one of maps, then two patch figures a page.
    let expected = 2 + patched.div_ceil(2);
    assert!(pages >= expected, "{pages} pages for {patched} patches");
    let sizes = whole.split("/MediaBox").skip(1);
    let mut sizes: Vec<&str> = sizes.filter_map(|rest| rest.split(']').next()).collect();
    sizes.dedup();
    assert_eq!(sizes.len(), 1, "pages have one size: {sizes:?}");
}
