//! Classifiers as files: read off the window's thread, and trained on the study on screen.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::analysis::verdicts::CheckedClassifier;
use crate::document::state::State;
use crate::engine::{Engine, Job, TrainedClassifierQuery, classifier_file, read_classifier};
use crate::panes::{ClassifierCommand, Command};
use crate::study::Study;
use crate::ui::text::counted;

use super::asks::verdict_settings;
use super::errors::{interruption, push_card};

/// Title of the card that says why a file gives no classifier.
const FAILED: &str = "The classifier could not be used";

/// The one classifier among paths, and the other paths. Of several none is taken.
pub fn split_classifier(mut paths: Vec<PathBuf>) -> (Option<PathBuf>, Vec<PathBuf>) {
    match paths.iter().filter(|path| is_classifier(path)).count() {
        1 => {
            let rule = paths.iter().position(|path| is_classifier(path));
            (rule.map(|index| paths.remove(index)), paths)
        }
        _ => (None, paths),
    }
}

/// Whether a path is that of a classifier, by its ending.
pub fn is_classifier(path: &Path) -> bool {
    (path.extension()).is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
}

/// For which study a classifier is read.
#[derive(Clone, Copy)]
struct Wanted {
    /// Which opening was on screen when it was asked for.
    opening: u64,
    /// Whether it is for the study that was named with it, which comes after that.
    next: bool,
}

/// Reads classifiers, one at a time; a later one takes the place of an earlier.
#[derive(Default)]
pub struct OpenedClassifiers {
    reading: Option<(Job<CheckedClassifier, String>, Wanted)>,
    /// Read, and waiting for its study.
    waiting: Option<(Arc<CheckedClassifier>, Wanted)>,
}

impl OpenedClassifiers {
    /// Begins to read one; `next` says whether it is for a study that was named with it.
    pub fn read(&mut self, state: &State, engine: &Engine, path: PathBuf, next: bool) {
        let opening = state.document.study.opening;
        let job = engine.spawn_aside(move |_| read_classifier(&path));
        self.reading = Some((job, Wanted { opening, next }));
        self.waiting = None;
    }

    /// What follows from what was read: that it is used, once its study is there.
    pub fn poll(&mut self, state: &mut State, engine: &Engine) -> Option<Command> {
        if let Some(outcome) = self.reading.as_mut().and_then(|(job, _)| job.poll()) {
            let (_, wanted) = self.reading.take()?;
            match outcome {
                Ok(rule) => self.waiting = Some((Arc::new(rule), wanted)),
                Err(error) => push_card(&mut state.errors, FAILED, error.to_string()),
            }
        }
        let Wanted { opening, next } = self.waiting.as_ref()?.1;
        let is_new = state.document.study.opening != opening;
        if next && !is_new && engine.opening() {
            return None;
        }
        let (rule, _) = self.waiting.take()?;
        if next == is_new {
            return Some(ClassifierCommand::Use(rule).into());
        }
        if is_new {
            let why = "another study was opened before it was read";
            push_card(&mut state.errors, FAILED, why);
        }
        // What was named with it could not be opened, which has a card.
        None
    }
}

/// A study and settings as they were when a classifier was to be trained on it.
pub struct ClassifierExport {
    study: Arc<Study>,
    query: TrainedClassifierQuery,
}

impl ClassifierExport {
    /// What `learn` writes, with the thresholds on screen.
    pub fn now(state: &State) -> Self {
        let mut verdicts = verdict_settings(&state.document);
        // The labels of the study train it, whatever classifies the study on screen.
        verdicts.rule = None;
        Self {
            study: Arc::clone(state.document.study()),
            query: TrainedClassifierQuery::new(verdicts),
        }
    }

    /// Trains and writes it, off the window's thread.
    pub fn write(self, engine: &mut Engine, path: PathBuf) {
        let path = with_json_ending(path);
        let store = Arc::clone(engine.store());
        let words = counted(self.study.count(), "subject");
        engine.start_export("Classifier", words, move |progress| {
            let rule = store.answer(&self.study, &self.query, progress);
            let rule = rule.map_err(interruption)?;
            let file = classifier_file(&rule, path).map_err(|error| error.to_string())?;
            Ok(vec![file])
        });
    }
}

/// A name without an ending becomes one of a classifier.
pub fn with_json_ending(path: PathBuf) -> PathBuf {
    match path.extension().and_then(OsStr::to_str) {
        Some(_) => path,
        None => path.with_extension("json"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_classifier_among_paths_is_the_one_that_ends_in_json() {
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        let (rule, others) = split_classifier(paths(&["study", "a.JSON"]));
        assert_eq!(
            (rule, others),
            (Some(PathBuf::from("a.JSON")), paths(&["study"]))
        );
        let two = paths(&["a.json", "b.json"]);
        assert_eq!(split_classifier(two.clone()), (None, two));
        assert_eq!(with_json_ending("a".into()), PathBuf::from("a.json"));
    }
}
