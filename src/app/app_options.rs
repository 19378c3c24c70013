//! What the window begins with.

use std::path::PathBuf;
use std::time::Instant;

use crate::engine::OpenSource;
use crate::study::built_in::BuiltInParams;

use super::dialogs::system_dialogs;
use super::path_question::AskPaths;

/// What the window begins with.
#[derive(Clone)]
pub struct AppOptions {
    /// What is opened first; nothing if `None`.
    pub open: Option<OpenSource>,
    /// How finely the built-in cohort is made when it is asked for.
    pub built_in: BuiltInParams,
    /// When the program began, for the times that it can print.
    pub started: Instant,
    /// Who is asked for files and folders.
    pub ask_paths: AskPaths,
    /// Whether somebody looks on: only what changed is drawn again, and with fewer pixels while something moves if the
    /// machine is slow. Otherwise every picture is drawn whole and in full.
    pub live: bool,
}

impl AppOptions {
    /// Opens `paths`, or the built-in cohort if there are none.
    pub fn opening(paths: Vec<PathBuf>) -> Self {
        Self {
            open: Some(OpenSource::paths_or_built_in(paths)),
            built_in: BuiltInParams::default(),
            started: Instant::now(),
            ask_paths: system_dialogs(),
            live: false,
        }
    }

    /// Opens a built-in cohort of another size.
    pub fn built_in(params: BuiltInParams) -> Self {
        Self {
            open: Some(OpenSource::BuiltIn(params)),
            built_in: params,
            ..Self::opening(Vec::new())
        }
    }

    /// Opens nothing.
    pub fn empty() -> Self {
        Self {
            open: None,
            ..Self::opening(Vec::new())
        }
    }
}
