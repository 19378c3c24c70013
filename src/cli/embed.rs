//! `embed`: a map of items from a file of distances or points.

use std::path::Path;

use serde_json::json;

use crate::analysis::embedding::{
    CheckedLleParams, CheckedSmacofParams, Embedding, EmbeddingError, LleParams, SmacofParams,
    classical_mds, isomap, lle, pca, raw_stress, smacof,
};
use crate::analysis::pose_distances::DistanceMatrix;
use crate::cli::args::EmbedArgs;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::words::{EmbedInput, EmbedMethod};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::progress::Progress;
use crate::report::coordinates_csv;

pub(super) fn embed(args: &EmbedArgs) -> Result<(), CliError> {
    let points_only = matches!(args.method, EmbedMethod::Pca | EmbedMethod::Lle);
    if points_only && args.input == EmbedInput::Distances {
        return Err(CliError::Usage(
            "--method pca and lle need --input points: distances have no directions".to_owned(),
        ));
    }
    let method = Method::checked(args)?;
    let rows = rows_of(&args.file)?;
    let items = rows.len();
    let distances = match args.input {
        EmbedInput::Distances => checked_distances(&rows)
            .map_err(|reason| CliError::Unusable(format!("{reason}: {}", args.file.display())))?,
        EmbedInput::Points => distances_of(&rows).ok_or_else(|| {
            let largest = "distances of the points are beyond the largest number";
            CliError::Unusable(format!("{largest}: {}", args.file.display()))
        })?,
    };
    let map = run_work(move |progress| {
        progress.begin_phase("computing the embedding", 0.0, 1.0);
        method
            .map(&rows, &distances, progress)
            .map(|map| (raw_stress(&distances, &map), map))
    });
    let (raw, map) = map?;
    // A number that is none would be read as a place.
    if map.coordinates.iter().any(|x| !x.is_finite()) {
        return Err(CliError::Unusable(format!(
            "the map has coordinates that are no numbers: {}",
            args.file.display()
        )));
    }
    let table = ExportFile {
        path: args.out.clone(),
        bytes: coordinates_csv(&map).into_bytes().into(),
    };
    write_files(vec![table]).map_err(CliError::Unusable)?;
    report(&map, raw, items, args)
}

/// A method with its checked settings.
struct Method {
    word: EmbedMethod,
    dimensions: usize,
    neighbours: usize,
    smacof: CheckedSmacofParams,
    lle: CheckedLleParams,
}

impl Method {
    fn checked(args: &EmbedArgs) -> Result<Self, CliError> {
        let (dimensions, neighbours) = (usize::from(args.dimensions), usize::from(args.neighbours));
        let smacof = SmacofParams {
            random_starts: usize::from(args.starts),
            seed: args.seed,
            ..SmacofParams::default()
        };
        let lle = LleParams {
            neighbours,
            regularisation: args.regularisation,
            dimensions,
        };
        let wrong = |error: String| CliError::Usage(error);
        Ok(Self {
            word: args.method,
            dimensions,
            neighbours,
            smacof: smacof.check().map_err(|error| wrong(error.to_string()))?,
            lle: lle.check().map_err(|error| wrong(error.to_string()))?,
        })
    }

    fn map(
        &self,
        rows: &[Vec<f64>],
        distances: &DistanceMatrix,
        progress: &Progress,
    ) -> Result<Embedding, EmbeddingError> {
        match self.word {
            EmbedMethod::Mds => classical_mds(distances, self.dimensions, progress),
            EmbedMethod::Smacof => smacof(distances, self.dimensions, &self.smacof, progress),
            EmbedMethod::Isomap => isomap(distances, self.neighbours, self.dimensions, progress),
            EmbedMethod::Lle => lle(&rows.concat(), rows.len(), &self.lle, progress),
            EmbedMethod::Pca => pca(&rows.concat(), rows.len(), self.dimensions, progress),
        }
    }
}

fn report(
    map: &Embedding,
    raw_stress: Option<f64>,
    items: usize,
    args: &EmbedArgs,
) -> Result<(), CliError> {
    if !args.json {
        let stress = map
            .stress
            .map_or_else(String::new, |stress| format!(", stress {stress:.4}"));
        let out = args.out.display();
        let parts = parts_sentence(map, args).map_or_else(String::new, |s| format!("\n{s}"));
        return print(&format!("{items} items{stress}: {out}{parts}"));
    }
    let mut object = serde_json::Map::new();
    if let Some(stress) = map.stress {
        object.insert("stress".to_owned(), json!(stress));
        // Of distances near the largest number it is none; the stress is the same share of them.
        let raw_stress = raw_stress.filter(|stress| stress.is_finite());
        object.insert("raw_stress".to_owned(), json!(raw_stress));
    }
    if let Some(eigenvalues) = &map.eigenvalues {
        object.insert("eigenvalues".to_owned(), json!(eigenvalues));
    }
    if let Some(error) = map.reconstruction_error {
        object.insert("reconstruction_error".to_owned(), json!(error));
    }
    if let Some(neighbours) = map.neighbours {
        object.insert("neighbours".to_owned(), json!(neighbours));
    }
    if let Some(parts) = map.parts {
        object.insert("parts".to_owned(), json!(parts));
    }
    if let Some(iterations) = map.iterations {
        object.insert("iterations".to_owned(), json!(iterations));
    }
    if let Some(sentence) = parts_sentence(map, args) {
        object.insert("notes".to_owned(), json!([sentence]));
    }
    print_json(&serde_json::Value::Object(object))
}

/// What was done where the graph of nearest neighbours is not connected: the map shows that, too.
fn parts_sentence(map: &Embedding, args: &EmbedArgs) -> Option<String> {
    let (parts, asked) = (map.parts.filter(|&parts| parts > 1)?, args.neighbours);
    let parts = format!(
        "warning: the graph of {asked} nearest neighbours falls into {parts} parts that are not connected"
    );
    match args.method {
        EmbedMethod::Isomap => Some(format!(
            "{parts}: they were joined by the shortest links between them, so lengths of ways from part to part depend on single links"
        )),
        EmbedMethod::Lle => {
            let used = map.neighbours.unwrap_or_default();
            Some(format!(
                "{parts}: {used} nearest neighbours were used instead, which join them to one part"
            ))
        }
        EmbedMethod::Mds | EmbedMethod::Smacof | EmbedMethod::Pca => None,
    }
}

/// Rows of numbers without a header, all of one length.
fn rows_of(path: &Path) -> Result<Vec<Vec<f64>>, CliError> {
    let wrong = |reason: String| CliError::Unusable(format!("{reason}: {}", path.display()));
    let bytes = std::fs::read(path).map_err(|error| wrong(error.to_string()))?;
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(&*bytes);
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for (line, record) in reader.records().enumerate() {
        let record = record.map_err(|error| wrong(error.to_string()))?;
        let mut row = Vec::with_capacity(record.len());
        for cell in &record {
            let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
            row.push(number.ok_or_else(|| {
                wrong(format!(
                    "line {}: {cell:?} is not a finite number",
                    line + 1
                ))
            })?);
        }
        if let Some(first) = rows.first().filter(|first| first.len() != row.len()) {
            return Err(wrong(format!(
                "line {}: {} numbers, but line 1 has {}",
                line + 1,
                row.len(),
                first.len()
            )));
        }
        rows.push(row);
    }
    if rows.is_empty() {
        return Err(wrong("holds no numbers".to_owned()));
    }
    Ok(rows)
}

/// A square matrix as distances: not negative, zero on the diagonal, symmetric to a millionth of
/// the largest entry, which is more than rounding in six printed digits leaves.
fn checked_distances(rows: &[Vec<f64>]) -> Result<DistanceMatrix, String> {
    let size = rows.len();
    let width = rows[0].len();
    if width != size {
        return Err(format!(
            "{size} rows of {width} numbers are not a square matrix"
        ));
    }
    let largest = rows
        .iter()
        .flatten()
        .fold(0.0_f64, |most, d| most.max(d.abs()));
    let slack = 1e-6 * largest;
    let mut upper = Vec::with_capacity(size * size.saturating_sub(1) / 2);
    for (i, row) in rows.iter().enumerate() {
        if row[i].abs() > slack {
            return Err(format!("row {i}: the diagonal is {}, not 0", row[i]));
        }
        for (j, other) in rows.iter().enumerate().skip(i + 1) {
            let (there, back) = (row[j], other[i]);
            if (there - back).abs() > slack {
                return Err(format!(
                    "row {i}, column {j}: {there}, but {back} in row {j}, column {i}"
                ));
            }
            if there.min(back) < 0.0 {
                let negative = there.min(back);
                return Err(format!("row {i}, column {j}: negative distance {negative}"));
            }
            upper.push(0.5 * there + 0.5 * back);
        }
    }
    DistanceMatrix::from_upper(size, upper).ok_or_else(|| "not a square matrix".to_owned())
}

/// `None` where one is beyond the largest number.
fn distances_of(rows: &[Vec<f64>]) -> Option<DistanceMatrix> {
    DistanceMatrix::of_points(&rows.concat(), rows.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_that_is_no_distance_is_refused_by_row_and_column() {
        let error = |rows: &[&[f64]]| {
            let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
            checked_distances(&rows).unwrap_err()
        };
        assert!(error(&[&[0.0, 1.0]]).contains("1 rows of 2 numbers"));
        assert!(error(&[&[0.0, 1.0], &[2.0, 0.0]]).contains("row 0, column 1"));
        assert!(
            error(&[&[0.0, -1.0], &[-1.0, 0.0]]).contains("row 0, column 1: negative distance -1")
        );
        assert!(error(&[&[1.0]]).contains("diagonal"));
        // Within the slack of rounding, and still no distance.
        assert!(
            error(&[&[0.0, 1e-9, 5.0], &[-1e-9, 0.0, 5.0], &[5.0, 5.0, 0.0]]).contains("negative")
        );
        // The difference of the two entries is beyond the largest number.
        assert!(error(&[&[0.0, 1.7e308], &[-1.7e308, 0.0]]).contains("row 0, column 1"));
    }

    #[test]
    fn distances_near_the_largest_number_are_distances() {
        let rows = vec![vec![0.0, 1.7e308], vec![1.7e308, 0.0]];
        assert_eq!(checked_distances(&rows).unwrap().get(0, 1), 1.7e308);
        let far = vec![vec![1.7e308], vec![-1.7e308]];
        assert_eq!(distances_of(&far), None);
    }

    #[test]
    fn points_give_their_euclidean_distances() {
        let rows = vec![vec![0.0, 0.0], vec![3.0, 4.0], vec![0.0, 1.0]];
        let distances = distances_of(&rows).unwrap();
        assert_eq!(distances.get(0, 1), 5.0);
        assert_eq!(distances.get(0, 2), 1.0);
    }
}
