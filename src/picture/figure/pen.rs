//! What figures are drawn with: words in one theme, the colour bar, the scale bar.

use std::sync::Arc;

use crate::picture::legend::ColourLegend;
use crate::picture::page::{Anchor, FigureFonts, Page, Type, Weight};
use crate::picture::scale_bar::ScaleBar;
use crate::picture::tokens::PictureTheme;
use crate::render::Picture;

/// Draws onto one page.
pub(in crate::picture) struct Pen<'a> {
    pub(in crate::picture) page: &'a mut Page,
    pub(in crate::picture) fonts: &'a FigureFonts,
    pub(in crate::picture) theme: &'a PictureTheme,
    /// The em of running text in pixels.
    pub(in crate::picture) text: f32,
}

impl Pen<'_> {
    /// Height of a line of running text.
    pub(in crate::picture) fn line_height(&self) -> f32 {
        1.4 * self.text
    }

    pub(in crate::picture) fn regular(&self, colour: [f32; 3]) -> Type {
        Type {
            weight: Weight::Regular,
            size: self.text,
            colour,
        }
    }

    pub(in crate::picture) fn strong(&self, colour: [f32; 3], size: f32) -> Type {
        Type {
            weight: Weight::SemiBold,
            size,
            colour,
        }
    }

    pub(in crate::picture) fn write(
        &mut self,
        words: &str,
        set: Type,
        anchor: Anchor,
        at: [f32; 2],
    ) -> f32 {
        self.page.words(self.fonts, words, set, anchor, at)
    }

    /// Words cut to a width.
    pub(in crate::picture) fn write_within(
        &mut self,
        words: &str,
        set: Type,
        anchor: Anchor,
        at: [f32; 2],
        most: f32,
    ) {
        let short = self.fonts.shortened(words, set.weight, set.size, most);
        self.write(&short, set, anchor, at);
    }

    /// Colour bars one above the other, the last one's heading ending at `bottom`; returns the upper edge.
    pub(in crate::picture) fn colour_bars(
        &mut self,
        legends: &[ColourLegend],
        headings: &[Vec<String>],
        [left, bottom]: [f32; 2],
        width: f32,
    ) -> f32 {
        let gap = 0.6 * self.line_height();
        let mut below = bottom;
        for (legend, heading) in legends.iter().zip(headings).rev() {
            below = self.colour_bar(legend, heading, [left, below], width) - gap;
        }
        if legends.is_empty() {
            bottom
        } else {
            below + gap
        }
    }

    /// A colour bar whose heading ends at `bottom`: heading below, numbers above it, colours on top; returns the
    /// upper edge.
    pub(in crate::picture) fn colour_bar(
        &mut self,
        legend: &ColourLegend,
        heading: &[String],
        [left, bottom]: [f32; 2],
        width: f32,
    ) -> f32 {
        let (text, line) = (self.text, self.line_height());
        let mut base = bottom - 0.2 * line;
        for words in heading.iter().rev() {
            self.write(
                words,
                self.regular(self.theme.muted),
                Anchor::Start,
                [left, base],
            );
            base -= line;
        }
        let numbers = base;
        let low = numbers - line;
        let high = low - 0.9 * text;
        // End colours stand apart from the bar, and only where such values are on show.
        let end = 0.7 * text;
        let from = left + if legend.below { end + 3.0 } else { 0.0 };
        let to = left + width - if legend.above { end + 3.0 } else { 0.0 };
        if legend.below {
            self.page
                .rectangle([left, high], [left + end, low], legend.map.below);
        }
        if legend.above {
            let right = left + width;
            self.page
                .rectangle([right - end, high], [right, low], legend.map.above);
        }
        let colours = Arc::new(Picture {
            width: legend.map.colours.len() as u32,
            height: 1,
            rgba: (legend.map.colours.iter())
                .flat_map(|&[red, green, blue]| [red, green, blue, 255])
                .collect(),
        });
        self.page
            .picture([from, high], [to - from, low - high], colours);
        let mut free_from = f32::NEG_INFINITY;
        for tick in &legend.ticks {
            let x = from + tick.position * (to - from);
            let set = self.regular(self.theme.text);
            let wide = self.fonts.width(&tick.text, set.weight, text);
            let at = (x - 0.5 * wide).clamp(left, (left + width - wide).max(left));
            if at >= free_from {
                let mark = [[x, low], [x, low + 0.25 * text]];
                self.page
                    .line(&mark, false, 1.0_f32.max(text / 15.0), self.theme.line);
                self.write(&tick.text, set, Anchor::Start, [at, numbers + 0.1 * line]);
                free_from = at + wide + 0.5 * text;
            }
        }
        high
    }

    /// A bar with end marks, its lower edge at `at`, its length written above, no further left than `least`.
    pub(in crate::picture) fn scale_bar(&mut self, bar: &ScaleBar, at: [f32; 2], least: f32) {
        let text = self.text;
        let width = (text / 10.0).max(1.0);
        let (left, right, y) = (at[0], at[0] + bar.pixels, at[1] - 0.3 * text);
        let colour = self.theme.text;
        self.page
            .line(&[[left, y], [right, y]], false, width, colour);
        for x in [left, right] {
            let end = [[x, y - 0.35 * text], [x, y + 0.35 * text]];
            self.page.line(&end, false, width, colour);
        }
        let words = self.fonts.width(&bar.text, Weight::Regular, text);
        let start = (0.5 * (left + right - words)).max(least);
        let set = self.regular(colour);
        self.write(&bar.text, set, Anchor::Start, [start, y - 0.55 * text]);
    }
}
