//! Figures for papers and reports: a heart with everything that is needed to read it.

mod canvas;
mod content;
mod cube;
mod layout;
mod make;
mod picture_file;
mod plan;
mod text;

pub use canvas::Canvas;
pub use content::{FigureContent, FigureSubject};
pub use layout::{FigureFrame, drawn_figure};
pub use make::{Figure, FigureOrder, FigureView, rendered_figure};
pub use picture_file::{FigureSettings, encoded_png};
pub use text::{FigureFonts, FontError, Weight};

/// Smallest width and height of a figure in pixels: below, its text would not be legible.
pub const LEAST_SIZE: [u32; 2] = [320, 240];
/// Greatest width and height of a figure in pixels.
pub const GREATEST_SIZE: u32 = 8192;
