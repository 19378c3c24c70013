//! Writes the file of a figure: its format is told by its ending, and a file that nobody named is not replaced.

use std::path::PathBuf;
use std::sync::Arc;

use crate::engine::{Engine, ExportFile, Store};
use crate::picture::page::PageFormat;
use crate::progress::Progress;

use super::typed_paths::with_png_ending;

/// Draws a figure and writes it, off the window's thread. A name without an ending becomes one of a picture; a file that
/// lies there then is not replaced, since nobody was asked about it.
///
/// # Errors
/// If the name has an ending that no figure has.
pub fn write_figure_file(
    engine: &mut Engine,
    path: PathBuf,
    name: &'static str,
    [width, height]: [u32; 2],
    draw: impl FnOnce(&Store, PageFormat, &Progress) -> Result<Vec<u8>, String> + Send + 'static,
) -> Result<(), String> {
    let ends = path.extension().is_some();
    let path = with_png_ending(path);
    let Some(format) = PageFormat::of(&path) else {
        return Err(format!(
            "{}: the name must end in .png, .svg or .pdf",
            path.display()
        ));
    };
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let words = format!("{width} × {height} pixels, {file}");
    let store = Arc::clone(engine.store());
    engine.start_export(name, words, move |progress| {
        if !ends && path.exists() {
            let path = path.display();
            return Err(format!(
                "a file lies there already; type its whole name to replace it: {path}"
            ));
        }
        let bytes = draw(&store, format, progress)?;
        Ok(vec![ExportFile {
            path,
            bytes: bytes.into(),
        }])
    });
    Ok(())
}
