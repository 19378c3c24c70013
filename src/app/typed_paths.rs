//! Paths that are typed where the system shows no file dialog: completed and checked off the window's thread.

use std::path::{Path, PathBuf};

use crate::document::PathEntry;
use crate::document::state::State;
use crate::engine::{CompletedPath, Engine, Job, completed_path, typed_path};
use crate::picture::page::PageFormat;

use super::opened_classifiers::with_json_ending;
use super::path_question::{PathQuestion, Then};

/// What became of what was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Reply {
    /// It goes on like this, with these names to choose from.
    Completed(CompletedPath),
    /// It is taken.
    Taken(Vec<PathBuf>),
    /// Something lies there: the text, and what that is.
    Replaces(String, String),
}

/// The path that is being typed, if one is.
#[derive(Default)]
pub struct TypedPaths {
    open: Option<(PathQuestion, Then)>,
    work: Option<Job<Reply, String>>,
    revision: u64,
    /// Where the last path was typed.
    folder: Option<PathBuf>,
}

impl TypedPaths {
    /// Whether the sheet is open.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Asks by the sheet.
    pub fn ask(&mut self, state: &mut State, question: PathQuestion, then: Then) {
        let folder = self.folder.clone();
        let folder = folder.or_else(|| std::env::current_dir().ok());
        let start = free_place(&question, &folder.unwrap_or_default());
        self.revision += 1;
        state.path_entry = Some(PathEntry {
            title: question.title().to_owned(),
            verb: question.verb(),
            text: start.display().to_string(),
            revision: self.revision,
            ..PathEntry::default()
        });
        self.open = Some((question, then));
    }

    /// Completes the last name of a path.
    pub fn complete(&mut self, engine: &Engine, text: String) {
        if let Some((question, _)) = &self.open {
            let files = matches!(
                question,
                PathQuestion::OpenFiles | PathQuestion::OpenClassifier
            );
            let work = move |_: &_| Ok(Reply::Completed(completed_path(&text, files)));
            self.work = Some(engine.spawn_aside(work));
        }
    }

    /// Takes a path, if it can be: what lies there is replaced only if that was agreed to.
    pub fn take(&mut self, engine: &Engine, text: String, replace: bool) {
        if let Some((question, _)) = &self.open {
            let question = question.clone();
            self.work = Some(engine.spawn_aside(move |_| checked(&question, &text, replace)));
        }
    }

    /// Closes the sheet; nothing is done.
    pub fn cancel(&mut self, state: &mut State) {
        self.open = None;
        self.work = None;
        state.path_entry = None;
    }

    /// Follows what was found: the paths that were taken, with what is to be done with them.
    pub fn poll(&mut self, state: &mut State) -> Option<(Vec<PathBuf>, Then)> {
        let outcome = self.work.as_mut()?.poll()?;
        self.work = None;
        let entry = state.path_entry.as_mut()?;
        (entry.refused, entry.replaces) = (None, None);
        entry.choices.clear();
        match outcome {
            Ok(Reply::Completed(completed)) => {
                self.revision += 1;
                (entry.text, entry.revision) = (completed.text, self.revision);
                entry.choices = completed.choices;
            }
            Ok(Reply::Replaces(text, words)) => entry.replaces = Some((text, words)),
            Err(reason) => entry.refused = Some(reason.to_string()),
            Ok(Reply::Taken(paths)) => {
                state.path_entry = None;
                let (_, then) = self.open.take()?;
                let last = paths.first().and_then(|path| path.parent());
                self.folder = last.map(Path::to_owned);
                return Some((paths, then));
            }
        }
        None
    }
}

/// Most names that are tried.
const MAX_NAMES: u32 = 1000;

/// The place that is proposed; for a study, which is written into an empty folder alone, the first name that is free.
fn free_place(question: &PathQuestion, folder: &Path) -> PathBuf {
    let first = folder.join(question.suggested());
    if *question != PathQuestion::SaveStudy || !first.exists() {
        return first;
    }
    let others = (2..MAX_NAMES).map(|n| folder.join(format!("{}-{n}", question.suggested())));
    let mut free = others.filter(|place| !place.exists());
    free.next().unwrap_or(first)
}

/// Whether a path answers a question, in words where it does not.
fn checked(question: &PathQuestion, text: &str, replace: bool) -> Result<Reply, String> {
    if text.trim().is_empty() {
        return Err("no path was typed".to_owned());
    }
    let path = typed_path(text.trim());
    let shown = path.display();
    let lies_there = |words: String| Ok(Reply::Replaces(text.to_owned(), words));
    match question {
        PathQuestion::OpenFiles | PathQuestion::OpenFolders | PathQuestion::OpenClassifier => {
            if !path.exists() {
                return Err(format!("there is no such file or folder: {shown}"));
            }
            if *question == PathQuestion::OpenClassifier && path.is_dir() {
                return Err(format!("this is a folder, not a file: {shown}"));
            }
            if *question == PathQuestion::OpenFolders && !path.is_dir() {
                return Err(format!("this is a file, not a folder: {shown}"));
            }
        }
        PathQuestion::SaveFigure { .. } | PathQuestion::SaveClassifier => {
            if path.is_dir() {
                return Err(format!("this is a folder; a name is missing: {shown}"));
            }
            let is_classifier = *question == PathQuestion::SaveClassifier;
            let path = match is_classifier {
                true => with_json_ending(path),
                false => with_png_ending(path),
            };
            if !is_classifier && PageFormat::of(&path).is_none() {
                return Err("the name must end in .png, .svg or .pdf".to_owned());
            }
            check_parent(&path)?;
            if !replace && (path.exists() || path.is_symlink()) {
                return lies_there(format!("a file lies there already: {}", path.display()));
            }
            return Ok(Reply::Taken(vec![path]));
        }
        PathQuestion::SaveTables | PathQuestion::SaveStudy => {
            if path.is_file() {
                return Err(format!("this is a file, not a folder: {shown}"));
            }
            if !path.is_dir() {
                check_parent(&path)?;
            }
            if !replace && path.join("summary.json").exists() {
                return lies_there(format!("tables of an earlier run lie there: {shown}"));
            }
        }
    }
    Ok(Reply::Taken(vec![path]))
}

fn check_parent(path: &Path) -> Result<(), String> {
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    match parent {
        Some(parent) if !parent.is_dir() => {
            Err(format!("there is no such folder: {}", parent.display()))
        }
        _ => Ok(()),
    }
}

/// A name without an ending becomes one of a picture.
pub fn with_png_ending(path: PathBuf) -> PathBuf {
    match path.extension() {
        Some(_) => path,
        None => path.with_extension("png"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{ExportFile, write_files};

    #[test]
    fn a_path_that_cannot_be_taken_is_refused_in_words() {
        let folder = tempfile::tempdir().unwrap();
        let names = ["old.png", "old.txt", "tables/summary.json"];
        let files = names.map(|name| ExportFile::text(folder.path(), name, String::new()));
        write_files(files.into()).unwrap();
        let at = format!("{}/", folder.path().display());
        let save = PathQuestion::SaveFigure {
            title: "Save",
            suggested: "P05.png".to_owned(),
        };
        let tables = PathQuestion::SaveTables;
        for (question, name, words) in [
            (&save, "", "folder"),
            (&save, "a.docx", "must end in"),
            (&save, "none/a.png", "there is no such folder"),
            (&tables, "old.txt", "not a folder"),
            (
                &PathQuestion::OpenFiles,
                "none.ply",
                "no such file or folder",
            ),
            (&PathQuestion::OpenFolders, "old.txt", "not a folder"),
            (&PathQuestion::OpenClassifier, "tables", "not a file"),
            (&PathQuestion::SaveClassifier, "none/rule", "no such folder"),
        ] {
            let refused = checked(question, &format!("{at}{name}"), false).unwrap_err();
            assert!(refused.contains(words), "{name}: {refused}");
        }
        assert!(checked(&save, "  ", false).is_err());
        for name in ["old", "old.png"] {
            let text = format!("{at}{name}");
            let asked = checked(&save, &text, false).unwrap();
            assert!(matches!(&asked, Reply::Replaces(about, _) if *about == text));
            let taken = checked(&save, &text, true).unwrap();
            assert_eq!(
                taken,
                Reply::Taken(vec![PathBuf::from(format!("{at}old.png"))])
            );
        }
        let asked = checked(&tables, &format!("{at}tables"), false).unwrap();
        assert!(matches!(asked, Reply::Replaces(..)), "tables lie there");
        let new = PathBuf::from(format!("{at}tables/new"));
        let taken = checked(&tables, &format!("{at}tables/new"), false).unwrap();
        assert_eq!(taken, Reply::Taken(vec![new]));
    }

    #[test]
    fn a_study_is_proposed_where_nothing_lies() {
        let study = PathQuestion::SaveStudy;
        let proposed = |taken: &[&str]| {
            let folder = tempfile::tempdir().unwrap();
            let named = |name: &&str| {
                let exact = tempfile::Builder::new()
                    .prefix(*name)
                    .rand_bytes(0)
                    .tempdir_in(folder.path());
                exact.unwrap()
            };
            let _taken: Vec<_> = taken.iter().map(named).collect();
            let place = free_place(&study, folder.path());
            place.file_name().unwrap().to_owned()
        };
        assert_eq!(proposed(&[]), "cardiomorph-study");
        assert_eq!(proposed(&["cardiomorph-study"]), "cardiomorph-study-2");
        let taken = ["cardiomorph-study", "cardiomorph-study-2"];
        assert_eq!(proposed(&taken), "cardiomorph-study-3");
    }
}
