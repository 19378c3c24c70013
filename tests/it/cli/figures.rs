//! Figures, the headless main job, and Ctrl-C.

use super::*;

struct Png {
    size: [u32; 2],
    pixels: Vec<u8>,
    texts: Vec<(String, String)>,
}

impl Png {
    fn read(path: &Path) -> Self {
        let file = std::io::BufReader::new(fs::File::open(path).unwrap());
        let mut reader = png::Decoder::new(file).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let info = reader.info();
        Self {
            size: [info.width, info.height],
            texts: info
                .utf8_text
                .iter()
                .map(|chunk| (chunk.keyword.clone(), chunk.get_text().unwrap()))
                .collect(),
            pixels,
        }
    }

    fn at(&self, x: u32, y: u32) -> [u8; 4] {
        let place = (y * self.size[0] + x) as usize * 4;
        self.pixels[place..place + 4].try_into().unwrap()
    }

    /// Pixels in a rectangle, given in shares of width and height, that meet a condition.
    fn count(
        &self,
        [x0, x1]: [f64; 2],
        [y0, y1]: [f64; 2],
        met: impl Fn([u8; 4]) -> bool,
    ) -> usize {
        let ends = |share: f64, size: u32| (share * f64::from(size)) as u32;
        let rows = ends(y0, self.size[1])..ends(y1, self.size[1]);
        rows.flat_map(|y| (ends(x0, self.size[0])..ends(x1, self.size[0])).map(move |x| (x, y)))
            .filter(|&(x, y)| met(self.at(x, y)))
            .count()
    }
}

fn is_tissue([red, green, blue, opacity]: [u8; 4]) -> bool {
    opacity == 255
        && red > 90
        && i32::from(red) - i32::from(green) > 40
        && green < 140
        && blue < 140
}

#[test]
fn a_figure_shows_the_heart_in_the_middle_and_its_name_in_the_corner() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("figure.png");
    let options = [
        "figure",
        text(demo()),
        "--subject",
        "P03",
        "--frame",
        "3",
        "--size",
        "640x480",
        "--theme",
        "light",
        "--view",
        "anterior",
        "--out",
        text(&out),
    ];
    let output = cardiomorph(&options);
    if without_adapter(&output) {
        return;
    }
    assert_eq!(code(&output), 0, "{}", said(&output));
    let first = fs::read(&out).unwrap();
    let figure = Png::read(&out);
    assert_eq!(figure.size, [640, 480]);
    for corner in [[0, 0], [639, 0], [0, 479], [639, 479]] {
        assert_eq!(figure.at(corner[0], corner[1]), [255; 4]);
    }
    assert!(figure.count([0.3, 0.7], [0.2, 0.8], is_tissue) > 5_000);
    assert_eq!(figure.count([0.0, 0.2], [0.2, 0.7], is_tissue), 0);
    let dark = |pixel: [u8; 4]| pixel[0] < 80 && pixel[1] < 80;
    assert!(
        figure.count([0.02, 0.3], [0.02, 0.1], dark) > 30,
        "the name"
    );
    assert!(
        figure.count([0.7, 0.98], [0.02, 0.1], dark) > 30,
        "the ejection fraction"
    );
    let text_of = |key: &str| {
        figure
            .texts
            .iter()
            .find(|(k, _)| k == key)
            .unwrap()
            .1
            .clone()
    };
    assert_eq!(text_of("Title"), "P03");
    assert_eq!(text_of("Frame"), "3");
    assert!(text_of("Comment").contains("not for diagnosis"));
    assert_eq!(code(&cardiomorph(&options)), 0);
    assert_eq!(
        fs::read(&out).unwrap(),
        first,
        "the same figure, the same bytes"
    );
}

#[test]
fn a_transparent_figure_has_nothing_behind_the_heart() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("figure.png");
    let options = [
        "figure",
        text(demo()),
        "--colour",
        "displacement",
        "--transparent",
        "--size",
        "400x300",
        "--frame",
        "3",
        "--out",
        text(&out),
        "--json",
    ];
    let output = cardiomorph(&options);
    if without_adapter(&output) {
        return;
    }
    let printed = json_of(&output);
    assert_eq!(printed["width"], 400);
    assert_eq!(printed["subject"], "N01");
    let figure = Png::read(&out);
    assert_eq!(figure.at(0, 0)[3], 0);
    assert_eq!(figure.at(200, 299)[3], 0);
    assert!(figure.count([0.3, 0.7], [0.2, 0.8], |pixel| pixel[3] == 255) > 1_000);
    assert!(figure.texts.iter().any(|(key, _)| key == "Colour limits"));
}

#[test]
fn without_a_display_the_main_job_is_done_into_a_folder_that_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let output = command(&[text(demo())])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(code(&output), 0, "{}", said(&output));
    let lines: Vec<String> = said(&output).lines().map(str::to_owned).collect();
    assert!(lines[0].contains("no display"), "{lines:?}");
    let printed = String::from_utf8(output.stdout).unwrap();
    let report = PathBuf::from(printed.trim());
    assert!(report.is_absolute());
    assert!(report.join("summary.json").is_file());
    assert!(report.join("poses_mds.csv").is_file());
    if !lines
        .iter()
        .any(|line| line.contains("no graphics adapter"))
    {
        assert!(report.join("figures/N01.png").is_file());
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_an_analysis_with_code_three_before_its_figures_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let fine = folder.path().join("fine");
    let written = cardiomorph(&["demo", "--vertices", "3000", "--out", text(&fine)]);
    assert_eq!(code(&written), 0, "{}", said(&written));
    let out = folder.path().join("report");
    let mut child = command(&[
        "analyze",
        text(&fine),
        "--out",
        text(&out),
        "--threads",
        "1",
    ])
    .stdout(Stdio::null())
    .stderr(Stdio::null())
    .spawn()
    .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    assert!(
        child.try_wait().unwrap().is_none(),
        "it was over before it could be stopped"
    );
    let asked = std::time::Instant::now();
    // The shell's own `kill`: a small system has no other.
    let killed = Command::new("sh")
        .args(["-c", &format!("kill -INT {}", child.id())])
        .status();
    assert!(killed.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(3));
    assert!(
        // All figures take over five seconds, one a quarter of a second.
        asked.elapsed() < std::time::Duration::from_secs(3),
        "{:?}",
        asked.elapsed()
    );
    // Tables that were known by then stand there, and the summary says that the rest is missing.
    if out.exists() {
        let summary = fs::read_to_string(out.join("summary.json")).unwrap();
        let summary: Value = serde_json::from_str(&summary).unwrap();
        assert_eq!(summary["complete"], false);
        let missing = summary["missing"].as_array().unwrap();
        assert!(missing.iter().any(|part| part == "figures"), "{summary}");
    }
}

#[test]
fn background_and_theme_are_chosen_and_transparent_has_a_short_name() {
    let folder = tempfile::tempdir().unwrap();
    let corner = |options: &[&str]| {
        let out = folder.path().join("figure.png");
        let usual = ["figure", text(demo()), "--size", "400x300"];
        let output = cardiomorph(&[&usual[..], options, &["--out", text(&out)]].concat());
        if without_adapter(&output) {
            return None;
        }
        assert_eq!(code(&output), 0, "{}", said(&output));
        Some(Png::read(&out).at(0, 0))
    };
    for (options, expected) in [
        (&["--background", "black"][..], [0, 0, 0, 255]),
        (&["--background", "white", "--theme", "dark"], [255; 4]),
        (&["--theme", "dark"], [0x1a, 0x1e, 0x24, 255]),
        (&["--background", "transparent"], [0; 4]),
        (&["--transparent"], [0; 4]),
    ] {
        let Some(found) = corner(options) else {
            return;
        };
        assert_eq!(found, expected, "{options:?}");
    }
    let both = [
        "figure",
        "--transparent",
        "--background",
        "black",
        "--out",
        "a.png",
    ];
    assert_eq!(code(&cardiomorph(&both)), 2);
}

#[test]
fn an_excluded_subject_has_a_figure() {
    let folder = tempfile::tempdir().unwrap();
    let study = folder.path().join("study");
    let output = cardiomorph(&["demo", "--out", text(&study), "--vertices", "200"]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    let manifest = study.join("study.toml");
    let toml = fs::read_to_string(&manifest).unwrap();
    let excluded = toml.replacen("id = \"N02\"", "id = \"N02\"\nexcluded = true", 1);
    assert_ne!(toml, excluded);
    fs::write(&manifest, excluded).unwrap();
    let png = folder.path().join("N02.png");
    let options = ["figure", text(&study), "--subject", "N02", "--frame", "1"];
    let output = cardiomorph(&[&options[..], &["--out", text(&png)]].concat());
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert!(png.exists());
}
