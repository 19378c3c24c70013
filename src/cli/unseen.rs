//! The main job where there is no window: the whole analysis into a folder.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::cli::analyze::analyzed;
use crate::cli::args::plain_analysis;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, say};
use crate::cli::run::exit_code;
use crate::cli::work::hear_ctrl_c;

/// Where the report goes, in the current folder.
const FOLDER: &str = "cardiomorph-report";

/// Analyses `paths`, or the built-in cohort if there are none, because a window cannot be opened
/// for the given reason. Writes tables and figures into a folder and prints its path.
pub fn run_unseen(reason: &str, paths: &[PathBuf]) -> ExitCode {
    hear_ctrl_c();
    let what = if paths.is_empty() {
        "the built-in cohort"
    } else {
        "the given paths"
    };
    say(&format!(
        "cardiomorph: {reason}; analysing {what} without a window"
    ));
    exit_code(report(paths))
}

fn report(paths: &[PathBuf]) -> Result<(), CliError> {
    let folder = Path::new(FOLDER);
    analyzed(&plain_analysis(paths, folder)?)?;
    let place = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    print(&place.display().to_string())
}
