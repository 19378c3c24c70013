//! Files that experiments write beside their tables: a figure and a summary.

use std::path::Path;

use serde_json::Value;

use crate::cli::outcome::CliError;
use crate::engine::ExportFile;
use crate::picture::page::{FigureFonts, Page, PageFormat};
use crate::report::pretty_json;

/// A figure drawn as SVG under a name in a folder.
///
/// # Errors
/// If the typefaces cannot be read or the figure cannot be written.
pub(super) fn figure_file(
    folder: &Path,
    name: &str,
    title: &str,
    draw: impl FnOnce(&FigureFonts) -> Page,
) -> Result<ExportFile, CliError> {
    let fonts = FigureFonts::load().map_err(CliError::unusable)?;
    let settings = vec![("Title", title.to_owned())];
    let bytes = PageFormat::Svg.file(&draw(&fonts), &settings, &fonts);
    Ok(ExportFile {
        path: folder.join(name),
        bytes: bytes.map_err(CliError::unusable)?.into(),
    })
}

/// `summary.json` in a folder.
///
/// # Errors
/// If it cannot be written as JSON.
pub(super) fn summary_file(folder: &Path, summary: &Value) -> Result<ExportFile, CliError> {
    let text = pretty_json(summary).map_err(CliError::unusable)?;
    Ok(ExportFile::text(folder, "summary.json", text))
}
