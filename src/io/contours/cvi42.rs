//! Outlines of a cvi42 workspace (`.cvi42wsx`, `.xml`): by the unique name of each image, in parts of its pixels.
//!
//! No description is published: the structure is that which public readers of UK Biobank exports take apart (`ukbb_cardiac`,
//! `parse_cvi42_xml.py`): an item `ImageStates` has an item for each image; its item `Contours` one for each outline, with
//! `SubpixelResolution`, by which coordinates are divided, and `Points`. Keys are matched without their name space. Whole
//! numbers are taken for centres of pixels, as those readers do.

use roxmltree::{Document, Node, ParsingOptions};

use super::outline::{ImageName, Outline, OutlineFile, OutlinePlace, PointBudget};
use crate::image::ContourPart;
use crate::io::xml::LineIndex;
use crate::io::{Limits, MAX_XML_ATTRIBUTES, ReadImageError};

/// Keys of outlines in slices across, with what they go around.
const PARTS: [(&str, ContourPart); 3] = [
    ("saendocardialContour", ContourPart::Endocardium),
    ("saepicardialContour", ContourPart::Epicardium),
    ("sarvendocardialContour", ContourPart::RightCavity),
];
/// Elements and texts of one file: 100 bytes each while it is parsed. A corner is five; 30 instants of 12 slices with three
/// outlines of 150 corners have 810,000.
const MAX_NODES: u32 = 3_000_000;
/// Bytes of one file: a node for every 16, which a corner's are.
const MAX_BYTES: u64 = 64 << 20;
/// Letters of an image's unique name; 64 in DICOM.
const MAX_UID: usize = 64;

/// Whether a file begins like a workspace.
pub(super) fn recognises(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    text.trim_start_matches('\u{feff}')
        .trim_start()
        .starts_with('<')
        && (text.contains("cvi42") || text.contains("ImageStates"))
}

/// Reads all outlines of a workspace.
///
/// # Errors
/// With the line that is not as it should be, or if the file is too large.
pub(super) fn read_cvi42(text: &str, limits: &Limits) -> Result<OutlineFile, ReadImageError> {
    let document = parsed(text)?;
    let lines = LineIndex::new(text);
    let mut file = OutlineFile::default();
    let mut budget = PointBudget::new(limits);
    let states = (document.descendants()).filter(|node| key(*node) == Some("ImageStates"));
    for image in states.flat_map(elements) {
        let Some(uid) = key(image).filter(|uid| is_uid(uid)) else {
            continue;
        };
        let drawn = elements(image).filter(|item| key(*item) == Some("Contours"));
        for outline in drawn.flat_map(elements) {
            let own = key(outline).and_then(|name| PARTS.iter().find(|(known, _)| *known == name));
            let Some((_, part)) = own else {
                file.pass_over("not around the cavities or the wall in slices across");
                continue;
            };
            let corners = corners(outline, &lines, &mut budget)?;
            match corners.len() {
                // An outline that was begun and given up.
                0..3 => file.pass_over("fewer than three corners"),
                _ => file.outlines.push(Outline {
                    part: *part,
                    place: OutlinePlace::InImage {
                        image: ImageName::Instance(uid.to_owned()),
                        corners,
                    },
                }),
            }
        }
    }
    Ok(file)
}

/// The document, if it takes little time and memory to parse.
fn parsed(text: &str) -> Result<Document<'_>, ReadImageError> {
    let size = text.len() as u64;
    if size > MAX_BYTES {
        return Err(ReadImageError::TooLarge {
            size,
            most: MAX_BYTES,
        });
    }
    // Between one `<` and the next stand the attributes of at most one element; the parser compares each with all others.
    for part in text.as_bytes().split(|&byte| byte == b'<') {
        let equals = part.iter().filter(|&&byte| byte == b'=').count();
        too_many("XML attributes of one element", equals, MAX_XML_ATTRIBUTES)?;
    }
    // Each element keeps those around it: a workspace has three.
    too_many(
        "XML name spaces",
        text.matches("xmlns").count(),
        MAX_NAMESPACES,
    )?;
    let options = ParsingOptions {
        nodes_limit: MAX_NODES,
        allow_dtd: !text.contains("<!ENTITY"),
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| ReadImageError::AtLine {
        line: error.pos().row as usize,
        reason: "the XML is damaged, too large or has entities of its own".to_owned(),
    })
}

/// Declarations of name spaces.
const MAX_NAMESPACES: usize = 32;

fn too_many(what: &'static str, count: usize, most: usize) -> Result<(), ReadImageError> {
    match count > most {
        true => Err(ReadImageError::TooMany {
            what,
            count: count as u64,
            most: most as u64,
        }),
        false => Ok(()),
    }
}

/// The key of an item.
fn key<'d>(node: Node<'d, '_>) -> Option<&'d str> {
    let mut attributes = node.attributes();
    attributes
        .find(|attribute| attribute.name() == "key")
        .map(|attribute| attribute.value())
}

fn elements<'d, 'i: 'd>(node: Node<'d, 'i>) -> impl Iterator<Item = Node<'d, 'i>> {
    node.children().filter(Node::is_element)
}

fn is_uid(text: &str) -> bool {
    (1..=MAX_UID).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit() || b == b'.')
}

/// Corners of an outline in pixels.
fn corners(
    outline: Node<'_, '_>,
    lines: &LineIndex,
    budget: &mut PointBudget,
) -> Result<Vec<[f64; 2]>, ReadImageError> {
    let item = |name: &str| elements(outline).find(|item| key(*item) == Some(name));
    let parts = match item("SubpixelResolution") {
        Some(item) => number(item, lines)?,
        None => 1.0,
    };
    if parts < 1.0 {
        return Err(wrong(outline, lines, "SubpixelResolution is less than 1"));
    }
    let mut corners = Vec::new();
    for point in item("Points").into_iter().flat_map(elements) {
        budget.take(1)?;
        let own = |name: &str| elements(point).find(|place| place.tag_name().name() == name);
        let (Some(x), Some(y)) = (own("x"), own("y")) else {
            return Err(wrong(point, lines, "a point without x or y"));
        };
        corners.push([number(x, lines)? / parts, number(y, lines)? / parts]);
    }
    Ok(corners)
}

fn number(node: Node<'_, '_>, lines: &LineIndex) -> Result<f64, ReadImageError> {
    let value = node.text().and_then(|text| text.trim().parse::<f64>().ok());
    let value = value.filter(|value| value.is_finite());
    value.ok_or_else(|| wrong(node, lines, "a number is expected here"))
}

fn wrong(node: Node<'_, '_>, lines: &LineIndex, reason: &str) -> ReadImageError {
    ReadImageError::AtLine {
        line: lines.line(node.range().start),
        reason: reason.to_owned(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    fn workspace(outlines: &str) -> String {
        format!(
            "<Workspace xmlns:Hash='cvi42/h'>\n<Hash:item Hash:key='ImageStates'>\n<Hash:item Hash:key='1.2.3'>\
             <Hash:item Hash:key='Contours'>\n{outlines}\n</Hash:item></Hash:item></Hash:item></Workspace>"
        )
    }

    fn outline(name: &str, parts: &str, points: &str) -> String {
        format!(
            "<Hash:item Hash:key='{name}'><Hash:item Hash:key='SubpixelResolution'>{parts}</Hash:item>\
             <Hash:item Hash:key='Points'>{points}</Hash:item></Hash:item>"
        )
    }

    const POINTS: &str = "<i><x>8</x><y>4</y></i><i><x>12</x><y>4</y></i><i><x>12</x><y>10</y></i>";

    #[test]
    fn coordinates_are_divided_by_the_resolution_and_other_outlines_passed_over() {
        let drawn = [
            outline("saepicardialContour", "4", POINTS),
            outline("laendocardialContour", "4", POINTS),
            outline("saendocardialContour", "4", ""),
        ];
        let text = workspace(&drawn.concat());
        let file = read_cvi42(&text, &Limits::default()).unwrap();
        let expected = Outline {
            part: ContourPart::Epicardium,
            place: OutlinePlace::InImage {
                image: ImageName::Instance("1.2.3".to_owned()),
                corners: vec![[2.0, 1.0], [3.0, 1.0], [3.0, 2.5]],
            },
        };
        assert_eq!(file.outlines, [expected]);
        assert_eq!(file.passed_over.len(), 2);
        assert!(recognises(text.as_bytes()) && !recognises(b"<VTKFile/>"));
    }

    #[test]
    fn errors_name_the_line() {
        let error = |text: &str| {
            read_cvi42(text, &Limits::default())
                .unwrap_err()
                .to_string()
        };
        let of = |parts: &str, points: &str| {
            error(&workspace(&outline("saendocardialContour", parts, points)))
        };
        assert_eq!(of("0", POINTS), "line 4: SubpixelResolution is less than 1");
        assert_eq!(of("four", POINTS), "line 4: a number is expected here");
        assert_eq!(of("4", "<i><x>1</x></i>"), "line 4: a point without x or y");
        assert_eq!(
            of("4", "<i><x>NaN</x><y>1</y></i>"),
            "line 4: a number is expected here"
        );
        let cut = error("<Workspace>\n<a>");
        assert!(
            cut.starts_with("line ") && cut.contains("the XML is damaged"),
            "{cut}"
        );
        let entities = "<!DOCTYPE a [<!ENTITY b \"bbb\">]><a>&b;</a>";
        assert!(error(entities).contains("entities of its own"));
    }
}
