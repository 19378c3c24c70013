//! Contours of radiotherapy (RTSTRUCT): closed polygons of structures, in the patient (PS3.3, C.8.8.5 and C.8.8.6).

use super::element::DataSet;
use super::layout::unsupported;
use super::tag::{
    CONTOUR_DATA, CONTOUR_IMAGES, CONTOUR_KIND, CONTOURS, REFERENCED_INSTANCE,
    REFERENCED_STRUCTURE, STRUCTURE_CONTOURS, STRUCTURE_NAME, STRUCTURE_NUMBER, STRUCTURES,
};
use crate::io::image_file::ReadImageError;
use crate::mesh::Point3;

/// One structure of a file of contours.
#[derive(Clone, Debug, PartialEq)]
pub struct ContouredStructure {
    /// Its number in the file.
    pub number: u32,
    /// What it is, where its name says so in words of anatomy; other words of its name stay in the file.
    pub part: Option<&'static str>,
    /// Closed polygons, each in one plane, in millimetres (LPS). The first point does not stand again at the end.
    pub polygons: Vec<Vec<Point3>>,
    /// For each polygon the unique name of the image that it was drawn in (SOP Instance UID), where one is said. It is never
    /// shown.
    pub images: Vec<Option<String>>,
}

/// Words of names, in order of preference, with what they mean.
const PARTS: [(&str, &str); 18] = [
    ("endo", "endocardium"),
    ("epi", "epicardium"),
    ("myocard", "myocardium"),
    ("left ventricle", "left ventricle"),
    ("right ventricle", "right ventricle"),
    ("ventricle left", "left ventricle"),
    ("ventricle right", "right ventricle"),
    ("left atrium", "left atrium"),
    ("right atrium", "right atrium"),
    ("pericard", "pericardium"),
    ("aorta", "aorta"),
    ("liver", "liver"),
    ("lung", "lung"),
    ("heart", "heart"),
    ("lv", "left ventricle"),
    ("rv", "right ventricle"),
    ("la", "left atrium"),
    ("ra", "right atrium"),
];

/// The structures that have closed contours.
///
/// # Errors
/// If there are none, a contour has numbers that are no points, or there are more than `most` points in all.
pub(super) fn structures(
    set: &DataSet<'_>,
    most: usize,
) -> Result<Vec<ContouredStructure>, ReadImageError> {
    let named: Vec<(u32, Option<&'static str>)> = (set.items(STRUCTURES).iter())
        .filter_map(|item| {
            let number = item.count(STRUCTURE_NUMBER)? as u32;
            Some((number, item.text(STRUCTURE_NAME).and_then(part_of)))
        })
        .collect();
    let mut left = most;
    let mut structures = Vec::new();
    for item in set.items(STRUCTURE_CONTOURS) {
        let Some(number) = item.count(REFERENCED_STRUCTURE).map(|number| number as u32) else {
            continue;
        };
        let (mut polygons, mut images) = (Vec::new(), Vec::new());
        for contour in item.items(CONTOURS) {
            if contour.text(CONTOUR_KIND) == Some("CLOSED_PLANAR") {
                polygons.push(polygon(&contour, most, &mut left)?);
                let image = contour.items(CONTOUR_IMAGES).into_iter().next();
                let name = image
                    .as_ref()
                    .and_then(|image| image.text(REFERENCED_INSTANCE));
                images.push(name.map(str::to_owned));
            }
        }
        if !polygons.is_empty() {
            let name = named.iter().find(|(own, _)| *own == number);
            structures.push(ContouredStructure {
                number,
                part: name.and_then(|(_, part)| *part),
                polygons,
                images,
            });
        }
    }
    if structures.is_empty() {
        return Err(unsupported("it has no closed contours"));
    }
    Ok(structures)
}

/// The points of one contour.
fn polygon(
    contour: &DataSet<'_>,
    most: usize,
    left: &mut usize,
) -> Result<Vec<Point3>, ReadImageError> {
    let wrong = |reason: &str| ReadImageError::InField {
        field: "ContourData",
        reason: reason.to_owned(),
    };
    let numbers = contour.numbers(CONTOUR_DATA);
    let numbers = numbers.ok_or_else(|| wrong("it is missing, or not all of it are numbers"))?;
    let (points, rest) = numbers.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(wrong("its numbers are not three a point"));
    }
    *left = left
        .checked_sub(points.len())
        .ok_or(ReadImageError::TooMany {
            what: "points of contours or more",
            count: most as u64 + 1,
            most: most as u64,
        })?;
    let mut points: Vec<Point3> = points
        .iter()
        .map(|&[x, y, z]| Point3::new(x, y, z))
        .collect();
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        return Err(wrong("a closed contour has fewer than three points"));
    }
    Ok(points)
}

/// What a name means in words of anatomy. Short words count only as whole ones.
pub(super) fn part_of(name: &str) -> Option<&'static str> {
    let name = name.to_ascii_lowercase();
    let spaced = name.replace(['_', '-', '.', '^'], " ");
    let whole = |word: &str| spaced.split_whitespace().any(|own| own == word);
    let found = PARTS.iter().find(|(word, _)| match word.len() {
        0..=2 => whole(word),
        _ => spaced.contains(word),
    });
    found.map(|(_, part)| *part)
}
