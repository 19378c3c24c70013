//! Where the blocks of a patch figure stand, by its size and by what it says.

use crate::picture::figure::patch::content::{
    COLUMN_WIDTHS, NUMBER_WIDTH, PATCH_COLUMNS, PatchContent,
};
use crate::picture::figure::plan::{bar_headings, bars_height};
use crate::picture::page::{FigureFonts, Weight};

/// The size that the design was drawn at; other sizes scale with it.
const DESIGN: [f32; 2] = [1600.0, 1200.0];
/// Text below 10.5 pixels is not legible: sizes stop shrinking here, at [`MIN_PATCH_SIZE`](crate::picture::figure::MIN_PATCH_SIZE).
const MIN_SCALE: f32 = 0.5;
/// Share of the width that the heart has.
const HEART_SHARE: f32 = 0.56;

/// Where the columns of the table stand, in pixels from the left edge of the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TableColumns {
    /// Left edge of the patch's number.
    pub number: f32,
    /// Right edges of the numbers of a patch.
    pub cells: [f32; PATCH_COLUMNS.len()],
    /// Left edge of the segments.
    pub segments: f32,
}

impl TableColumns {
    fn new(margin: f32, scale: f32) -> Self {
        let mut offset = NUMBER_WIDTH;
        let cells = COLUMN_WIDTHS.map(|width| {
            offset += width;
            margin + offset * scale
        });
        Self {
            number: margin,
            cells,
            segments: margin + offset * scale,
        }
    }
}

/// Sizes of one patch figure in pixels, and the place left for the heart.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchFrame {
    /// Width and height of the whole figure.
    pub size: [u32; 2],
    /// Pixels per point of the design; also for line widths in the scene.
    pub scale: f32,
    /// Upper left corner of the heart's picture.
    pub heart_at: [u32; 2],
    /// Width and height of the heart's picture.
    pub heart_size: [u32; 2],
    pub(super) margin: f32,
    pub(super) title: f32,
    pub(super) text: f32,
    pub(super) line: f32,
    pub(super) evidence: Vec<String>,
    pub(super) headings: Vec<Vec<String>>,
    pub(super) segments: Vec<Vec<String>>,
    pub(super) imprint: Vec<String>,
    /// Where the columns of the table stand.
    pub(super) columns: TableColumns,
    /// Base line of the heading of the table.
    pub(super) table_top: f32,
    /// Lower edge of what explains heart and bull's-eye.
    pub(super) legend_bottom: f32,
    pub(super) bar_width: f32,
    pub(super) cube: f32,
}

impl PatchFrame {
    /// Lays out a figure of this size for this content.
    pub fn of(size: [u32; 2], content: &PatchContent, fonts: &FigureFonts) -> Self {
        let [width, height] = size.map(|pixels| pixels as f32);
        let scale = (width / DESIGN[0]).min(height / DESIGN[1]).max(MIN_SCALE);
        let (margin, title, text) = (34.0 * scale, 36.0 * scale, 21.0 * scale);
        let line = 1.4 * text;
        let room = width - 2.0 * margin;
        let wrapped = |words: &str, most: f32| fonts.wrapped(words, Weight::Regular, text, most);
        let evidence = wrapped(&content.verdict.evidence, room);
        let heart_width = (HEART_SHARE * width).round();
        let cube = if content.heart.cube.is_empty() {
            0.0
        } else {
            118.0 * scale
        };
        let bar_width = (360.0 * scale).min(0.6 * heart_width);
        let headings = bar_headings(&content.heart.legends, fonts, text, 1.1 * bar_width);
        let columns = TableColumns::new(margin, scale);
        let segments: Vec<Vec<String>> = (content.rows.iter())
            .map(|row| wrapped(&row.segments, width - margin - columns.segments))
            .collect();
        let imprint = [
            fonts.wrapped(&content.parameters, Weight::Regular, 0.87 * text, room),
            fonts.wrapped(&content.heart.footer, Weight::Regular, 0.87 * text, room),
        ]
        .concat();
        // From above: name and moment, verdict and evidence.
        let above =
            margin + title + line + 1.5 * line + line * evidence.len() as f32 + 0.3 * margin;
        // From below: imprint, table.
        let imprint_height = 1.1 * line * imprint.len() as f32 + 0.8 * margin;
        let lines: usize = segments.iter().map(|lines| lines.len().max(1)).sum();
        let header = if content.rows.is_empty() { 0.0 } else { 1.3 };
        let table_height = line * (header + lines as f32 + 1.2) + 0.6 * margin;
        let table_top = height - imprint_height - table_height + line;
        let legend_height = bars_height(&headings, text) + 0.2 * line;
        let legend_bottom = table_top - 1.5 * line;
        let heart_bottom = legend_bottom - legend_height.max(cube) - 0.2 * margin;
        Self {
            size,
            scale,
            heart_at: [0, above.round() as u32],
            heart_size: [
                heart_width as u32,
                (heart_bottom - above.round()).round().max(1.0) as u32,
            ],
            margin,
            title,
            text,
            line,
            evidence,
            headings,
            segments,
            imprint,
            columns,
            table_top,
            legend_bottom,
            bar_width,
            cube,
        }
    }

    /// Width by height of the heart's picture.
    pub fn heart_aspect(&self) -> f32 {
        self.heart_size[0] as f32 / self.heart_size[1] as f32
    }
}
