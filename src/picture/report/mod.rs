//! The report of a whole analysis as pages: verdicts, maps, and behind them the patch figures.

mod content;
mod cover;
mod map_page;
mod order;
mod patch_pages;
mod sheet;

use crate::picture::page::{FigureFonts, FigureSettings, Page};
use crate::study::Study;

pub use order::ReportOrder;

/// Width of the report's paper, A4.
pub const REPORT_WIDTH_MM: f32 = 210.0;

/// The pages of a report, all of one size and numbered: verdicts, maps, then the patch figures, two a page.
pub fn report_pages(
    order: &ReportOrder<'_>,
    patch_figures: &[Page],
    fonts: &FigureFonts,
) -> Vec<Page> {
    let mut pages = cover::cover_pages(order, fonts);
    pages.extend(map_page::map_page(order, fonts));
    pages.extend(patch_pages::patch_pages(patch_figures));
    sheet::number(&mut pages, fonts);
    pages
}

/// What the file of a report says of itself.
pub fn report_settings(study: &Study) -> FigureSettings {
    vec![
        ("Title", format!("{}: analysis", study.name)),
        (
            "Software",
            concat!("Cardiomorph ", env!("CARGO_PKG_VERSION")).to_owned(),
        ),
        ("Comment", "research use, not for diagnosis".to_owned()),
    ]
}
