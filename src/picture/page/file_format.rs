//! The files that a page can become.

use std::path::Path;

use crate::picture::page::FigureSettings;
use crate::picture::page::fonts::FigureFonts;
use crate::picture::page::marks::Page;
use crate::picture::page::pdf::{PdfError, pdf_file};
use crate::picture::page::png_file::{PngError, encoded_png};
use crate::picture::page::raster::{RasterError, raster};
use crate::picture::page::svg::svg_file;

/// Width of a figure in SVG and PDF: two columns of a journal.
pub const PRINT_WIDTH_MM: f32 = 180.0;

/// A kind of file for pages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PageFormat {
    /// Pixels.
    #[default]
    Png,
    /// Shapes and words, for drawing programs and the web.
    Svg,
    /// Shapes and words, for print.
    Pdf,
}

/// A page could not become a file.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// It could not be drawn.
    #[error(transparent)]
    Raster(#[from] RasterError),
    /// A picture could not be encoded.
    #[error(transparent)]
    Png(#[from] PngError),
    /// The PDF could not be written.
    #[error(transparent)]
    Pdf(#[from] PdfError),
}

impl PageFormat {
    /// By the ending of a file's name; `None` for another ending or none.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match &*ending {
            "png" => Some(Self::Png),
            "svg" => Some(Self::Svg),
            "pdf" => Some(Self::Pdf),
            _ => None,
        }
    }

    /// The bytes of a file of one page, which has the settings inside.
    ///
    /// # Errors
    /// If the page has no size or is beyond memory.
    pub fn file(
        self,
        page: &Page,
        settings: &FigureSettings,
        fonts: &FigureFonts,
    ) -> Result<Vec<u8>, PageError> {
        Ok(match self {
            Self::Png => encoded_png(&raster(page, 1.0, fonts)?, settings)?,
            Self::Svg => svg_file(page, PRINT_WIDTH_MM, settings)?.into_bytes(),
            Self::Pdf => pdf_file(std::slice::from_ref(page), PRINT_WIDTH_MM, settings)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_of_the_name_tells_the_format() {
        let of = |name: &str| PageFormat::of(Path::new(name));
        assert_eq!(of("a/P07.PNG"), Some(PageFormat::Png));
        assert_eq!(of("P07.svg"), Some(PageFormat::Svg));
        assert_eq!(of("P07.v2.pdf"), Some(PageFormat::Pdf));
        assert_eq!(of("P07"), None);
        assert_eq!(of("P07.jpg"), None);
    }

    #[test]
    fn a_page_becomes_each_kind_of_file() {
        let page = Page::new([40.0, 30.0], Some([1.0; 3]));
        let fonts = FigureFonts::load().unwrap();
        let settings = vec![("Title", "P07".to_owned())];
        for (format, start) in [
            (PageFormat::Png, &b"\x89PNG"[..]),
            (PageFormat::Svg, b"<svg"),
            (PageFormat::Pdf, b"%PDF"),
        ] {
            let bytes = format.file(&page, &settings, &fonts).unwrap();
            assert!(bytes.starts_with(start), "{format:?}");
        }
    }
}
