//! Pages as one PDF file: words stay words, shapes stay shapes.

use krilla::Document;
use krilla::color::rgb;
use krilla::geom::{Path, PathBuilder, Point, Size, Transform};
use krilla::image::Image;
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin, Paint, Stroke};
use krilla::surface::Surface;
use krilla::text::{Font, TextDirection};
use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::picture::page::FigureSettings;
use crate::picture::page::marks::{Mark, Page};
use crate::picture::page::raster::byte;
use crate::picture::page::weight::Weight;
use crate::render::Picture;

/// Points of PDF in a millimetre.
const POINTS_PER_MM: f32 = 72.0 / 25.4;

/// The pages could not become a PDF file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the pages cannot be written as PDF: {0}")]
pub struct PdfError(String);

/// The bytes of a PDF file of pages that are each `width_mm` wide. Settings stand in its description as `key: value`.
///
/// The same pages give the same bytes: no date is written.
///
/// # Errors
/// If a page has no size, or the writer refuses.
pub fn pdf_file(
    pages: &[Page],
    width_mm: f32,
    settings: &FigureSettings,
) -> Result<Vec<u8>, PdfError> {
    let typefaces = typefaces(pages)?;
    let mut document = Document::new();
    document.set_metadata(metadata(settings));
    for page in pages {
        let points = width_mm * POINTS_PER_MM / page.size[0];
        let [width, height] = page.size.map(|side| side * points);
        let sized = PageSettings::from_wh(width, height);
        let empty = || PdfError(format!("a page of {width} × {height} points"));
        let mut sheet = document.start_page_with(sized.ok_or_else(empty)?);
        let mut surface = sheet.surface();
        surface.push_transform(&Transform::from_scale(points, points));
        lay(&mut surface, page, &typefaces);
        surface.pop();
        surface.finish();
        sheet.finish();
    }
    document
        .finish()
        .map_err(|error| PdfError(format!("{error:?}")))
}

/// A typeface in a document.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Face {
    Inter(Weight),
    Further(usize),
}

/// Inter, and the further faces that the pages use.
fn typefaces(pages: &[Page]) -> Result<HashMap<Face, Font>, PdfError> {
    let mut typefaces = HashMap::new();
    for weight in [Weight::Regular, Weight::SemiBold] {
        let font = Font::new(weight.file().into(), 0);
        let damaged = || PdfError("the built-in font cannot be read".to_owned());
        typefaces.insert(Face::Inter(weight), font.ok_or_else(damaged)?);
    }
    for mark in pages.iter().flat_map(|page| &page.marks) {
        if let Mark::Text {
            face: Some(face), ..
        } = mark
            && let Entry::Vacant(place) = typefaces.entry(Face::Further(face.number()))
        {
            let damaged = || PdfError("a font of this system cannot be read".to_owned());
            let font = Font::new(face.bytes.into(), face.index);
            place.insert(font.ok_or_else(damaged)?);
        }
    }
    Ok(typefaces)
}

fn metadata(settings: &FigureSettings) -> Metadata {
    let of = |key: &str| {
        let found = settings.iter().find(|(other, _)| *other == key);
        found.map_or_else(String::new, |(_, value)| value.clone())
    };
    let all: Vec<String> = settings
        .iter()
        .map(|(key, value)| format!("{key}: {value}"))
        .collect();
    Metadata::new()
        .title(of("Title"))
        .creator(of("Software"))
        .description(all.join("\n"))
        .language("en".to_owned())
}

fn lay(surface: &mut Surface<'_>, page: &Page, typefaces: &HashMap<Face, Font>) {
    if let Some(colour) = page.background {
        let [width, height] = page.size;
        let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        fill(surface, &corners, colour, 1.0);
    }
    for mark in &page.marks {
        match mark {
            Mark::Fill {
                corners,
                colour,
                opacity,
            } => fill(surface, corners, *colour, *opacity),
            Mark::Line {
                points,
                closed,
                width,
                colour,
                opacity,
            } => {
                surface.set_fill(None);
                surface.set_stroke(Some(Stroke {
                    paint: paint(*colour),
                    width: *width,
                    opacity: share(*opacity),
                    line_cap: LineCap::Round,
                    line_join: LineJoin::Round,
                    ..Stroke::default()
                }));
                if let Some(path) = polyline(points, *closed) {
                    surface.draw_path(&path);
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
                surface.set_stroke(None);
                surface.set_fill(Some(filling(*colour, 1.0)));
                let (key, direction) = match face {
                    None => (Face::Inter(*weight), TextDirection::LeftToRight),
                    Some(face) => (Face::Further(face.number()), TextDirection::Auto),
                };
                if let Some(font) = typefaces.get(&key) {
                    let at = Point::from_xy(at[0], at[1]);
                    surface.draw_text(at, font.clone(), *size, words, false, direction);
                }
            }
            Mark::Picture { at, size, picture } => put(surface, picture, *at, *size),
        }
    }
}

fn fill(surface: &mut Surface<'_>, corners: &[[f32; 2]], colour: [f32; 3], opacity: f32) {
    surface.set_stroke(None);
    surface.set_fill(Some(filling(colour, opacity)));
    if let Some(path) = polyline(corners, true) {
        surface.draw_path(&path);
    }
}

fn put(surface: &mut Surface<'_>, picture: &Picture, at: [f32; 2], size: [f32; 2]) {
    let Some(size) = Size::from_wh(size[0], size[1]) else {
        return;
    };
    if picture.width == 0 || picture.height == 0 {
        return;
    }
    let image = Image::from_rgba8(picture.rgba.clone(), picture.width, picture.height);
    surface.push_transform(&Transform::from_translate(at[0], at[1]));
    surface.draw_image(image, size);
    surface.pop();
}

fn polyline(points: &[[f32; 2]], closed: bool) -> Option<Path> {
    let (first, rest) = points.split_first()?;
    let mut path = PathBuilder::new();
    path.move_to(first[0], first[1]);
    for point in rest {
        path.line_to(point[0], point[1]);
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn paint(colour: [f32; 3]) -> Paint {
    let [red, green, blue] = colour.map(byte);
    rgb::Color::new(red, green, blue).into()
}

fn filling(colour: [f32; 3], opacity: f32) -> Fill {
    Fill {
        paint: paint(colour),
        opacity: share(opacity),
        rule: FillRule::EvenOdd,
    }
}

fn share(opacity: f32) -> NormalizedF32 {
    NormalizedF32::new(opacity.clamp(0.0, 1.0)).unwrap_or(NormalizedF32::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::fonts::FigureFonts;
    use crate::picture::page::marks::{Anchor, Type};
    use std::sync::Arc;

    #[test]
    fn pages_have_their_width_and_the_same_pages_the_same_bytes() {
        let mut page = Page::new([400.0, 200.0], Some([1.0; 3]));
        let set = Type {
            weight: Weight::SemiBold,
            size: 24.0,
            colour: [0.0; 3],
        };
        let fonts = FigureFonts::load().unwrap();
        page.words(&fonts, "P-041", set, Anchor::Middle, [200.0, 100.0]);
        page.rectangle([10.0, 10.0], [20.0, 20.0], [1.0, 0.0, 0.0]);
        page.line(&[[0.0, 0.0], [9.0, 9.0]], true, 1.0, [0.0; 3]);
        let raster = Picture {
            width: 1,
            height: 1,
            rgba: vec![1, 2, 3, 4],
        };
        page.picture([0.0; 2], [5.0; 2], Arc::new(raster));
        let settings = vec![("Title", "P-041".to_owned()), ("Software", "x".to_owned())];
        let pages = [page.clone(), page];
        let bytes = pdf_file(&pages, 127.0, &settings).unwrap();
        assert_eq!(bytes, pdf_file(&pages, 127.0, &settings).unwrap());
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.starts_with("%PDF-"));
        // 127 mm are 360 points; the page is half as high.
        assert_eq!(text.matches("[0 0 360 180]").count(), 2, "{text}");
        assert!(text.contains("P-041"));
    }

    #[test]
    fn a_page_without_size_is_refused() {
        let error = pdf_file(&[Page::new([10.0, 0.0], None)], 100.0, &Vec::new()).unwrap_err();
        assert!(error.to_string().contains("cannot be written as PDF"));
    }
}
