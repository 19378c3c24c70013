//! The folder of an analysis: each table stands there as soon as it is known, and `summary.json` says what is missing.

use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde_json::{Value, json};

use crate::engine::export::{ExportFile, cannot_write, free_name_beside, staged, write_files};
use crate::report::pretty_json;

/// Its name is a promise to scripts.
const SUMMARY: &str = "summary.json";
/// Who wrote a summary; only files of such a one are removed.
const PROGRAM: &str = "Cardiomorph";
/// A summary of any study is far smaller.
const MAX_SUMMARY_BYTES: u64 = 256 << 20;

/// A folder into which one run writes its results one by one.
///
/// What an earlier run left there by its own account goes when the first result of this one comes, and a summary with
/// `"complete": false` takes its place until [`Self::finish`]: whenever the run ends, by a failure, a stop or a full disk, no
/// table of this run stands beside one of another.
#[derive(Debug)]
pub struct ResultFolder {
    folder: PathBuf,
    written: Mutex<Vec<String>>,
}

impl ResultFolder {
    /// Nothing is touched yet.
    pub fn new(folder: PathBuf) -> Self {
        Self {
            folder,
            written: Mutex::default(),
        }
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.folder
    }

    /// Names of what was written so far, relative to the folder.
    pub fn written(&self) -> Vec<String> {
        self.names().clone()
    }

    /// Writes results.
    ///
    /// # Errors
    /// If one cannot be written: why, and which.
    pub fn write(&self, files: Vec<ExportFile>) -> Result<(), String> {
        let mut names = self.names();
        if names.is_empty() {
            clear_earlier(&self.folder);
            write_summary(&self.folder, &unfinished(&[], &[], "the run has not ended"))?;
        }
        for file in files {
            let name = name_in(&self.folder, &file.path);
            write_files(vec![file])?;
            names.extend(name);
        }
        Ok(())
    }

    /// Writes the summary of a whole run and returns it, with its list of files.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(&self, mut summary: Value) -> Result<Value, String> {
        complete(&mut summary, &self.names());
        write_summary(&self.folder, &summary)?;
        Ok(summary)
    }

    /// Says in the summary that the run ended early, why, and which of the `expected` files are missing, and returns that as
    /// a sentence. Where nothing was written, nothing is touched and there is no sentence.
    ///
    /// # Errors
    /// If the summary cannot be written.
    pub fn give_up(&self, expected: &[String], reason: &str) -> Result<Option<String>, String> {
        let written = self.names();
        if written.is_empty() {
            return Ok(None);
        }
        let missing: Vec<&str> = (expected.iter())
            .filter(|name| !written.contains(name))
            .map(String::as_str)
            .collect();
        write_summary(&self.folder, &unfinished(&written, &missing, reason))?;
        Ok(Some(format!(
            "{} files stand in {}; missing: {}",
            written.len(),
            self.folder.display(),
            missing.join(", ")
        )))
    }

    fn names(&self) -> MutexGuard<'_, Vec<String>> {
        self.written.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The summary of a whole run with the names of its files.
pub(super) fn complete(summary: &mut Value, names: &[String]) {
    if let Value::Object(object) = summary {
        object.insert("files".to_owned(), json!(names));
        object.insert("complete".to_owned(), json!(true));
    }
}

/// The name of a file within the folder.
pub(super) fn name_in(folder: &Path, path: &Path) -> Option<String> {
    let name = path.strip_prefix(folder).ok()?;
    Some(name.display().to_string())
}

fn unfinished(written: &[String], missing: &[&str], reason: &str) -> Value {
    json!({
        "program": PROGRAM,
        "version": env!("CARGO_PKG_VERSION"),
        "note": "research use, not for diagnosis",
        "complete": false,
        "reason": reason,
        "missing": missing,
        "files": written,
    })
}

fn write_summary(folder: &Path, summary: &Value) -> Result<(), String> {
    let text = pretty_json(summary).map_err(|error| error.to_string())?;
    write_files(vec![ExportFile::text(folder, SUMMARY, text)]).map(|_| ())
}

/// Writes the results of a whole run in place of those of an earlier one: all of them, or nothing changes.
///
/// What an earlier run left there by its own account is moved aside and goes once everything new stands. A failure moves it
/// back; where the program is killed in between, no summary stands beside a mixture.
///
/// # Errors
/// If a result cannot be written: why, and which.
pub fn replace_results(folder: &Path, files: Vec<ExportFile>) -> Result<Vec<PathBuf>, String> {
    let mut staged = staged(files)?;
    let mut old = earlier_results(folder);
    let unlisted = (staged.iter())
        .map(|partial| partial.place().to_owned())
        .filter(|place| !old.contains(place))
        .collect::<Vec<_>>();
    old.extend(unlisted);
    let mut aside: Vec<(PathBuf, PathBuf)> = Vec::new();
    let mut placed: Vec<PathBuf> = Vec::new();
    let outcome = (old.into_iter())
        .try_for_each(|place| {
            if fs::symlink_metadata(&place).is_ok() {
                let beside = free_name_beside(&place);
                fs::rename(&place, &beside).map_err(|error| cannot_write(&error, &place))?;
                aside.push((place, beside));
            }
            Ok(())
        })
        .and_then(|()| {
            staged.iter_mut().try_for_each(|partial| {
                let named = partial.finish();
                named.map_err(|error| cannot_write(&error, partial.place()))?;
                placed.push(partial.place().to_owned());
                Ok(())
            })
        });
    if let Err(reason) = outcome {
        for place in placed {
            fs::remove_file(place).ok();
        }
        for (place, beside) in aside.into_iter().rev() {
            fs::rename(beside, place).ok();
        }
        return Err(reason);
    }
    for (_, beside) in aside {
        fs::remove_file(beside).ok();
    }
    Ok(placed)
}

/// Removes the results of an earlier run, the summary first. What cannot be removed stays, and is written over or reported
/// when its turn comes.
fn clear_earlier(folder: &Path) {
    for path in earlier_results(folder) {
        fs::remove_file(path).ok();
    }
}

/// The results of an earlier run that its summary lists, the summary first; none without such a summary.
///
/// Nothing else in the folder is among them: no file that this program did not write, and nothing outside, whatever the
/// list says.
fn earlier_results(folder: &Path) -> Vec<PathBuf> {
    let place = folder.join(SUMMARY);
    let small = fs::symlink_metadata(&place)
        .is_ok_and(|found| found.is_file() && found.len() <= MAX_SUMMARY_BYTES);
    let earlier: Option<Value> = (small.then(|| fs::read(&place).ok()).flatten())
        .and_then(|bytes| serde_json::from_slice(&bytes).ok());
    let Some(earlier) = earlier.filter(|summary| summary["program"] == PROGRAM) else {
        return Vec::new();
    };
    let names = earlier["files"].as_array().into_iter().flatten();
    let places = names
        .filter_map(Value::as_str)
        .filter_map(|name| result_place(folder, Path::new(name)))
        .filter(|path| fs::symlink_metadata(path).is_ok_and(|found| !found.is_dir()));
    std::iter::once(place).chain(places).collect()
}

/// Where a result of this name lies: in the folder or in `figures`, if that is no link.
fn result_place(folder: &Path, name: &Path) -> Option<PathBuf> {
    let ending = name.extension()?.to_str()?;
    let known = ["csv", "json", "md", "npy", "pdf", "png"].contains(&ending);
    let parts: Vec<Component<'_>> = name.components().collect();
    let inside = match parts[..] {
        [Component::Normal(_)] => true,
        [Component::Normal(figures), Component::Normal(_)] => {
            let real = fs::symlink_metadata(folder.join(figures));
            figures == "figures" && real.is_ok_and(|found| found.is_dir())
        }
        _ => false,
    };
    (known && inside).then(|| folder.join(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary(folder: &Path) -> Value {
        serde_json::from_slice(&fs::read(folder.join(SUMMARY)).unwrap()).unwrap()
    }

    fn table(folder: &Path, name: &str) -> Vec<ExportFile> {
        vec![ExportFile::text(folder, name, "subject\n".to_owned())]
    }

    #[test]
    fn a_run_that_fails_says_what_is_missing_and_leaves_nothing_of_the_run_before() {
        let place = tempfile::tempdir().unwrap();
        let folder = place.path();
        let first = ResultFolder::new(folder.to_owned());
        first.write(table(folder, "frames.csv")).unwrap();
        first.write(table(folder, "figures/P1.png")).unwrap();
        assert_eq!(summary(folder)["complete"], false, "a kill leaves this");
        first.finish(json!({ "program": PROGRAM })).unwrap();
        assert_eq!(summary(folder)["complete"], true);
        fs::write(folder.join("notes.csv"), "mine").unwrap();

        let second = ResultFolder::new(folder.to_owned());
        assert_eq!(second.give_up(&[], "stopped"), Ok(None));
        assert_eq!(summary(folder)["complete"], true, "nothing was begun");
        second.write(table(folder, "subjects.csv")).unwrap();
        let expected = ["subjects.csv", "frames.csv"].map(str::to_owned);
        let words = second.give_up(&expected, "disk full").unwrap().unwrap();
        assert!(words.ends_with("missing: frames.csv"), "{words}");
        let said = summary(folder);
        assert_eq!(said["reason"], "disk full");
        assert_eq!(said["missing"], json!(["frames.csv"]));
        assert_eq!(said["files"], json!(["subjects.csv"]));
        assert!(!folder.join("frames.csv").exists() && !folder.join("figures/P1.png").exists());
        assert!(folder.join("notes.csv").exists(), "not written by a run");
    }

    #[test]
    fn results_take_the_place_of_those_of_an_earlier_run_together_or_not_at_all() {
        let place = tempfile::tempdir().unwrap();
        let folder = place.path();
        let names = || {
            let entries = fs::read_dir(folder).unwrap();
            let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
            let mut names: Vec<_> = entries.map(name).collect();
            names.sort();
            names
        };
        let first = ResultFolder::new(folder.to_owned());
        first.write(table(folder, "frames.csv")).unwrap();
        first.write(table(folder, "verdicts.csv")).unwrap();
        first.finish(json!({ "program": PROGRAM })).unwrap();
        fs::write(folder.join("notes.csv"), "mine").unwrap();
        let before = (names(), summary(folder));

        // A folder lies where a table is to go.
        fs::create_dir(folder.join("subjects.csv")).unwrap();
        let new = |name: &str| ExportFile::text(folder, name, "new\n".to_owned());
        let files = || vec![new("frames.csv"), new("subjects.csv")];
        replace_results(folder, files()).unwrap_err();
        fs::remove_dir(folder.join("subjects.csv")).unwrap();
        assert_eq!((names(), summary(folder)), before);
        let frames = || fs::read_to_string(folder.join("frames.csv")).unwrap();
        assert_eq!(frames(), "subject\n");

        let written = replace_results(folder, files()).unwrap();
        assert_eq!(written.len(), 2);
        assert_eq!(names(), ["frames.csv", "notes.csv", "subjects.csv"]);
        assert_eq!(frames(), "new\n");
    }

    #[test]
    fn a_list_that_leads_elsewhere_removes_nothing_there() {
        let place = tempfile::tempdir().unwrap();
        let (folder, outside) = (place.path().join("out"), place.path().join("mine.csv"));
        fs::create_dir(&folder).unwrap();
        fs::write(&outside, "mine").unwrap();
        fs::write(folder.join("thesis.tex"), "mine").unwrap();
        let files = json!(["../mine.csv", outside, "thesis.tex", "a/../../mine.csv"]);
        let earlier = json!({ "program": PROGRAM, "files": files });
        fs::write(folder.join(SUMMARY), earlier.to_string()).unwrap();
        clear_earlier(&folder);
        assert!(outside.exists() && folder.join("thesis.tex").exists());
        assert!(!folder.join(SUMMARY).exists());
    }

    #[test]
    fn a_summary_of_another_program_is_left_alone() {
        let place = tempfile::tempdir().unwrap();
        let other = json!({ "program": "other", "files": ["a.csv"] });
        fs::write(place.path().join(SUMMARY), other.to_string()).unwrap();
        fs::write(place.path().join("a.csv"), "theirs").unwrap();
        clear_earlier(place.path());
        assert!(place.path().join("a.csv").exists() && place.path().join(SUMMARY).exists());
    }
}
