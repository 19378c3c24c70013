//! The pages lead where they say: every file, function, test and link that a page names exists.
#![expect(
    clippy::unwrap_used,
    reason = "a page that cannot be read is a failed test"
)]

use std::fs;
use std::path::{Path, PathBuf};

/// Pages of the repository that a reader is sent to.
const PAGES: &[&str] = &[
    "README.md",
    "CHANGELOG.md",
    "src/ARCHITECTURE.md",
    "tests/bench/RESULTS.md",
    "src/analysis/experiments/COMPARISON.md",
    "src/analysis/experiments/NOISE_DEFORMATION.md",
    "src/analysis/experiments/NOISE_MEDIAL.md",
    "src/analysis/experiments/PARTNERS.md",
    "src/analysis/experiments/REAL_WALLS.md",
];

const ARCHITECTURE: &str = "src/ARCHITECTURE.md";

/// A first page is read in one sitting.
const MAX_README_LINES: usize = 199;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn page(place: &str) -> String {
    fs::read_to_string(root().join(place)).unwrap()
}

/// What stands between backticks, outside of fenced blocks.
fn code_words(page: &str) -> Vec<&str> {
    let mut fenced = false;
    let prose = page.lines().filter(|line| {
        let fence = line.starts_with("```");
        fenced ^= fence;
        !fenced && !fence
    });
    prose
        .flat_map(|line| line.split('`').skip(1).step_by(2))
        .collect()
}

/// Where a path of the architecture page lies: those of tests and hidden folders from the root, all others from `src/`.
fn placed(path: &str) -> PathBuf {
    if path.starts_with("tests/") || path.starts_with("src/") || path.starts_with('.') {
        root().join(path)
    } else {
        root().join("src").join(path)
    }
}

/// Whether a source file defines an item of this name; calls do not count.
fn defines(text: &str, name: &str) -> bool {
    ["fn", "struct", "enum", "trait", "const", "type"]
        .iter()
        .any(|kind| {
            text.match_indices(&format!("{kind} {name}"))
                .any(|(at, found)| {
                    let ends_here = |c: char| !(c.is_alphanumeric() || c == '_');
                    text[..at].chars().next_back().is_none_or(ends_here)
                        && text[at + found.len()..].starts_with(ends_here)
                })
        })
}

/// Targets of `[…](…)` that lead to a file, without the part after `#`.
fn links(page: &str) -> Vec<&str> {
    page.split("](")
        .skip(1)
        .filter_map(|rest| rest.split([')', '#']).next())
        .filter(|target| !target.is_empty() && !target.contains("://"))
        .collect()
}

fn folders_in(place: &str) -> Vec<String> {
    let entries = fs::read_dir(root().join(place)).unwrap();
    let folders = entries.map(Result::unwrap).filter(|e| e.path().is_dir());
    folders
        .map(|e| e.file_name().into_string().unwrap())
        .collect()
}

#[test]
fn every_file_and_name_on_the_architecture_page_exists() {
    let text = page(ARCHITECTURE);
    let mut wrong = Vec::new();
    let mut names = 0;
    for word in code_words(&text) {
        let (path, name) = match word.split_once("::") {
            Some((path, name)) if path.ends_with(".rs") => (path, Some(name)),
            _ => (word, None),
        };
        let is_path = path.contains('/') || path.ends_with(".rs");
        if !is_path || path == "file.rs" {
            continue;
        }
        let place = placed(path);
        match (place.exists(), name) {
            (false, _) => wrong.push(format!("{path} does not exist")),
            (true, Some(name)) => {
                names += 1;
                if !defines(&fs::read_to_string(&place).unwrap(), name) {
                    wrong.push(format!("{path} defines no {name}"));
                }
            }
            (true, None) => {}
        }
    }
    assert!(wrong.is_empty(), "{ARCHITECTURE}: {wrong:#?}");
    assert!(names > 50, "only {names} names were found on the page");
}

#[test]
fn every_room_and_every_folder_of_the_analysis_is_on_the_architecture_page() {
    let text = page(ARCHITECTURE);
    let words = code_words(&text);
    let rooms = folders_in("src").into_iter();
    let folders = folders_in("src/analysis").into_iter();
    let missing: Vec<String> = rooms
        .chain(folders.map(|folder| format!("analysis/{folder}/")))
        .filter(|wanted| !words.contains(&wanted.as_str()))
        .collect();
    assert!(
        missing.is_empty(),
        "{ARCHITECTURE} does not name {missing:#?}"
    );
}

#[test]
fn every_link_leads_to_a_file() {
    let mut wrong = Vec::new();
    for place in PAGES {
        let text = page(place);
        let folder = root().join(place).parent().unwrap().to_owned();
        for target in links(&text) {
            if !folder.join(target).exists() {
                wrong.push(format!("{place} links to {target}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_readme_is_short_and_names_the_test_command() {
    let text = page("README.md");
    let lines = text.lines().count();
    assert!(lines <= MAX_README_LINES, "{lines} lines");
    let block = text.split_once("<!-- test command -->\n```sh\n").unwrap().1;
    let command = block.split_once("\n```").unwrap().0;
    assert_eq!(command, "./setup.sh && cargo test --release");
}

#[test]
fn names_count_where_they_are_defined_and_links_where_they_lead_to_a_file() {
    let source = "pub(super) fn measure(a: u8) {}\n// fn other\nconst MAX: u8 = measure_all();";
    assert!(defines(source, "measure") && defines(source, "MAX"));
    assert!(!defines(source, "measure_all") && !defines(source, "meas"));
    let page = "`a.rs::b` and\n```sh\n`not/this.rs`\n```\n[x](y.md#z), [w](https://w), ![v](u.png)";
    assert_eq!(code_words(page), ["a.rs::b"]);
    assert_eq!(links(page), ["y.md", "u.png"]);
}
