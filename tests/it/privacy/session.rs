//! A session of the window on files with seeded words: what it shows, remembers and exports.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

use cardiomorph::app::{App, AppOptions};
use cardiomorph::panes::{Command, FileCommand, Pane};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT;

use super::search::{Searched, Words};
use super::{INPUTS, THE_WHOLE_WAY, seeded};
use crate::shared::shared_data;

/// What the window remembers from one run to the next.
#[derive(Default)]
struct Memory(BTreeMap<String, String>);

impl eframe::Storage for Memory {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

fn window(path: &Path) -> Harness<'static, App> {
    let options = AppOptions::opening(vec![path.to_owned()]);
    Harness::builder()
        .with_size([1400.0, 900.0])
        .with_max_steps(64)
        .build_eframe(move |cc| App::new(cc, options).unwrap())
}

/// Steps until nothing has worked for a while.
fn settle(harness: &mut Harness<'_, App>) {
    let begin = Instant::now();
    let mut quiet = 0;
    while quiet < 30 {
        assert!(begin.elapsed() < Duration::from_secs(120), "still at work");
        harness.step();
        std::thread::sleep(Duration::from_millis(4));
        quiet = if harness.state().busy() { 0 } else { quiet + 1 };
    }
}

/// Every word on the screen: names and values of all that can be read out.
fn on_screen(harness: &Harness<'_, App>) -> String {
    let mut words = Vec::new();
    for node in harness.root().children_recursive() {
        let node = node.accesskit_node();
        words.extend(
            [node.label(), node.value(), node.description()]
                .into_iter()
                .flatten(),
        );
    }
    words.join("\n")
}

fn exported(harness: &mut Harness<'_, App>, folder: &Path) {
    let path = |name: &str| Some(folder.join(name));
    let mut exports = vec![
        FileCommand::ExportTables(path("tables")),
        FileCommand::ExportStudy(path("study")),
    ];
    for ending in ["png", "svg", "pdf"] {
        exports.push(FileCommand::ExportFigure(path(&format!("figure.{ending}"))));
        exports.push(FileCommand::ExportPatchFigure(path(&format!(
            "patch.{ending}"
        ))));
    }
    let panes = [
        Pane::POSE_MAP,
        Pane::DEFORMATION_MAP,
        Pane::BULLS_EYE,
        Pane::CURVES,
    ];
    for (number, pane) in panes.into_iter().enumerate() {
        let figure = path(&format!("pane_{number}.png"));
        exports.push(FileCommand::ExportPaneFigure(pane, figure));
    }
    for export in exports {
        harness.state_mut().push(Command::File(export));
        harness.run_steps(2);
        settle(harness);
    }
}

/// Opens a path, exports all that can be exported (or nothing), and looks through everything. What was on screen, too.
fn searched(path: &Path, exports: bool, words: &Words) -> (Searched, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = window(path);
    settle(&mut harness);
    let mut shown = on_screen(&harness);
    if exports {
        exported(&mut harness, folder.path());
        shown += &on_screen(&harness);
    }
    let mut memory = Memory::default();
    eframe::App::save(harness.state_mut(), &mut memory);
    let mut searched = Searched::folder(words, folder.path());
    searched.note("the screen", &words.within(shown.as_bytes()));
    searched.note(
        "what is kept",
        &words.within(format!("{:?}", memory.0).as_bytes()),
    );
    let state = harness.state().state();
    let held = format!("{:?} {:?}", state.document.study(), state.errors);
    searched.note("the document", &words.within(held.as_bytes()));
    (searched, shown)
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn nothing_of_a_patient_is_on_screen_in_exports_or_in_what_is_kept_of_a_session() {
    let mut files = 0;
    for (number, place) in INPUTS.into_iter().enumerate() {
        let path = shared_data(&format!("images/{place}"));
        let (searched, shown) = searched(&path, number < THE_WHOLE_WAY, &seeded());
        assert!(searched.found.is_empty(), "{place}: {:#?}", searched.found);
        assert!(shown.len() > 200, "{place}: {shown}");
        files += searched.files.len();
        let kib = searched.bytes / 1024;
        println!("{place}: {} files of {kib} KiB", searched.files.len());
    }
    assert!(files > 20, "{files} files were exported");
}

/// The other way round: the name of a file is on screen, in the document and in the exports, and is found there.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_search_of_a_session_finds_a_name_that_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    for part in ["endo", "epi"] {
        let from = shared_data(&format!("images/gated_spect_dicom/p1/truth_{part}.nii.gz"));
        let to = folder.path().join(format!("Zebulon-Quux_{part}.nii.gz"));
        std::fs::copy(from, to).unwrap();
    }
    let (searched, _) = searched(folder.path(), true, &Words::new(["ZEBULON^QUUX"]));
    for place in ["the screen", "the document", "study.toml", "subjects.csv"] {
        assert!(
            searched.found.iter().any(|found| found.contains(place)),
            "not in {place}: {:#?}",
            searched.found
        );
    }
}
