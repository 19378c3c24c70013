//! The plan of the house, kept true by test: who may use whom, and which doors stay shut.
#![expect(
    clippy::unwrap_used,
    reason = "a source file that cannot be read is a failed test"
)]

#[path = "architecture/cycles.rs"]
mod cycles;

use std::fs;
use std::path::{Path, PathBuf};

/// Each room with the rooms it may use. A room missing here fails the test.
/// `src/ARCHITECTURE.md` draws the same plan and says why.
const MAY_USE: &[(&str, &[&str])] = &[
    ("lib", &[]),
    ("units", &[]),
    ("progress", &[]),
    ("numeric", &["progress"]),
    ("mesh", &["units", "numeric"]),
    ("image", &["units", "progress", "numeric", "mesh"]),
    ("study", &["units", "mesh"]),
    (
        "analysis",
        &["units", "progress", "numeric", "mesh", "image", "study"],
    ),
    ("io", &["units", "progress", "mesh", "image", "study"]),
    (
        "report",
        &["units", "progress", "mesh", "study", "analysis"],
    ),
    (
        "engine",
        &[
            "units", "progress", "numeric", "mesh", "image", "study", "analysis", "io", "report",
        ],
    ),
    ("render", &["units", "mesh"]),
    (
        "picture",
        &[
            "units", "progress", "mesh", "study", "analysis", "report", "render",
        ],
    ),
    ("ui", &["study", "picture"]),
    (
        "document",
        &[
            "units", "mesh", "image", "study", "analysis", "io", "engine", "render", "picture",
        ],
    ),
    (
        "panes",
        &[
            "units", "mesh", "image", "study", "analysis", "io", "report", "engine", "picture",
            "render", "ui", "document",
        ],
    ),
    (
        "app",
        &[
            "units", "progress", "mesh", "study", "analysis", "io", "report", "engine", "render",
            "picture", "ui", "panes", "document",
        ],
    ),
    (
        "cli",
        &[
            "units", "progress", "mesh", "image", "study", "analysis", "io", "report", "engine",
            "render", "picture",
        ],
    ),
    ("main", &[]),
];

/// Folders of `analysis` with the other folders each may use.
const ANALYSIS_MAY_USE: &[(&str, &[&str])] = &[
    ("mod.rs", &[]),
    ("alignment", &[]),
    ("surface_extraction", &[]),
    ("registration", &["alignment"]),
    ("measures", &[]),
    ("curvature", &[]),
    ("correspondence", &["alignment", "registration", "measures"]),
    ("medial", &["measures"]),
    ("medial_space", &["medial"]),
    ("segments", &["measures"]),
    ("thickness_methods", &["medial", "segments", "measures"]),
    (
        "thickening",
        &["medial", "medial_space", "segments", "measures"],
    ),
    (
        "medial_map",
        &[
            "measures",
            "medial",
            "medial_space",
            "thickening",
            "segments",
            "pose_distances",
            "embedding",
        ],
    ),
    (
        "verdicts",
        &[
            "thickening",
            "medial",
            "measures",
            "segments",
            "classification",
        ],
    ),
    ("walls_from_masks", &[]),
    ("walls_from_contours", &["walls_from_masks"]),
    ("walls_from_spect", &["walls_from_masks"]),
    ("walls_from_cine", &[]),
    (
        "preparation",
        &[
            "surface_extraction",
            "walls_from_masks",
            "walls_from_spect",
            "walls_from_cine",
            "walls_from_contours",
        ],
    ),
    ("metrics", &[]),
    ("geodesics", &["metrics"]),
    ("transport", &["alignment", "metrics", "geodesics"]),
    ("pose_distances", &["alignment", "metrics", "transport"]),
    ("embedding", &["pose_distances", "alignment"]),
    ("classification", &["pose_distances", "embedding"]),
    (
        "deformations",
        &[
            "alignment",
            "metrics",
            "transport",
            "pose_distances",
            "embedding",
        ],
    ),
    (
        "experiments",
        &[
            "alignment",
            "measures",
            "medial",
            "medial_space",
            "segments",
            "thickening",
            "metrics",
            "geodesics",
            "transport",
            "pose_distances",
            "embedding",
            "classification",
            "deformations",
        ],
    ),
];

/// Words from outside with the only rooms that may say them.
// A place with a slash is part of a room.
const FENCED: &[(&str, &[&str])] = &[
    ("egui::", &["ui", "panes", "app"]),
    ("eframe::", &["app"]),
    (
        "wgpu::",
        &["render", "panes/viewport/paint", "app/window_picture"],
    ),
    ("std::fs", &["io", "engine", "cli"]),
    ("std::thread", &["engine"]),
    ("Workers::", &["engine"]), // threads by another name
    ("Instant::now", &["engine", "panes", "app"]),
    ("println!", &["cli"]),
    ("super::super", &[]), // would leave the room unseen
];

const MOST_LINES: usize = 400;

struct SourceFile {
    place: PathBuf,
    room: String,
    text: String,
}

fn source_files() -> Vec<SourceFile> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = Vec::new();
    collect_rust_files(&src, &mut paths);
    paths.sort();
    paths
        .into_iter()
        .map(|path| {
            let place = path.strip_prefix(&src).unwrap().to_owned();
            let room = place.iter().next().unwrap().to_str().unwrap();
            let room = room.trim_end_matches(".rs").to_owned();
            SourceFile {
                text: fs::read_to_string(&path).unwrap(),
                place,
                room,
            }
        })
        .collect()
}

fn collect_rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect_rust_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

fn code_lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines()
        .filter(|line| !line.trim_start().starts_with("//"))
}

fn rooms_named(line: &str) -> impl Iterator<Item = &str> {
    line.split("crate::").skip(1).map(first_word)
}

fn first_word(text: &str) -> &str {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .next()
        .unwrap_or_default()
}

#[test]
fn rooms_use_only_the_rooms_they_may() {
    let mut wrong = Vec::new();
    for file in source_files() {
        let Some((_, allowed)) = MAY_USE.iter().find(|(room, _)| *room == file.room) else {
            wrong.push(format!(
                "{}: room {:?} is not on the plan",
                file.place.display(),
                file.room
            ));
            continue;
        };
        for used in code_lines(&file.text).flat_map(rooms_named) {
            if used != file.room && !allowed.contains(&used) {
                wrong.push(format!("{} uses crate::{used}", file.place.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn folders_of_the_analysis_use_only_what_they_may() {
    let mut wrong = Vec::new();
    for file in source_files().iter().filter(|file| file.room == "analysis") {
        let folder = file.place.iter().nth(1).unwrap().to_str().unwrap();
        let Some((_, allowed)) = ANALYSIS_MAY_USE.iter().find(|(name, _)| *name == folder) else {
            wrong.push(format!("analysis/{folder} is not on the plan"));
            continue;
        };
        for line in code_lines(&file.text) {
            for rest in line.split("crate::analysis::").skip(1) {
                let used = first_word(rest);
                if used != folder && !allowed.contains(&used) {
                    wrong.push(format!("{} uses analysis::{used}", file.place.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn outside_words_stay_in_their_rooms() {
    let mut wrong = Vec::new();
    for file in source_files() {
        for (word, rooms) in FENCED {
            let place = file.place.to_string_lossy();
            let allowed = |room: &&str| match room.contains('/') {
                true => place.contains(*room),
                false => file.room == **room,
            };
            if !rooms.iter().any(allowed) && code_lines(&file.text).any(|l| l.contains(word)) {
                wrong.push(format!("{} says {word}", file.place.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn files_stay_at_human_size() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    collect_rust_files(&root.join("src"), &mut paths);
    collect_rust_files(&root.join("tests"), &mut paths);
    let long = |path: &PathBuf| fs::read_to_string(path).unwrap().lines().count() > MOST_LINES;
    paths.retain(long);
    assert!(paths.is_empty(), "over {MOST_LINES} lines: {paths:#?}");
}

#[test]
fn every_file_opens_with_a_sentence() {
    let wrong: Vec<_> = source_files()
        .into_iter()
        .filter(|file| !file.text.starts_with("//!"))
        .map(|file| file.place)
        .collect();
    assert!(wrong.is_empty(), "no module doc comment: {wrong:#?}");
}
