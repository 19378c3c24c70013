//! A page of shapes, lines, words and pictures, and how it becomes pixels, SVG or PDF.

mod code_face;
mod faces;
mod file_format;
mod fonts;
mod marks;
mod outline;
mod pdf;
mod png_file;
mod raster;
mod runs;
mod setting_in_file;
mod svg;
mod system_faces;
mod weight;

pub use code_face::letter_code;
pub use faces::{FacesFor, FurtherFace, faces_for};
pub use file_format::{PRINT_WIDTH_MM, PageError, PageFormat};
pub use fonts::{FigureFonts, FontError};
pub use marks::{Anchor, Mark, Page, Type};
pub use pdf::{PdfError, pdf_file};
pub use png_file::{PngError, VIEW_KEY, encoded_png, png_text};
pub use raster::{RasterError, raster};
pub use svg::svg_file;
pub use weight::Weight;

/// Settings of a figure in words, in the order in which they stand in the file.
pub type FigureSettings = Vec<(&'static str, String)>;
