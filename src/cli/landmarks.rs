//! Pairs of landmarks in a CSV file.

use std::io::Read;
use std::path::Path;

use crate::cli::outcome::CliError;
use crate::mesh::Point3;

/// Bytes of a file of landmarks: more than any number of them that a spline may have.
const MAX_LANDMARK_BYTES: u64 = 1 << 20;

/// Corresponding points.
#[derive(Default)]
pub(super) struct LandmarkPairs {
    /// Points of A.
    pub from: Vec<Point3>,
    /// Those of B that they lie on.
    pub onto: Vec<Point3>,
}

/// Reads rows of `ax,ay,az,bx,by,bz`, after a header of these names or without one.
///
/// # Errors
/// If the file cannot be read, holds more than a MiB, no pairs, or something else.
pub(super) fn read_landmarks(path: &Path) -> Result<LandmarkPairs, CliError> {
    let wrong = |reason: String| CliError::Unusable(format!("{reason}: {}", path.display()));
    let file = std::fs::File::open(path).map_err(|error| wrong(error.to_string()))?;
    let mut bytes = Vec::new();
    let read = file.take(MAX_LANDMARK_BYTES + 1).read_to_end(&mut bytes);
    let read = read.map_err(|error| wrong(error.to_string()))?;
    if read as u64 > MAX_LANDMARK_BYTES {
        return Err(wrong(format!(
            "more than {MAX_LANDMARK_BYTES} bytes of landmarks"
        )));
    }
    landmarks_of(&bytes).map_err(wrong)
}

fn landmarks_of(bytes: &[u8]) -> Result<LandmarkPairs, String> {
    const HEADER: [&str; 6] = ["ax", "ay", "az", "bx", "by", "bz"];
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let mut pairs = LandmarkPairs::default();
    for (number, record) in reader.records().enumerate() {
        let record = record.map_err(|error| error.to_string())?;
        let line = record
            .position()
            .map_or(number as u64 + 1, csv::Position::line);
        if number == 0 && record.iter().map(str::to_ascii_lowercase).eq(HEADER) {
            continue;
        }
        let mut row = [0.0; 6];
        if record.len() != row.len() {
            return Err(format!(
                "line {line}: {} numbers, but a pair has 6",
                record.len()
            ));
        }
        for (number, cell) in row.iter_mut().zip(&record) {
            let found = cell.parse::<f64>().ok().filter(|number| number.is_finite());
            *number =
                found.ok_or_else(|| format!("line {line}: {cell:?} is not a finite number"))?;
        }
        let [ax, ay, az, bx, by, bz] = row;
        pairs.from.push(Point3::new(ax, ay, az));
        pairs.onto.push(Point3::new(bx, by, bz));
    }
    if pairs.from.is_empty() {
        return Err("holds no landmarks".to_owned());
    }
    Ok(pairs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn landmarks_are_pairs_with_a_header_or_without() {
        let rows = "1,2,3,4,5,6\n-1, 2.5,3e1,4,5,6\n";
        for text in [rows.to_owned(), format!("AX,ay,az,bx,by,bz\r\n{rows}")] {
            let pairs = landmarks_of(text.as_bytes()).map_err(|error| panic!("{error}"));
            let pairs = pairs.unwrap_or_default();
            assert_eq!(pairs.from[1], Point3::new(-1.0, 2.5, 30.0));
            assert_eq!(pairs.onto, [Point3::new(4.0, 5.0, 6.0); 2]);
        }
    }

    #[test]
    fn rows_that_are_no_pairs_are_refused_by_line() {
        let error = |text: &str| landmarks_of(text.as_bytes()).err().unwrap_or_default();
        assert_eq!(error(""), "holds no landmarks");
        assert_eq!(error("ax,ay,az,bx,by,bz\n"), "holds no landmarks");
        assert_eq!(
            error("1,2,3,4,5,6\n1,2,3\n"),
            "line 2: 3 numbers, but a pair has 6"
        );
        assert_eq!(
            error("1,2,3,4,5,nan\n"),
            "line 1: \"nan\" is not a finite number"
        );
        assert_eq!(
            error("x,y,z,u,v,w\n"),
            "line 1: \"x\" is not a finite number"
        );
    }
}
