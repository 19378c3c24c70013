//! What files say of a patient leaves the program by no way: seeded names, numbers and dates are looked for in every byte
//! of whatever a whole `analyze`, every other command and a session of the window write, print and show.

#[cfg(test)]
mod pdf_text;
#[cfg(test)]
mod search;
#[cfg(test)]
mod session;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use self::search::{Searched, Words};
use crate::shared::shared_data;

/// What the descriptions of the shared images call seeded, and what else in these files points to a person: birth date,
/// age, address, date of the study, descriptions as people type them, the root of the unique names.
const SEEDED: [&str; 17] = [
    "SEEDED",
    "HOSPITAL ZQX",
    "ALPHA SEEDED",
    "BETA SEEDED",
    "DELTA SEEDED",
    "patient comment",
    "19310723",
    "23071931",
    "07231931",
    "077Y",
    "19700102",
    "19700103",
    "1.2.826.0.1.3680043",
    "SYNTHETIC NM",
    "STRESS GATED SA",
    "REST GATED SA",
    "synthetic wrap",
];

/// Folders and files that hold them. The first are taken the whole way, to reports and figures; with the others, parts of
/// the first, it ends with what is read of them.
const INPUTS: [&str; 8] = [
    "gated_spect_dicom",
    "acdc_cine_dicom",
    "volume_quirks/lab_extension_phi.nii.gz",
    "gated_spect_dicom/p2/gated_rle.dcm",
    "gated_spect_dicom/p1",
    "gated_spect_dicom/p1/IM000003",
    "acdc_cine_dicom/study",
    "volume_quirks",
];
const THE_WHOLE_WAY: usize = 4;

fn seeded() -> Words {
    Words::new(SEEDED)
}

/// A folder in which the program runs: its home, its place for passing files, and what it writes.
struct Run {
    folder: tempfile::TempDir,
    /// What was printed, by command.
    printed: Vec<(String, Vec<u8>)>,
    done: usize,
}

impl Run {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        for name in ["home", "tmp", "out"] {
            fs::create_dir(folder.path().join(name)).unwrap();
        }
        Self {
            folder,
            printed: Vec::new(),
            done: 0,
        }
    }

    fn out(&self, name: &str) -> PathBuf {
        self.folder.path().join("out").join(name)
    }

    /// Runs a command; whether it has done what it was asked.
    fn command(&mut self, arguments: &[&str]) -> bool {
        let place = self.folder.path();
        let mut command = Command::new(env!("CARGO_BIN_EXE_cardiomorph"));
        command
            .args(arguments)
            .stdin(Stdio::null())
            .current_dir(place);
        let home = place.join("home");
        for (variable, below) in [
            ("HOME", ""),
            ("XDG_CONFIG_HOME", "config"),
            ("XDG_DATA_HOME", "data"),
            ("XDG_CACHE_HOME", "cache"),
            ("XDG_STATE_HOME", "state"),
            ("XDG_RUNTIME_DIR", ""),
        ] {
            command.env(variable, home.join(below));
        }
        command.env("TMPDIR", place.join("tmp"));
        for (variable, value) in [
            ("RUST_LOG", "trace"),
            ("RUST_BACKTRACE", "full"),
            ("CARDIOMORPH_TIMES", "1"),
        ] {
            command.env(variable, value);
        }
        for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(variable);
        }
        let output = command.output().unwrap();
        assert!(
            output.status.code().is_some(),
            "{arguments:?} was ended by a signal"
        );
        self.done += usize::from(output.status.success());
        let name = arguments.join(" ");
        self.printed.push((
            format!("{name} (stdout)"),
            [&output.stdout[..], b"\n"].concat(),
        ));
        self.printed
            .push((format!("{name} (stderr)"), output.stderr));
        output.status.success()
    }

    /// Every command that only reads images, or makes meshes and measures of them.
    fn reading_commands(&mut self, input: &str, name: &str) {
        let labels = ["--labels", "cavity=1,wall=2"];
        for more in [&[][..], &["--json"]] {
            self.command(&[&["image", input], more].concat());
            self.command(&[&["info", input], more].concat());
            for (kind, options) in [("mesh", &[][..]), ("labelled", &labels)] {
                let out = self.out(&format!("{name}_{kind}"));
                let all = ["mesh", input, "--out", out.to_str().unwrap()];
                self.command(&[&all, options, more].concat());
            }
            let out = self.out(&format!("{name}_measures"));
            let all = ["measure", input, "--out", out.to_str().unwrap()];
            self.command(&[&all, more].concat());
        }
    }

    /// Reports of images and of the meshes that were made of them, and figures of the first of these that has a report.
    /// Whether there was one.
    fn analysing_commands(&mut self, input: &str, name: &str) -> bool {
        let made = [
            input.to_owned(),
            text(&self.out(&format!("{name}_mesh"))),
            text(&self.out(&format!("{name}_labelled"))),
        ];
        let mut analysed = false;
        for (number, study) in made.iter().enumerate() {
            let out = |what: &str| text(&self.out(&format!("{name}_{number}_{what}")));
            let (report, rule) = (out("report"), out("rule.json"));
            let written = self.command(&["analyze", study, "--out", &report]);
            self.command(&["learn", study, "--out", &rule]);
            // Of a study that cannot be analysed a figure is refused like any other.
            let endings = match (written, analysed) {
                (true, false) => &["svg", "pdf", "png"][..],
                _ => &["svg"],
            };
            analysed |= written;
            for ending in endings {
                let figure = text(&self.out(&format!("{name}_{number}_figure.{ending}")));
                self.command(&["figure", study, "--out", &figure, "--size", "360x300"]);
                let patch = text(&self.out(&format!("{name}_{number}_patch.{ending}")));
                self.command(&[
                    "figure", study, "--patch", "--out", &patch, "--size", "800x600",
                ]);
            }
        }
        analysed
    }

    /// What is found in all that was printed and written.
    fn searched(&self, words: &Words) -> Searched {
        let mut searched = Searched::folder(words, self.folder.path());
        for (command, printed) in &self.printed {
            searched.note(command, &words.within(printed));
        }
        searched
    }
}

fn text(path: &Path) -> String {
    path.to_str().unwrap().to_owned()
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn nothing_of_a_patient_is_in_what_any_command_prints_or_writes() {
    let mut run = Run::new();
    let mut analysed = 0;
    for (number, place) in INPUTS.iter().enumerate() {
        let input = text(&shared_data(&format!("images/{place}")));
        let name = format!("i{number}");
        run.reading_commands(&input, &name);
        if number < THE_WHOLE_WAY {
            analysed += usize::from(run.analysing_commands(&input, &name));
        }
    }
    let searched = run.searched(&seeded());
    println!(
        "{} commands, {} of them done; {} files of {} KiB searched",
        run.printed.len() / 2,
        run.done,
        searched.files.len(),
        searched.bytes / 1024
    );
    assert!(searched.found.is_empty(), "{:#?}", searched.found);
    // A search of nothing would find nothing.
    assert!(analysed >= 2 && run.done > 40, "{analysed} {}", run.done);
    for ending in [".csv", ".json", ".ply", ".toml", ".pdf", ".svg", ".png"] {
        assert!(
            searched.files.iter().any(|file| file.ends_with(ending)),
            "no file ends with {ending}"
        );
    }
}

/// The other way round: a name that the program is meant to write, since it is that of a file, is found wherever it stands.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_search_finds_a_name_that_is_written_in_every_kind_of_file() {
    let mut run = Run::new();
    let input = tempfile::tempdir().unwrap();
    for part in ["endo", "epi"] {
        let from = shared_data(&format!("images/gated_spect_dicom/p1/truth_{part}.nii.gz"));
        let to = input.path().join(format!("Zebulon-Quux_{part}.nii.gz"));
        fs::copy(from, to).unwrap();
    }
    let path = input.path().to_str().unwrap();
    run.reading_commands(path, "named");
    assert!(run.analysing_commands(path, "named"));
    let searched = run.searched(&Words::new(["ZEBULON^QUUX"]));
    let told = |needed: &str| {
        assert!(
            searched.found.iter().any(|found| found.contains(needed)),
            "no {needed} in {:#?}",
            searched.found
        );
    };
    for needed in [
        "(stdout)",
        "the name out/",
        "measures.csv: ",
        "subjects.csv: ",
        "as glyphs",
        "summary.json: ",
        "study.toml: ",
        "fit.csv: ",
        "report.pdf: ",
    ] {
        told(needed);
    }
    for needed in ["patch.svg: ", "patch.pdf: ", "patch.png: "] {
        told(needed);
    }
}

/// What is damaged is told with a reason, and the reason quotes nothing of the file.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn nothing_of_a_patient_is_in_the_reason_why_a_damaged_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let files = [
        ("gated_spect_dicom/p1/IM000003", "ima"),
        ("gated_spect_dicom/p2/gated_rle.dcm", "dcm"),
        ("acdc_cine_dicom/study/IM_088", "dcm"),
        ("volume_quirks/lab_extension_phi.nii.gz", "nii.gz"),
    ];
    for (number, (place, ending)) in files.iter().enumerate() {
        let whole = fs::read(shared_data(&format!("images/{place}"))).unwrap();
        for seed in 0..60 {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            let mut bytes = whole.clone();
            for _ in 0..random.random_range(1..4) {
                let at = random.random_range(0..bytes.len().min(3000));
                match random.random_range(0..4) {
                    0 => bytes[at] = random.random(),
                    1 => drop(bytes.remove(at)),
                    2 => bytes.insert(at, random.random()),
                    _ => bytes.truncate(at.max(600)),
                }
            }
            let name = format!("damaged_{number}_{seed}.{ending}");
            fs::write(folder.path().join(name), bytes).unwrap();
        }
    }
    let mut run = Run::new();
    let input = text(folder.path());
    let out = text(&run.out("damaged"));
    for arguments in [
        &["image", &input][..],
        &["image", &input, "--json"],
        &["info", &input],
        &["mesh", &input, "--out", &out],
        &["analyze", &input, "--out", &out],
    ] {
        run.command(arguments);
    }
    let searched = run.searched(&seeded());
    assert!(searched.found.is_empty(), "{:#?}", searched.found);
    let printed: usize = run.printed.iter().map(|(_, bytes)| bytes.len()).sum();
    assert!(printed > 10_000, "{printed} bytes say little of 240 files");
}
