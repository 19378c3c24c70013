//! Writes what a pane shows as a figure: a map, the bull's-eye, curves.
//!
//! What it holds is fixed when it is asked for, as of every export: see [`super::export`].

use std::path::PathBuf;

use crate::engine::Engine;
use crate::picture::figure::check_figure_size;
use crate::picture::page::{FigureFonts, PageFormat};
use crate::picture::plot::{PlotColours, PlotFigure, drawn_plot};
use crate::progress::Progress;

use super::export::FigureColours;
use super::figure_file::write_figure_file;

/// Width and height in pixels where none are chosen, those of a figure of the 3D view.
const USUAL_SIZE: [u32; 2] = [2000, 1500];

/// A plot with size and colours as they were when it was asked for.
pub struct PlotExport {
    figure: PlotFigure,
    size: [u32; 2],
    colours: FigureColours,
}

impl PlotExport {
    /// A plot in the size and colours that are chosen.
    ///
    /// # Errors
    /// If no figure has this size.
    pub fn of(figure: PlotFigure, colours: FigureColours) -> Result<Self, String> {
        let size = colours.size.unwrap_or(USUAL_SIZE);
        check_figure_size(size, false).map_err(|error| error.to_string())?;
        Ok(Self {
            figure,
            size,
            colours,
        })
    }

    /// A name for its file.
    pub fn file_name(&self) -> String {
        format!("{}.png", self.figure.stem)
    }

    /// Draws and writes it, off the window's thread.
    ///
    /// # Errors
    /// If the name has an ending that no figure has.
    pub fn write(self, engine: &mut Engine, path: PathBuf) -> Result<(), String> {
        let size = self.size;
        write_figure_file(engine, path, "Figure", size, move |_, format, progress| {
            self.drawn(format, progress)
        })
    }

    fn drawn(&self, format: PageFormat, progress: &Progress) -> Result<Vec<u8>, String> {
        progress.begin_phase("drawing", 0.0, 0.8);
        let fonts = FigureFonts::load().map_err(|error| error.to_string())?;
        let colours = PlotColours {
            size: self.size,
            theme: &self.colours.theme,
            transparent: self.colours.transparent,
        };
        let finished = drawn_plot(&self.figure, &colours, &fonts);
        progress.begin_phase("writing", 0.8, 1.0);
        progress.check().map_err(|stopped| stopped.to_string())?;
        let bytes = format.file(&finished.page, &finished.settings, &fonts);
        bytes.map_err(|error| error.to_string())
    }
}
