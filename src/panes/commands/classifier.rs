//! Commands about the classifier from a file that makes the verdicts.

use super::action::{Menu, Row, row};
use crate::analysis::verdicts::CheckedClassifier;
use std::path::PathBuf;
use std::sync::Arc;

/// Commands about the classifier from a file that makes the verdicts.
#[derive(Clone, Debug, PartialEq)]
pub enum ClassifierCommand {
    /// Ask for its file.
    Choose,
    /// Read it, and classify by it.
    Open(PathBuf),
    /// Classify by it.
    Use(Arc<CheckedClassifier>),
    /// Classify by the labels of the study, or by the built-in one.
    Forget,
    /// Train one on the study and write it; `None` asks where.
    Export(Option<PathBuf>),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<ClassifierCommand>] = &[
    row(Menu::File, 1, "Open classifier…", None, ClassifierCommand::Choose),
    row(Menu::Analysis, 2, "Forget the opened classifier", None, ClassifierCommand::Forget),
    row(Menu::Export, 0, "Classifier trained on the study…", None, ClassifierCommand::Export(None)),
];
