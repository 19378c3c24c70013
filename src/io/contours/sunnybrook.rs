//! Outlines of the Sunnybrook Cardiac Data (MICCAI 2009 challenge): a text file for each outline, `IM-0001-0048-icontour-manual.txt`.
//!
//! Each line has a column and a row in pixels. They are counted from 1, as in MATLAB: under the outlines of SC-HF-I-4 the gradient of
//! the image is greatest when they are moved by −1 pixel (−0.5 to −1.5) from a count from 0.

use super::outline::{ImageName, Outline, OutlineFile, OutlinePlace, PointBudget};
use crate::image::ContourPart;
use crate::io::image_source::number;
use crate::io::{Limits, ReadImageError};

/// Ends of names, with what the outline goes around; outlines of papillary muscles (`p1contour`) have others.
const ENDINGS: [(&str, ContourPart); 4] = [
    ("-icontour-manual.txt", ContourPart::Endocardium),
    ("-icontour-auto.txt", ContourPart::Endocardium),
    ("-ocontour-manual.txt", ContourPart::Epicardium),
    ("-ocontour-auto.txt", ContourPart::Epicardium),
];

/// The number of the image and the part that a name says; `None` if it is no name of such a file.
pub(super) fn named(name: &str) -> Option<(u32, ContourPart)> {
    let lower = name.to_ascii_lowercase();
    let (rest, part) = ENDINGS
        .iter()
        .find_map(|(ending, part)| Some((lower.strip_suffix(ending)?, *part)))?;
    let digits = rest.rsplit('-').next()?;
    Some((digits.parse().ok()?, part))
}

/// Reads an outline.
///
/// # Errors
/// With the line that is no pair of numbers, or if there are too few or too many.
pub(super) fn read_sunnybrook(
    name: &str,
    text: &str,
    limits: &Limits,
) -> Result<OutlineFile, ReadImageError> {
    let (image, part) = named(name).ok_or_else(|| {
        ReadImageError::Unsupported("its name does not say which image it belongs to".to_owned())
    })?;
    let mut budget = PointBudget::new(limits);
    let mut corners = Vec::new();
    for (line, words) in text.lines().enumerate().map(|(n, line)| (n + 1, line)) {
        let mut words = words.split_whitespace();
        let [column, row, more] = [words.next(), words.next(), words.next()];
        let (Some(column), Some(row), None) = (column, row, more) else {
            match column {
                None => continue,
                Some(_) => {
                    return Err(ReadImageError::AtLine {
                        line,
                        reason: "a line of an outline has two numbers: column and row".to_owned(),
                    });
                }
            }
        };
        budget.take(1)?;
        let corner = [
            number::<f64>(column, "column", line)? - 1.0,
            number::<f64>(row, "row", line)? - 1.0,
        ];
        if !corner.iter().all(|place| place.is_finite()) {
            return Err(ReadImageError::AtLine {
                line,
                reason: "a corner is no finite number".to_owned(),
            });
        }
        corners.push(corner);
    }
    if corners.len() < 3 {
        return Err(ReadImageError::Unsupported(
            "an outline has at least three corners".to_owned(),
        ));
    }
    Ok(OutlineFile {
        outlines: vec![Outline {
            part,
            place: OutlinePlace::InImage {
                image: ImageName::Number(image),
                corners,
            },
        }],
        ..OutlineFile::default()
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    const NAME: &str = "IM-0001-0048-ocontour-manual.txt";

    #[test]
    fn pixels_are_counted_from_one_and_names_say_the_rest() {
        let file = read_sunnybrook(NAME, "1.5 2\r\n4 2\n\n4 6.25\n", &Limits::default()).unwrap();
        let outline = Outline {
            part: ContourPart::Epicardium,
            place: OutlinePlace::InImage {
                image: ImageName::Number(48),
                corners: vec![[0.5, 1.0], [3.0, 1.0], [3.0, 5.25]],
            },
        };
        assert_eq!(file.outlines, [outline]);
        assert_eq!(
            named("IM-0001-0007-icontour-auto.TXT"),
            Some((7, ContourPart::Endocardium))
        );
        assert_eq!(named("IM-0001-0007-p1contour-manual.txt"), None);
    }

    #[test]
    fn errors_name_the_line() {
        let error = |text: &str| {
            let read = read_sunnybrook(NAME, text, &Limits::default());
            read.unwrap_err().to_string()
        };
        assert_eq!(
            error("1 2\n3 x\n"),
            "line 2: row: `x` is no number of its kind"
        );
        assert_eq!(
            error("1 2\n3\n"),
            "line 2: a line of an outline has two numbers: column and row"
        );
        assert_eq!(
            error("1 2\nNaN 3\n"),
            "line 2: a corner is no finite number"
        );
        assert_eq!(error("1 2\n3 4\n"), "an outline has at least three corners");
        let few = Limits {
            vertices: 2,
            ..Limits::default()
        };
        let read = read_sunnybrook(NAME, "1 2\n3 4\n5 6\n", &few);
        assert_eq!(
            read.unwrap_err().to_string(),
            "3 points of contours or more; the limit is 2"
        );
    }
}
