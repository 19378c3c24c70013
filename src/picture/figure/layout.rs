//! Puts heart and text together: where everything stands at any size of figure.

use std::sync::Arc;

use crate::picture::figure::content::FigureContent;
use crate::picture::figure::cube::draw_cube;
use crate::picture::figure::pen::Pen;
use crate::picture::figure::plan::Plan;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::scale_bar::ScaleBar;
use crate::picture::tokens::PictureTheme;
use crate::render::{Camera, Picture};

/// The size that the design was drawn at; other sizes scale with it.
const DESIGN: [f32; 2] = [1200.0, 900.0];
/// Text below 10.5 pixels is not legible: sizes stop shrinking here.
const MIN_SCALE: f32 = 0.7;

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
        let scale = (width / DESIGN[0]).min(height / DESIGN[1]).max(MIN_SCALE);
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

/// A whole figure around a heart's picture, which has the size that `frame` says and is taken with `camera`.
pub fn drawn_figure(
    frame: &FigureFrame,
    content: &FigureContent,
    heart: Arc<Picture>,
    camera: &Camera,
    theme: &PictureTheme,
    transparent: bool,
    fonts: &FigureFonts,
) -> Page {
    let plan = Plan::of(frame.size, frame.scale, content, fonts);
    let mut page = Page::new(plan.size, (!transparent).then_some(theme.background));
    let height = frame.heart_height as f32;
    let place = [0.0, frame.heart_top as f32];
    page.picture(place, [plan.size[0], height], heart);
    let mut pen = Pen {
        page: &mut page,
        fonts,
        theme,
        text: plan.text,
    };
    header(&mut pen, &plan, content);
    footer(&mut pen, &plan, content, camera, height);
    page
}

fn header(pen: &mut Pen<'_>, plan: &Plan, content: &FigureContent) {
    let Plan {
        margin,
        title,
        line,
        size,
        ..
    } = *plan;
    let theme = pen.theme;
    let room = size[0] - 2.0 * margin;
    let base = margin + 0.75 * title;
    let name = pen.strong(theme.text, title);
    pen.write_within(&content.title, name, Anchor::Start, [margin, base], room);
    let below = base + line;
    let muted = pen.regular(theme.muted);
    pen.write_within(&content.moment, muted, Anchor::Start, [margin, below], room);
    if plan.facts_below {
        let facts: Vec<&str> = [&*content.ejection_fraction, &*content.volumes]
            .into_iter()
            .filter(|words| !words.is_empty())
            .collect();
        let (set, at) = (pen.regular(theme.text), [margin, below + line]);
        pen.write_within(&facts.join(" · "), set, Anchor::Start, at, room);
        return;
    }
    let right = size[0] - margin;
    pen.write(&content.ejection_fraction, name, Anchor::End, [right, base]);
    pen.write(&content.volumes, muted, Anchor::End, [right, below]);
}

fn footer(
    pen: &mut Pen<'_>,
    plan: &Plan,
    content: &FigureContent,
    camera: &Camera,
    heart_height: f32,
) {
    let Plan {
        margin,
        line,
        size,
        bar_width,
        cube,
        ..
    } = *plan;
    let bottom = imprint(pen, &plan.imprint, [margin, size[1] - margin * 0.8]) + 0.2 * line;
    let at = [margin, bottom];
    let legend_top = pen.colour_bars(&content.legends, &plan.headings, at, bar_width);
    let has_legend = !content.legends.is_empty();
    let most = if has_legend && !plan.scale_above {
        size[0] - bar_width - cube - 4.0 * margin
    } else {
        0.4 * size[0]
    };
    let most = most.min(0.22 * size[0]).max(40.0);
    if let Some(bar) = ScaleBar::fitting(camera, heart_height, most, content.unit) {
        let left = match (has_legend, plan.scale_above) {
            (true, false) => {
                let between = margin + bar_width + size[0] - margin - cube;
                0.5 * (between - bar.pixels)
            }
            _ => margin,
        };
        let at = if plan.scale_above {
            legend_top - 0.6 * margin
        } else {
            bottom
        };
        pen.scale_bar(&bar, [left, at], margin);
    }
    if cube > 0.0 {
        let centre = [size[0] - margin - 0.5 * cube, bottom - 0.5 * cube];
        draw_cube(pen, &content.cube, camera.world_from_camera, centre, cube);
    }
}

/// Small lines that end at `at`; returns the base line that a line above them would have.
pub(in crate::picture) fn imprint(
    pen: &mut Pen<'_>,
    lines: &[String],
    [left, mut base]: [f32; 2],
) -> f32 {
    let mut set = pen.regular(pen.theme.muted);
    set.size *= 0.87;
    for words in lines.iter().rev() {
        pen.write(words, set, Anchor::Start, [left, base]);
        base -= 1.1 * pen.line_height();
    }
    base
}
