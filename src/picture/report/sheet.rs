//! One sheet of the report: its size, its type, its foot.

use crate::picture::figure::Pen;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::tokens::PictureTheme;

/// A4 at six pixels a millimetre.
pub(super) const SIZE: [f32; 2] = [1260.0, 1782.0];
/// Around what stands on it.
pub(super) const MARGIN: f32 = 90.0;
/// The em of running text: 9.5 points.
pub(super) const TEXT: f32 = 20.0;
/// From base line to base line.
pub(super) const LINE: f32 = 1.4 * TEXT;
/// Where nothing but the foot stands below.
pub(super) const BOTTOM: f32 = SIZE[1] - MARGIN - 2.0 * LINE;
/// Colours of the report.
pub(super) const THEME: PictureTheme = PictureTheme::LIGHT;

/// An empty sheet.
pub(super) fn sheet() -> Page {
    Page::new(SIZE, Some(THEME.background))
}

/// A pen for a sheet.
pub(super) fn pen<'a>(page: &'a mut Page, fonts: &'a FigureFonts) -> Pen<'a> {
    Pen {
        page,
        fonts,
        theme: &THEME,
        text: TEXT,
    }
}

/// Writes the foot of every sheet: the program, what the report is not for, the number.
pub(super) fn number(pages: &mut [Page], fonts: &FigureFonts) {
    let count = pages.len();
    for (index, page) in pages.iter_mut().enumerate() {
        let mut pen = pen(page, fonts);
        let base = SIZE[1] - MARGIN + 0.5 * LINE;
        let mut set = pen.regular(THEME.muted);
        set.size *= 0.87;
        let program = format!(
            "Cardiomorph {} · research use, not for diagnosis",
            env!("CARGO_PKG_VERSION")
        );
        pen.write(&program, set, Anchor::Start, [MARGIN, base]);
        let place = format!("page {} of {count}", index + 1);
        pen.write(&place, set, Anchor::End, [SIZE[0] - MARGIN, base]);
    }
}
