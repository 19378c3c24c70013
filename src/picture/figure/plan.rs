//! Where the blocks of a figure stand, by its size and by what it says.

use crate::picture::figure::content::FigureContent;
use crate::picture::legend::ColourLegend;
use crate::picture::page::{FigureFonts, Weight};

/// Where blocks stand; everything in pixels.
pub(super) struct Plan {
    pub(super) size: [f32; 2],
    pub(super) margin: f32,
    pub(super) title: f32,
    pub(super) text: f32,
    pub(super) line: f32,
    pub(super) bar_width: f32,
    pub(super) cube: f32,
    /// Facts stand below the moment instead of at the right.
    pub(super) facts_below: bool,
    /// The scale bar stands above the colour bar instead of beside it.
    pub(super) scale_above: bool,
    /// Lines below each colour bar.
    pub(super) headings: Vec<Vec<String>>,
    pub(super) imprint: Vec<String>,
    pub(super) header_height: f32,
    pub(super) footer_height: f32,
}

impl Plan {
    pub(super) fn of(
        size: [u32; 2],
        scale: f32,
        content: &FigureContent,
        fonts: &FigureFonts,
    ) -> Self {
        let size = size.map(|pixels| pixels as f32);
        let (margin, title, text) = (22.0 * scale, 26.0 * scale, 15.0 * scale);
        let line = 1.4 * text;
        let room = size[0] - 2.0 * margin;
        let measure = |words: &str| fonts.width(words, Weight::Regular, text);
        let facts = measure(&content.volumes).max(fonts.width(
            &content.ejection_fraction,
            Weight::SemiBold,
            title,
        ));
        let left =
            measure(&content.moment).max(fonts.width(&content.title, Weight::SemiBold, title));
        let facts_below = left + facts + margin > room;
        let cube = if content.cube.is_empty() {
            0.0
        } else {
            92.0 * scale
        };
        let bar_width = (300.0 * scale).min(room - cube - margin).min(0.6 * room);
        let headings = bar_headings(&content.legends, fonts, text, bar_width);
        let has_legend = !headings.is_empty();
        let scale_above = has_legend && bar_width + cube + 2.0 * margin + 100.0 * scale > room;
        let imprint = fonts.wrapped(&content.footer, Weight::Regular, 0.87 * text, room);
        let header_lines = if facts_below && !content.ejection_fraction.is_empty() {
            2.0
        } else {
            1.0
        };
        let legend_height = bars_height(&headings, text);
        let scale_height = 1.9 * text;
        let blocks = if scale_above {
            legend_height + scale_height + 0.5 * margin
        } else {
            legend_height.max(scale_height)
        };
        Self {
            header_height: margin + title + line * header_lines + 0.4 * margin,
            footer_height: blocks.max(cube) + 1.1 * line * imprint.len() as f32 + 1.4 * margin,
            size,
            margin,
            title,
            text,
            line,
            bar_width,
            cube,
            facts_below,
            scale_above,
            headings,
            imprint,
        }
    }
}

/// What stands below each colour bar: title, unit, and where its limits come from.
pub(super) fn bar_headings(
    legends: &[ColourLegend],
    fonts: &FigureFonts,
    text: f32,
    width: f32,
) -> Vec<Vec<String>> {
    let words = legends
        .iter()
        .map(|legend| format!("{} ({})", legend.heading(), legend.note));
    words
        .map(|words| fonts.wrapped(&words, Weight::Regular, text, width))
        .collect()
}

/// Height of colour bars with these headings, one above the other.
pub(super) fn bars_height(headings: &[Vec<String>], text: f32) -> f32 {
    let line = 1.4 * text;
    let bars = headings.iter();
    let each = bars.map(|heading| 0.9 * text + line * (1.0 + heading.len() as f32));
    each.sum::<f32>() + 0.6 * line * headings.len().saturating_sub(1) as f32
}
