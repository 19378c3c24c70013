//! Guide points of biv-me (`GPFile_000.txt`): points of outlines in slices, and landmarks; a line each.
//!
//! `x y z contour-type slice weight frame`, separated by tabs or spaces, in millimetres (LPS), frames from 0. The outline of the
//! epicardium is in two pieces: the free wall (`SAX_LV_EPICARDIAL`) and the septum (`SAX_RV_SEPTUM`), which closes that of the right
//! cavity too. Slices along the long axis are passed over: a wall is made of slices across.

use std::collections::BTreeMap;

use super::outline::{FrameName, Outline, OutlineFile, OutlinePlace, PointBudget, mean};
use crate::image::ContourPart;
use crate::io::image_source::number;
use crate::io::{Limits, ReadImageError};
use crate::mesh::Point3;

/// Whether a file begins like one of guide points.
pub(super) fn recognises(head: &[u8]) -> bool {
    let first = head.split(|&byte| byte == b'\n').next().unwrap_or_default();
    let words = String::from_utf8_lossy(first).to_ascii_lowercase();
    let mut words = words.split_whitespace();
    words.by_ref().take(3).eq(["x", "y", "z"]) && words.next() == Some("contour")
}

/// The pieces of each outline.
const OUTLINES: [(ContourPart, &[&str]); 3] = [
    (ContourPart::Endocardium, &["SAX_LV_ENDOCARDIAL"]),
    (
        ContourPart::Epicardium,
        &["SAX_LV_EPICARDIAL", "SAX_RV_SEPTUM"],
    ),
    (
        ContourPart::RightCavity,
        &["SAX_RV_FREEWALL", "SAX_RV_SEPTUM"],
    ),
];
/// Points by frame, slice and kind.
type Pieces = BTreeMap<(u32, u32), BTreeMap<String, Vec<Point3>>>;
/// Letters of a kind that are kept.
const MAX_KIND: usize = 32;

/// Reads guide points.
///
/// # Errors
/// With the line that is not as it should be, or if there are too many.
pub(super) fn read_guide_points(
    text: &str,
    limits: &Limits,
) -> Result<OutlineFile, ReadImageError> {
    let mut budget = PointBudget::new(limits);
    let mut pieces = Pieces::new();
    for (index, line) in text.lines().enumerate().skip(1) {
        if line.trim().is_empty() {
            continue;
        }
        budget.take(1)?;
        let (key, kind, point) = guide_point(line, index + 1)?;
        let slice = pieces.entry(key).or_default();
        slice.entry(kind).or_default().push(point);
    }
    let mut file = OutlineFile::default();
    for ((frame, _), kinds) in &pieces {
        for (part, names) in OUTLINES {
            let own: Vec<&[Point3]> = (names.iter())
                .filter_map(|name| kinds.get(*name).map(Vec::as_slice))
                .collect();
            // Without its first piece it is another outline's rest.
            if !kinds.contains_key(names[0]) {
                continue;
            }
            let points = joined(&own);
            match points.len() < 3 {
                true => file.pass_over("fewer than three guide points"),
                false => file.outlines.push(Outline {
                    part,
                    place: OutlinePlace::InWorld {
                        frame: FrameName::FromZero(*frame),
                        points,
                    },
                }),
            }
        }
        for _ in kinds.keys().filter(|kind| kind.starts_with("LAX_LV_")) {
            file.pass_over("in slices along the long axis");
        }
    }
    landmarks(&pieces, &mut file);
    Ok(file)
}

/// Points of the first frame that has some.
fn landmarks(pieces: &Pieces, file: &mut OutlineFile) {
    let of_kind = |kind: &str| {
        let with = |((frame, _), kinds): (&(u32, u32), &BTreeMap<String, Vec<Point3>>)| {
            kinds.get(kind).map(|points| (*frame, points.clone()))
        };
        let all: Vec<(u32, Vec<Point3>)> = pieces.iter().filter_map(with).collect();
        let first = all.iter().map(|(frame, _)| *frame).min();
        let own = all.into_iter().filter(|(frame, _)| Some(*frame) == first);
        mean(&own.flat_map(|(_, points)| points).collect::<Vec<_>>())
    };
    file.points.apex = of_kind("APEX_POINT");
    file.points.base = of_kind("MITRAL_VALVE");
    file.points.septum = of_kind("RV_INSERT");
}

/// Frame and slice, kind, and place.
fn guide_point(
    line: &str,
    line_number: usize,
) -> Result<((u32, u32), String, Point3), ReadImageError> {
    let wrong = |reason: &str| ReadImageError::AtLine {
        line: line_number,
        reason: reason.to_owned(),
    };
    let words: Vec<&str> = line.split_whitespace().take(8).collect();
    let &[x, y, z, kind, slice, _weight, frame] = words.as_slice() else {
        return Err(wrong(
            "a guide point has seven fields: x, y, z, contour type, slice, weight, frame",
        ));
    };
    let mut place = Point3::origin();
    for (axis, (word, name)) in [(x, "x"), (y, "y"), (z, "z")].into_iter().enumerate() {
        place[axis] = number::<f64>(word, name, line_number)?;
    }
    if !place.iter().all(|x| x.is_finite()) {
        return Err(wrong("a place is no finite number"));
    }
    if kind.len() > MAX_KIND {
        return Err(wrong("a contour type of more than 32 letters"));
    }
    // Frames and slices are written as numbers with or without a fraction.
    let whole = |word: &str, name: &str| {
        let value = number::<f64>(word, name, line_number)?;
        match value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
            true => Ok(value as u32),
            false => Err(wrong("slices and frames are whole numbers")),
        }
    };
    let key = (whole(frame, "frame")?, whole(slice, "slice")?);
    Ok((key, kind.to_owned(), place))
}

/// Pieces of an outline as one, each turned so that it goes on where the one before it ends.
fn joined(pieces: &[&[Point3]]) -> Vec<Point3> {
    let mut whole: Vec<Point3> = Vec::new();
    for piece in pieces {
        let mut piece = opened(piece);
        if let [Some(&start), Some(&end)] = [whole.first(), whole.last()]
            && let [Some(&first), Some(&last)] = [piece.first(), piece.last()]
        {
            let gaps = |a: Point3, b: Point3| (end - a).norm() + (start - b).norm();
            if gaps(last, first) < gaps(first, last) {
                piece.reverse();
            }
        }
        whole.append(&mut piece);
    }
    whole
}

/// A piece that begins after its greatest step: files begin anywhere.
fn opened(piece: &[Point3]) -> Vec<Point3> {
    let steps = piece.iter().zip(piece.iter().cycle().skip(1));
    let lengths = steps.map(|(a, b)| (b - a).norm()).enumerate();
    let greatest = lengths.max_by(|a, b| a.1.total_cmp(&b.1));
    let mut turned = piece.to_vec();
    if let Some((place, _)) = greatest {
        turned.rotate_left((place + 1) % piece.len());
    }
    turned
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    const HEAD: &str = "x\ty\tz\tcontour type\tframeID\tweight\ttime frame\n";

    #[test]
    fn pieces_make_closed_outlines_whatever_way_they_go() {
        let mut text = HEAD.to_owned();
        // A square in two pieces that begin in the middle and go in opposite ways.
        for (x, y, kind) in [
            (4, 0, "SAX_LV_EPICARDIAL"),
            (4, 4, "SAX_LV_EPICARDIAL"),
            (0, 0, "SAX_LV_EPICARDIAL"),
            (2, 0, "SAX_LV_EPICARDIAL"),
            (0, 2, "SAX_RV_SEPTUM"),
            (0, 4, "SAX_RV_SEPTUM"),
            (2, 4, "SAX_RV_SEPTUM"),
        ] {
            text += &format!("{x}.0\t{y}\t5\t{kind}\t2\t1.0\t9\n");
        }
        text += "7\t8\t9\tAPEX_POINT\t7\t1.0\t9\n";
        let file = read_guide_points(&text, &Limits::default()).unwrap();
        let [outline] = file.outlines.as_slice() else {
            panic!("{:?}", file.outlines);
        };
        let OutlinePlace::InWorld { frame, points } = &outline.place else {
            panic!("{outline:?}");
        };
        assert_eq!(*frame, FrameName::FromZero(9));
        let around: f64 = (points.iter().zip(points.iter().cycle().skip(1)))
            .map(|(a, b)| (b - a).norm())
            .sum();
        assert!((around - 16.0).abs() < 1e-9, "{points:?}");
        assert_eq!(file.points.apex, Some(Point3::new(7.0, 8.0, 9.0)));
        assert!(recognises(HEAD.as_bytes()) && !recognises(b"x y z\n1 2 3"));
    }

    #[test]
    fn errors_name_the_line() {
        let error = |line: &str| {
            let read = read_guide_points(&format!("{HEAD}{line}\n"), &Limits::default());
            read.unwrap_err().to_string()
        };
        assert!(error("1 2 3 A 1 1.0").starts_with("line 2: a guide point has seven fields"));
        assert_eq!(
            error("1 b 3 A 1 1 0"),
            "line 2: y: `b` is no number of its kind"
        );
        assert_eq!(
            error("1 2 3 A 1 1 0.5"),
            "line 2: slices and frames are whole numbers"
        );
        assert_eq!(
            error("1 2 inf A 1 1 0"),
            "line 2: a place is no finite number"
        );
    }
}
