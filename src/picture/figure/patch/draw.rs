//! Puts the blocks of a patch figure onto its page.

use std::sync::Arc;

use crate::picture::figure::cube::draw_cube;
use crate::picture::figure::layout::imprint;
use crate::picture::figure::patch::bulls_eye::draw_bulls_eye;
use crate::picture::figure::patch::content::{PATCH_COLUMNS, PatchContent};
use crate::picture::figure::patch::frame::PatchFrame;
use crate::picture::figure::pen::Pen;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::patch_words::PatchStanding;
use crate::picture::scale_bar::ScaleBar;
use crate::picture::tokens::PictureTheme;
use crate::render::{Camera, Picture};

/// A whole figure around a heart's picture, which has the size that `frame` says and is taken with `camera`.
pub fn drawn_patch_figure(
    frame: &PatchFrame,
    content: &PatchContent,
    heart: Arc<Picture>,
    camera: &Camera,
    theme: &PictureTheme,
    transparent: bool,
    fonts: &FigureFonts,
) -> Page {
    let size = frame.size.map(|pixels| pixels as f32);
    let mut page = Page::new(size, (!transparent).then_some(theme.background));
    let place = frame.heart_at.map(|pixels| pixels as f32);
    page.picture(place, frame.heart_size.map(|pixels| pixels as f32), heart);
    let mut pen = Pen {
        page: &mut page,
        fonts,
        theme,
        text: frame.text,
    };
    header(&mut pen, frame, content);
    beside_heart(&mut pen, frame, content, camera);
    let left = (frame.heart_at[0] + frame.heart_size[0]) as f32;
    let low = [left, frame.heart_at[1] as f32];
    let high = [size[0] - frame.margin, frame.legend_bottom];
    draw_bulls_eye(&mut pen, &content.bulls_eye, low, high);
    table(&mut pen, frame, content);
    let base = size[1] - 0.8 * frame.margin;
    imprint(&mut pen, &frame.imprint, [frame.margin, base]);
    page
}

fn header(pen: &mut Pen<'_>, frame: &PatchFrame, content: &PatchContent) {
    let PatchFrame {
        margin,
        title,
        line,
        ..
    } = *frame;
    let theme = pen.theme;
    let (left, right) = (margin, frame.size[0] as f32 - margin);
    let room = right - left;
    let mut base = margin + 0.75 * title;
    let name = pen.strong(theme.text, title);
    let muted = pen.regular(theme.muted);
    pen.write_within(
        &content.heart.title,
        name,
        Anchor::Start,
        [left, base],
        0.7 * room,
    );
    let facts = &content.heart.ejection_fraction;
    pen.write(facts, name, Anchor::End, [right, base]);
    base += line;
    pen.write_within(
        &content.heart.moment,
        muted,
        Anchor::Start,
        [left, base],
        0.7 * room,
    );
    pen.write(&content.heart.volumes, muted, Anchor::End, [right, base]);
    let verdict = &content.verdict;
    base += 1.5 * line;
    if !verdict.heading.is_empty() {
        let colour = if verdict.abnormal {
            theme.emphasis
        } else {
            theme.text
        };
        let set = pen.strong(colour, 1.25 * pen.text);
        pen.write_within(&verdict.heading, set, Anchor::Start, [left, base], room);
    }
    for words in &frame.evidence {
        base += line;
        pen.write(words, muted, Anchor::Start, [left, base]);
    }
}

/// Colour bar, scale bar and cube below the heart.
fn beside_heart(pen: &mut Pen<'_>, frame: &PatchFrame, content: &PatchContent, camera: &Camera) {
    let PatchFrame {
        margin,
        legend_bottom: bottom,
        bar_width,
        cube,
        ..
    } = *frame;
    let width = frame.heart_size[0] as f32;
    let legends = &content.heart.legends;
    pen.colour_bars(legends, &frame.headings, [margin, bottom], bar_width);
    let most = (width - bar_width - cube - 4.0 * margin).clamp(0.1 * width, 0.25 * width);
    let height = frame.heart_size[1] as f32;
    if let Some(bar) = ScaleBar::fitting(camera, height, most, content.heart.unit) {
        let between = 2.0 * margin + bar_width + width - cube;
        let left = 0.5 * (between - bar.pixels);
        pen.scale_bar(&bar, [left, bottom], margin);
    }
    if cube > 0.0 {
        let centre = [width - 0.5 * cube, bottom - 0.5 * cube];
        draw_cube(
            pen,
            &content.heart.cube,
            camera.world_from_camera,
            centre,
            cube,
        );
    }
}

fn table(pen: &mut Pen<'_>, frame: &PatchFrame, content: &PatchContent) {
    let PatchFrame {
        margin,
        line,
        columns,
        ..
    } = *frame;
    let theme = pen.theme;
    let mut base = frame.table_top;
    let muted = pen.regular(theme.muted);
    let plain = pen.regular(theme.text);
    // Numbers end where the next column would begin.
    let gap = 0.9 * pen.text;
    let cells = columns.cells.map(|right| right - gap);
    if !content.rows.is_empty() {
        let part = content.standing.part();
        pen.write(part, muted, Anchor::Start, [columns.number, base]);
        for (column, x) in PATCH_COLUMNS.iter().zip(cells) {
            pen.write(column.heading, muted, Anchor::End, [x, base]);
        }
        let at = [columns.segments, base];
        pen.write("Segments", muted, Anchor::Start, at);
        let below = base + 0.35 * line;
        let ends = [[margin, below], [frame.size[0] as f32 - margin, below]];
        pen.page
            .line(&ends, false, (pen.text / 15.0).max(1.0), theme.line);
        base += 1.3 * line;
    }
    for (index, (row, segments)) in content.rows.iter().zip(&frame.segments).enumerate() {
        let colour = match content.standing {
            PatchStanding::RegionOnly => theme.muted,
            PatchStanding::NoVerdict
            | PatchStanding::UnclassifiedPatch
            | PatchStanding::AbnormalPatch => theme.emphasis,
        };
        let number = pen.strong(colour, pen.text);
        let name = (index + 1).to_string();
        pen.write(&name, number, Anchor::Start, [columns.number, base]);
        for (cell, x) in row.cells.iter().zip(cells) {
            pen.write(cell, plain, Anchor::End, [x, base]);
        }
        for (step, words) in segments.iter().enumerate() {
            let at = [columns.segments, base + step as f32 * line];
            pen.write(words, plain, Anchor::Start, at);
        }
        base += line * segments.len().max(1) as f32;
    }
    let room = frame.size[0] as f32 - 2.0 * margin;
    pen.write_within(&content.note, muted, Anchor::Start, [margin, base], room);
}
