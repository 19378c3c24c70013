//! The headless door from outside: options, exit codes, columns, keys, and the same bytes for any number of threads.

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
        "summary.json",
    ] {
        let read = |report: &PathBuf| fs::read(report.join(name)).unwrap();
        assert!(read(&reports[0]) == read(&reports[1]), "{name} differs");
    }
    let poses = reports[0].join("poses_mds.csv");
    assert_eq!(header(&poses), ["subject", "frame", "x", "y"]);
    assert_eq!(rows(&poses).len(), 184);
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
    let there = distance(&a, &b, &[]);
    let back = distance(&b, &a, &[]);
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
    for metric in ["isometric", "rigid", "angle-preserving", "quasi-conformal"] {
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

#[test]
fn unusable_input_is_one_and_wrong_usage_is_two() {
    let folder = tempfile::tempdir().unwrap();
    let out = text(folder.path()).to_owned() + "/out.csv";
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
            &["figure", &demo, "--subject", "X", "--out", &out],
            2,
            "no such subject",
        ),
        (
            &["figure", &demo, "--frame", "8", "--out", &out],
            2,
            "frames 0 to 7",
        ),
        (
            &["figure", &demo, "--size", "9x9", "--out", &out],
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
fn ctrl_c_ends_an_analysis_with_code_three_within_half_a_second() {
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
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(killed.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(3));
    assert!(
        asked.elapsed() < std::time::Duration::from_millis(1_000),
        "{:?}",
        asked.elapsed()
    );
    assert!(!out.exists(), "a stopped analysis writes nothing");
}
