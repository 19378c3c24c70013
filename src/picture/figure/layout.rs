//! Puts heart and text together: where everything stands at any size of figure.

use crate::picture::figure::canvas::Canvas;
use crate::picture::figure::content::FigureContent;
use crate::picture::figure::cube::draw_cube;
use crate::picture::figure::plan::Plan;
use crate::picture::figure::text::{FigureFonts, Weight};
use crate::picture::legend::ColourLegend;
use crate::picture::scale_bar::ScaleBar;
use crate::picture::tokens::PictureTheme;
use crate::render::Camera;

/// The size that the design was drawn at; other sizes scale with it.
const DESIGN: [f32; 2] = [1200.0, 900.0];
/// Text below 10.5 pixels is not legible: sizes stop shrinking here.
const LEAST_SCALE: f32 = 0.7;

/// Sizes of one figure in pixels, and the place left for the heart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureFrame {
    /// Width and height of the whole figure.
    pub size: [u32; 2],
    /// Pixels per point of the design; also for line widths in the scene.
    pub scale: f32,
    /// Upper edge of the heart's picture, which is as wide as the figure.
    pub heart_top: u32,
    /// Height of the heart's picture.
    pub heart_height: u32,
}

impl FigureFrame {
    /// Lays out a figure of this size for this content.
    pub fn of(size: [u32; 2], content: &FigureContent, fonts: &FigureFonts) -> Self {
        let [width, height] = size.map(|pixels| pixels as f32);
        let scale = (width / DESIGN[0]).min(height / DESIGN[1]).max(LEAST_SCALE);
        let plan = Plan::of(size, scale, content, fonts);
        let top = plan.header_height.round();
        let bottom = (height - plan.footer_height).round();
        Self {
            size,
            scale,
            heart_top: top as u32,
            heart_height: (bottom - top).max(1.0) as u32,
        }
    }

    /// Width by height of the heart's picture.
    pub fn heart_aspect(&self) -> f32 {
        self.size[0] as f32 / self.heart_height as f32
    }
}

/// Draws a whole figure around a heart's picture, which has the size that `frame` says and is
/// taken with `camera`; pixels as in [`Canvas`].
pub fn drawn_figure(
    frame: &FigureFrame,
    content: &FigureContent,
    heart_pixels: &[u8],
    camera: &Camera,
    theme: &PictureTheme,
    transparent: bool,
    fonts: &FigureFonts,
) -> Canvas {
    let [width, height] = frame.size;
    let opacity = if transparent { 0.0 } else { 1.0 };
    let mut canvas = Canvas::filled(width, height, theme.background, opacity);
    canvas.put(0, frame.heart_top, width, heart_pixels);
    let plan = Plan::of(frame.size, frame.scale, content, fonts);
    let mut pen = Pen {
        canvas: &mut canvas,
        fonts,
        theme,
        plan: &plan,
    };
    pen.header(content);
    pen.footer(content, camera, frame.heart_height as f32);
    canvas
}

/// Draws the blocks of one figure.
struct Pen<'a> {
    canvas: &'a mut Canvas,
    fonts: &'a FigureFonts,
    theme: &'a PictureTheme,
    plan: &'a Plan,
}

impl Pen<'_> {
    fn header(&mut self, content: &FigureContent) {
        let Plan {
            margin,
            title,
            text,
            line,
            size,
            ..
        } = *self.plan;
        let room = size[0] - 2.0 * margin;
        let name = self
            .fonts
            .shortened(&content.title, Weight::SemiBold, title, room);
        let base = margin + 0.75 * title;
        self.write(
            &name,
            Weight::SemiBold,
            title,
            [margin, base],
            self.theme.text,
        );
        let moment = self
            .fonts
            .shortened(&content.moment, Weight::Regular, text, room);
        let below = base + line;
        self.write(
            &moment,
            Weight::Regular,
            text,
            [margin, below],
            self.theme.muted,
        );
        if self.plan.facts_below {
            let facts: Vec<&str> = [&*content.ejection_fraction, &*content.volumes]
                .into_iter()
                .filter(|words| !words.is_empty())
                .collect();
            let facts = self
                .fonts
                .shortened(&facts.join(" · "), Weight::Regular, text, room);
            self.write(
                &facts,
                Weight::Regular,
                text,
                [margin, below + line],
                self.theme.text,
            );
            return;
        }
        let right = size[0] - margin;
        self.write_to(
            &content.ejection_fraction,
            Weight::SemiBold,
            title,
            [right, base],
            self.theme.text,
        );
        self.write_to(
            &content.volumes,
            Weight::Regular,
            text,
            [right, below],
            self.theme.muted,
        );
    }

    fn footer(&mut self, content: &FigureContent, camera: &Camera, heart_height: f32) {
        let Plan {
            margin,
            text,
            line,
            size,
            bar_width,
            cube,
            ..
        } = *self.plan;
        let mut base = size[1] - margin * 0.8;
        for words in self.plan.imprint.iter().rev() {
            self.write(
                words,
                Weight::Regular,
                0.87 * text,
                [margin, base],
                self.theme.muted,
            );
            base -= 1.1 * line;
        }
        let bottom = base + 0.2 * line;
        let mut legend_top = bottom;
        if let Some(legend) = &content.legend {
            legend_top = self.colour_bar(legend, bottom);
        }
        let most = if content.legend.is_some() && !self.plan.scale_above {
            size[0] - bar_width - cube - 4.0 * margin
        } else {
            0.4 * size[0]
        };
        let most = most.min(0.22 * size[0]).max(40.0);
        if let Some(bar) = ScaleBar::fitting(camera, heart_height, most, content.unit) {
            let left = match (&content.legend, self.plan.scale_above) {
                (Some(_), false) => {
                    let between = margin + bar_width + size[0] - margin - cube;
                    0.5 * (between - bar.pixels)
                }
                _ => margin,
            };
            let at = if self.plan.scale_above {
                legend_top - 0.6 * margin
            } else {
                bottom
            };
            self.scale_bar(&bar, [left, at]);
        }
        if cube > 0.0 {
            let centre = [size[0] - margin - 0.5 * cube, bottom - 0.5 * cube];
            draw_cube(
                self.canvas,
                self.fonts,
                &content.cube,
                camera.world_from_camera,
                centre,
                cube,
                self.theme,
            );
        }
    }

    /// Heading below, numbers above it, colours on top; returns the upper edge.
    fn colour_bar(&mut self, legend: &ColourLegend, bottom: f32) -> f32 {
        let Plan {
            margin,
            text,
            line,
            bar_width,
            ..
        } = *self.plan;
        let mut base = bottom - 0.2 * line;
        for words in self.plan.heading.iter().rev() {
            self.write(
                words,
                Weight::Regular,
                text,
                [margin, base],
                self.theme.muted,
            );
            base -= line;
        }
        let numbers = base;
        let low = numbers - line;
        let (left, high) = (margin, low - 0.9 * text);
        // End colours stand apart from the bar, and only where such values are on show.
        let end = 0.7 * text;
        let from = left + if legend.below { end + 3.0 } else { 0.0 };
        let to = left + bar_width - if legend.above { end + 3.0 } else { 0.0 };
        if legend.below {
            self.canvas
                .fill_rectangle([left, high], [left + end, low], legend.map.below);
        }
        if legend.above {
            let right = left + bar_width;
            self.canvas
                .fill_rectangle([right - end, high], [right, low], legend.map.above);
        }
        let colours = &legend.map.colours;
        let columns = (to - from).round().max(1.0) as usize;
        for column in 0..columns {
            let colour = colours[column * (colours.len() - 1) / columns.max(2)];
            let x = from.round() + column as f32;
            let colour = colour.map(|channel| f32::from(channel) / 255.0);
            self.canvas
                .fill_rectangle([x, high], [x + 1.0, low], colour);
        }
        let mut free_from = f32::NEG_INFINITY;
        for tick in &legend.ticks {
            let x = from + tick.position * (to - from);
            let width = self.fonts.width(&tick.text, Weight::Regular, text);
            let at = (x - 0.5 * width).clamp(left, left + bar_width - width);
            if at >= free_from {
                self.canvas.line(
                    [x, low],
                    [x, low + 0.25 * text],
                    1.0_f32.max(text / 15.0),
                    self.theme.line,
                );
                self.write(
                    &tick.text,
                    Weight::Regular,
                    text,
                    [at, numbers + 0.1 * line],
                    self.theme.text,
                );
                free_from = at + width + 0.5 * text;
            }
        }
        high
    }

    /// A bar with end marks, its lower edge at `at`, its length written above.
    fn scale_bar(&mut self, bar: &ScaleBar, at: [f32; 2]) {
        let text = self.plan.text;
        let width = (text / 10.0).max(1.0);
        let (left, right, y) = (at[0], at[0] + bar.pixels, at[1] - 0.3 * text);
        let colour = self.theme.text;
        self.canvas.line([left, y], [right, y], width, colour);
        for x in [left, right] {
            self.canvas
                .line([x, y - 0.35 * text], [x, y + 0.35 * text], width, colour);
        }
        let words = self.fonts.width(&bar.text, Weight::Regular, text);
        let start = (0.5 * (left + right - words)).max(self.plan.margin);
        self.write(
            &bar.text,
            Weight::Regular,
            text,
            [start, y - 0.55 * text],
            colour,
        );
    }

    fn write(&mut self, words: &str, weight: Weight, size: f32, at: [f32; 2], colour: [f32; 3]) {
        self.fonts
            .draw(self.canvas, words, weight, size, at, colour);
    }

    /// Text that ends at `at`.
    fn write_to(&mut self, words: &str, weight: Weight, size: f32, at: [f32; 2], colour: [f32; 3]) {
        let width = self.fonts.width(words, weight, size);
        self.write(words, weight, size, [at[0] - width, at[1]], colour);
    }
}
