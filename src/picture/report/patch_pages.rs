//! Patch figures on sheets of the report.

use crate::picture::page::Page;
use crate::picture::report::sheet::{BOTTOM, LINE, MARGIN, SIZE, sheet};

/// Figures on a sheet, one below the other.
const A_SHEET: usize = 2;
/// Between two figures.
const GAP: f32 = LINE;

/// The figures, each as large as a place on its sheet allows.
pub(super) fn patch_pages(figures: &[Page]) -> Vec<Page> {
    let width = SIZE[0] - 2.0 * MARGIN;
    let height = (BOTTOM - MARGIN - (A_SHEET - 1) as f32 * GAP) / A_SHEET as f32;
    (figures.chunks(A_SHEET))
        .map(|figures| {
            let mut page = sheet();
            for (place, figure) in figures.iter().enumerate() {
                let scale = (width / figure.size[0]).min(height / figure.size[1]);
                let left = 0.5 * (SIZE[0] - scale * figure.size[0]);
                let top = MARGIN + place as f32 * (height + GAP);
                page.lay(figure, [left, top], scale);
            }
            page
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::Mark;

    #[test]
    fn figures_stand_two_a_sheet_within_its_margins() {
        let mut figure = Page::new([1600.0, 1200.0], Some([1.0; 3]));
        figure.rectangle([0.0, 0.0], [1600.0, 1200.0], [0.5; 3]);
        let pages = patch_pages(&[figure.clone(), figure.clone(), figure]);
        assert_eq!(pages.len(), 2);
        for page in &pages {
            assert_eq!(page.size, SIZE);
            for mark in &page.marks {
                let Mark::Fill { corners, .. } = mark else {
                    panic!("{mark:?}");
                };
                assert!(corners.iter().all(|[x, y]| {
                    (MARGIN..=SIZE[0] - MARGIN).contains(x) && (MARGIN..=BOTTOM + 0.1).contains(y)
                }));
            }
        }
        assert_eq!(patch_pages(&[]), []);
    }
}
