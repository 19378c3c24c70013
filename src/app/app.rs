//! The window as eframe sees it.

use std::path::PathBuf;

/// What the window begins with.
#[derive(Clone, Debug, Default)]
pub struct AppOptions {
    /// Files and folders to open; the built-in cohort if there are none.
    pub paths: Vec<PathBuf>,
}

impl AppOptions {
    /// Opens `paths`, or the built-in cohort if there are none.
    pub fn opening(paths: Vec<PathBuf>) -> Self {
        Self { paths }
    }
}

/// The window.
#[derive(Debug)]
pub struct App {
    options: AppOptions,
}

impl App {
    /// Prepares the window.
    ///
    /// # Errors
    /// If the operating system refuses the threads for background work.
    pub fn new(_cc: &eframe::CreationContext<'_>, options: AppOptions) -> std::io::Result<Self> {
        Ok(Self { options })
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        ui.label(format!("{} paths", self.options.paths.len()));
    }
}
