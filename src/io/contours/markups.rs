//! Markups of 3D Slicer (`.mrk.json`): closed curves as outlines, points as landmarks.
//!
//! Slicer draws a closed curve smoothly through its points, so that one of few points is drawn here as a Catmull–Rom curve
//! through them: a circle of eight points then has its area to 1 %; the polygon would have a tenth less.

use serde::Deserialize;

use super::outline::{
    FrameName, Outline, OutlineFile, OutlinePlace, PointBudget, mean, part_of_name,
};
use crate::image::ContourPart;
use crate::io::{Limits, ReadImageError};
use crate::mesh::Point3;

/// `{` of one file: one for each point, with some 60 bytes of memory.
const MAX_OBJECTS: usize = 500_000;
/// Bytes of one file; Slicer writes 300 a point.
const MAX_BYTES: u64 = 64 << 20;
/// A curve of more points is a polygon: the curve through them differs by less than 0.2 % of its area.
const SMOOTHED_BELOW: usize = 60;
/// Corners for each point of a smooth curve.
const CORNERS_PER_POINT: usize = 8;

#[derive(Deserialize)]
struct Markups {
    markups: Vec<Markup>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Markup {
    #[serde(rename = "type")]
    kind: String,
    coordinate_system: Option<String>,
    coordinate_units: Option<serde_json::Value>,
    #[serde(default)]
    control_points: Vec<ControlPoint>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct ControlPoint {
    label: Option<String>,
    position: Option<[f64; 3]>,
    position_status: Option<String>,
}

/// Whether a file begins like one of markups.
pub(super) fn recognises(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    text.trim_start().starts_with('{') && text.contains("markups")
}

/// Reads markups. `name` is that of the file: what a curve goes around stands there, or in the labels of its points.
///
/// # Errors
/// With the line that is not as it should be, or if a unit or a system of coordinates is not known.
pub(super) fn read_markups(
    name: &str,
    text: &str,
    limits: &Limits,
) -> Result<OutlineFile, ReadImageError> {
    let size = text.len() as u64;
    if size > MAX_BYTES {
        return Err(ReadImageError::TooLarge {
            size,
            most: MAX_BYTES,
        });
    }
    let objects = text.bytes().filter(|&byte| byte == b'{').count();
    if objects > MAX_OBJECTS {
        return Err(ReadImageError::TooMany {
            what: "points or more",
            count: objects as u64,
            most: MAX_OBJECTS as u64,
        });
    }
    let read: Markups = serde_json::from_str(text).map_err(|error| ReadImageError::AtLine {
        line: error.line(),
        reason: match error.is_data() {
            true => "this is not as in markups of Slicer".to_owned(),
            false => "the JSON is damaged".to_owned(),
        },
    })?;
    let mut budget = PointBudget::new(limits);
    let mut file = OutlineFile::default();
    let stem = name.strip_suffix(".mrk.json").unwrap_or(name);
    for markup in &read.markups {
        let points = points(markup)?;
        budget.take(points.len().saturating_mul(CORNERS_PER_POINT))?;
        match markup.kind.as_str() {
            "ClosedCurve" => curve(stem, markup, &points, &mut file),
            "Fiducial" => landmarks(&points, &mut file),
            _ => file.pass_over("markups that are no closed curves and no points"),
        }
    }
    Ok(file)
}

/// Defined points in the world, with their labels.
fn points(markup: &Markup) -> Result<Vec<(&str, Point3)>, ReadImageError> {
    let wrong = |field: &'static str, reason: &str| ReadImageError::InField {
        field,
        reason: reason.to_owned(),
    };
    let sign = match markup.coordinate_system.as_deref() {
        // As the schema says where nothing is said.
        Some("LPS") | None => 1.0,
        Some("RAS") => -1.0,
        Some(_) => return Err(wrong("coordinateSystem", "neither LPS nor RAS")),
    };
    let millimetres = match &markup.coordinate_units {
        None => true,
        Some(serde_json::Value::String(unit)) => unit == "mm",
        // Codes of a unit, as some versions write them.
        Some(other) => other.to_string().contains("\"mm\""),
    };
    if !millimetres {
        return Err(wrong("coordinateUnits", "not mm"));
    }
    let defined = markup.control_points.iter().filter(|point| {
        !matches!(
            point.position_status.as_deref(),
            Some("undefined" | "missing")
        )
    });
    let mut points = Vec::new();
    for point in defined {
        let [x, y, z] = (point.position).ok_or_else(|| wrong("position", "a point has none"))?;
        let place = Point3::new(sign * x, sign * y, z);
        if !place.iter().all(|x| x.is_finite()) {
            return Err(wrong("position", "it is no finite number"));
        }
        points.push((point.label.as_deref().unwrap_or_default(), place));
    }
    Ok(points)
}

fn curve(stem: &str, markup: &Markup, points: &[(&str, Point3)], file: &mut OutlineFile) {
    let labels = markup.control_points.iter().take(1);
    let labels = labels.filter_map(|point| point.label.as_deref());
    let part: Option<ContourPart> = labels.chain([stem]).find_map(part_of_name);
    match (part, points.len()) {
        (_, 0..3) => file.pass_over("closed curves of fewer than three points"),
        (None, _) => file.pass_over("closed curves whose name says neither endo, epi nor RV"),
        (Some(part), _) => {
            let points: Vec<Point3> = points.iter().map(|(_, place)| *place).collect();
            file.outlines.push(Outline {
                part,
                place: OutlinePlace::InWorld {
                    frame: frame_of_name(stem),
                    points: smooth(&points),
                },
            });
        }
    }
}

/// Words before a number that counts instants.
const FRAME_WORDS: [&str; 6] = ["frame", "phase", "gate", "time", "volume", "t"];

/// The number of the instant that a name says: `frame0`, `t3`.
fn frame_of_name(stem: &str) -> FrameName {
    let lower = stem.to_ascii_lowercase();
    let mut words = lower.split(|c: char| !c.is_ascii_alphanumeric());
    let number = words.find_map(|word| {
        let digits = FRAME_WORDS
            .iter()
            .find_map(|known| word.strip_prefix(known))?;
        digits.parse().ok()
    });
    number.map_or(FrameName::Unsaid, FrameName::Number)
}

/// A closed Catmull–Rom curve through points (uniform, tension ½), where they are few.
fn smooth(points: &[Point3]) -> Vec<Point3> {
    let count = points.len();
    if count >= SMOOTHED_BELOW {
        return points.to_vec();
    }
    let mut corners = Vec::with_capacity(count * CORNERS_PER_POINT);
    for place in 0..count {
        let [a, b, c, d] = [count - 1, 0, 1, 2].map(|step| points[(place + step) % count].coords);
        for part in 0..CORNERS_PER_POINT {
            let t = part as f64 / CORNERS_PER_POINT as f64;
            let (square, cube) = (t * t, t * t * t);
            let corner = b + 0.5
                * ((c - a) * t
                    + (2.0 * a - 5.0 * b + 4.0 * c - d) * square
                    + (3.0 * b - a - 3.0 * c + d) * cube);
            corners.push(Point3::from(corner));
        }
    }
    corners
}

/// Words of labels of points.
fn landmarks(points: &[(&str, Point3)], file: &mut OutlineFile) {
    let of = |words: &[&str]| {
        let own = points.iter().filter(|(label, _)| {
            let label = label.to_ascii_lowercase();
            words.iter().all(|word| label.contains(word))
        });
        mean(&own.map(|(_, place)| *place).collect::<Vec<_>>())
    };
    file.points.apex = of(&["apex"]);
    file.points.base = of(&["mitral"]).or_else(|| of(&["base"]));
    file.points.septum = of(&["rv", "insert"]).or_else(|| of(&["sept"]));
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    fn markup(kind: &str, system: &str, points: &[(&str, [f64; 3])]) -> String {
        let points: Vec<String> = (points.iter())
            .map(|(label, position)| {
                format!("{{\"label\": \"{label}\", \"position\": {position:?}, \"positionStatus\": \"defined\"}}")
            })
            .collect();
        format!(
            "{{\"@schema\": \"markups-schema\", \"markups\": [{{\"type\": \"{kind}\", \"coordinateSystem\": \"{system}\",\
             \"coordinateUnits\": \"mm\",\n\"controlPoints\": [{}]}}]}}",
            points.join(",\n")
        )
    }

    fn circle(count: usize) -> Vec<(&'static str, [f64; 3])> {
        let angle = |n: usize| std::f64::consts::TAU * n as f64 / count as f64;
        let at = |n| [20.0 * angle(n).cos(), 20.0 * angle(n).sin(), 7.0];
        (0..count).map(|n| ("", at(n))).collect()
    }

    fn read(name: &str, text: &str) -> OutlineFile {
        read_markups(name, text, &Limits::default()).unwrap()
    }

    #[test]
    fn a_circle_of_few_points_has_its_area() {
        let file = read(
            "endo_frame3.mrk.json",
            &markup("ClosedCurve", "LPS", &circle(8)),
        );
        let [Outline { part, place }] = file.outlines.as_slice() else {
            panic!("{file:?}");
        };
        assert_eq!(*part, ContourPart::Endocardium);
        let OutlinePlace::InWorld { frame, points } = place else {
            panic!("{place:?}");
        };
        assert_eq!(*frame, FrameName::Number(3));
        let edges = points.iter().zip(points.iter().cycle().skip(1));
        let area: f64 = edges.map(|(a, b)| 0.5 * (a.x * b.y - a.y * b.x)).sum();
        let circle = std::f64::consts::PI * 400.0;
        assert!((area / circle - 1.0).abs() < 0.012, "{}", area / circle);
    }

    #[test]
    fn both_systems_of_coordinates_give_one_place() {
        let points = [
            ("APEX_POINT", [1.0, 2.0, 3.0]),
            ("rv insert", [4.0, 4.0, 4.0]),
        ];
        let mirrored = points.map(|(label, [x, y, z])| (label, [-x, -y, z]));
        let lps = read("a", &markup("Fiducial", "LPS", &points));
        let ras = read("a", &markup("Fiducial", "RAS", &mirrored));
        assert_eq!(lps, ras);
        assert_eq!(lps.points.apex, Some(Point3::new(1.0, 2.0, 3.0)));
        assert_eq!(lps.points.septum, Some(Point3::new(4.0, 4.0, 4.0)));
    }

    #[test]
    fn what_is_no_outline_is_counted_and_what_is_wrong_named() {
        let nameless = read("curve", &markup("ClosedCurve", "LPS", &circle(8)));
        assert!(nameless.outlines.is_empty() && nameless.passed_over.len() == 1);
        let line = read("endo", &markup("Line", "LPS", &circle(2)));
        assert!(line.outlines.is_empty() && line.passed_over.len() == 1);
        let error = |text: &str| {
            let read = read_markups("endo", text, &Limits::default());
            read.unwrap_err().to_string()
        };
        let metres = markup("ClosedCurve", "LPS", &circle(8)).replace("\"mm\"", "\"m\"");
        assert_eq!(error(&metres), "coordinateUnits: not mm");
        let other = markup("ClosedCurve", "XYZ", &circle(8));
        assert_eq!(error(&other), "coordinateSystem: neither LPS nor RAS");
        let cut = markup("ClosedCurve", "LPS", &circle(8));
        assert_eq!(error(&cut[..cut.len() - 2]), "line 9: the JSON is damaged");
        let words = cut.replacen("[20.0", "[\"a\"", 1);
        assert_eq!(error(&words), "line 2: this is not as in markups of Slicer");
    }
}
