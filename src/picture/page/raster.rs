//! A page as pixels.

use ab_glyph::Point;
use tiny_skia::{
    Color, FillRule, FilterQuality, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap,
    PixmapPaint, PixmapRef, Stroke, Transform,
};

use crate::picture::page::fonts::FigureFonts;
use crate::picture::page::marks::{Mark, Page};
use crate::picture::page::outline::{OutlineSink, trace};
use crate::picture::page::weight::Letter;
use crate::render::Picture;

/// A page too large to draw, or without any size.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("a picture of {} × {} pixels cannot be drawn", size[0], size[1])]
pub struct RasterError {
    /// Pixels across and down.
    pub size: [f32; 2],
}

/// Draws a page with `scale` pixels for each of its own.
///
/// # Errors
/// If it has no size, or one beyond memory.
pub fn raster(page: &Page, scale: f32, fonts: &FigureFonts) -> Result<Picture, RasterError> {
    let size = page.size.map(|side| (side * scale).round());
    let refused = RasterError { size };
    let mut pixmap = Pixmap::new(size[0] as u32, size[1] as u32).ok_or(refused)?;
    if let Some([red, green, blue]) = page.background {
        pixmap.fill(opaque(red, green, blue));
    }
    let to_pixels = Transform::from_scale(scale, scale);
    for mark in &page.marks {
        draw(&mut pixmap, mark, to_pixels, fonts);
    }
    let (width, height) = (pixmap.width(), pixmap.height());
    let mut rgba = pixmap.take();
    for pixel in rgba.chunks_exact_mut(4).filter(|pixel| pixel[3] < 255) {
        let alpha = u32::from(pixel[3]).max(1);
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * 255 + alpha / 2) / alpha).min(255) as u8;
        }
    }
    Ok(Picture {
        width,
        height,
        rgba,
    })
}

fn opaque(red: f32, green: f32, blue: f32) -> Color {
    let [red, green, blue] = [red, green, blue].map(byte);
    Color::from_rgba8(red, green, blue, 255)
}

/// A channel in 0..=1 as a byte.
pub(super) fn byte(channel: f32) -> u8 {
    (channel.clamp(0.0, 1.0) * 255.0).round() as u8
}

fn paint(colour: [f32; 3], opacity: f32) -> Paint<'static> {
    let [red, green, blue] = colour.map(byte);
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, byte(opacity));
    paint.anti_alias = true;
    paint
}

fn draw(pixmap: &mut Pixmap, mark: &Mark, to_pixels: Transform, fonts: &FigureFonts) {
    match mark {
        Mark::Fill {
            corners,
            colour,
            opacity,
        } => {
            if let Some(path) = polyline(corners, true) {
                let paint = paint(*colour, *opacity);
                pixmap.fill_path(&path, &paint, FillRule::EvenOdd, to_pixels, None);
            }
        }
        Mark::Line {
            points,
            closed,
            width,
            colour,
            opacity,
        } => {
            let stroke = Stroke {
                width: *width,
                line_cap: LineCap::Round,
                line_join: LineJoin::Round,
                ..Stroke::default()
            };
            if let Some(path) = polyline(points, *closed) {
                pixmap.stroke_path(&path, &paint(*colour, *opacity), &stroke, to_pixels, None);
            }
        }
        Mark::Text {
            words,
            face,
            weight,
            size,
            at,
            colour,
        } => {
            let outlines = match face {
                None => fonts.outlines(words, *weight, *size),
                Some(face) => face.outlines(words, *size).0,
            };
            if let Some(path) = letters(&outlines, *at) {
                let paint = paint(*colour, 1.0);
                pixmap.fill_path(&path, &paint, FillRule::Winding, to_pixels, None);
            }
        }
        Mark::Picture { at, size, picture } => put(pixmap, picture, *at, *size, to_pixels),
    }
}

fn polyline(points: &[[f32; 2]], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    path.move_to(first[0], first[1]);
    for point in rest {
        path.line_to(point[0], point[1]);
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// Outlines of a line of words, with its base line starting at `at`.
fn letters(outlines: &[Letter], at: [f32; 2]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for letter in outlines {
        let mut sink = RasterPath {
            path: &mut path,
            letter,
            at,
        };
        trace(&letter.curves, &mut sink);
    }
    path.finish()
}

/// A letter on its way into a path.
struct RasterPath<'a> {
    path: &'a mut PathBuilder,
    letter: &'a Letter,
    at: [f32; 2],
}

impl RasterPath<'_> {
    fn place(&self, point: Point) -> [f32; 2] {
        self.letter.place(self.at, point)
    }
}

impl OutlineSink for RasterPath<'_> {
    fn move_to(&mut self, to: Point) {
        let [x, y] = self.place(to);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, to: Point) {
        let [x, y] = self.place(to);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, by: Point, to: Point) {
        let ([bx, by], [x, y]) = (self.place(by), self.place(to));
        self.path.quad_to(bx, by, x, y);
    }

    fn cubic_to(&mut self, _: Point, by: [Point; 2], to: Point) {
        let [[ax, ay], [bx, by]] = by.map(|point| self.place(point));
        let [x, y] = self.place(to);
        self.path.cubic_to(ax, ay, bx, by, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

/// Lays pixels down, each on one of the page's where they have its size.
fn put(pixmap: &mut Pixmap, raster: &Picture, at: [f32; 2], size: [f32; 2], to_pixels: Transform) {
    if raster.width == 0 || raster.height == 0 {
        return;
    }
    let multiplied = premultiplied(&raster.rgba);
    let Some(source) = PixmapRef::from_bytes(&multiplied, raster.width, raster.height) else {
        return;
    };
    let stretch = Transform::from_row(
        size[0] / raster.width as f32,
        0.0,
        0.0,
        size[1] / raster.height as f32,
        at[0],
        at[1],
    );
    let whole = stretch.post_concat(to_pixels);
    let near = |a: f32, b: f32| (a - b).abs() < 1e-3;
    let exact = near(whole.sx, 1.0)
        && near(whole.sy, 1.0)
        && near(whole.tx, whole.tx.round())
        && near(whole.ty, whole.ty.round());
    let paint = PixmapPaint {
        quality: if exact {
            FilterQuality::Nearest
        } else {
            FilterQuality::Bicubic
        },
        ..PixmapPaint::default()
    };
    pixmap.draw_pixmap(0, 0, source, &paint, whole, None);
}

/// With the opacity multiplied in.
fn premultiplied(rgba: &[u8]) -> Vec<u8> {
    let mut multiplied = rgba.to_vec();
    for pixel in multiplied.chunks_exact_mut(4).filter(|p| p[3] < 255) {
        let alpha = u32::from(pixel[3]);
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * alpha + 127) / 255) as u8;
        }
    }
    multiplied
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::marks::{Anchor, Type};
    use crate::picture::page::weight::Weight;
    use std::sync::Arc;

    fn page() -> Page {
        Page::new([60.0, 40.0], Some([1.0; 3]))
    }

    fn drawn(page: &Page, scale: f32) -> Picture {
        raster(page, scale, &FigureFonts::load().unwrap()).unwrap()
    }

    /// How much black there is, in pixels.
    fn dark(raster: &Picture) -> f32 {
        let pixels = raster.rgba.chunks(4);
        pixels.map(|p| 1.0 - f32::from(p[0]) / 255.0).sum()
    }

    #[test]
    fn shapes_and_lines_cover_their_area_at_any_scale() {
        let mut page = page();
        page.fill(
            &[[10.25, 10.0], [30.25, 10.0], [30.25, 20.5], [10.25, 20.5]],
            [0.0; 3],
        );
        for scale in [1.0, 2.5] {
            let area = dark(&drawn(&page, scale)) / (scale * scale);
            assert!((area - 210.0).abs() < 2.0, "{area}");
        }
        let mut page = Page::new([60.0, 40.0], Some([1.0; 3]));
        page.line(&[[10.0, 20.0], [50.0, 20.0]], false, 3.0, [0.0; 3]);
        let with_round_ends = 40.0 * 3.0 + std::f32::consts::PI * 1.5 * 1.5;
        assert!((dark(&drawn(&page, 1.0)) - with_round_ends).abs() < 2.0);
    }

    #[test]
    fn text_is_as_dark_as_its_area() {
        let fonts = FigureFonts::load().unwrap();
        let set = Type {
            weight: Weight::Regular,
            size: 30.0,
            colour: [0.0; 3],
        };
        let mut page = page();
        page.words(&fonts, "I", set, Anchor::Start, [20.0, 32.0]);
        // An I is a bar of cap height (0.73 em) by its stem (0.09 em).
        let area = dark(&drawn(&page, 1.0));
        assert!((area - 30.0 * 0.73 * 30.0 * 0.09).abs() < 15.0, "{area}");
    }

    #[test]
    fn a_picture_of_the_right_size_is_laid_down_pixel_by_pixel() {
        let rgba = vec![255, 0, 0, 255, 0, 0, 255, 128, 0, 255, 0, 255, 9, 8, 7, 0];
        let red_blue = Arc::new(Picture {
            width: 2,
            height: 2,
            rgba,
        });
        let mut page = Page::new([6.0, 4.0], None);
        page.picture([3.0, 1.0], [2.0, 2.0], red_blue);
        let drawn = drawn(&page, 1.0);
        assert_eq!(drawn.pixel(3, 1), [255, 0, 0, 255]);
        assert_eq!(drawn.pixel(3, 2), [0, 255, 0, 255]);
        let [red, green, blue, opacity] = drawn.pixel(4, 1);
        assert_eq!([red, green, opacity], [0, 0, 128]);
        assert!(blue >= 254);
        assert_eq!(drawn.pixel(4, 2), [0; 4]);
    }

    #[test]
    fn a_page_without_size_is_refused() {
        let empty = Page::new([0.0, 10.0], None);
        let refused = raster(&empty, 1.0, &FigureFonts::load().unwrap()).unwrap_err();
        assert_eq!(
            refused.to_string(),
            "a picture of 0 × 10 pixels cannot be drawn"
        );
    }
}
