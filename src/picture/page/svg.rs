//! A page as SVG: words stay words, shapes stay shapes, pictures lie inside.

use std::collections::BTreeSet;
use std::fmt::Write;

use ab_glyph::Point;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::picture::page::FigureSettings;
use crate::picture::page::marks::{Mark, Page};
use crate::picture::page::outline::{OutlineSink, trace};
use crate::picture::page::png_file::{PngError, encoded_png};
use crate::picture::page::raster::byte;
use crate::picture::page::weight::{Letter, Weight};

/// The text of an SVG file `width_mm` wide. The typeface lies inside, as far as it is used, and each setting stands in the
/// metadata as `key: value`.
///
/// # Errors
/// If a picture on the page cannot be encoded.
pub fn svg_file(page: &Page, width_mm: f32, settings: &FigureSettings) -> Result<String, PngError> {
    let [width, height] = page.size;
    let height_mm = width_mm * height / width;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width_mm}mm\" height=\"{height_mm}mm\" viewBox=\"0 0 {width} {height}\">\n"
    );
    if let Some((_, title)) = settings.iter().find(|(key, _)| *key == "Title") {
        put(
            &mut svg,
            format_args!("<title>{}</title>\n", escaped(title)),
        );
    }
    svg.push_str("<metadata>\n");
    for (key, value) in settings {
        put(
            &mut svg,
            format_args!("{}: {}\n", escaped(key), escaped(value)),
        );
    }
    svg.push_str("</metadata>\n");
    typefaces(&mut svg, page);
    if let Some(colour) = page.background {
        let colour = hex(colour);
        put(
            &mut svg,
            format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"{colour}\"/>\n"),
        );
    }
    for mark in &page.marks {
        add(&mut svg, mark)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// Writing into a string cannot fail.
fn put(svg: &mut String, words: std::fmt::Arguments<'_>) {
    svg.write_fmt(words).ok();
}

/// Only the weights that the page uses.
fn typefaces(svg: &mut String, page: &Page) {
    let weights = page.marks.iter().filter_map(|mark| match mark {
        Mark::Text {
            weight, face: None, ..
        } => Some(weight.number()),
        _ => None,
    });
    let used: BTreeSet<u16> = weights.collect();
    if used.is_empty() {
        return;
    }
    svg.push_str("<style>\n");
    for weight in [Weight::Regular, Weight::SemiBold] {
        let number = weight.number();
        if used.contains(&number) {
            let file = STANDARD.encode(weight.file());
            put(
                svg,
                format_args!(
                    "@font-face {{ font-family: Inter; font-weight: {number}; src: url(data:font/otf;base64,{file}); }}\n"
                ),
            );
        }
    }
    svg.push_str(
        "text { font-family: Inter, Helvetica, Arial, sans-serif; white-space: pre; }\n</style>\n",
    );
}

fn add(svg: &mut String, mark: &Mark) -> Result<(), PngError> {
    match mark {
        Mark::Fill {
            corners,
            colour,
            opacity,
        } => put(
            svg,
            format_args!(
                "<path d=\"{}Z\" fill=\"{}\" fill-rule=\"evenodd\"{}/>\n",
                path(corners),
                hex(*colour),
                seen_through("fill-opacity", *opacity)
            ),
        ),
        Mark::Line {
            points,
            closed,
            width,
            colour,
            opacity,
        } => put(
            svg,
            format_args!(
                "<path d=\"{}{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{}/>\n",
                path(points),
                if *closed { "Z" } else { "" },
                hex(*colour),
                short(*width),
                seen_through("stroke-opacity", *opacity)
            ),
        ),
        // A face of the system may be too large for the file, or nobody's to hand on: its letters are shapes that say what
        // they are.
        Mark::Text {
            words,
            face: Some(face),
            size,
            at,
            colour,
            ..
        } => put(
            svg,
            format_args!(
                "<path d=\"{}\" fill=\"{}\"><title>{}</title></path>\n",
                letters(&face.outlines(words, *size).0, *at),
                hex(*colour),
                escaped(words)
            ),
        ),
        Mark::Text {
            words,
            face: None,
            weight,
            size,
            at,
            colour,
        } => put(
            svg,
            format_args!(
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-weight=\"{}\" fill=\"{}\">{}</text>\n",
                short(at[0]),
                short(at[1]),
                short(*size),
                weight.number(),
                hex(*colour),
                escaped(words)
            ),
        ),
        Mark::Picture { at, size, picture } => {
            let file = STANDARD.encode(encoded_png(picture, &Vec::new())?);
            put(
                svg,
                format_args!(
                    "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,{file}\"/>\n",
                    short(at[0]),
                    short(at[1]),
                    short(size[0]),
                    short(size[1])
                ),
            );
        }
    }
    Ok(())
}

fn path(points: &[[f32; 2]]) -> String {
    let mut path = String::new();
    for (index, point) in points.iter().enumerate() {
        let letter = if index == 0 { 'M' } else { 'L' };
        put(
            &mut path,
            format_args!("{letter}{} {}", short(point[0]), short(point[1])),
        );
    }
    path
}

/// Outlines of letters as one path, the base line starting at `at`.
fn letters(outlines: &[Letter], at: [f32; 2]) -> String {
    let mut path = String::new();
    for letter in outlines {
        let mut sink = SvgPath {
            path: &mut path,
            letter,
            at,
        };
        trace(&letter.curves, &mut sink);
    }
    path
}

/// A letter on its way into a path.
struct SvgPath<'a> {
    path: &'a mut String,
    letter: &'a Letter,
    at: [f32; 2],
}

impl SvgPath<'_> {
    fn put(&mut self, sign: char, points: &[Point]) {
        let places: Vec<String> = (points.iter())
            .map(|&point| {
                let [x, y] = self.letter.place(self.at, point).map(short);
                format!("{x} {y}")
            })
            .collect();
        self.path.push(sign);
        self.path.push_str(&places.join(" "));
    }
}

impl OutlineSink for SvgPath<'_> {
    fn move_to(&mut self, to: Point) {
        self.put('M', &[to]);
    }

    fn line_to(&mut self, to: Point) {
        self.put('L', &[to]);
    }

    fn quad_to(&mut self, by: Point, to: Point) {
        self.put('Q', &[by, to]);
    }

    fn cubic_to(&mut self, _: Point, [a, b]: [Point; 2], to: Point) {
        self.put('C', &[a, b, to]);
    }

    fn close(&mut self) {
        self.path.push('Z');
    }
}

fn seen_through(attribute: &str, opacity: f32) -> String {
    if opacity < 1.0 {
        format!(" {attribute}=\"{}\"", short(opacity))
    } else {
        String::new()
    }
}

/// Two digits after the point: a hundredth of a pixel.
fn short(number: f32) -> f32 {
    (number * 100.0).round() / 100.0
}

fn hex(colour: [f32; 3]) -> String {
    let [red, green, blue] = colour.map(byte);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Text in which nothing can be taken for markup, without characters that XML cannot hold.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            control if control.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::fonts::FigureFonts;
    use crate::picture::page::marks::{Anchor, Type};
    use crate::render::Picture;
    use std::sync::Arc;

    #[test]
    fn words_and_shapes_can_be_read_back() {
        let mut page = Page::new([200.0, 100.0], Some([1.0; 3]));
        page.fill(&[[1.0, 2.0], [3.0, 4.0], [5.126, 6.0]], [1.0, 0.0, 0.5]);
        page.line(&[[0.0, 0.0], [10.0, 0.0]], false, 1.5, [0.0; 3]);
        let set = Type {
            weight: Weight::SemiBold,
            size: 12.0,
            colour: [0.0; 3],
        };
        let fonts = FigureFonts::load().unwrap();
        page.words(&fonts, "P<1> & ", set, Anchor::Start, [20.0, 30.0]);
        let raster = Arc::new(Picture {
            width: 1,
            height: 1,
            rgba: vec![1, 2, 3, 255],
        });
        page.picture([0.0, 0.0], [50.0, 25.0], raster);
        let settings = vec![("Title", "P<1>".to_owned())];
        let svg = svg_file(&page, 100.0, &settings).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("width"), Some("100mm"));
        assert_eq!(root.attribute("height"), Some("50mm"));
        let named = |name| root.children().filter(move |node| node.has_tag_name(name));
        let text = named("text").next().unwrap();
        assert_eq!(text.text(), Some("P<1> & "));
        assert_eq!(text.attribute("x"), Some("20"));
        let first = named("path").next().unwrap();
        assert_eq!(first.attribute("d"), Some("M1 2L3 4L5.13 6Z"));
        assert_eq!(first.attribute("fill"), Some("#ff0080"));
        assert_eq!(named("image").count(), 1);
        let metadata = named("metadata").next().unwrap().text().unwrap();
        assert!(metadata.contains("Title: P<1>"));
        let style = named("style").next().unwrap().text().unwrap();
        assert!(style.contains("font-weight: 600") && !style.contains("font-weight: 400"));
    }

    #[test]
    fn letters_that_inter_lacks_are_shapes_that_say_what_they_are() {
        let set = Type {
            weight: Weight::Regular,
            size: 12.0,
            colour: [0.0; 3],
        };
        let fonts = FigureFonts::load().unwrap();
        let mut page = Page::new([200.0, 100.0], None);
        page.words(&fonts, "a心\u{1}", set, Anchor::Start, [20.0, 30.0]);
        let svg = svg_file(&page, 100.0, &Vec::new()).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let shapes = document
            .descendants()
            .filter(|node| node.has_tag_name("path"));
        let titles: Vec<&str> = shapes
            .map(|shape| {
                assert!(shape.attribute("d").unwrap().len() > 50, "{shape:?}");
                shape.first_element_child().unwrap().text().unwrap()
            })
            .collect();
        assert_eq!(titles, ["心", " "], "XML holds no control character");
        let words = document
            .descendants()
            .find(|node| node.has_tag_name("text"));
        assert_eq!(words.unwrap().text(), Some("a"));
    }
}
